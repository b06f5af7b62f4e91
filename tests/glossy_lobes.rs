//! The glossy lobes of the empirical models by themselves: what each reflects, where its diffuse companion is black.
//!
//! The laws of the contract see these models at full diffuse *and* specular reflectance too, where both together create
//! energy as declared; the bounds of the single lobes, which hold without exception, stand here.

#![allow(
    clippy::unwrap_used,
    reason = "a test's own helpers may fail as loudly as the test"
)]

use brdf_explorer::analysis::reflectance::directional_hemispherical;
use brdf_explorer::bxdf::Material;
use brdf_explorer::bxdf::math::frame::direction_from_degrees;

/// Absolute error allowed.
const ERROR: f64 = 1e-6;

/// Absolute error asked of the quadrature: its estimate of it may fall short by a factor.
const ASKED: f64 = 1e-7;

/// The share reflected of light arriving at this polar angle, azimuth 0.
fn rho(material: &str, theta_deg: f64) -> f64 {
    let material: Material = material.parse().unwrap();
    let wi = direction_from_degrees(theta_deg, 0.0);
    let found = directional_hemispherical(&*material.build::<f64>(), wi, ASKED);
    // A lobe that does not fade out at the horizon ends there in a jump, which costs the cubature digits.
    let allowed = if material.to_string().contains("duer") {
        5e-6
    } else {
        ERROR
    };
    assert!(found.error <= allowed, "{material} {theta_deg}: {found:?}");
    found.reflection[0]
}

#[test]
fn bounded_lobes_never_create_energy() {
    let mut materials: Vec<String> = Vec::new();
    for exponent in [1.0, 3.0, 64.0, 1000.0] {
        for model in ["phong", "blinn_phong"] {
            materials.push(format!("{model}:exponent={exponent}"));
        }
        for specular in [0.0, 0.05, 1.0] {
            materials.push(format!(
                "ashikhmin_shirley:diffuse=1,specular={specular},exponent_x={exponent},exponent_y=10"
            ));
        }
    }
    for width in [0.01, 0.15, 0.5, 1.0] {
        materials.push(format!("ward:alpha={width}"));
        materials.push(format!("ward:alpha_x={width},alpha_y=.3"));
        materials.push(format!("cook_torrance:f0=1,m={width}"));
    }
    for material in materials {
        for theta_deg in [0.0, 30.0, 60.0, 75.0, 85.0, 89.0] {
            let share = rho(&material, theta_deg);
            assert!(share <= 1.0 + ERROR, "{material} at {theta_deg}: {share}");
        }
    }
}

#[test]
fn lobes_normalised_at_normal_incidence_reflect_all_there() {
    for exponent in [1.0, 2.5, 64.0, 1e4] {
        for model in ["phong", "blinn_phong"] {
            let share = rho(&format!("{model}:exponent={exponent}"), 0.0);
            assert!((share - 1.0).abs() <= ERROR, "{model} {exponent}: {share}");
        }
    }
    // Half of a narrow lobe about a grazing mirror direction lies below the horizon, and the cosine takes the rest.
    let share = rho("phong:exponent=10000", 60.0);
    assert!((share - 0.5).abs() < 1e-4, "{share}");
}

#[test]
fn wards_bounded_form_has_its_closed_form_at_normal_incidence() {
    // The weight of a half vector is 1 - tan^2 there, up to 45 degrees.
    for a in [0.15_f64, 0.5, 1.0] {
        let expected = 1.0 - a * a * (1.0 - (-1.0 / (a * a)).exp());
        let share = rho(&format!("ward:alpha={a}"), 0.0);
        assert!((share - expected).abs() <= ERROR, "{a}: {share} {expected}");
    }
}

#[test]
fn the_older_forms_of_ward_create_energy_towards_grazing() {
    for (variant, alpha, theta_deg, expected) in [
        ("ward", 0.5, 89.9, 1.48),
        ("ward", 0.5, 60.0, 0.35),
        ("duer", 0.5, 85.0, 1.33),
        ("duer", 0.7, 89.9, 49.18),
    ] {
        let share = rho(&format!("ward:variant={variant},alpha={alpha}"), theta_deg);
        // Half a unit of the digits given.
        assert!(
            (share - expected).abs() < 0.005,
            "{variant} {theta_deg}: {share}"
        );
    }
}

#[test]
fn long_grooves_reflect_all_of_a_narrow_lobe_and_lose_light_between() {
    assert!((rho("cook_torrance:f0=1,m=.0001", 60.0) - 1.0).abs() <= 2.0 * ERROR);
    let share = rho("cook_torrance:f0=1,m=.2", 80.0);
    assert!((0.9..0.95).contains(&share), "{share}");
    assert_eq!(rho("cook_torrance:f0=0", 30.0), 0.0);
}
