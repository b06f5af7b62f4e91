//! Curve and mesh follow the lobe of every model, over the whole sweep of its parameters.

#![allow(
    clippy::unwrap_used,
    reason = "a test's own helpers may fail as loudly as the test"
)]

use brdf_explorer::analysis::lobe::HORIZON_LIFT;
use brdf_explorer::analysis::reflectance::directional_hemispherical_within;
use brdf_explorer::analysis::{HeldLobe, Hold, RadialScale, lobe3d, polar};
use brdf_explorer::bxdf::math::frame::direction_from_degrees;
use brdf_explorer::bxdf::models::MODELS;
use brdf_explorer::bxdf::param::ParamSet;
use brdf_explorer::bxdf::{ModelSpec, Scatterer};
use brdf_explorer::lab::contract::parameter_sets;
use glam::DVec3;
use rayon::prelude::*;

/// The integral and the maximum shown are the true ones within this share.
const WITHIN: f64 = 0.01;

/// Given directions in degrees: along the normal, oblique, grazing, and from below.
const HELD_DEG: [(f64, f64); 4] = [(0.0, 0.0), (40.0, 25.0), (85.0, -60.0), (150.0, 100.0)];

/// Widths so unlike that the lobe is a blade 1:10000: its length would take some 10^6 triangles as narrow as the blade,
/// and the mesh ends at some 10^5. The peak and the plotted section hold there too, the mesh's integral does not.
fn is_blade(params: &ParamSet) -> bool {
    ["alpha_x", "alpha_y"]
        .map(|name| params.get(name))
        .map(|value| value.map(|_| ()))
        == [Some(()), Some(())]
        && params.number("alpha_y") > 1000.0 * params.number("alpha_x")
}

/// Runs `check` for every model with a value, parameter set of its sweep and held direction; returns what it finds wrong.
fn for_every_lobe(
    check: impl Fn(&ModelSpec, &ParamSet, &dyn Scatterer<f64>, DVec3) -> Option<String> + Sync,
) -> Vec<String> {
    let cases: Vec<_> = MODELS
        .into_iter()
        .filter(|model| !model.is_delta_only())
        .flat_map(|model| {
            parameter_sets(model)
                .into_iter()
                .map(move |set| (model, set))
        })
        .collect();
    cases
        .par_iter()
        .flat_map_iter(|(model, params)| {
            let bxdf = model.build::<f64>(params);
            let check = &check;
            HELD_DEG.into_iter().filter_map(move |(theta, phi)| {
                let held = direction_from_degrees(theta, phi);
                let problem = check(model, params, &*bxdf, held)?;
                Some(format!("{}:{params} at {theta}: {problem}", model.id))
            })
        })
        .collect()
}

#[test]
fn the_mesh_of_every_model_integrates_to_its_reflectance() {
    let request = lobe3d::Request {
        scale: RadialScale::Linear,
        with_cosine: false,
    };
    let problems = for_every_lobe(|_, params, bxdf, held| {
        let lobe = HeldLobe::new(bxdf, Hold::Light, held);
        let mesh = lobe3d::mesh(&lobe, &request);
        let rho = directional_hemispherical_within(bxdf, held, 1e-4, 50_000);
        let deltas: f64 = lobe.arrows().iter().map(|arrow| arrow.flux[0]).sum();
        let exact = rho.reflection[0] + rho.transmission[0] - deltas;
        let found = mesh.integral()[0];
        let is_good = is_blade(params) || (found - exact).abs() <= WITHIN * exact + rho.error;
        (!is_good).then(|| {
            format!(
                "mesh {found}, lobe {exact}, {} triangles",
                mesh.triangles.len()
            )
        })
    });
    assert!(problems.is_empty(), "\n{}", problems.join("\n"));
}

/// The largest value found by climbing from `start`: steps along and across, halved where neither climbs. It stays above
/// the horizon, where some lobes have no largest value, as far as the plot does.
fn climb(value: impl Fn(DVec3) -> f64, start: DVec3) -> f64 {
    let (mut at, mut best, mut step) = (start, value(start), 0.02);
    while step > 1e-9 {
        let side = at.any_orthonormal_vector();
        let other = at.cross(side);
        let found = [side, -side, other, -other]
            .into_iter()
            .filter_map(|towards| (at + towards * step).try_normalize())
            .filter(|w| w.z * start.z.signum() > HORIZON_LIFT)
            .map(|w| (value(w), w))
            .max_by(|a, b| a.0.total_cmp(&b.0));
        match found {
            Some((higher, w)) if higher > best => (best, at) = (higher, w),
            _ => step *= 0.5,
        }
    }
    best
}

#[test]
fn the_plotted_maximum_of_every_model_is_the_true_one() {
    let problems = for_every_lobe(|_, _, bxdf, held| {
        let lobe = HeldLobe::new(bxdf, Hold::Light, held);
        let largest = |w: DVec3| lobe.value(w).into_iter().fold(0.0, f64::max);
        let phi = held.y.atan2(held.x);
        let request = polar::Request {
            phi,
            with_cosine: false,
            scale: RadialScale::Linear,
        };
        let section = polar::section(&lobe, &request);
        // In the section, climbing from its own highest points and from where lobes are known to be.
        let value = |w: DVec3| largest(polar::direction(polar::signed_angle(w, phi), phi));
        let mirror = DVec3::new(-held.x, -held.y, held.z);
        let starts = [held, mirror, -held, DVec3::Z * held.z.signum()];
        let best = starts
            .into_iter()
            .map(|start| {
                climb(
                    value,
                    polar::direction(polar::signed_angle(start, phi), phi),
                )
            })
            .fold(0.0, f64::max);
        (section.peak < (1.0 - WITHIN) * best)
            .then(|| format!("section {}, found {best}", section.peak))
    });
    assert!(problems.is_empty(), "\n{}", problems.join("\n"));
}
