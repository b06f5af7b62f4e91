use std::f64::consts::PI;

use super::*;
use bxdf::Material;
use bxdf::math::frame::direction_from_degrees;

/// A scene with the light to the left and the viewer to the right, at these angles.
fn scene(material: &str, light_deg: f64, viewer_deg: f64) -> Scene {
    let material: Material = material.parse().unwrap();
    let light = direction_from_degrees(light_deg, 180.0);
    Scene::new(
        material,
        0.0,
        light,
        direction_from_degrees(viewer_deg, 0.0),
    )
}

fn given(arguments: &[&str]) -> Vec<Given> {
    let one = |word: &&str| {
        let number = word.parse().map(Given::Number);
        number.unwrap_or_else(|_| Given::Word((*word).to_owned()))
    };
    arguments.iter().map(one).collect()
}

fn value(scene: &Scene, id: &str, arguments: &[&str]) -> f64 {
    let quantity = find(id).unwrap();
    quantity.value(scene, &given(arguments)).unwrap()
}

/// A mirror of microfacets: its Fresnel factor is 1.
const WHITE: &str = "rough_conductor:distribution=ggx,eta=0,k=1e4,alpha=";

fn near(a: f64, b: f64, tolerance: f64) {
    assert!((a - b).abs() <= tolerance * b.abs(), "{a} for {b}");
}

#[test]
fn every_quantity_says_what_it_is_and_is_found() {
    let ids: Vec<&str> = all().map(|quantity| quantity.id).collect();
    for quantity in all() {
        assert!(std::ptr::eq(find(quantity.id).unwrap(), quantity));
        assert_eq!(ids.iter().filter(|id| **id == quantity.id).count(), 1);
        assert!(!quantity.symbol.is_empty() && !quantity.meaning.ends_with('.'));
        let optional = quantity.arguments.iter().map(|one| one.is_optional);
        assert!(optional.is_sorted(), "{}", quantity.form());
    }
    let line = find("rho_ht").err().unwrap().to_string();
    assert!(line.contains("rho_h"), "{line}");
}

#[test]
fn arguments_are_checked() {
    for (id, arguments, expected) in [
        ("share", &[][..], "it is written 'share(diffuse|"),
        ("f", &["red", "red"], "it is written 'f([luminance|red"),
        (
            "angle",
            &["moon"],
            "the of 'moon': allowed is light, viewer",
        ),
        (
            "theta_m",
            &["2"],
            "the u '2': allowed is a number from 0 to 1",
        ),
        ("parameter", &["3"], "expected a name"),
    ] {
        let line = find(id).unwrap().check(&given(arguments)).unwrap_err();
        assert!(line.contains(expected), "{line}");
    }
    assert_eq!(find("integral").unwrap().check(&given(&["1"])), Ok(()));
}

/// The answers of the questions that students ask most, to the digits that they are told in.
#[test]
fn known_answers() {
    let lambert = scene("lambertian_reflection:reflectance=.5", 30.0, 0.0);
    near(value(&lambert, "integral", &["1"]), 2.0 * PI, 1e-12);
    near(value(&lambert, "integral", &["cos"]), PI, 1e-12);
    near(value(&lambert, "f", &[]), 0.159, 2e-3);
    near(value(&lambert, "pi_f", &[]), 0.5, 1e-12);
    near(
        value(&lambert, "f_cos", &["red"]),
        0.159 * 0.75f64.sqrt(),
        2e-3,
    );
    for id in ["rho_dh", "rho_hd", "rho_hh"] {
        near(value(&lambert, id, &[]), 0.5, 1e-4);
    }
    near(value(&lambert, "integral", &["f_cos"]), 0.5, 1e-4);
    near(value(&lambert, "integral", &["pdf"]), 1.0, 1e-4);
    near(value(&lambert, "share", &["diffuse"]), 0.5, 1e-4);
    assert_eq!(value(&lambert, "share", &["diffuse", "transmission"]), 0.0);

    let narrow = scene(&format!("{WHITE}.1"), 0.0, 0.0);
    near(value(&narrow, "f", &[]), 7.96, 1e-3);
    near(value(&narrow, "rho_dh", &[]), 0.988, 1e-3);
    near(
        value(&scene(&format!("{WHITE}.01"), 0.0, 0.0), "f", &[]),
        796.0,
        1e-3,
    );

    let mirror = scene("fresnel_specular:eta=1.5", 80.0, 80.0);
    near(value(&mirror, "delta", &["reflection"]), 0.3877, 1e-3);
    near(
        value(&mirror, "delta", &["transmission"]),
        1.0 - 0.3877,
        1e-3,
    );
    near(value(&mirror, "fresnel", &["mean"]), 0.3877, 1e-3);
    near(value(&mirror, "angle", &["brewster"]), 56.31, 1e-4);
    near(value(&mirror, "angle", &["transmitted"]), 41.04, 1e-3);
    near(
        value(
            &scene("fresnel_specular:eta=1.5", 120.0, 0.0),
            "angle",
            &["critical"],
        ),
        41.81,
        1e-4,
    );

    let wide = scene(&format!("{WHITE}.3"), 0.0, 0.0);
    near(value(&wide, "D", &[]), 3.54, 1e-3);
    near(value(&wide, "theta_m", &[".5"]), 16.7, 2e-3);
    near(value(&wide, "theta_m_mode", &[]), 10.2, 5e-3);
    near(value(&wide, "theta_m_mean", &[]), 20.8, 3e-3);
    let beckmann = WHITE.replace("ggx", "beckmann");
    let beckmann = scene(&format!("{beckmann}.3"), 0.0, 0.0);
    near(value(&beckmann, "theta_m", &[".5"]), 14.0, 4e-3);
    near(value(&beckmann, "theta_m_mode", &[]), 12.5, 5e-3);
    near(value(&beckmann, "theta_m_mean", &[]), 14.6, 4e-3);

    near(
        value(&scene(&format!("{WHITE}.3"), 60.0, 0.0), "jacobian", &[]),
        3.46,
        2e-3,
    );
    near(
        value(
            &scene(&format!("{WHITE}.3"), 60.0, 0.0),
            "angle",
            &["difference"],
        ),
        30.0,
        1e-9,
    );
    for (program, alpha) in [("disney", 0.25), ("pbrt_v4", 0.707), ("pbrt_v3", 1.13)] {
        near(
            value(&wide, "alpha_of_roughness", &[program, ".5"]),
            alpha,
            2e-3,
        );
    }
}

/// In closed form: theta_m of GGX is atan(alpha sqrt(u / (1 - u))), of Beckmann atan(alpha sqrt(-ln(1 - u))).
#[test]
fn inverse_distributions_are_the_closed_ones() {
    for alpha in [1e-3, 0.05, 0.3, 1.0] {
        let ggx = scene(&format!("{WHITE}{alpha}"), 0.0, 0.0);
        let beckmann = WHITE.replace("ggx", "beckmann");
        let beckmann = scene(&format!("{beckmann}{alpha}"), 0.0, 0.0);
        for u in [0.01, 0.3, 0.5, 0.99f64] {
            let tangents = [u / (1.0 - u), -(-u).ln_1p()].map(|x| alpha * x.sqrt());
            for (scene, tangent) in [&ggx, &beckmann].into_iter().zip(tangents) {
                let expected = tangent.atan().to_degrees();
                near(value(scene, "theta_m", &[&u.to_string()]), expected, 1e-5);
            }
        }
    }
}

/// In closed form: the density of theta_m of GGX is 2 alpha² tan sec² / (alpha² + tan²)² per radian.
#[test]
fn the_density_of_the_angle_is_the_closed_one() {
    let alpha = 0.3_f64;
    let ggx = scene(&format!("{WHITE}{alpha}"), 0.0, 0.0);
    for theta in [1.0_f64, 10.2, 60.0] {
        let (tan, cos) = (theta.to_radians().tan(), theta.to_radians().cos());
        let per_radian = 2.0 * alpha * alpha * tan / (cos * (alpha * alpha + tan * tan)).powi(2);
        let found = value(&ggx, "theta_m_density", &[&theta.to_string()]);
        near(found, per_radian.to_radians(), 1e-9);
    }
}

/// Of a Lambertian surface all samples by the cosine weigh the same, and those drawn evenly weigh 2 rho cos: their mean square is
/// 4 rho² / 3.
#[test]
fn variances_are_those_of_the_textbook() {
    let card = scene("lambertian_reflection:reflectance=.6", 30.0, 40.0);
    near(value(&card, "variance", &["uniform"]), 0.36 / 3.0, 0.05);
    for exact in ["cosine", "importance"] {
        assert!(value(&card, "variance", &[exact]) < 1e-20);
    }
    let narrow = scene(&format!("{WHITE}.1"), 30.0, 30.0);
    let [by_cosine, by_lobe] = ["cosine", "importance"].map(|by| value(&narrow, "variance", &[by]));
    assert!(by_cosine > 100.0 * by_lobe && by_lobe > 0.0);
}

/// What is drawn and lost, counted by the model's own sampler, which draws visible normals.
#[test]
fn lost_samples_are_those_of_the_sampler() {
    use crate::analysis::sampling::{Draw, Draws};
    use crate::analysis::{HeldLobe, Hold};
    for alpha in ["3", "5"] {
        let material = format!("{WHITE}.{alpha}");
        let scene = scene(&material, 80.0, 80.0);
        let lost = value(&scene, "lost_samples", &["visible"]);
        let lobe: HeldLobe<'_> = scene.held(Hold::Viewer);
        let count = 100_000;
        let draws = Draws::new(lobe.surface(), scene.viewer().into(), 1, 0, count);
        let counted = draws.iter().filter(Draw::is_lost).count() as f64 / count as f64;
        let deviation = (lost * (1.0 - lost) / count as f64).sqrt();
        assert!((lost - counted).abs() < 4.0 * deviation, "{lost} {counted}");
        assert!(value(&scene, "lost_samples", &["all"]) > 5.0 * lost);
    }
}

#[test]
fn laws_and_errors() {
    let phong = scene("phong", 60.0, 20.0);
    assert!(value(&phong, "deviation", &["reciprocity"]) >= 0.0);
    let gold = scene("rough_conductor:alpha=.2", 60.0, 50.0);
    assert!(value(&gold, "deviation", &["reciprocity"]) < 1e-12);
    assert_eq!(value(&gold, "deviation", &["energy"]), 0.0);
    let error = value(&gold, "error", &["f32"]);
    assert!(error > 1e-9 && error < 1e-4, "{error}");
    assert!(value(&gold, "error", &["f64"]) < 1e-12);
    let components = gold.material().components();
    let (first, _) = components[0].stand_ins().next().unwrap();
    assert!(value(&gold, "error", &[first.name]) > 1e-6);
    let line = find("error")
        .unwrap()
        .value(&gold, &given(&["f16"]))
        .unwrap_err();
    assert!(line.contains("there is f32, f64, "), "{line}");
    near(value(&gold, "parameter", &["alpha_x"]), 0.2, 1e-12);
    near(
        value(&gold, "F", &["red"]),
        value(&gold, "f", &["red"]) / (value(&gold, "D", &[]) * value(&gold, "G", &[]))
            * 4.0
            * gold.light().z
            * gold.viewer().z,
        1e-9,
    );
}

#[test]
fn what_is_undefined_says_why() {
    let chalk = scene("lambertian_reflection", 30.0, 0.0);
    for (id, arguments, expected) in [
        ("D", &[][..], "no single microfacet model"),
        ("theta_m", &[".5"], "no single microfacet model"),
        ("angle", &["brewster"], "no index of refraction"),
        ("parameter", &["alpha"], "unknown parameter 'alpha'"),
    ] {
        let line = find(id)
            .unwrap()
            .value(&chalk, &given(arguments))
            .unwrap_err();
        assert!(line.contains(expected), "{line}");
    }
    let line = find("rho_dh")
        .unwrap()
        .value(&scene("lambertian_reflection", 90.0, 0.0), &[]);
    assert!(line.is_err());
}

#[test]
fn scenes_are_changed_by_name() {
    let gold = scene("rough_conductor:alpha=.2", 60.0, 50.0)
        .with_light(30.0)
        .with_viewer(10.0);
    near(value(&gold, "angle", &["light"]), 30.0, 1e-9);
    near(value(&gold, "angle", &["viewer"]), 10.0, 1e-9);
    // At n there is no azimuth: each goes back to its own side.
    let apart = scene("rough_conductor:alpha=.2", 0.0, 0.0)
        .with_light(40.0)
        .with_viewer(40.0);
    assert!(apart.light().x < -0.6 && apart.viewer().x > 0.6);
    let wide = gold.clone().with_parameter("alpha", ".4").unwrap();
    near(value(&wide, "parameter", &["alpha_y"]), 0.4, 1e-12);
    for (name, text, expected) in [
        ("alpha", "7", "alpha"),
        ("alpha", "steep", "alpha"),
        ("flavour", "1", "unknown parameter 'flavour'"),
    ] {
        let line = gold.clone().with_parameter(name, text).err().unwrap();
        assert!(line.contains(expected), "{line}");
    }
}
