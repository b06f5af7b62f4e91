//! Limits: where one model becomes another, or itself turned.

use glam::DVec3;

use super::law::LawId;
use super::law_tally::Tallies;
use super::plan::Plan;
use super::pointwise::pairs;
use super::sweep::directions;
use crate::analysis::reflectance::directional_hemispherical;
use crate::analysis::statistics::Random;
use crate::rounding::relative_difference;
use crate::specimen::Specimen;
use bxdf::math::{Vec3, frame};
use bxdf::{Material, ModelSpec, Side};

/// How the two models of a [`Limit`] are related.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// The same `f` and `pdf` at every pair, and the same deltas.
    Same,
    /// The same `f` and `pdf` with `wi` mirrored about the normal.
    Mirrored,
    /// The same `f` and `pdf` with both directions turned by 90 degrees about the normal.
    QuarterTurn,
    /// A narrow lobe and the delta that it shrinks to: the same flux within [`CONE`] of the delta, the same reflectance.
    NarrowLobe,
    /// The deltas of the second model above the surface are among those of the first, with the same flux.
    HasDeltas,
    /// The delta of the second model above the surface points where one of the first does; its flux is its own.
    SameDirection,
}

/// Two materials that must agree.
#[derive(Clone, Copy, Debug)]
pub struct Limit {
    /// The material whose model the limit is checked with.
    pub material: &'static str,
    /// What it must agree with.
    pub becomes: &'static str,
    /// In which sense.
    pub relation: Relation,
    /// Relative difference allowed.
    pub tolerance: f64,
    /// Why that much.
    pub reason: &'static str,
}

/// Half-angle of the cone about a delta that counts as its direction, in radians.
pub const CONE: f64 = 0.02;

/// A handful of roundings in f64.
const ROUNDING: f64 = 1e-14;

/// Cosine from which a lobe of width 1e-4 is compared with its delta: 80 degrees from n; nearer to the horizon its tail
/// is cut off.
const SMALLEST_COSINE: f64 = 0.17;

const SHARED_FORMULA: &str = "the same formula, in another order of operations";
const TAIL: &str = "the tail outside a cone of c is (2 alpha / (c cos))^2 of the flux, 6e-4 at 80 degrees; the rest is the \
                    Fresnel factor over the lobe";

/// Every limit of the catalogue.
pub static LIMITS: [Limit; 34] = [
    same("oren_nayar:sigma=0", "lambertian_reflection"),
    same("eon:roughness=0", "lambertian_reflection"),
    same(
        "rough_conductor:fresnel=schlick,f0=1,alpha_x=.1,alpha_y=.4",
        "rough_conductor:fresnel=one,alpha_x=.1,alpha_y=.4",
    ),
    Limit {
        tolerance: 1e-9,
        reason: "1 - F is about 4 n / k^2, far below 1e-9 at k = 1e10",
        ..same(
            "rough_conductor:eta=1,k=10000000000",
            "rough_conductor:fresnel=one",
        )
    },
    Limit {
        relation: Relation::QuarterTurn,
        ..same(
            "rough_conductor:alpha_x=.05,alpha_y=.4",
            "rough_conductor:alpha_x=.4,alpha_y=.05",
        )
    },
    Limit {
        relation: Relation::QuarterTurn,
        ..same(
            "retro_reflector:alpha_x=.05,alpha_y=.4",
            "retro_reflector:alpha_x=.4,alpha_y=.05",
        )
    },
    narrow(
        "rough_conductor:fresnel=one,alpha=.0001",
        "specular_reflection",
    ),
    narrow(
        "rough_conductor:fresnel=one,masking=separable,alpha=.0001",
        "specular_reflection",
    ),
    narrow(
        "rough_conductor:fresnel=one,distribution=beckmann,alpha=.0001",
        "specular_reflection",
    ),
    Limit {
        relation: Relation::QuarterTurn,
        ..same(
            "rough_conductor:distribution=beckmann,compensation=kulla_conty,alpha_x=.05,alpha_y=.4",
            "rough_conductor:distribution=beckmann,compensation=kulla_conty,alpha_x=.4,alpha_y=.05",
        )
    },
    Limit {
        relation: Relation::QuarterTurn,
        ..same(
            "rough_dielectric:alpha_x=.05,alpha_y=.4",
            "rough_dielectric:alpha_x=.4,alpha_y=.05",
        )
    },
    narrow(
        "rough_dielectric:eta=1.8,alpha=.0001",
        "fresnel_specular:eta=1.8",
    ),
    narrow(
        "rough_dielectric:distribution=beckmann,eta=.5,alpha=.0001",
        "fresnel_specular:eta=.5",
    ),
    same("rough_dielectric:eta=1", "specular_transmission:eta=1"),
    same("plastic:eta=1", "lambertian_reflection:reflectance=.5"),
    narrow("plastic:diffuse=0,alpha=.0001", "plastic:diffuse=0,alpha=0"),
    Limit {
        relation: Relation::HasDeltas,
        ..same(
            "plastic:alpha=0",
            "specular_reflection:fresnel=dielectric,eta=1.5",
        )
    },
    narrow(
        "rough_conductor:alpha=.0001,eta=.143/.375/1.442,k=3.983/2.386/1.603",
        "specular_reflection:fresnel=conductor,eta=.143/.375/1.442,k=3.983/2.386/1.603",
    ),
    Limit {
        relation: Relation::QuarterTurn,
        ..same("ward:alpha_x=.05,alpha_y=.4", "ward:alpha_x=.4,alpha_y=.05")
    },
    Limit {
        relation: Relation::QuarterTurn,
        ..same(
            "ashikhmin_shirley:exponent_x=10,exponent_y=1000",
            "ashikhmin_shirley:exponent_x=1000,exponent_y=10",
        )
    },
    same("phong:specular=0,diffuse=.8", "lambertian_reflection"),
    same("blinn_phong:specular=0,diffuse=.8", "lambertian_reflection"),
    same("ward:specular=0,diffuse=.8", "lambertian_reflection"),
    narrow("ward:alpha=.0001", "specular_reflection"),
    narrow("ward:variant=duer,alpha=.0001", "specular_reflection"),
    narrow("cook_torrance:f0=1,m=.0001", "specular_reflection"),
    narrow(
        "cook_torrance:f0=.04,m=.0001",
        "specular_reflection:fresnel=dielectric,eta=1.5",
    ),
    Limit {
        relation: Relation::Mirrored,
        ..same(
            "retro_reflector:reflectance=1,alpha_x=.1,alpha_y=.4",
            "rough_conductor:fresnel=one,alpha_x=.1,alpha_y=.4",
        )
    },
    Limit {
        relation: Relation::HasDeltas,
        ..same(
            "fresnel_specular:eta=1.33",
            "specular_reflection:fresnel=dielectric,eta=1.33",
        )
    },
    Limit {
        relation: Relation::SameDirection,
        ..same(
            "fresnel_specular:eta=1.33",
            "specular_transmission:eta=1.33",
        )
    },
    same("fresnel_specular:eta=1", "specular_transmission:eta=1"),
    same("thin_dielectric:eta=1", "specular_transmission:eta=1"),
    Limit {
        tolerance: 1e-12,
        reason: "1 - F is below 4 n / (k^2 cos), 1e-17 here",
        ..same(
            "specular_reflection:fresnel=conductor,eta=1,k=10000000000",
            "specular_reflection",
        )
    },
    Limit {
        tolerance: 1e-12,
        reason: "condition numbers of the Fresnel factor up to 100",
        ..same(
            "specular_reflection:fresnel=conductor,eta=1.5,k=0",
            "specular_reflection:fresnel=dielectric,eta=1.5",
        )
    },
];

const fn same(material: &'static str, becomes: &'static str) -> Limit {
    Limit {
        material,
        becomes,
        relation: Relation::Same,
        tolerance: 1e-11,
        reason: SHARED_FORMULA,
    }
}

const fn narrow(material: &'static str, becomes: &'static str) -> Limit {
    Limit {
        material,
        becomes,
        relation: Relation::NarrowLobe,
        tolerance: 1e-3,
        reason: TAIL,
    }
}

/// Checks the limits that begin with `model`.
pub(super) fn limits(model: &ModelSpec, plan: &Plan, tallies: &mut Tallies) {
    for limit in &LIMITS {
        let id = limit.material.split(':').next();
        if id != Some(model.id) {
            continue;
        }
        match (
            limit.material.parse::<Material>(),
            limit.becomes.parse::<Material>(),
        ) {
            (Ok(a), Ok(b)) => {
                let specimens = [a, b].map(|m| Specimen::of_material(&m));
                let [a, b] = &specimens;
                compare(limit, a, b, plan, tallies);
            }
            (Err(error), _) | (_, Err(error)) => {
                tallies.require(LawId::Limits, false, || error.to_string());
            }
        }
    }
}

/// Checks one limit between two specimens.
pub fn compare(limit: &Limit, a: &Specimen, b: &Specimen, plan: &Plan, tallies: &mut Tallies) {
    match limit.relation {
        Relation::Same => {
            same_values(limit, a, b, plan, tallies, |w| w, |w| w);
            same_deltas(limit, a, b, tallies);
        }
        Relation::Mirrored => {
            same_values(
                limit,
                a,
                b,
                plan,
                tallies,
                |w| w,
                Vec3::mirrored_about_normal,
            );
        }
        Relation::QuarterTurn => {
            let turned = |w: Vec3<f64>| Vec3::new(-w.y, w.x, w.z);
            same_values(limit, a, b, plan, tallies, turned, turned);
        }
        Relation::NarrowLobe => narrow_lobe(limit, a, b, tallies),
        Relation::HasDeltas | Relation::SameDirection => same_deltas(limit, a, b, tallies),
    }
}

/// The same values of `f` and `pdf` where the directions of the second model are warped.
fn same_values(
    limit: &Limit,
    a: &Specimen,
    b: &Specimen,
    plan: &Plan,
    tallies: &mut Tallies,
    warp_wo: impl Fn(Vec3<f64>) -> Vec3<f64>,
    warp_wi: impl Fn(Vec3<f64>) -> Vec3<f64>,
) {
    for (wo, wi) in pairs(a, plan, 91) {
        let (to, ti) = (warp_wo(wo.into()), warp_wi(wi.into()));
        let found = a.double.f(wo.into(), wi.into()).0;
        let expected = b.double.f(to, ti).0;
        let pdf = (a.double.pdf(wo.into(), wi.into()), b.double.pdf(to, ti));
        for (x, y) in found.into_iter().zip(expected).chain([pdf]) {
            tallies.record(
                LawId::Limits,
                relative_difference(x, y),
                limit.tolerance,
                || {
                    format!(
                        "{} against {}",
                        a.witness(&[("wo", wo), ("wi", wi)]),
                        b.name
                    )
                },
            );
        }
    }
}

/// The deltas of `b` are those of `a`, in direction and (unless only the direction is asked for) in flux.
fn same_deltas(limit: &Limit, a: &Specimen, b: &Specimen, tallies: &mut Tallies) {
    // A reflection-only model takes a direction below for its mirror image: its index does not change sides.
    let is_shared = |w: &DVec3| limit.relation == Relation::Same || w.z > 0.0;
    for w in directions().into_iter().filter(is_shared) {
        let (found, expected) = (a.double.deltas(w.into()), b.double.deltas(w.into()));
        let witness = || format!("{} against {}", a.witness(&[("w", w)]), b.name);
        let count = |deltas: &bxdf::Deltas<f64>| deltas.iter().flatten().count();
        if limit.relation == Relation::Same {
            tallies.require(LawId::Limits, count(&found) == count(&expected), witness);
        }
        for delta in expected.into_iter().flatten() {
            let Some(twin) = found.iter().flatten().find(|twin| twin.side == delta.side) else {
                tallies.require(LawId::Limits, false, witness);
                continue;
            };
            let miss = DVec3::from(twin.direction - delta.direction).length();
            tallies.record(LawId::Limits, miss, ROUNDING, witness);
            if limit.relation == Relation::SameDirection {
                continue;
            }
            for (x, y) in twin.flux.0.into_iter().zip(delta.flux.0) {
                tallies.record(
                    LawId::Limits,
                    relative_difference(x, y),
                    limit.tolerance,
                    witness,
                );
            }
        }
    }
}

/// The lobe of `a` sends into the cone about each delta of `b` the delta's share, and its reflectance is the delta's.
fn narrow_lobe(limit: &Limit, a: &Specimen, b: &Specimen, tallies: &mut Tallies) {
    /// Samples per direction: at a tail of 6e-4 the mean is off by 1.5e-4 (one standard error) in 2^15.
    const SAMPLES: u32 = 1 << 15;
    let mut random = Random::new(92);
    for w in directions()
        .into_iter()
        .filter(|w| w.z.abs() > SMALLEST_COSINE)
    {
        let rho = directional_hemispherical(&*a.double, w, 1e-6);
        for delta in b.double.deltas(w.into()).into_iter().flatten() {
            let mut flux = [0.0; 3];
            for i in 0..SAMPLES {
                // Stratified, so that the lobes are chosen as often as they should be.
                let uc = (f64::from(i) + random.unit()) / f64::from(SAMPLES);
                let sample = a.double.sample_f(w.into(), uc, random.pair());
                let near = sample.filter(|sample| {
                    frame::angle_between(sample.wi.into(), delta.direction.into()) < CONE
                });
                let weight = near.map_or([0.0; 3], |sample| sample.weight().0);
                flux.iter_mut()
                    .zip(weight)
                    .for_each(|(sum, x)| *sum += x / f64::from(SAMPLES));
            }
            let share = match delta.side {
                Side::Reflection => rho.reflection,
                Side::Transmission => rho.transmission,
            };
            let in_cone = flux.into_iter().zip(delta.weight.0);
            for (x, y) in in_cone.chain(share.into_iter().zip(delta.flux.0)) {
                tallies.record(
                    LawId::Limits,
                    relative_difference(x, y),
                    limit.tolerance,
                    || format!("{} against {}", a.witness(&[("w", w)]), b.name),
                );
            }
        }
    }
}
