//! f32 and f64 against the reference precision.

use glam::DVec3;

use super::law::LawId;
use super::law_tally::Tallies;
use super::plan::Plan;
use super::pointwise::pairs;
use crate::rounding::stability_bound;
use crate::specimen::Specimen;
use crate::stability::point::{self, Tested};
use bxdf::math::Real;

/// Both precisions keep the stability law, at grazing directions too.
pub(super) fn precision(specimen: &Specimen, plan: &Plan, tallies: &mut Tallies) {
    let (single, double) = (point::single(specimen), point::double(specimen));
    for pair in pairs(specimen, plan, 81) {
        record(&single, pair, tallies);
        record(&double, pair, tallies);
    }
}

fn record<R: Real>(tested: &Tested<'_, R>, pair: (DVec3, DVec3), tallies: &mut Tallies) {
    // What is within the bound of a well-conditioned result needs no condition number.
    let finding = tested.compare(pair, 1.0);
    let error = finding.relative_error;
    let allowed = if finding.ratio > 0.0 {
        error / finding.ratio
    } else {
        stability_bound(0.0, R::UNIT_ROUNDOFF)
    };
    tallies.record(LawId::Precision, error, allowed, || {
        let (_, wo, wi) = tested.at(pair);
        let at = tested.specimen.witness(&[("wo", wo), ("wi", wi)]);
        format!("{at} in {}, {}", R::NAME, finding.what)
    });
}
