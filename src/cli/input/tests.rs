use super::lines::MAX_LINE_BYTES;
use super::*;

const HEADER: &str = "wi_z,wo_x,wo_y,wo_z,wi_x,wi_y,note\n";

fn rows(text: &str) -> Result<Rows> {
    let source = io::Cursor::new(text.to_owned().into_bytes());
    Rows::read(Box::new(source), "test".into())
}

/// The error of the first row that has one.
fn first_error(text: &str) -> String {
    let mut rows = match rows(text) {
        Ok(rows) => rows,
        Err(error) => return error.to_string(),
    };
    loop {
        match rows.next_row() {
            Ok(row) => assert!(row.is_some(), "no error in {text}"),
            Err(error) => return error.to_string(),
        }
    }
}

#[test]
fn columns_go_by_name_and_keep_their_text() {
    let text = format!("\u{feff}# a comment\r\n{HEADER}\r\n 1.0,+0,-0.,2e0,.6,0,\"a, b\"\r\n");
    let mut rows = rows(&text).unwrap();
    let row = rows.next_row().unwrap().unwrap();
    assert_eq!(row.texts, ["+0", "-0.", "2e0", ".6", "0", " 1.0"]);
    assert_eq!(row.wo, DVec3::Z);
    assert!(row.was_normalised && (row.wi.length() - 1.0).abs() < 1e-15);
    assert!(rows.next_row().unwrap().is_none());
}

#[test]
fn vectors_are_normalised_only_where_they_must_be() {
    for (x, was_unit) in [(1.0 + 4e-7, true), (1.0 + 6e-7, false)] {
        let (w, found) = unit("wo", DVec3::X * x).unwrap();
        assert_eq!(found, was_unit);
        assert_eq!(w.x == x, was_unit);
    }
    for tiny_or_huge in [1e-300, 1e300] {
        let (w, _) = unit("wo", DVec3::new(3.0, 0.0, 4.0) * tiny_or_huge).unwrap();
        assert!((w - DVec3::new(0.6, 0.0, 0.8)).length() < 1e-15);
    }
}

#[test]
fn errors_name_the_line_of_the_file() {
    let good = "1,0,0,1,0,0,\n";
    for (text, expected) in [
        (String::new(), "test: no header; the columns read are wo_x,"),
        ("wo_x,wo_y\n".into(), "line 1: no column 'wo_z'"),
        (
            "#\n\nwo_x,wo_x,wo_y,wo_z\n".into(),
            "line 3: two columns 'wo_x'",
        ),
        (
            format!("#\n{HEADER}{good}1,2\n"),
            "line 4: 2 fields where the header has 7",
        ),
        (
            format!("{HEADER}{good}#\n\n{good}#\r\n1,a,0,1,0,0,"),
            "line 7: wo_x = 'a' is not a number",
        ),
        (
            format!("{HEADER}nan,0,0,1,0,0,\n"),
            "line 2: wi_z = nan is not finite",
        ),
        (
            format!("{HEADER}1e400,0,0,1,0,0,\n"),
            "line 2: wi_z = 1e400 is not finite",
        ),
        (format!("{HEADER}0,0,0,1,0,0,\n"), "line 2: wi has length 0"),
        (
            format!("{HEADER}{good}{}", "1".repeat(MAX_LINE_BYTES + 1)),
            "test: line 3 is longer than 1048576 bytes",
        ),
    ] {
        let line = first_error(&text);
        assert!(line.starts_with(expected), "{line}");
    }
}

/// The texts and directions of the only row of `bytes`.
fn only_row(bytes: Vec<u8>) -> ([String; 6], [DVec3; 2]) {
    let mut rows = Rows::read(Box::new(io::Cursor::new(bytes)), "test".into()).unwrap();
    let row = rows.next_row().unwrap().unwrap();
    let found = (row.texts.map(Cow::into_owned), [row.wo, row.wi]);
    assert!(rows.next_row().unwrap().is_none());
    found
}

#[test]
fn spreadsheets_write_what_is_read() {
    let commas = format!("{HEADER}0.8,0,0,1,6e-1,-0.0,\n");
    let expected = only_row(commas.clone().into_bytes());
    assert_eq!(expected.1, [DVec3::Z, DVec3::new(0.6, -0.0, 0.8)]);
    let semicolons = commas.replace(',', ";");
    let decimal_commas = semicolons.replace('.', ",");
    let tabs = decimal_commas.replace(';', "\t");
    let quoted = semicolons.replace("wo_x;", "\"wo_x\";");
    let said = format!("sep=;\r\n{decimal_commas}");
    for text in [commas, semicolons, decimal_commas, tabs, quoted, said] {
        for text in [text.replace('\n', "\r\n"), text.replace('\n', "\r"), text] {
            let marked = format!("\u{feff}{text}");
            let utf16: Vec<u8> = marked.encode_utf16().flat_map(u16::to_le_bytes).collect();
            for bytes in [text.clone().into_bytes(), marked.into_bytes(), utf16] {
                assert_eq!(only_row(bytes), expected, "{text:?}");
            }
        }
    }
}

#[test]
fn what_no_spreadsheet_writes_is_said() {
    for (text, expected) in [
        (
            "wo_x|wo_y|wo_z|wi_x|wi_y|wi_z\n".to_owned(),
            "line 1: 'wo_x|wo_y|wo_z|wi_x|wi_y|wi_z' is no header; it has the columns wo_x,",
        ),
        (
            format!("{HEADER}0,8,0,0,1,0,6,0,\n"),
            "line 2: 9 fields where the header has 7; where commas part the fields, numbers have",
        ),
        (
            format!("{}1.234,5;0;0;1;0;0;\n", HEADER.replace(',', ";")),
            "line 2: wi_z = '1.234,5' is not a number",
        ),
        (
            format!("{}1,2,5;0;0;1;0;0;\n", HEADER.replace(',', ";")),
            "line 2: wi_z = '1,2,5' is not a number",
        ),
        (
            "\u{1b}[2J\n".to_owned(),
            "line 1: '\\u{1b}[2J' is no header",
        ),
        // The line of the file, though the first one was left out.
        (
            format!("sep=;\n#\n{}#\n1;a;0;1;0;0;\n", HEADER.replace(',', ";")),
            "line 5: wo_x = 'a' is not a number",
        ),
    ] {
        let line = first_error(&text);
        assert!(line.starts_with(expected), "{line}");
    }
}
