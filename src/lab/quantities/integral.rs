//! Integrals over the hemisphere about n.

use super::f::of_channel;
use super::quantity::{Argument, Given, Quantity, Value, word};
use super::scene::Scene;
use crate::analysis::integral::{ExactRequest, Integrand};
use crate::analysis::{Detail, Hold, Query, Subject};

pub(super) const QUANTITY: Quantity = Quantity {
    id: "integral",
    symbol: "integral over the hemisphere",
    unit: "",
    meaning: "The integral over the hemisphere about n of 1, of the cosine, of f cos with the light fixed, or of the density of \
        samples with the viewer fixed",
    arguments: &[Argument::word("of", &["1", "cos", "f_cos", "pdf"])],
    value,
};

fn value(scene: &Scene, given: &[Given]) -> Value {
    let (integrand, hold) = match word(given, 0).as_str() {
        "1" => (Integrand::One, Hold::Light),
        "cos" => (Integrand::Cosine, Hold::Light),
        "f_cos" => (Integrand::FCos, Hold::Light),
        _ => (Integrand::Density, Hold::Viewer),
    };
    let request = ExactRequest {
        integrand,
        is_sphere: false,
    };
    let subject = Subject::of(scene.held(hold));
    let exact = request.answer(&subject, Detail::Full, &|| true);
    let value = exact.and_then(|exact| exact.value);
    let value = value.ok_or("it was not computed")?;
    Ok(of_channel(value, ""))
}
