//! `eval`: values, kept text, refused rows, files.

use std::fs;

use super::{
    HEADER, done, files_in, folder, numbers, refused, rows, run_with_input, stderr, stdout,
};

#[test]
fn eval_keeps_the_text_of_its_columns_and_adds_values() {
    let input = "# origin: by hand\nnote,wi_z,wi_y,wi_x,wo_z,wo_y,wo_x\n\
                 \"a, b\",1.0,0,-0.,.8,0,6e-1\n# between\n,-1,0,0,1,0,0\n";
    let table = done(&["eval", "lambertian_reflection:reflectance=.5"], input);
    let value = 0.5 * std::f64::consts::FRAC_1_PI;
    let pdf = std::f64::consts::FRAC_1_PI;
    assert_eq!(
        table,
        format!(
            "wo_x,wo_y,wo_z,wi_x,wi_y,wi_z,f_r,f_g,f_b,pdf\n\
             6e-1,0,.8,-0.,0,1.0,{value},{value},{value},{pdf}\n\
             0,0,1,0,0,-1,0,0,0,0\n"
        )
    );
}

#[test]
fn eval_of_no_rows_is_a_header() {
    assert_eq!(
        done(&["eval", "oren_nayar"], HEADER),
        "wo_x,wo_y,wo_z,wi_x,wi_y,wi_z,f_r,f_g,f_b,pdf\n"
    );
}

#[test]
fn eval_in_every_precision_agrees_with_the_formula() {
    // GGX with F = 1 at normal incidence, wh half way to wi: D / (2 (t_i + mu_i)), t the stretched length.
    let (alpha, wi) = (0.3_f64, [0.6_f64, 0.8]);
    let (wh_x, wh_z) = (0.6 / 3.6_f64.sqrt(), 1.8 / 3.6_f64.sqrt());
    let q = (wh_x / alpha).powi(2) + wh_z * wh_z;
    let d = 1.0 / (std::f64::consts::PI * alpha * alpha * q * q);
    let t = (wi[1] * wi[1] + (alpha * wi[0]).powi(2)).sqrt();
    let expected = d / (2.0 * (t + wi[1]));
    let input = format!("{HEADER}0,0,1,0.6,0,0.8\n");
    let mut values = Vec::new();
    // Tolerances: some ten roundings of the precision; the reference is as good as the f64 formula above.
    for (precision, tolerance) in [("f32", 2e-6), ("f64", 4e-15), ("reference", 4e-15)] {
        let material = "rough_conductor:fresnel=one,alpha=0.3";
        let table = done(&["eval", material, "--precision", precision], &input);
        let row = numbers(&rows(&table)[0]);
        assert!(
            (row[6] / expected - 1.0).abs() < tolerance,
            "{precision}: {row:?}"
        );
        values.push(row[6]);
    }
    assert!(values[0] != values[1], "f32 is f32");
    assert_eq!(values[0], f64::from(values[0] as f32));
    assert_eq!(
        done(
            &["eval", "rough_conductor:fresnel=one,alpha=0.3"],
            &format!("{HEADER}0,0,1,0.6,0,0.8\n")
        ),
        done(
            &[
                "eval",
                "rough_conductor:fresnel=one,alpha_x=0.3,alpha_y=0.3",
                "--precision",
                "f64"
            ],
            &format!("{HEADER}0,0,1,0.6,0,0.8\n")
        ),
    );
}

#[test]
fn eval_works_from_file_to_file_even_the_same() {
    let folder = folder("from_file_to_file");
    let file = folder.join("rows.csv");
    let path = file.to_str().unwrap();
    let input = format!("# a comment\n{HEADER}0,0,1,0,0,1\n0,0,-1,0.6,0,-0.8\n");
    fs::write(&file, &input).unwrap();
    let expected = done(&["eval", "lambertian_reflection"], &input);
    assert_eq!(
        done(
            &["eval", "lambertian_reflection", "--in", path, "--out", path],
            ""
        ),
        ""
    );
    assert_eq!(fs::read_to_string(&file).unwrap(), expected);
    assert_eq!(
        done(
            &["eval", "lambertian_reflection", "--in", path, "--out", "-"],
            ""
        ),
        expected
    );
    assert_eq!(files_in(&folder), ["rows.csv"]);
}

#[test]
fn eval_normalises_and_says_so_once() {
    let input = format!("{HEADER}0,0,2,0,0,1\n0,0,1,0,0,1\n0,0,1e-200,3e200,0,4e200\n");
    let output = run_with_input(&["eval", "oren_nayar"], &input);
    assert_eq!(output.status.code(), Some(0));
    assert_eq!(
        stderr(&output),
        "2 rows with directions that are not of unit length, normalised\n"
    );
    let unit = done(
        &["eval", "oren_nayar"],
        &format!("{HEADER}0,0,1,0,0,1\n0,0,1,0.6,0,0.8\n"),
    );
    let (found, unit) = (rows(stdout(&output)), rows(&unit));
    assert_eq!(found[0][..6], ["0", "0", "2", "0", "0", "1"]);
    assert_eq!(found[0][6..], unit[0][6..]);
    let (a, b) = (numbers(&found[2][6..]), numbers(&unit[1][6..]));
    assert!(a.iter().zip(b).all(|(a, b)| (a / b - 1.0).abs() < 1e-15));
}

#[test]
fn eval_refuses_bad_rows_by_their_line_and_leaves_no_file() {
    let folder = folder("bad_rows");
    let file = folder.join("out.csv");
    let path = file.to_str().unwrap();
    let good = "0,0,1,0,0,1\n";
    for (rows, expected) in [
        (
            "0,0,1,0,zero,1\n",
            "error: line 4: wi_y = 'zero' is not a number",
        ),
        (
            "0,0,1,0,0\n",
            "error: line 4: 5 fields where the header has 6",
        ),
        ("# x\n0,0,0,0,0,1\n", "error: line 5: wo has length 0"),
        ("0,0,1,0,inf,1\n", "error: line 4: wi_y = inf is not finite"),
        ("NaN,0,1,0,0,1\n", "error: line 4: wo_x = NaN is not finite"),
        (
            "1e999,0,1,0,0,1\n",
            "error: line 4: wo_x = 1e999 is not finite",
        ),
    ] {
        let input = format!("# first\n{HEADER}{good}{rows}{good}");
        let line = refused(&["eval", "oren_nayar", "--out", path], &input);
        assert_eq!(line, expected);
        assert_eq!(files_in(&folder), [""; 0]);
    }
    fs::write(&file, "kept").unwrap();
    refused(&["eval", "oren_nayar", "--out", path], "wo_x\n0\n");
    assert_eq!(fs::read_to_string(&file).unwrap(), "kept");
    assert_eq!(files_in(&folder), ["out.csv"]);
}

#[test]
fn eval_refuses_what_is_no_table() {
    let line = refused(&["eval", "oren_nayar"], "");
    assert!(line.contains("standard input: no header"), "{line}");
    let line = refused(&["eval", "oren_nayar"], "wo_x,wo_y,wo_z,wi_x,wi_y\n");
    assert_eq!(line, "error: line 1: no column 'wi_z'");
    let line = refused(&["eval", "oren_nayar", "--in", "no/such.csv"], "");
    assert!(line.starts_with("error: no/such.csv: "), "{line}");
    let nowhere = folder("no_table").join("no/such/folder.csv");
    let nowhere = nowhere.to_str().unwrap();
    let line = refused(&["eval", "oren_nayar", "--out", nowhere], HEADER);
    assert!(line.contains("folder.csv: "), "{line}");
}
