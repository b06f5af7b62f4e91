//! f.

use super::quantity::{Argument, Given, Quantity, word};
use super::scene::Scene;
use crate::analysis::{Channel, Hold};

/// The channels of a value, the first one where none is named.
pub(super) const CHANNELS: &[&str] = &["luminance", "red", "green", "blue"];

pub(super) const CHANNEL: Argument = Argument::word("channel", CHANNELS).optional();

pub(super) const QUANTITY: Quantity = Quantity {
    id: "f",
    symbol: "f",
    unit: "1/sr",
    meaning: "The value of the BSDF for the light and the viewer, without deltas",
    arguments: &[CHANNEL],
    value: |scene, given| Ok(value(scene, given)),
};

pub(super) fn value(scene: &Scene, given: &[Given]) -> f64 {
    let lobe = scene.held(Hold::Light);
    of_channel(lobe.value(scene.viewer()), &word(given, 0))
}

/// The channel of this name.
pub(super) fn of_channel(rgb: [f64; 3], name: &str) -> f64 {
    let channel = match name {
        "red" => Channel::Red,
        "green" => Channel::Green,
        "blue" => Channel::Blue,
        _ => Channel::Luminance,
    };
    channel.of(rgb)
}
