//! How much samples scatter about the integral that they estimate.

use super::quantity::{Argument, Given, Quantity, Value, word};
use super::scene::Scene;
use crate::analysis::Hold;
use crate::analysis::sampling::{FIRST_SEED, estimators};

/// How many directions are drawn: as many as the view of samples draws at first.
const COUNT: usize = 1 << 12;

pub(super) const QUANTITY: Quantity = Quantity {
    id: "variance",
    symbol: "variance",
    unit: "",
    meaning: "The variance of a sample of what the viewer sees in light from everywhere, where directions are drawn by the material \
        (importance), by the cosine or evenly (uniform): as found with 4096 of them",
    arguments: &[Argument::word(
        "drawn",
        &["importance", "cosine", "uniform"],
    )],
    value,
};

fn value(scene: &Scene, given: &[Given]) -> Value {
    let all = estimators(&scene.held(Hold::Viewer), COUNT, FIRST_SEED.into());
    let wanted = word(given, 0);
    let found = all
        .iter()
        .find(|one| one.name.eq_ignore_ascii_case(&wanted));
    found
        .map(|one| one.variance)
        .ok_or_else(|| "no light leaves towards the viewer".to_owned())
}
