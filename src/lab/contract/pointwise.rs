//! The laws of `f` and `pdf` at single pairs of directions: support, reciprocity, isotropy.

use glam::DVec3;

use super::statistics::{Quantity, is_subnormal, relative_difference, rounding_bound};
use super::subject::Subject;
use super::sweep::directions;
use super::{LawId, Plan, Tallies};
use crate::analysis::statistics::Random;
use crate::bxdf::math::Real;
use crate::bxdf::math::frame::{direction_from_degrees, turned_about_normal};
use crate::bxdf::{Declaration, ModelSpec, Side};

/// Polar angles of grazing pairs, in degrees.
const GRAZING_DEG: [f64; 5] = [85.0, 89.0, 89.9, 89.999, 90.0 - 1e-7];

/// A density this small is a true value that underflows, not a place where samples never go.
const UNDERFLOW: f64 = 1e-290;

/// Pairs that meet the lobes: random ones, sampled ones (where the lobe is narrow, the only ones inside it), grazing ones.
pub(super) fn pairs(subject: &Subject, plan: &Plan, seed: u64) -> Vec<(DVec3, DVec3)> {
    let mut random = Random::new(seed);
    let mut pairs = Vec::new();
    for _ in 0..plan.effort.pairs() {
        pairs.push((random.direction(), random.direction()));
        let wo = random.direction();
        pairs.extend(
            subject
                .double
                .sample_f(wo.into(), random.unit(), random.pair())
                .filter(|sample| !sample.is_delta)
                .map(|sample| (wo, sample.wi.into())),
        );
    }
    for theta_o in GRAZING_DEG {
        for theta_i in GRAZING_DEG {
            for phi in [0.0, 20.0, 180.0, 200.5] {
                let wo = direction_from_degrees(theta_o, phi);
                pairs.push((wo, direction_from_degrees(theta_i, 20.0)));
                pairs.push((wo, direction_from_degrees(180.0 - theta_i, 20.0)));
            }
        }
    }
    pairs
}

/// `f` and `pdf` are 0 on a side without a lobe and in the horizon plane; a value has a density.
pub(super) fn support(subject: &Subject, plan: &Plan, tallies: &mut Tallies) {
    let mut random = Random::new(31);
    let mut cases = pairs(subject, plan, 32);
    for wo in directions() {
        cases.extend((0..plan.effort.pairs()).map(|_| (wo, random.direction())));
        cases.push((wo, DVec3::X));
        cases.push((DVec3::NEG_Y, wo));
    }
    for (wo, wi) in cases {
        let f = subject.double.f(wo.into(), wi.into()).max_channel();
        let pdf = subject.double.pdf(wo.into(), wi.into());
        let side = if wo.z * wi.z > 0.0 {
            Side::Reflection
        } else {
            Side::Transmission
        };
        let witness = || subject.witness(&[("wo", wo), ("wi", wi)]);
        if wo.z == 0.0 || wi.z == 0.0 || !subject.has_side(side) {
            tallies.record(LawId::Support, f.max(pdf), 0.0, witness);
        } else {
            tallies.require(LawId::Support, pdf > 0.0 || f <= UNDERFLOW, witness);
        }
    }
}

/// `n_i^2` f(wo, wi) = `n_o^2` f(wi, wo), in every channel, within the stability law.
pub(super) fn reciprocity(subject: &Subject, plan: &Plan, tallies: &mut Tallies) {
    for (wo, wi) in pairs(subject, plan, 41) {
        for channel in 0..3 {
            let (deviation, error) = reciprocity_deviation(subject, wo, wi, channel);
            tallies.record(LawId::Reciprocity, deviation, error, || {
                subject.witness(&[("wo", wo), ("wi", wi)])
            });
        }
    }
}

/// The relative difference of the two ways, and what rounding explains of it.
fn reciprocity_deviation(subject: &Subject, wo: DVec3, wi: DVec3, channel: usize) -> (f64, f64) {
    let quantity = Quantity::F(channel);
    let (n_o, n_i) = (subject.index_at(wo), subject.index_at(wi));
    let there = quantity.of(&*subject.double, wo.into(), wi.into());
    let back = quantity.of(&*subject.double, wi.into(), wo.into());
    if is_subnormal::<f64>(there) && is_subnormal::<f64>(back) {
        return (0.0, 0.0);
    }
    let deviation = relative_difference(n_i * n_i * there, n_o * n_o * back);
    let error = rounding_bound(subject, (wo, wi), quantity, deviation, f64::UNIT_ROUNDOFF);
    (deviation, error)
}

/// An isotropic lobe turns with both directions; one declared anisotropic must show it somewhere.
pub(super) fn isotropy(subject: &Subject, plan: &Plan, tallies: &mut Tallies) {
    /// Relative difference from which a lobe visibly depends on the azimuth.
    const VISIBLE: f64 = 1e-3;
    let mut largest: f64 = 0.0;
    for (index, (wo, wi)) in pairs(subject, plan, 51).into_iter().enumerate() {
        let turn = 0.3 + index as f64;
        let [wo_turned, wi_turned] = [wo, wi].map(|w| turned_about_normal(w, turn));
        for quantity in Quantity::ALL {
            let here = quantity.of(&*subject.double, wo.into(), wi.into());
            let turned = quantity.of(&*subject.double, wo_turned.into(), wi_turned.into());
            if is_subnormal::<f64>(here) && is_subnormal::<f64>(turned) {
                continue;
            }
            let deviation = relative_difference(here, turned);
            largest = largest.max(deviation);
            if subject.is_isotropic {
                // The turned components carry the rounding of the larger ones: the bounds of both places.
                let bound =
                    |at| rounding_bound(subject, at, quantity, deviation, f64::UNIT_ROUNDOFF);
                let error = bound((wo, wi)) + bound((wo_turned, wi_turned));
                tallies.record(LawId::Isotropy, deviation, error, || {
                    subject.witness(&[("wo", wo), ("wi", wi)])
                });
            }
        }
    }
    if !subject.is_isotropic {
        tallies.require(LawId::Isotropy, largest > VISIBLE, || {
            format!("{} is declared anisotropic and is not", subject.name)
        });
    }
}

/// By how much reciprocity breaks at a declared witness, or what is wrong with the witness.
pub(super) fn declared_break(model: &ModelSpec, declaration: &Declaration) -> Result<f64, String> {
    let subject = super::energy::declared_subject(model, declaration)?;
    let wi = direction_from_degrees(declaration.theta_deg, 0.0);
    let mut largest: f64 = 0.0;
    for theta_deg in (0..180).step_by(5) {
        for phi_deg in (0..360).step_by(30) {
            let wo = direction_from_degrees(f64::from(theta_deg), f64::from(phi_deg));
            for channel in 0..3 {
                let (deviation, error) = reciprocity_deviation(&subject, wo, wi, channel);
                if deviation > error {
                    largest = largest.max(deviation);
                }
            }
        }
    }
    if largest > 0.0 {
        Ok(largest)
    } else {
        Err(format!(
            "{} keeps reciprocity at the declared witness",
            subject.name
        ))
    }
}
