//! `tradeoff`: what accuracy costs, as other programs read it.

use super::{Json, done, json, refused};

#[test]
fn tradeoff_reports_points_slopes_and_advice() {
    let words = [
        "tradeoff",
        "rough_conductor:alpha=0.3",
        "--family",
        "stand_ins",
        "--tolerance",
        "0.05",
        "--json",
    ];
    let report = json(&done(&words, ""));
    assert_eq!(report["material"], "rough_conductor");
    assert!(
        report["machine"]
            .as_str()
            .is_some_and(|text| !text.is_empty())
    );
    let families = report["families"].as_array().unwrap();
    let [family] = &families[..] else {
        panic!("{families:?}");
    };
    assert_eq!(family["id"], "stand_ins");
    assert_eq!(family["cost_unit"], "evaluation");
    assert!(
        family["reference"]
            .as_str()
            .is_some_and(|text| !text.is_empty())
    );
    assert!(family["not_applicable"].is_null() && family["slopes"].is_object());
    let points = family["points"].as_array().unwrap();
    let named = |name: &str| points.iter().find(|point| point["choice"] == name).unwrap();
    let exact = named("as it is");
    assert_eq!(exact["error_rms"], 0.0);
    assert!(exact["worst"].is_null() && exact["n"].is_null());
    let schlick = named("Schlick for exact Fresnel");
    for number in [
        "cost_ns",
        "error_rms",
        "error_max",
        "albedo_error",
        "delta_e",
    ] {
        assert!(
            schlick[number].as_f64().unwrap() > 0.0,
            "{number}: {schlick}"
        );
    }
    for direction in ["wo", "wi"] {
        let w = schlick["worst"][direction].as_array().unwrap();
        let square: f64 = w.iter().map(|x| x.as_f64().unwrap().powi(2)).sum();
        assert!((square - 1.0).abs() < 1e-6, "{direction}");
    }
    let is_front = |point: &&Json| point["pareto"].as_bool().unwrap();
    assert!(points.iter().any(|point| is_front(&point)));
    let advice = report["advice"].as_array().unwrap();
    for id in ["stand_ins", "material"] {
        let own = advice.iter().find(|one| one["family"] == id).unwrap();
        assert_eq!(own["tolerance"], 0.05);
        assert!(own["error_rms"].as_f64().unwrap() <= 0.05, "{own}");
        assert!(own["cost_ns"].as_f64().unwrap() > 0.0 && own["choice"].is_string());
    }
}

#[test]
fn a_tolerance_that_nothing_meets_names_the_closest() {
    let words = [
        "tradeoff",
        "phong",
        "--family",
        "tables",
        "--tolerance",
        "0",
    ];
    let text = done(&words, "");
    assert!(text.contains("nothing meets it; closest: "), "{text}");
    let words = ["tradeoff", "fresnel_specular", "--family", "tables"];
    assert!(done(&words, "").contains("not applicable: its light is all in Dirac deltas"));
}

#[test]
fn points_are_rows_of_csv() {
    let words = ["tradeoff", "gold", "--family", "channels", "--csv"];
    let text = done(&words, "");
    let mut lines = text.lines();
    let columns = lines.next().unwrap().split(',').count();
    let rows: Vec<&str> = lines.collect();
    // Three colours, and three numbers of wavelengths.
    assert_eq!(rows.len(), 4);
    assert!(
        rows.iter().all(|row| row.starts_with("channels,")),
        "{rows:?}"
    );
    assert!(columns > 8);
}

#[test]
fn what_is_no_family_or_tolerance_is_refused() {
    let line = refused(&["tradeoff", "phong", "--family", "table"], "");
    assert!(
        line.contains("unknown family 'table'; nearest: tables"),
        "{line}"
    );
    for tolerance in ["-1", "nan", "inf", "much"] {
        let option = format!("--tolerance={tolerance}");
        let line = refused(&["tradeoff", "phong", &option], "");
        assert!(line.contains("expected a number, 0 or more"), "{line}");
    }
    let line = refused(&["tradeoff", "phong", "--json", "--csv"], "");
    assert!(line.contains("--csv"), "{line}");
}
