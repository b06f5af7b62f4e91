//! The density of samples.

use super::quantity::Quantity;
use super::scene::Scene;

pub(super) const QUANTITY: Quantity = Quantity {
    id: "pdf",
    symbol: "pdf",
    unit: "1/sr",
    meaning: "The density with which the model's sampler draws the light's direction for the viewer, without deltas",
    arguments: &[],
    value: |scene, _| Ok(value(scene)),
};

fn value(scene: &Scene) -> f64 {
    let (wo, wi) = (scene.viewer(), scene.light());
    scene.surface().pdf(wo.into(), wi.into())
}
