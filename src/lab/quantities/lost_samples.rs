//! Samples that leave into the surface.

use std::f64::consts::PI;

use super::normals::Normals;
use super::quantity::{Argument, Given, Quantity, Value, word};
use super::scene::Scene;
use bxdf::math::frame;

pub(super) const QUANTITY: Quantity = Quantity {
    id: "lost_samples",
    symbol: "samples lost",
    unit: "",
    meaning: "The share of reflected directions that lie below the surface, with normals drawn as D cos has them (all) or as \
        the viewer sees them (visible)",
    arguments: &[Argument::word("normals", &["all", "visible"])],
    value,
};

/// Over the azimuth of the normal both integrals are closed: a normal at theta sends the viewer's direction above the
/// surface where cos phi exceeds a bound, and the visible normals have the weight h · o.
fn value(scene: &Scene, given: &[Given]) -> Value {
    let viewer = scene.viewer();
    if viewer.z <= 0.0 {
        return Err("the viewer is not above the surface".to_owned());
    }
    let (sin_o, cos_o) = frame::theta(viewer).sin_cos();
    let normals = Normals::of(scene)?;
    // The azimuth, 0..pi, below which `level + slope cos phi` is positive.
    let positive_below = |level: f64, slope: f64| {
        if slope <= 0.0 {
            return if level > 0.0 { PI } else { 0.0 };
        }
        let cosine = (-level / slope).clamp(-1.0, 1.0);
        ((1.0 - cosine) * (1.0 + cosine)).sqrt().atan2(cosine)
    };
    // The azimuth below which the reflected direction lies above the surface.
    let kept_below = |theta: f64| {
        let (sin_2, cos_2) = (2.0 * theta).sin_cos();
        positive_below(cos_o * cos_2, sin_o * sin_2)
    };
    if word(given, 0) == "all" {
        return Ok(1.0 - normals.mean(&|theta| kept_below(theta) / PI));
    }
    // D cos is what the mean is over, so the cosine is divided out.
    let seen = |theta: f64, end: f64| {
        let (sin, cos) = theta.sin_cos();
        (sin_o * sin * end.sin() + cos_o * cos * end) / cos
    };
    let kept = normals.mean(&|theta| seen(theta, kept_below(theta)));
    let all = normals.mean(&|theta| {
        let (sin, cos) = theta.sin_cos();
        seen(theta, positive_below(cos_o * cos, sin_o * sin))
    });
    Ok(1.0 - kept / all)
}
