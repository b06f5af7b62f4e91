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
}

#[test]
fn threads_that_no_machine_runs_are_refused() {
    for threads in ["0", "-1", "1025", "3000", "1e3", "99999999999999999999"] {
        let line = refused(&["bench", "phong", "--threads", threads], "");
        let expected =
            format!("error: --threads '{threads}': expected a whole number from 1 to 1024");
        assert_eq!(line, expected);
    }
}

/// Threads that the machine cannot start are a message, not a panic.
#[cfg(target_os = "linux")]
#[test]
fn threads_beyond_the_memory_are_refused() {
    let program = env!("CARGO_BIN_EXE_brdf-explorer");
    let script = format!("ulimit -v 1000000; exec '{program}' bench phong --threads 1000");
    let output = std::process::Command::new("sh")
        .args(["-c", &script])
        .output()
        .unwrap();
    let message = super::stderr(&output);
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert_eq!(message.lines().count(), 1, "{message}");
    assert!(
        message.starts_with("error: 1000 threads cannot be started: ")
            && message.ends_with("; fewer --threads may do\n"),
        "{message}"
    );
}

#[test]
fn pairs_that_are_none_are_refused_and_lengths_are_said() {
    let path = folder("bench_pairs").join("pairs.bin");
    let text = path.to_str().unwrap();
    let with = |changes: &[(usize, f32)]| {
        let mut arrays = [0.0_f32, 0.0, 1.0, 0.0, 0.0, 1.0, 0.5, 0.5, 0.5].map(|x| [x; 128]);
        for (array, value) in changes {
            arrays[*array][7] = *value;
        }
        let bytes: Vec<u8> = arrays
            .as_flattened()
            .iter()
            .flat_map(|x| x.to_le_bytes())
            .collect();
        std::fs::write(&path, bytes).unwrap();
    };
    for (changes, expected) in [
        (&[(0, f32::NAN)][..], "pair 7: wo = NaN,0,1 is not finite"),
        (&[(5, f32::INFINITY)], "pair 7: wi = 0,0,inf is not finite"),
        (&[(2, 0.0)], "pair 7: wo has length 0"),
        (
            &[(6, 1.0)],
            "pair 7: uc = 1: expected 0 or more, and less than 1",
        ),
        (&[(8, -0.5)], "pair 7: u1 = -0.5: expected"),
        (&[(7, f32::NAN)], "pair 7: u0 = NaN: expected"),
    ] {
        with(changes);
        let line = refused(&["bench", "phong", "--pairs", text], "");
        assert!(line.contains(expected), "{line}");
    }
    with(&[(2, 0.5), (3, 3.0)]);
    let only = ["--precision", "f32", "--path", "plain"];
    let words = [
        &["bench", "lambertian_reflection", "--pairs", text][..],
        &only,
    ]
    .concat();
    let output = super::run_with_input(&words, "");
    assert_eq!(output.status.code(), Some(0));
    assert_eq!(
        super::stderr(&output),
        "1 pair with directions that are not of unit length, normalised\n"
    );
    let line = refused(&["bench", "phong", "--pairs", "/dev/zero"], "");
    assert!(line.contains("more than 144 MiB"), "{line}");
}
