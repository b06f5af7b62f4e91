//! f with the cosine.

use super::f::{self, CHANNEL};
use super::quantity::Quantity;

pub(super) const QUANTITY: Quantity = Quantity {
    id: "f_cos",
    symbol: "f cos θ_i",
    unit: "1/sr",
    meaning: "What a light of unit radiance adds per unit of solid angle: f by the cosine of the light",
    arguments: &[CHANNEL],
    value: |scene, given| Ok(f::value(scene, given) * scene.light().z.abs()),
};
