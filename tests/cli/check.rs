//! `check`: laws and extremes, as other programs read them.

use super::{Json, done, json, refused};

fn extremes(words: &[&str]) -> Json {
    json(&done(words, ""))
}

#[test]
fn extremes_are_reported_by_case_and_precision() {
    let material = "rough_dielectric:eta=1.33,alpha=0.05";
    let report = extremes(&["check", material, "--extremes", "--json"]);
    let models = report["models"].as_array().unwrap();
    let [model] = &models[..] else {
        panic!("{models:?}");
    };
    assert_eq!(model["laws"].as_array().map(Vec::len), Some(0));
    let extremes = model["extremes"].as_array().unwrap();
    for case in [
        "grazing",
        "mirror",
        "critical",
        "subnormal",
        "sampler_ends",
        "climb",
    ] {
        for precision in ["f32", "f64"] {
            let is_it = |one: &&Json| one["case"] == case && one["precision"] == precision;
            let found = extremes.iter().find(is_it);
            let found = found.unwrap_or_else(|| panic!("{case} {precision}: {extremes:?}"));
            assert!(found["n"].as_u64().unwrap() > 20, "{found}");
            assert_eq!(
                [
                    &found["non_finite"],
                    &found["negative"],
                    &found["misplaced"]
                ],
                [0, 0, 0]
            );
            let ratio = found["max_bound_ratio"].as_f64().unwrap();
            assert!(ratio <= found["allowed_ratio"].as_f64().unwrap(), "{found}");
            assert!(found["max_rel_error"].as_f64().unwrap() >= 0.0);
        }
    }
    let worst = &extremes.iter().find(|one| one["case"] == "mirror").unwrap()["worst"];
    assert_eq!(
        worst["params"],
        "rough_dielectric:eta=1.33,alpha_x=0.05,alpha_y=0.05"
    );
    for direction in ["wo", "wi"] {
        assert_eq!(
            worst[direction].as_array().map(Vec::len),
            Some(3),
            "{worst}"
        );
    }
    assert_eq!(report["summary"]["unstable"], 0);
}

#[test]
fn a_check_has_laws_and_extremes() {
    let report = extremes(&["check", "lambertian_reflection", "--json"]);
    let model = &report["models"][0];
    assert_eq!(model["laws"].as_array().map(Vec::len), Some(13));
    assert!(
        model["extremes"]
            .as_array()
            .is_some_and(|all| all.len() > 20)
    );
    let text = done(&["check", "lambertian_reflection", "--extremes"], "");
    assert!(
        text.contains("subnormal") && text.contains("0 extremes unstable"),
        "{text}"
    );
    assert!(!text.contains("pdf_integral"), "{text}");
}

#[test]
fn what_makes_no_sense_is_refused() {
    assert!(refused(&["check", "golt", "--extremes"], "").contains("unknown"));
    for words in [
        &["check", "gold", "--points", "10"][..],
        &["check", "gold", "--markdown"],
        &["check", "--all", "--points", "-1"],
        &["check", "--extremes"],
    ] {
        refused(words, "");
    }
}

/// The laws of a material, and the exit code.
fn laws(material: &str) -> (Vec<Json>, i32) {
    let output = super::run_with_input(&["check", material, "--json"], "");
    let report = json(super::stdout(&output));
    let laws = report["models"][0]["laws"].as_array().unwrap().clone();
    (laws, output.status.code().unwrap())
}

fn one<'a>(laws: &'a [Json], law: &str) -> &'a Json {
    laws.iter().find(|one| one["law"] == law).unwrap()
}

#[test]
fn a_check_of_a_material_is_of_that_material() {
    for (material, expected) in [
        ("gold", [("energy", "ok", 0.0), ("reciprocity", "ok", 0.0)]),
        (
            "phong:diffuse=.3,specular=.3",
            [("energy", "ok", 0.0), ("reciprocity", "ok", 0.0)],
        ),
        (
            "phong:diffuse=.9,specular=.9",
            [("energy", "declared", 0.8), ("reciprocity", "ok", 0.0)],
        ),
    ] {
        let (laws, exit) = laws(material);
        assert_eq!(exit, 0, "{material}");
        for (law, status, worst) in expected {
            let report = one(&laws, law);
            assert_eq!(report["status"], status, "{material}: {report}");
            let found = report["worst"].as_f64().unwrap();
            assert!((found - worst).abs() < 1e-3, "{material}: {report}");
            let mut keys: Vec<&String> = report.as_object().unwrap().keys().collect();
            keys.sort();
            assert_eq!(keys, ["error", "law", "n", "status", "witness", "worst"]);
        }
    }
}

#[test]
fn a_check_says_where_and_why_a_law_is_broken() {
    let folder = super::folder("check");
    let heavy = folder.join("heavy.toml");
    let lobe = "[[lobes]]\nmodel = \"lambertian_reflection\"\nreflectance = 0.5\nweight = ";
    std::fs::write(&heavy, format!("{lobe}3\n")).unwrap();
    let path = heavy.to_str().unwrap();
    let output = super::run_with_input(&["check", path], "");
    assert_eq!(output.status.code(), Some(1));
    let text = super::stdout(&output);
    for expected in [
        "energy         violated        5.00e-1",
        "share of the flux created at 3 * lambertian_reflection:reflectance=0.5 wi (",
        "50 % more leaves than arrives, because its weight is 3",
        "limits         -",
    ] {
        assert!(text.contains(expected), "{expected}: {text}");
    }
    std::fs::write(&heavy, format!("{lobe}4e38\n")).unwrap();
    let line = refused(&["check", path], "");
    assert!(
        line.contains("allowed is a number from 0 to 1000"),
        "{line}"
    );
}
