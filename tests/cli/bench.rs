//! `bench`: speeds, as numbers.

use super::{done, folder, json, refused};

#[test]
fn bench_measures_every_operation_on_given_pairs() {
    let path = folder("bench").join("pairs.bin");
    // 128 pairs of directions along n, and numbers of one half.
    let arrays = [0.0_f32, 0.0, 1.0, 0.0, 0.0, 1.0, 0.5, 0.5, 0.5];
    let bytes: Vec<u8> = arrays
        .iter()
        .flat_map(|x| x.to_le_bytes().repeat(128))
        .collect();
    std::fs::write(&path, bytes).unwrap();
    let path = path.to_str().unwrap();
    let words = [
        "bench",
        "oren_nayar",
        "--pairs",
        path,
        "--threads",
        "1",
        "--json",
    ];
    let report = json(&done(&words, ""));
    assert_eq!(report["pairs"], 128);
    assert_eq!(report["threads"], 1);
    let rows = report["rows"].as_array().unwrap();
    // Two precisions, four operations, three ways to run.
    assert_eq!(rows.len(), 24);
    for row in rows {
        assert_eq!(row["material"], "oren_nayar");
        let ns = row["ns"].as_f64().unwrap();
        assert!(
            ns > 0.0 && row["spread"][0].as_f64().unwrap() <= ns,
            "{row}"
        );
    }
    let only = ["--precision", "f32", "--path", "parallel"];
    let report = json(&done(&[&words[..], &only].concat(), ""));
    let rows = report["rows"].as_array().unwrap();
    assert_eq!(rows.len(), 4);
    for row in rows {
        assert_eq!(
            (&row["precision"], &row["path"]),
            (&"f32".into(), &"parallel".into())
        );
    }
}

#[test]
fn an_unknown_way_to_measure_is_refused() {
    for (option, expected) in [
        (
            "--precision",
            "unknown native precision 'fast'; nearest: f32, f64",
        ),
        ("--path", "unknown path 'fast'; nearest: "),
    ] {
        let line = refused(&["bench", "phong", option, "fast"], "");
        assert!(line.contains(expected), "{line}");
    }
}

#[test]
fn a_file_that_holds_no_pairs_is_refused() {
    let path = folder("bench_refused").join("short.bin");
    std::fs::write(&path, [0_u8; 40]).unwrap();
    let line = refused(&["bench", "--pairs", path.to_str().unwrap()], "");
    assert!(line.contains("40 bytes are not nine arrays"), "{line}");
    assert!(refused(&["bench", "--threads", "0"], "").contains("--threads"));
}
