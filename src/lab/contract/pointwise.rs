//! The laws of `f` and `pdf` at single pairs of directions: support, reciprocity, isotropy.

use glam::DVec3;

use super::law::LawId;
use super::law_tally::Tallies;
use super::plan::Plan;
use super::sweep::directions;
use crate::analysis::statistics::Random;
use crate::rounding::{Quantity, is_subnormal, relative_difference, rounding_bound};
use crate::specimen::Specimen;
use bxdf::math::Real;
use bxdf::math::frame::{direction_from_degrees, turned_about_normal};
use bxdf::{Declaration, ModelSpec, Side};

/// Polar angles of grazing pairs, in degrees.
const GRAZING_DEG: [f64; 5] = [85.0, 89.0, 89.9, 89.999, 90.0 - 1e-7];

/// A density this small is a true value that underflows, not a place where samples never go.
const UNDERFLOW: f64 = 1e-290;

/// Pairs that meet the lobes: random ones, sampled ones (where the lobe is narrow, the only ones inside it), grazing ones.
pub(super) fn pairs(specimen: &Specimen, plan: &Plan, seed: u64) -> Vec<(DVec3, DVec3)> {
    let mut random = Random::new(seed);
    let mut pairs = Vec::new();
    for _ in 0..plan.effort.pairs() {
        pairs.push((random.direction(), random.direction()));
        let wo = random.direction();
        pairs.extend(
            specimen
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
pub(super) fn support(specimen: &Specimen, plan: &Plan, tallies: &mut Tallies) {
    let mut random = Random::new(31);
    let mut cases = pairs(specimen, plan, 32);
    for wo in directions() {
        cases.extend((0..plan.effort.pairs()).map(|_| (wo, random.direction())));
        cases.push((wo, DVec3::X));
        cases.push((DVec3::NEG_Y, wo));
    }
    let values = specimen.values(&cases);
    for ((wo, wi), [r, g, b, pdf]) in cases.into_iter().zip(values) {
        let f = r.max(g).max(b);
        let side = if wo.z * wi.z > 0.0 {
            Side::Reflection
        } else {
            Side::Transmission
        };
        let witness = || specimen.witness(&[("wo", wo), ("wi", wi)]);
        if wo.z == 0.0 || wi.z == 0.0 || !specimen.has_side(side) {
            tallies.record(LawId::Support, f.max(pdf), 0.0, witness);
        } else {
            tallies.require(LawId::Support, pdf > 0.0 || f <= UNDERFLOW, witness);
        }
    }
}

/// `n_i^2` f(wo, wi) = `n_o^2` f(wi, wo), in every channel, within the stability law.
pub(super) fn reciprocity(specimen: &Specimen, plan: &Plan, tallies: &mut Tallies) {
    let pairs = pairs(specimen, plan, 41);
    for_each_deviation(specimen, &pairs, |(wo, wi), deviation, error| {
        tallies.record(LawId::Reciprocity, deviation, error, || {
            specimen.witness(&[("wo", wo), ("wi", wi)])
        });
    });
}

/// Calls `record` with each of `pairs` and each channel's [`reciprocity_deviation`].
fn for_each_deviation(
    specimen: &Specimen,
    pairs: &[(DVec3, DVec3)],
    mut record: impl FnMut((DVec3, DVec3), f64, f64),
) {
    let back: Vec<_> = pairs.iter().map(|(wo, wi)| (*wi, *wo)).collect();
    let values = specimen
        .values(pairs)
        .into_iter()
        .zip(specimen.values(&back));
    for (pair, ([there @ .., _], [back @ .., _])) in pairs.iter().zip(values) {
        for (channel, values) in there.into_iter().zip(back).enumerate() {
            let (deviation, error) = reciprocity_deviation(specimen, *pair, channel, values);
            record(*pair, deviation, error);
        }
    }
}

/// The relative difference of the values `there` and `back` of a channel, and what rounding explains of it.
fn reciprocity_deviation(
    specimen: &Specimen,
    (wo, wi): (DVec3, DVec3),
    channel: usize,
    (there, back): (f64, f64),
) -> (f64, f64) {
    let quantity = Quantity::F(channel);
    let (n_o, n_i) = (specimen.index_at(wo), specimen.index_at(wi));
    if is_subnormal::<f64>(there) && is_subnormal::<f64>(back) {
        return (0.0, 0.0);
    }
    let deviation = relative_difference(n_i * n_i * there, n_o * n_o * back);
    let error = rounding_bound(specimen, (wo, wi), quantity, deviation, f64::UNIT_ROUNDOFF);
    (deviation, error)
}

/// An isotropic lobe turns with both directions; one declared anisotropic must show it somewhere.
pub(super) fn isotropy(specimen: &Specimen, plan: &Plan, tallies: &mut Tallies) {
    /// Relative difference from which a lobe visibly depends on the azimuth.
    const VISIBLE: f64 = 1e-3;
    let mut largest: f64 = 0.0;
    let pairs = pairs(specimen, plan, 51);
    let turned = pairs.iter().enumerate().map(|(index, (wo, wi))| {
        let turn = 0.3 + index as f64;
        (
            turned_about_normal(*wo, turn),
            turned_about_normal(*wi, turn),
        )
    });
    let turned_pairs: Vec<_> = turned.collect();
    let values = specimen
        .values(&pairs)
        .into_iter()
        .zip(specimen.values(&turned_pairs));
    let cases = pairs.into_iter().zip(turned_pairs).zip(values);
    for (((wo, wi), (wo_turned, wi_turned)), (here, turned)) in cases {
        for (quantity, (here, turned)) in
            Quantity::ALL.into_iter().zip(here.into_iter().zip(turned))
        {
            if is_subnormal::<f64>(here) && is_subnormal::<f64>(turned) {
                continue;
            }
            let deviation = relative_difference(here, turned);
            largest = largest.max(deviation);
            if specimen.is_isotropic {
                // The turned components carry the rounding of the larger ones: the bounds of both places.
                let bound =
                    |at| rounding_bound(specimen, at, quantity, deviation, f64::UNIT_ROUNDOFF);
                let error = bound((wo, wi)) + bound((wo_turned, wi_turned));
                tallies.record(LawId::Isotropy, deviation, error, || {
                    specimen.witness(&[("wo", wo), ("wi", wi)])
                });
            }
        }
    }
    if !specimen.is_isotropic {
        tallies.require(LawId::Isotropy, largest > VISIBLE, || {
            format!("{} is declared anisotropic and is not", specimen.name)
        });
    }
}

/// The largest relative difference of the two ways at `pairs` that rounding does not explain; 0 where it explains all.
pub(super) fn reciprocity_broken(specimen: &Specimen, pairs: &[(DVec3, DVec3)]) -> f64 {
    let mut largest: f64 = 0.0;
    for_each_deviation(specimen, pairs, |_, deviation, error| {
        if deviation > error {
            largest = largest.max(deviation);
        }
    });
    largest
}

/// By how much reciprocity breaks at a declared witness, or what is wrong with the witness.
pub(super) fn declared_break(model: &ModelSpec, declaration: &Declaration) -> Result<f64, String> {
    let specimen = super::energy::declared_subject(model, declaration)?;
    let wi = direction_from_degrees(declaration.theta_deg, 0.0);
    let thetas = (0..180).step_by(5).map(f64::from);
    let pairs = thetas.flat_map(|theta_deg| {
        let phis = (0..360).step_by(30).map(f64::from);
        phis.map(move |phi_deg| (direction_from_degrees(theta_deg, phi_deg), wi))
    });
    let largest = reciprocity_broken(&specimen, &pairs.collect::<Vec<_>>());
    if largest > 0.0 {
        Ok(largest)
    } else {
        Err(format!(
            "{} keeps reciprocity at the declared witness",
            specimen.name
        ))
    }
}
