//! The hemispherical-directional reflectance.

use super::f::of_channel;
use super::quantity::{Given, Quantity, Value};
use super::rho_dh::ACCURACY;
use super::scene::Scene;
use crate::analysis::Hold;

pub(super) const QUANTITY: Quantity = Quantity {
    id: "rho_hd",
    symbol: "ρ_hd",
    unit: "",
    meaning: "The hemispherical-directional reflectance: what the viewer sees of light that is the same from everywhere, over \
        that light",
    arguments: &[],
    value,
};

/// The integral of f cos over the light, and what each delta weighs. Across an interface radiance changes with the square of
/// the index, which is part of the weights.
fn value(scene: &Scene, _: &[Given]) -> Value {
    if scene.viewer().z == 0.0 {
        return Err("nothing is seen along the horizon".to_owned());
    }
    let lobe = scene.held(Hold::Viewer);
    let (tolerance, evaluations) = ACCURACY;
    let integrals = lobe.integrals(tolerance, evaluations).into_iter();
    let deltas = lobe.arrows().into_iter().map(|arrow| arrow.weight);
    let all = integrals.map(|integral| integral.value).chain(deltas);
    Ok(all.map(|rgb| of_channel(rgb, "")).sum())
}
