//! The weight of a delta.

use super::f::of_channel;
use super::quantity::{Argument, Given, Quantity, word};
use super::scene::Scene;
use crate::analysis::Hold;

pub(super) const QUANTITY: Quantity = Quantity {
    id: "delta",
    symbol: "weight of the delta",
    unit: "",
    meaning: "The share of the light's flux that a Dirac delta sends in its one direction, on one side of the surface",
    arguments: &[Argument::word("side", &["reflection", "transmission"])],
    value: |scene, given| Ok(value(scene, given)),
};

fn value(scene: &Scene, given: &[Given]) -> f64 {
    let side = word(given, 0);
    let arrows = scene.held(Hold::Light).arrows().into_iter();
    let there = arrows.filter(|arrow| arrow.side.id() == side);
    there.map(|arrow| of_channel(arrow.flux, "")).sum()
}
