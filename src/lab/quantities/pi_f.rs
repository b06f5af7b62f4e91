//! The reflectance factor.

use std::f64::consts::PI;

use super::f::{self, CHANNEL};
use super::quantity::Quantity;

pub(super) const QUANTITY: Quantity = Quantity {
    id: "pi_f",
    symbol: "π f",
    unit: "",
    meaning: "The reflectance factor: f over that of a white Lambertian surface",
    arguments: &[CHANNEL],
    value: |scene, given| Ok(PI * f::value(scene, given)),
};
