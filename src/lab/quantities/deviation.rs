//! How far a law is broken here.

use super::quantity::{Argument, Given, Quantity, Value, word};
use super::rho_dh;
use super::scene::Scene;
use crate::analysis::Hold;
use crate::rounding::relative_difference;

pub(super) const QUANTITY: Quantity = Quantity {
    id: "deviation",
    symbol: "deviation",
    unit: "",
    meaning: "How far a law is broken here: reciprocity by the relative difference of f with light and viewer exchanged, energy \
        by what more leaves than arrives",
    arguments: &[Argument::word("law", &["reciprocity", "energy"])],
    value,
};

fn value(scene: &Scene, given: &[Given]) -> Value {
    if word(given, 0) == "energy" {
        let leaving = rho_dh::of(scene, scene.light(), &[])?;
        return Ok((leaving - 1.0).max(0.0));
    }
    let (light, viewer) = (scene.light(), scene.viewer());
    if light.z * viewer.z <= 0.0 {
        return Err("light and viewer are not on one side of the surface".to_owned());
    }
    let lobe = scene.held(Hold::Light);
    let there = lobe.value(viewer);
    let back = crate::analysis::HeldLobe::new(lobe.surface(), Hold::Light, viewer).value(light);
    let pairs = there.into_iter().zip(back);
    Ok(pairs
        .map(|(a, b)| relative_difference(a, b))
        .fold(0.0, f64::max))
}
