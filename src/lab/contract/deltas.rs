//! The laws of Dirac delta lobes.

use glam::DVec3;

use super::law::LawId;
use super::law_tally::Tallies;
use super::sweep::directions;
use crate::analysis::statistics::Random;
use crate::rounding::relative_difference;
use crate::specimen::Specimen;
use bxdf::math::Real;
use bxdf::math::frame::direction_from_degrees;
use bxdf::{Delta, Side};

/// Disagreement of numbers that differ by a handful of operations in f64.
const SAME: f64 = 16.0 * f64::UNIT_ROUNDOFF;

/// Random directions tried beside those of the sweep.
const RANDOM_DIRECTIONS: usize = 32;

/// The numbers of each delta agree with one another, and the light finds its way back.
pub(super) fn deltas(specimen: &Specimen, tallies: &mut Tallies) {
    let mut random = Random::new(61);
    let mut all = directions();
    all.extend((0..RANDOM_DIRECTIONS).map(|_| random.direction()));
    // Just inside and outside the critical angle of glass, and within the narrow cone of the highest index.
    all.extend([180.0 - 41.8, 180.0 - 41.82, 179.96].map(|t| direction_from_degrees(t, 10.0)));
    for w in all {
        let found = specimen.double.deltas(w.into());
        let probability: f64 = found.iter().flatten().map(|delta| delta.probability).sum();
        tallies.record(LawId::Deltas, (probability - 1.0).max(0.0), SAME, || {
            specimen.witness(&[("wi", w)])
        });
        for delta in found.into_iter().flatten() {
            consistency(specimen, w, &delta, tallies);
            way_back(specimen, w, &delta, tallies);
        }
    }
}

fn consistency(specimen: &Specimen, w: DVec3, delta: &Delta<f64>, tallies: &mut Tallies) {
    let direction: DVec3 = delta.direction.into();
    let witness = || specimen.witness(&[("wi", w), ("wo", direction)]);
    let length_error = (delta.direction.length_squared() - 1.0).abs();
    tallies.record(LawId::Deltas, length_error, SAME, witness);
    let side = if w.z * direction.z > 0.0 {
        Side::Reflection
    } else {
        Side::Transmission
    };
    tallies.require(
        LawId::Deltas,
        side == delta.side && specimen.has_side(side),
        witness,
    );
    tallies.require(
        LawId::Deltas,
        delta.probability > 0.0 && delta.probability <= 1.0,
        witness,
    );
    let e = specimen.index_at(direction) / specimen.index_at(w);
    for (flux, weight) in delta.flux.0.into_iter().zip(delta.weight.0) {
        tallies.require(LawId::Deltas, (0.0..=1.0).contains(&flux), witness);
        tallies.record(
            LawId::Deltas,
            relative_difference(weight * e * e, flux),
            SAME,
            witness,
        );
    }
}

/// The delta of the delta's direction on the same side leads back to `w`, with the same share of the flux.
fn way_back(specimen: &Specimen, w: DVec3, delta: &Delta<f64>, tallies: &mut Tallies) {
    let direction: DVec3 = delta.direction.into();
    let witness = || specimen.witness(&[("wi", w), ("wo", direction)]);
    let back = specimen
        .double
        .deltas(delta.direction)
        .into_iter()
        .flatten()
        .find(|back| back.side == delta.side);
    let Some(back) = back else {
        tallies.require(LawId::Reciprocity, false, witness);
        return;
    };
    // Near the critical angle the way back takes its cosine from n^2 - sin^2, of which rounding leaves u / cos^2.
    let error = 16.0 * f64::UNIT_ROUNDOFF * (1.0 + 1.0 / (w.z * w.z));
    let miss = (DVec3::from(back.direction) - w).length();
    tallies.record(LawId::Reciprocity, miss, error, witness);
    for (there, back) in delta.flux.0.into_iter().zip(back.flux.0) {
        tallies.record(
            LawId::Reciprocity,
            relative_difference(there, back),
            error,
            witness,
        );
    }
}
