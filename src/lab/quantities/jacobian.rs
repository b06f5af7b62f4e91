//! The Jacobian of reflection about the half vector.

use super::quantity::{Given, Quantity, Value};
use super::scene::Scene;

pub(super) const QUANTITY: Quantity = Quantity {
    id: "jacobian",
    symbol: "dω_o / dω_h",
    unit: "",
    meaning: "How much solid angle of reflected directions a solid angle of half vectors makes: 4 (h · o)",
    arguments: &[],
    value,
};

fn value(scene: &Scene, _: &[Given]) -> Value {
    if scene.light().z * scene.viewer().z <= 0.0 {
        return Err("light and viewer are not on one side of the surface".to_owned());
    }
    let half = scene.half().ok_or("there is no half vector")?;
    Ok(4.0 * half.dot(scene.viewer()))
}
