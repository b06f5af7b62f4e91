use glam::DVec3;

use super::*;
use crate::analysis::Hold;
use bxdf::Material;
use bxdf::math::frame::direction_from_degrees;
use bxdf::models::MODELS;

fn study(material: &str, theta_deg: f64, count: usize) -> Study {
    study_of(&material.parse().unwrap(), theta_deg, count, 1)
}

fn study_of(material: &Material, theta_deg: f64, count: usize, seed: u64) -> Study {
    let model = material.build();
    let held = direction_from_degrees(theta_deg, 20.0);
    let subject = Subject::of(HeldLobe::new(&*model, Hold::Light, held));
    let request = Request {
        part: Part::All,
        count,
        seed,
        phi: 20.0_f64.to_radians(),
    };
    request.answer(&subject, Detail::Full, &|| true).unwrap()
}

#[test]
fn one_seed_gives_one_study() {
    let material: Material = "principled".parse().unwrap();
    let [a, b, c] = [5, 5, 6].map(|seed| study_of(&material, 40.0, 3000, seed));
    assert_eq!(a, b);
    assert!(a.points[0].u != c.points[0].u);
    assert_eq!(a.points.len() + a.lost, 3000);
}

#[test]
fn lost_draws_are_counted_among_those_of_no_weight() {
    let grazing = study("rough_conductor:alpha=0.5", 80.0, 4096);
    let lost = grazing.lost as f64 / 4096.0;
    assert!(lost > 0.02 && grazing.weights.zeros >= lost, "{lost}");
}

#[test]
fn a_diffuse_lobe_is_sampled_as_it_should_be() {
    let white = study("lambertian_reflection:reflectance=0.5", 50.0, 8192);
    assert_eq!((white.points.len(), white.lost), (8192, 0));
    // All weights are the reflectance: one bin, no variance.
    let [bin] = white.weights.bins[..] else {
        panic!("{:?}", white.weights);
    };
    assert_eq!(bin.count, 8192);
    assert!((bin.log10[0]..bin.log10[1]).contains(&0.5_f64.log10()));
    assert!((white.weights.mean - 0.5).abs() < 1e-12 && white.weights.zeros == 0.0);
    let [importance, cosine, uniform] = white.estimators;
    assert!((importance.mean - 0.5).abs() < 1e-12 && importance.variance < 1e-24);
    assert!((cosine.mean - 0.5).abs() < 1e-12 && cosine.variance < 1e-24);
    // f cos / pdf = 0.5 * 2 mu, mu uniform: variance 1/12.
    assert!((uniform.mean - 0.5).abs() < 4.0 * uniform.standard_error);
    assert!((uniform.variance - 1.0 / 12.0).abs() < 0.005, "{uniform:?}");
    // The curves are one: cos / pi.
    for density in &white.densities {
        let expected = density.angle_deg.to_radians().cos() / std::f64::consts::PI;
        assert!((density.pdf - density.f_cos).abs() < 1e-6);
        assert!((density.pdf - expected).abs() < 1e-6);
    }
}

#[test]
fn cells_are_those_that_an_integral_by_hand_gives() {
    let white = study("lambertian_reflection", 30.0, 4096);
    let histogram = &white.histogram;
    let observed: usize = histogram.cells.iter().map(|cell| cell.observed).sum();
    assert_eq!(observed, 4096);
    let whole: f64 = histogram.cells.iter().map(|cell| cell.solid_angle).sum();
    assert!((whole - 4.0 * std::f64::consts::PI).abs() < 1e-9);
    for cell in &histogram.cells {
        // The integral of cos / pi between two polar angles and two azimuths.
        let [a, b] = cell.theta.map(|theta| theta.sin().powi(2));
        let turn = (cell.phi[1] - cell.phi[0]) / std::f64::consts::TAU;
        let expected = if cell.theta[0] < 1.5 {
            (b - a) * turn
        } else {
            0.0
        };
        assert!(
            (cell.expected - 4096.0 * expected).abs() < 1e-2,
            "{cell:?} {expected}"
        );
    }
}

#[test]
fn samples_follow_the_density_of_every_model() {
    for model in MODELS {
        for theta in [0.0, 35.0, 80.0] {
            let study = study_of(&Material::of(model), theta, 8192, 3);
            let Histogram {
                degrees,
                p_value,
                expectation_error,
                ..
            } = study.histogram;
            // Some 80 tests: 1e-5 is a false alarm in 1e-3 of all runs.
            assert!(p_value > 1e-5, "{} {theta}: p = {p_value}", model.id);
            assert!(
                expectation_error < 0.1,
                "{} {theta}: {expectation_error}",
                model.id
            );
            assert!(
                degrees > 50 || model.is_delta_only(),
                "{} {theta}: {degrees}",
                model.id
            );
        }
    }
}

#[test]
fn narrow_lobes_have_cells_of_their_own() {
    for material in ["rough_conductor:alpha=0.001", "retro_reflector:alpha=0.001"] {
        for theta in [0.0, 60.0] {
            let Histogram {
                degrees, p_value, ..
            } = study(material, theta, 8192).histogram;
            assert!(
                degrees > 50 && p_value > 1e-4,
                "{material} {theta}: {degrees} {p_value}"
            );
        }
    }
}

#[test]
fn samples_that_follow_another_density_are_told() {
    let material: Material = "rough_conductor:alpha=0.3".parse().unwrap();
    let other: Material = "rough_conductor:alpha=0.35".parse().unwrap();
    let held = direction_from_degrees(40.0, 0.0);
    let (model, other) = (material.build(), other.build());
    let lobe = HeldLobe::new(&*model, Hold::Viewer, held);
    let draws = drawn(
        &HeldLobe::new(&*other, Hold::Viewer, held),
        8192,
        1,
        &|| true,
    )
    .unwrap();
    let histogram = Histogram::new(&lobe, &draws.points, draws.lost, 1, &|| true).unwrap();
    assert!(histogram.p_value < 1e-6, "{}", histogram.p_value);
}

#[test]
fn deltas_are_counted_apart() {
    let glass = study("fresnel_specular", 0.0, 4096);
    assert!(glass.points.iter().all(|point| point.is_delta));
    assert_eq!(
        (glass.histogram.deltas, glass.histogram.degrees),
        ([4096.0; 2], 0)
    );
    assert!(glass.densities.is_empty() && glass.estimators[0].mean == 0.0);
    assert!(
        (glass.weights.mean - 1.0).abs() < 0.6,
        "{}",
        glass.weights.mean
    );
    let pair = study("principled:metallic=0", 40.0, 4096);
    assert!(pair.estimators[0].variance < pair.estimators[2].variance);
}

#[test]
fn the_estimators_agree_on_both_sides_of_the_surface() {
    for material in [
        "rough_dielectric:alpha=0.4",
        "lambertian_transmission",
        "rough_conductor:alpha=0.3",
    ] {
        let [importance, cosine, uniform] = study(material, 40.0, 16384).estimators;
        for other in [cosine, uniform] {
            let gap = (importance.mean - other.mean).abs();
            let error = importance.standard_error.hypot(other.standard_error);
            assert!(
                gap <= 4.5 * error + 1e-12,
                "{material}: {importance:?} {other:?}"
            );
            assert!(importance.variance <= other.variance + 1e-12, "{material}");
        }
    }
}

#[test]
fn curves_of_both_densities_enclose_as_much() {
    // In the section of an isotropic lobe held along n, the integral over the sphere is that over the angle.
    let study = study("rough_conductor:fresnel=one,alpha=0.4", 0.0, 1024);
    let integral = |value: fn(&Density) -> f64| -> f64 {
        let ring =
            |d: &Density| value(d) * d.angle_deg.to_radians().sin().abs() * std::f64::consts::PI;
        let pieces = study.densities.windows(2);
        let areas = pieces.map(|pair| {
            let width = (pair[1].angle_deg - pair[0].angle_deg).to_radians();
            0.5 * (ring(&pair[0]) + ring(&pair[1])) * width
        });
        areas.sum()
    };
    assert!(
        (integral(|d| d.f_cos) - 1.0).abs() < 2e-3,
        "{}",
        integral(|d| d.f_cos)
    );
    let lost = study.lost as f64 / 1024.0;
    assert!(
        (integral(|d| d.pdf) + lost - 1.0).abs() < 0.02,
        "{}",
        integral(|d| d.pdf)
    );
    assert!(
        study
            .densities
            .windows(2)
            .all(|pair| pair[0].angle_deg <= pair[1].angle_deg)
    );
}

#[test]
fn the_coarse_study_begins_as_the_full_one() {
    let model = "phong".parse::<Material>().unwrap().build();
    let subject = Subject::of(HeldLobe::new(&*model, Hold::Viewer, DVec3::Z));
    let request = Request {
        part: Part::All,
        count: 4096,
        seed: 9,
        phi: 0.0,
    };
    let [coarse, full] = [Detail::Coarse, Detail::Full]
        .map(|detail| request.answer(&subject, detail, &|| true).unwrap());
    let n = coarse.points.len();
    assert_eq!(coarse.points.len() + coarse.lost, 256);
    assert_eq!(coarse.points[..], full.points[..n]);
    assert!(request.answer(&subject, Detail::Full, &|| false).is_none());
}

#[test]
fn what_is_not_wanted_is_left_empty() {
    let surface = "plastic".parse::<Material>().unwrap().build();
    let held = direction_from_degrees(40.0, 0.0);
    let subject = Subject::of(HeldLobe::new(&*surface, Hold::Viewer, held));
    let study = |part| {
        let request = Request {
            part,
            count: 256,
            seed: 3,
            phi: 0.0,
        };
        request.answer(&subject, Detail::Full, &|| true).unwrap()
    };
    let all = study(Part::All);
    for part in [
        Part::Points,
        Part::Histogram,
        Part::Weights,
        Part::Densities,
        Part::Estimators,
    ] {
        let one = study(part);
        assert_eq!(one.points, all.points, "{part:?}");
        let is_wanted = |of: Part| of == part;
        assert_eq!(one.histogram == all.histogram, is_wanted(Part::Histogram));
        assert_eq!(one.weights == all.weights, is_wanted(Part::Weights));
        assert_eq!(one.densities == all.densities, is_wanted(Part::Densities));
        assert_eq!(
            one.estimators == all.estimators,
            is_wanted(Part::Estimators)
        );
    }
}
