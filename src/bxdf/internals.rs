//! What the labs look at inside the models, and nobody else needs: no part of the interface, and free to change.

use crate::math::{Real, Vec3};
use crate::models::eon;
use crate::param::ParamSet;

/// The part of the energy-preserving Oren-Nayar model's compensation that loses digits in the textbook's form.
#[inline(always)]
pub fn eon_loss<R: Real>(w: Vec3<R>) -> R {
    eon::loss(w)
}

/// The set with the number `name` where its range need not reach: for a look inside a model's core, whose formulas hold on
/// beyond what is allowed. `None` where the model has no such number.
#[must_use]
pub fn beyond_range(set: &ParamSet, name: &str, value: f64) -> Option<ParamSet> {
    set.beyond_range(name, value)
}
