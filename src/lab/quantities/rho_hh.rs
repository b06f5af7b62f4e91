//! The hemispherical-hemispherical reflectance.

use super::f::of_channel;
use super::quantity::{Given, Quantity, Value, word};
use super::rho_dh::{ACCURACY, SIDE};
use super::scene::Scene;
use crate::analysis::reflectance::CurveRequest;
use crate::analysis::{Detail, Hold, Query, Subject};

pub(super) const QUANTITY: Quantity = Quantity {
    id: "rho_hh",
    symbol: "ρ_hh",
    unit: "",
    meaning: "The hemispherical-hemispherical reflectance: the share that leaves of light that arrives evenly from above",
    arguments: &[SIDE],
    value,
};

fn value(scene: &Scene, given: &[Given]) -> Value {
    let (tolerance, max_evaluations) = ACCURACY;
    let request = CurveRequest {
        phi_deg: 0.0,
        angles: 2,
        tolerance,
        max_evaluations,
    };
    let subject = Subject::of(scene.held(Hold::Light));
    let curve = request.answer(&subject, Detail::Full, &|| true);
    let mean = curve.and_then(|curve| curve.hemispherical);
    let mean = mean.ok_or("it was not computed")?;
    let [up, down] = [mean.reflection, mean.transmission].map(|rgb| of_channel(rgb, ""));
    Ok(match word(given, 0).as_str() {
        "reflection" => up,
        "transmission" => down,
        _ => up + down,
    })
}
