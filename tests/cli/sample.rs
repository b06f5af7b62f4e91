//! `sample`: reproducible rows that agree with `eval`, deltas, lost samples.

use super::{HEADER, done, files_in, folder, numbers, refused, rows};

#[test]
fn samples_repeat_by_seed_and_agree_with_eval() {
    let material = "rough_conductor:alpha_x=0.2,alpha_y=0.6";
    let sample = |seed: &str, precision: &str| {
        let arguments = [
            "sample", material, "--wo", "70,-20", "-n", "200", "--seed", seed,
        ];
        done(&[&arguments[..], &["--precision", precision]].concat(), "")
    };
    let table = sample("7", "f64");
    assert_eq!(table, sample("7", "f64"));
    assert_ne!(table, sample("8", "f64"));
    assert!(table.starts_with("u0,u1,uc,wi_x,wi_y,wi_z,f_r,f_g,f_b,pdf,delta\n"));
    let rows = rows(&table);
    assert_eq!(rows.len(), 200);
    let (sin_theta, cos_theta) = 70_f64.to_radians().sin_cos();
    let (sin_phi, cos_phi) = (-20_f64).to_radians().sin_cos();
    let wo = format!(
        "{},{},{cos_theta}",
        sin_theta * cos_phi,
        sin_theta * sin_phi
    );
    let mut input = HEADER.to_owned();
    let mut drawn = Vec::new();
    for row in &rows {
        assert_eq!(row.len(), 11);
        let u = numbers(&row[..3]);
        assert!(u.iter().all(|u| (0.0..1.0).contains(u)), "{row:?}");
        assert_eq!(row[10], "0");
        if row[3].is_empty() {
            assert_eq!(row[3..], ["", "", "", "", "", "", "0", "0"]);
        } else {
            input += &[&wo, row[3], row[4], row[5]].join(",");
            input.push('\n');
            drawn.push(numbers(&row[6..10]));
        }
    }
    assert!(drawn.len() > 150 && drawn.len() < 200, "{}", drawn.len());
    let values = done(&["eval", material], &input);
    for (row, drawn) in super::rows(&values).iter().zip(drawn) {
        for (value, drawn) in numbers(&row[6..10]).iter().zip(drawn) {
            // wo is spelled out anew here, a rounding away from the one that was sampled.
            assert!((value / drawn - 1.0).abs() < 1e-12, "{value} {drawn}");
        }
    }
    for precision in ["f32", "reference"] {
        let other = sample("7", precision);
        let (a, b) = (numbers(&super::rows(&other)[0]), numbers(&rows[0]));
        // f32: a few hundred round-offs after the warp.
        assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-4));
    }
}

#[test]
fn delta_samples_carry_weight_over_cosine_and_probability() {
    let table = done(
        &["sample", "fresnel_specular", "--wo", "0,0", "-n", "100"],
        "",
    );
    let mut reflected = 0;
    for row in rows(&table) {
        assert_eq!(row[10], "1");
        let row = numbers(&row);
        // Reflectance of glass at normal incidence; radiance is divided by eta^2 on the way in.
        let (probability, weight) = if row[5] > 0.0 {
            reflected += 1;
            (0.04, 0.04)
        } else {
            (0.96, 0.96 / 2.25)
        };
        assert_eq!((row[3].abs(), row[4].abs(), row[5].abs()), (0.0, 0.0, 1.0));
        assert!((row[9] - probability).abs() < 1e-15, "{row:?}");
        assert!((row[6] - weight).abs() < 1e-15, "{row:?}");
    }
    assert!(reflected < 15, "{reflected}");
}

#[test]
fn lost_samples_are_rows_too() {
    // From below, beyond the critical angle of 41.8 degrees.
    let table = done(
        &[
            "sample",
            "specular_transmission",
            "--wo",
            "120,0",
            "-n",
            "3",
        ],
        "",
    );
    for row in rows(&table) {
        assert_eq!(row[3..], ["", "", "", "", "", "", "0", "0"]);
    }
    let none = done(&["sample", "oren_nayar", "--wo", "10,0", "-n", "0"], "");
    assert_eq!(none.lines().count(), 1);
}

#[test]
fn sample_refuses_bad_numbers_and_leaves_no_file() {
    let folder = folder("bad_sample");
    let path = folder.join("out.csv");
    let path = path.to_str().unwrap();
    for (wo, n, seed, expected) in [
        ("181,0", "1", "1", "theta '181': expected 0 to 180 degrees"),
        ("-1,0", "1", "1", "theta '-1'"),
        ("nan,0", "1", "1", "theta 'nan'"),
        ("30,inf", "1", "1", "phi 'inf'"),
        ("30", "1", "1", "expected THETA,PHI in degrees"),
        ("30,0", "-1", "1", "-n '-1': expected a whole number"),
        ("30,0", "1.5", "1", "-n '1.5': expected a whole number"),
        ("30,0", "2000000000", "1", "the limit is 1000000000 samples"),
        ("30,0", "1", "x", "--seed 'x': expected a whole number"),
    ] {
        let arguments = [
            "sample",
            "oren_nayar",
            "--wo",
            wo,
            "-n",
            n,
            "--seed",
            seed,
            "--out",
            path,
        ];
        let line = refused(&arguments, "");
        assert!(line.contains(expected), "{line}");
    }
    assert_eq!(files_in(&folder), [""; 0]);
}

#[test]
fn a_seed_gives_the_samples_of_the_view() {
    use brdf_explorer::analysis::sampling::{Part, Request};
    use brdf_explorer::analysis::{Detail, HeldLobe, Hold, Query, Subject};
    use brdf_explorer::bxdf::material::{file, library};
    use brdf_explorer::bxdf::math::frame::direction_from_degrees;

    let mixture = folder("seed").join("mixture.toml");
    let text = "[[lobes]]\nmodel = \"phong\"\nweight = 0.4\n[[lobes]]\nmodel = \"thin_dielectric\"\nweight = 0.5\n";
    std::fs::write(&mixture, text).unwrap();
    let mixture = mixture.to_str().unwrap();
    // Beyond the draws that are made together, and not a whole number of them.
    let count = 5000;
    for (given, material) in [
        ("gold", library::read("gold").unwrap()),
        (
            "principled:metallic=0.5",
            library::read("principled:metallic=0.5").unwrap(),
        ),
        (
            "rough_dielectric",
            library::read("rough_dielectric").unwrap(),
        ),
        (mixture, file::parse(text, "mixture").unwrap()),
    ] {
        let count_text = count.to_string();
        let words = [
            "sample",
            given,
            "--wo",
            "40,20",
            "-n",
            &count_text,
            "--seed",
            "11",
        ];
        let table = done(&words, "");
        let rows = rows(&table);
        let model = material.build();
        let held = direction_from_degrees(40.0, 20.0);
        let subject = Subject::of(HeldLobe::new(&*model, Hold::Viewer, held));
        let request = Request {
            part: Part::Points,
            count: 8192,
            seed: 11,
            phi: 0.0,
        };
        let study = request.answer(&subject, Detail::Full, &|| true).unwrap();
        let drawn: Vec<&Vec<&str>> = rows.iter().filter(|row| !row[3].is_empty()).collect();
        assert!(drawn.len() > count / 2 && drawn.len() < study.points.len());
        for (row, point) in drawn.into_iter().zip(&study.points) {
            let row = numbers(row);
            assert_eq!(row[..2], point.u, "{given}");
            assert_eq!(
                (row[2], row[10] == 1.0),
                (point.uc, point.is_delta),
                "{given}"
            );
            assert_eq!(row[3..6], point.direction.to_array(), "{given}");
            for (f, weight) in row[6..9].iter().zip(point.weight) {
                assert_eq!(f * row[5].abs() / row[9], weight, "{given}");
            }
        }
    }
}
