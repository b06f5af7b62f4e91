//! Samples at the ends of the unit cube.

use glam::DVec3;
use xprec::Df64;

use super::ExtremeKind;
use super::directions::views;
use super::extreme_tally::{Finding, Tally};
use super::point::Tested;
use crate::rounding::{
    Quantity, UNIT_LENGTH_ROUNDOFFS, quantities, relative_difference, stability_bound,
};
use crate::specimen::Specimen;
use bxdf::math::{Real, Vec3};
use bxdf::optics::Spectrum;
use bxdf::{Sample, Side};

/// Whether every channel is finite and not negative.
pub(crate) fn is_good<R: Real>(spectrum: Spectrum<R>) -> bool {
    spectrum.0.into_iter().all(is_good_number)
}

/// Whether `x` is finite and not negative.
pub(crate) fn is_good_number<R: Real>(x: R) -> bool {
    x.is_finite() && x >= R::zero()
}

/// Whether the direction of a sample is a unit vector.
pub(crate) fn is_unit<R: Real>(wi: Vec3<R>) -> bool {
    // The given directions are unit vectors to f64 at best; a sample cannot be better than they are.
    let unit_roundoff = R::UNIT_ROUNDOFF.max(f64::UNIT_ROUNDOFF);
    (wi.length_squared() - R::one()).as_f64().abs() <= UNIT_LENGTH_ROUNDOFFS * unit_roundoff
}

/// Numbers of the unit interval where samplers' inner functions end or have their poles: logarithms and roots at 0 and 1,
/// tangents of the turn at its quarters, inverses of error functions at 1/2.
fn ends<R: Real>() -> [R; 6] {
    let half_step = R::of(R::UNIT_ROUNDOFF);
    let (half, last) = (R::of(0.5), R::one() - half_step);
    [
        R::zero(),
        R::min_positive_value(),
        half_step,
        half,
        R::of(0.75),
        last,
    ]
}

/// Numbers that choose among lobes; 1 is rounded to the last below it.
pub(super) const CHOICES: [f64; 3] = [0.0, 0.5, 1.0];

/// Draws samples at the ends of the unit square along directions of view, with each of `choices` among lobes.
pub(super) fn samples<R: Real>(
    at: &Tested<'_, R>,
    cases: &[ExtremeKind],
    choices: &[f64],
    tally: &mut Tally,
) {
    let ends = ends::<R>().map(R::as_f64);
    for view in views() {
        for uc in choices {
            for u in ends {
                for v in ends {
                    sample(at, cases, view, [u, v, *uc], tally);
                }
            }
        }
    }
}

/// Draws the sample at these numbers (the direction's two, and the choice) along `wo`.
pub(super) fn sample<R: Real>(
    at: &Tested<'_, R>,
    cases: &[ExtremeKind],
    wo: DVec3,
    [u, v, uc]: [f64; 3],
    tally: &mut Tally,
) {
    let wo: Vec3<R> = wo.into();
    // Rounding must not reach 1.
    let number = |x: f64| R::of(x).min(R::one() - R::of(R::UNIT_ROUNDOFF));
    let drawn = at.model.sample_f(wo, number(uc), [number(u), number(v)]);
    let finding = drawn.map_or_else(Finding::default, |sample| judged(at, wo, &sample));
    tally.add(cases, R::NAME, finding, || {
        let wi: DVec3 = drawn.map_or(DVec3::Z, |sample| sample.wi.into());
        (at.specimen.name.clone(), wo.into(), wi)
    });
}

/// What is found of a sample of `wo`.
fn judged<R: Real>(at: &Tested<'_, R>, wo: Vec3<R>, sample: &Sample<R>) -> Finding {
    let weight = sample.weight();
    let is_finite = is_good(sample.f) && is_good(weight) && is_good_number(sample.pdf);
    let mut finding = Finding {
        is_not_finite: !is_finite,
        is_misplaced: !is_unit(sample.wi)
            || sample.pdf <= R::zero()
            || is_astray(at.specimen, wo, sample.wi),
        weight: is_finite.then(|| weight.0.map(Real::as_f64).into_iter().fold(0.0, f64::max)),
        what: "f",
        ..Finding::default()
    };
    // The reference is not held against itself.
    if is_finite && !sample.is_delta && R::NAME != Df64::NAME {
        let [r, g, b] = sample.f.0;
        let carried = [r, g, b, sample.pdf];
        let anew = quantities(at.model, wo, sample.wi);
        for quantity in Quantity::ALL {
            let [carried, anew] = [carried, anew].map(|all| quantity.of(all).as_f64());
            let error = relative_difference(carried, anew);
            finding.relative_error = finding.relative_error.max(error);
        }
        finding.ratio = finding.relative_error / stability_bound(0.0, R::UNIT_ROUNDOFF);
    }
    finding
}

/// Whether `wi` is in the horizon plane, or on a side where no lobe goes.
fn is_astray<R: Real>(specimen: &Specimen, wo: Vec3<R>, wi: Vec3<R>) -> bool {
    wi.z == R::zero() || !specimen.has_side(Side::between(wo, wi))
}
