//! The law of the inner lobes: they make up the model, and each is drawn by a map of its own.

use glam::DVec3;

use super::integrals::ESTIMATE;
use super::law::LawId;
use super::law_tally::Tallies;
use super::plan::Plan;
use super::pointwise::pairs;
use crate::analysis::reflectance::directional_hemispherical_within;
use crate::rounding::relative_difference;
use crate::specimen::Specimen;

/// Relative difference of f and the sum of its lobes that rounding explains: a few additions of positive numbers.
const SAME_SUM: f64 = 1e-14;

/// Absolute error wanted of the integrals over the maps, and what they may take for it.
const TOLERANCE: f64 = 1e-5;
const MAX_EVALUATIONS: usize = 40_000;

/// The lobes' values sum to f.
pub(super) fn values(specimen: &Specimen, plan: &Plan, tallies: &mut Tallies) {
    for (wo, wi) in pairs(specimen, plan, 61) {
        let whole = specimen.double.f(wo.into(), wi.into()).0;
        let mut sum = [0.0; 3];
        for index in 0..specimen.double.lobes().len() {
            let part = specimen.double.lobe_f(index, wo.into(), wi.into()).0;
            sum.iter_mut().zip(part).for_each(|(sum, f)| *sum += f);
        }
        for (whole, sum) in whole.into_iter().zip(sum) {
            // Where f is saturated, the sum may be infinite.
            let deviation = relative_difference(whole, sum.min(f64::MAX));
            tallies.record(LawId::Lobes, deviation, SAME_SUM, || {
                specimen.witness(&[("wo", wo), ("wi", wi)])
            });
        }
    }
}

/// The integrals over the lobes' maps are those of f |cos| over the sphere: `integral` and its error, without deltas.
pub(super) fn integrals(
    specimen: &Specimen,
    wi: DVec3,
    (integral, error): ([f64; 3], f64),
    tallies: &mut Tallies,
) {
    let bxdf = &*specimen.double;
    let found = directional_hemispherical_within(bxdf, wi, TOLERANCE, MAX_EVALUATIONS);
    let mut rho = found.reflection;
    rho.iter_mut()
        .zip(found.transmission)
        .for_each(|(rho, t)| *rho += t);
    for delta in bxdf.deltas(wi.into()).into_iter().flatten() {
        rho.iter_mut()
            .zip(delta.flux.0)
            .for_each(|(rho, flux)| *rho -= flux);
    }
    let error = ESTIMATE * (error + found.error.max(TOLERANCE));
    for (rho, integral) in rho.into_iter().zip(integral) {
        tallies.record(LawId::Lobes, (rho - integral).abs(), error, || {
            format!(
                "{}: {rho} by the maps, {integral} by cells",
                specimen.witness(&[("wi", wi)])
            )
        });
    }
}
