//! A parameter of the material.

use super::quantity::{Argument, Given, Quantity, Value, word};
use super::scene::Scene;
use super::scene::unknown_parameter;
use crate::analysis::Channel;
use bxdf::param;

pub(super) const QUANTITY: Quantity = Quantity {
    id: "parameter",
    symbol: "parameter",
    unit: "",
    meaning: "A number of the material, as its slider has it; of a colour its luminance",
    arguments: &[Argument::name("name")],
    value,
};

fn value(scene: &Scene, given: &[Given]) -> Value {
    let name = word(given, 0);
    let components = scene.material().components().iter();
    let mut values = components.filter_map(|component| {
        let params = component.params();
        match params.get(&name)? {
            param::Value::Number(x) => Some(x),
            param::Value::Rgb(rgb) => Some(Channel::Luminance.of(rgb)),
            param::Value::Bool(flag) => Some(f64::from(u8::from(flag))),
            _ => None,
        }
    });
    let found = values.next();
    found.ok_or_else(|| unknown_parameter(scene.material(), &name))
}
