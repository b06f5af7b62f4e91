//! Finite and not negative: `f`, `pdf` and samples at every extreme, in every precision.

use glam::DVec3;

use super::law::LawId;
use super::law_tally::Tallies;
use super::plan::Plan;
use crate::analysis::statistics::Random;
use crate::specimen::{Specimen, Witness};
use crate::stability::{is_good, is_good_number, is_unit};
use bxdf::Scatterer;
use bxdf::math::frame::cos_sin_deg;
use bxdf::math::{Real, Vec3};

/// Absolute cosines down to the horizon: 1e-23 squares to a subnormal f32, 1e-38 is one itself; 1e-160 and 1e-308 are
/// the same in f64 (and 0 in f32).
const COSINES: [f64; 10] = [
    1.0, 0.7, 1e-2, 1e-5, 1e-8, 1e-23, 1e-38, 1e-160, 1e-308, 0.0,
];

/// Azimuths against the given direction's, in degrees: aligned, opposed, and neither.
const AZIMUTHS_DEG: [f64; 4] = [0.0, 180.0, 90.0, 33.0];

/// Runs the law in f32, f64 and the reference precision.
pub(super) fn finite(specimen: &Specimen, plan: &Plan, tallies: &mut Tallies) {
    finite_in(specimen, &*specimen.single, plan, tallies);
    finite_in(specimen, &*specimen.double, plan, tallies);
    finite_in(specimen, &*specimen.reference, plan, tallies);
}

fn finite_in<R: Real>(
    specimen: &Specimen,
    bxdf: &dyn Scatterer<R>,
    plan: &Plan,
    tallies: &mut Tallies,
) {
    let given: Vec<Vec3<R>> = COSINES
        .into_iter()
        .flat_map(|cos| [direction(cos, 0.0), -direction(cos, 0.0)])
        .collect();
    let others: Vec<Vec3<R>> = COSINES
        .into_iter()
        .flat_map(|cos| AZIMUTHS_DEG.map(|azimuth| direction(cos, azimuth)))
        .flat_map(|w| [w, -w])
        .collect();
    let mut random = Random::new(71);
    let random_pairs = (0..plan.effort.pairs())
        .map(|_| (random.direction().into(), random.direction().into()))
        .collect::<Vec<(Vec3<R>, Vec3<R>)>>();
    let pairs = given
        .iter()
        .flat_map(|wo| others.iter().map(|wi| (*wo, *wi)))
        .chain(random_pairs);
    for (wo, wi) in pairs {
        let holds = is_good(bxdf.f(wo, wi)) && is_good_number(bxdf.pdf(wo, wi));
        tallies.require(LawId::Finite, holds, || Witness {
            text: format!("{} in {}: wo {wo:?} wi {wi:?}", specimen.name, R::NAME),
            wo: Some(in_double(wo)),
            wi: Some(in_double(wi)),
        });
    }
    for wo in given {
        samples_are_finite(specimen, bxdf, wo, tallies);
    }
}

/// The unit direction with this cosine and azimuth, rounded to the precision.
fn direction<R: Real>(cos: f64, azimuth_deg: f64) -> Vec3<R> {
    let radius = ((1.0 - cos) * (1.0 + cos)).sqrt();
    let (cos_phi, sin_phi) = cos_sin_deg(azimuth_deg);
    Vec3::new(R::of(radius * cos_phi), R::of(radius * sin_phi), R::of(cos))
}

/// The direction in f64.
fn in_double<R: Real>(w: Vec3<R>) -> DVec3 {
    DVec3::new(w.x.as_f64(), w.y.as_f64(), w.z.as_f64())
}

fn samples_are_finite<R: Real>(
    specimen: &Specimen,
    bxdf: &dyn Scatterer<R>,
    wo: Vec3<R>,
    tallies: &mut Tallies,
) {
    let ends = [R::zero(), R::of(0.5), R::one() - R::of(R::UNIT_ROUNDOFF)];
    for uc in ends {
        for u in ends {
            for v in ends {
                let Some(sample) = bxdf.sample_f(wo, uc, [u, v]) else {
                    continue;
                };
                let holds = is_unit(sample.wi)
                    && is_good(sample.f)
                    && is_good(sample.weight())
                    && is_good_number(sample.pdf)
                    && sample.pdf > R::zero();
                tallies.require(LawId::Finite, holds, || {
                    let text = format!(
                        "{} in {}: sample of wo {wo:?} at uc {uc:?}, u {u:?} {v:?}: {sample:?}",
                        specimen.name,
                        R::NAME
                    );
                    Witness {
                        wo: Some(in_double(wo)),
                        ..text.into()
                    }
                });
            }
        }
    }
}
