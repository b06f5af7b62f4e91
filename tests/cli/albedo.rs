//! `albedo`: reflectances, shares and isotropy.

use super::{done, json, refused};

#[test]
fn albedo_reports_where_the_light_goes() {
    let report = json(&done(&["albedo", "lambertian_reflection", "--json"], ""));
    assert_eq!(report["material"], "lambertian_reflection");
    assert_eq!(report["phi"], 0.0);
    assert_eq!(report["isotropic"]["declared"], true);
    assert_eq!(report["isotropic"]["measured"], true);
    let rows = report["rows"].as_array().unwrap();
    assert_eq!(rows.len(), 4);
    for (row, theta) in rows.iter().zip([0.0, 30.0, 60.0, 85.0]) {
        assert_eq!(row["theta"], theta);
        for (name, expected) in [
            ("reflection", 0.8),
            ("transmission", 0.0),
            ("absorbed", 0.2),
        ] {
            for channel in 0..3 {
                let found = row[name][channel].as_f64().unwrap();
                // The error asked of the quadrature.
                assert!((found - expected).abs() < 2e-9, "{name}: {found}");
            }
        }
        assert!(row["error"].as_f64().unwrap() <= 1e-9);
        assert_eq!(row["shares"]["diffuse"]["reflection"], row["reflection"]);
    }
}

#[test]
fn albedo_tells_sides_azimuths_and_anisotropy_apart() {
    let report = json(&done(
        &["albedo", "fresnel_specular", "--theta", "0,180", "--json"],
        "",
    ));
    for row in report["rows"].as_array().unwrap() {
        let specular = &row["shares"]["perfect_specular"];
        assert!((specular["reflection"][0].as_f64().unwrap() - 0.04).abs() < 1e-12);
        assert!((specular["transmission"][2].as_f64().unwrap() - 0.96).abs() < 1e-12);
    }
    let report = json(&done(
        &[
            "albedo",
            "rough_conductor:alpha_x=0.1,alpha_y=0.5",
            "--phi",
            "-90",
            "--theta",
            "45",
            "--json",
        ],
        "",
    ));
    assert_eq!(report["phi"], -90.0);
    assert_eq!(report["isotropic"]["declared"], false);
    assert_eq!(report["isotropic"]["measured"], false);
    let text = done(&["albedo", "lambertian_reflection", "--theta", "10"], "");
    assert!(text.contains("0.800000 0.800000 0.800000"), "{text}");
    // No light arrives in the surface plane: no share is 0, or 1, of nothing.
    let at_horizon = ["albedo", "gold", "--theta", "90,89.999"];
    let text = done(&at_horizon, "");
    let row = text.lines().find(|line| line.starts_with("     90 "));
    let words: Vec<&str> = row.unwrap().split_whitespace().collect();
    assert_eq!(words, ["90", "-", "-", "-", "-"]);
    assert!(text.contains("At 90 degrees no light arrives"), "{text}");
    let report = json(&done(&[&at_horizon[..], &["--json"]].concat(), ""));
    assert!(report["rows"][0]["absorbed"].is_null());
    assert!(report["rows"][1]["reflection"][0].as_f64().unwrap() > 0.99);
    for (option, value, expected) in [
        ("--theta", "10,190", "theta '190': expected 0 to 180"),
        ("--theta", "", "theta ''"),
        ("--phi", "nan", "phi 'nan': expected a finite number"),
    ] {
        let line = refused(&["albedo", "oren_nayar", option, value], "");
        assert!(line.contains(expected), "{line}");
    }
}

#[test]
fn a_material_file_stands_for_its_material() {
    let file = std::env::temp_dir().join(format!(
        "brdf-explorer-material-{}.toml",
        std::process::id()
    ));
    std::fs::write(
        &file,
        "[[lobes]]\nmodel = \"lambertian_reflection\"\nreflectance = 0.25\n",
    )
    .unwrap();
    let run = || {
        std::process::Command::new(env!("CARGO_BIN_EXE_brdf-explorer"))
            .arg("albedo")
            .arg(&file)
            .args(["--theta", "30", "--json"])
            .output()
            .unwrap()
    };
    let output = run();
    let report: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert!((report["rows"][0]["reflection"][0].as_f64().unwrap() - 0.25).abs() < 1e-9);
    std::fs::write(
        &file,
        "[[lobes]]\nmodel = \"lambertian_reflection\"\nreflectance = 2\n",
    )
    .unwrap();
    let output = run();
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(
        message.contains("line 3") && message.trim_end().lines().count() == 1,
        "{message}"
    );
    std::fs::remove_file(&file).unwrap();
    assert_eq!(run().status.code(), Some(2), "a missing file");
}
