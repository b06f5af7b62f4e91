//! The reflectance of a smooth interface.

use super::quantity::{Argument, Given, Quantity, Value, word};
use super::scene::Scene;
use crate::analysis::Channel;
use crate::analysis::fresnel::{Face, Interface, Reflectances, lobe};
use bxdf::math::frame;

pub(super) const QUANTITY: Quantity = Quantity {
    id: "fresnel",
    symbol: "F(θ_i)",
    unit: "",
    meaning: "The reflectance of the material's interface, were it smooth, at the angle of the light: for light of both \
        polarisations, of one, or as an approximation has it",
    arguments: &[Argument::word(
        "curve",
        &["mean", "s", "p", "schlick", "lazanyi"],
    )],
    value,
};

fn value(scene: &Scene, given: &[Given]) -> Value {
    let curve = word(given, 0);
    let of = |at: Reflectances| match curve.as_str() {
        "s" => at.s,
        "p" => at.p,
        "schlick" => at.schlick,
        "lazanyi" => at.lazanyi,
        _ => at.mean(),
    };
    let (faces, theta_deg) = faces(scene)?;
    let values: Vec<f64> = faces.iter().map(|face| of(face.at(theta_deg))).collect();
    Ok(match values[..] {
        [red, green, blue] => Channel::Luminance.of([red, green, blue]),
        [grey, ..] => grey,
        [] => f64::NAN,
    })
}

/// The sides of the interface that the light is on, for each channel or for all at once, and the angle of the light from the
/// normal on that side, in degrees.
pub(super) fn faces(scene: &Scene) -> Result<(Vec<Face>, f64), String> {
    let interface = lobe(scene.material(), 0).and_then(Interface::of);
    let interface = interface.ok_or("the material has no index of refraction")?;
    let theta_deg = frame::theta(scene.light()).to_degrees();
    let is_below = scene.light().z < 0.0;
    if is_below && interface.is_absorbing() {
        return Err("light from below is absorbed before it gets to the surface".to_owned());
    }
    let faces = interface.channels.iter().map(|(_, index)| {
        let face = Face::new(*index);
        if is_below { face.reversed() } else { face }
    });
    let from_normal = if is_below {
        180.0 - theta_deg
    } else {
        theta_deg
    };
    Ok((faces.collect(), from_normal))
}
