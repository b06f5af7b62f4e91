//! The chance of a false alarm, and condition numbers.

use glam::DVec3;
use xprec::Df64;

use super::subject::Subject;
use crate::bxdf::Bxdf;
use crate::bxdf::math::{Real, Vec3};

/// Chance of a false alarm in a whole run over one model.
const SIGNIFICANCE: f64 = 1e-3;

/// The largest p-value that counts as a failure among `tests` independent ones (Sidak 1967): with it, the chance that
/// any of them fails by chance is [`SIGNIFICANCE`].
pub(super) fn sidak(tests: usize) -> f64 {
    // 1 - (1 - a)^(1/n), without cancellation.
    -((-SIGNIFICANCE).ln_1p() / tests.max(1) as f64).exp_m1()
}

/// The stability law: relative error <= 16 (1 + kappa) u.
fn stability_bound(kappa: f64, unit_roundoff: f64) -> f64 {
    16.0 * (1.0 + kappa) * unit_roundoff
}

/// A number that a model gives for a pair of directions.
#[derive(Clone, Copy, Debug)]
pub(super) enum Quantity {
    /// A channel of `f`: 0, 1 or 2.
    F(usize),
    /// The density.
    Pdf,
}

impl Quantity {
    /// All of them.
    pub(super) const ALL: [Self; 4] = [Self::F(0), Self::F(1), Self::F(2), Self::Pdf];

    /// Its value in the model's precision.
    pub(super) fn of<R: Real>(self, bxdf: &dyn Bxdf<R>, wo: Vec3<R>, wi: Vec3<R>) -> R {
        match self {
            Self::F(channel) => {
                let rgb = bxdf.f(wo, wi).0;
                rgb.into_iter().nth(channel).unwrap_or(R::nan())
            }
            Self::Pdf => bxdf.pdf(wo, wi),
        }
    }
}

/// Relative step of the derivatives by the directions' components, in reference precision: small beside alpha mu, the
/// width in which the narrowest lobe reacts between grazing directions (1e-4 times 1e-9), large beside 1e-32.
const COMPONENT_STEP: f64 = 1e-16;

/// The condition number of `quantity`: the sum of |x d/dx| over its absolute value, over the six components of the
/// directions and the numeric parameters, by differences.
pub(super) fn condition_number(subject: &Subject, wo: DVec3, wi: DVec3, quantity: Quantity) -> f64 {
    let value = |o: Vec3<Df64>, i: Vec3<Df64>| quantity.of(&*subject.reference, o, i);
    let (wo_exact, wi_exact) = (Vec3::from(wo), Vec3::from(wi));
    let moved = |w: Vec3<Df64>, axis: usize, sign: f64| {
        let step = Df64::of(1.0) + Df64::of(sign * COMPONENT_STEP);
        match axis {
            0 => Vec3::new(w.x * step, w.y, w.z),
            1 => Vec3::new(w.x, w.y * step, w.z),
            _ => Vec3::new(w.x, w.y, w.z * step),
        }
    };
    let mut sum = 0.0;
    for axis in 0..3 {
        let by_wo = [1.0, -1.0].map(|sign| value(moved(wo_exact, axis, sign), wi_exact));
        let by_wi = [1.0, -1.0].map(|sign| value(wo_exact, moved(wi_exact, axis, sign)));
        for [up, down] in [by_wo, by_wi] {
            sum += (up - down).as_f64().abs() / (2.0 * COMPONENT_STEP);
        }
    }
    for neighbour in &subject.neighbours {
        let [up, down] = &neighbour.pair;
        let [up, down] = [up, down].map(|bxdf| quantity.of(&**bxdf, wo.into(), wi.into()));
        sum += (up - down).abs() / neighbour.relative_step;
    }
    let here = value(wo_exact, wi_exact).as_f64().abs();
    // A value of 0 all around is exact; one at the edge of a lobe may be anything nearby.
    if sum == 0.0 { 0.0 } else { sum / here }
}

/// What the stability law allows for `quantity` at a pair, in a precision of `unit_roundoff`; the condition number is
/// measured only where `deviation` needs it.
pub(super) fn rounding_bound(
    subject: &Subject,
    (wo, wi): (DVec3, DVec3),
    quantity: Quantity,
    deviation: f64,
    unit_roundoff: f64,
) -> f64 {
    let well_conditioned = stability_bound(0.0, unit_roundoff);
    if deviation <= well_conditioned {
        well_conditioned
    } else {
        stability_bound(condition_number(subject, wo, wi, quantity), unit_roundoff)
    }
}

/// |a - b| over the larger of the two; 0 where both are 0, infinite where one is no finite number.
pub(super) fn relative_difference(a: f64, b: f64) -> f64 {
    if a == b {
        0.0
    } else if a.is_finite() && b.is_finite() {
        (a - b).abs() / a.abs().max(b.abs())
    } else {
        f64::INFINITY
    }
}

/// Whether `x` is so small in precision `R` that its digits are no longer all there.
pub(super) fn is_subnormal<R: Real>(x: f64) -> bool {
    x.abs() < R::min_positive_value().as_f64() * 4.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_tests_share_one_chance_of_a_false_alarm() {
        assert!((sidak(1) - SIGNIFICANCE).abs() < 1e-15);
        assert!((1.0 - (1.0 - sidak(100)).powi(100) - SIGNIFICANCE).abs() < 1e-12);
    }
}
