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
