//! f32 and f64 against the reference precision.

use glam::DVec3;
use xprec::Df64;

use super::law::LawId;
use super::law_tally::Tallies;
use super::plan::Plan;
use super::pointwise::pairs;
use crate::rounding::{Quantity, is_subnormal, quantities, relative_difference, rounding_bound};
use crate::specimen::Specimen;
use bxdf::Scatterer;
use bxdf::math::{Real, Vec3};

/// Both precisions keep the stability law, at grazing directions too.
pub(super) fn precision(specimen: &Specimen, plan: &Plan, tallies: &mut Tallies) {
    for (wo, wi) in pairs(specimen, plan, 81) {
        let models = (&*specimen.single, &*specimen.reference_of_single);
        compare::<f32>(specimen, models, (wo, wi), tallies);
        let models = (&*specimen.double, &*specimen.reference);
        compare::<f64>(specimen, models, (wo, wi), tallies);
    }
}

fn compare<R: Real>(
    specimen: &Specimen,
    (tested, reference): (&dyn Scatterer<R>, &dyn Scatterer<Df64>),
    (wo, wi): (DVec3, DVec3),
    tallies: &mut Tallies,
) {
    // The directions are rounded first, so that both sides see the same ones.
    let (wo, wi): (Vec3<R>, Vec3<R>) = (wo.into(), wi.into());
    let (wo_rounded, wi_rounded): (DVec3, DVec3) = (wo.into(), wi.into());
    let exact = (wo_rounded.into(), wi_rounded.into());
    let found = quantities(tested, wo, wi);
    let truth = quantities(reference, exact.0, exact.1);
    for quantity in Quantity::ALL {
        let truth = quantity.of(truth).as_f64();
        if is_subnormal::<R>(truth) {
            continue;
        }
        let deviation = relative_difference(quantity.of(found).as_f64(), truth);
        let at = (wo_rounded, wi_rounded);
        let error = rounding_bound(specimen, at, quantity, deviation, R::UNIT_ROUNDOFF);
        tallies.record(LawId::Precision, deviation, error, || {
            let at = specimen.witness(&[("wo", wo_rounded), ("wi", wi_rounded)]);
            format!("{at} in {}, {quantity:?}", R::NAME)
        });
    }
}
