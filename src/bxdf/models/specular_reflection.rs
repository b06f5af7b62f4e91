//! A perfect mirror: all that is reflected goes in the mirror direction.
//!
//! # Source
//! The law of reflection; Fresnel's equations for the weight (`born1999`).
//!
//! # Departures
//! None.
//!
//! # Validity
//! A Dirac delta: `f` and `pdf` are 0, the lobe is what [`Bxdf::deltas`] and [`Bxdf::sample_f`] return. A dielectric's
//! transmitted light is dropped (it counts as absorbed); `fresnel_specular` keeps it.

use crate::common::*;
use crate::delta_only::{DeltaLobes, DeltaOnly};
use crate::optics::{Spectrum, conductor, fresnel};
use crate::param::ParamSet;
use crate::{Delta, Deltas};

/// The list entry.
pub(super) static SPEC: ModelSpec = ModelSpec {
    id: "specular_reflection",
    title: "Specular reflection",
    source: "Law of reflection; Fresnel's equations, Born & Wolf 1999, sections 1.5 and 14.2",
    summary: "A perfect mirror: one arrow in the mirror direction, and nothing anywhere else",
    lobes: &[Lobe::reflection(Category::PerfectSpecular)],
    parameters: &[
        ParamSpec::choice(
            "fresnel",
            &["one", "dielectric", "conductor"],
            "How much is reflected: all of it, as a dielectric of index eta, or as a metal of index eta and k",
        )
        .role(Role::Fresnel),
        ParamSpec::rgb(
            "reflectance",
            [1.0; 3],
            "Factor on the reflected light, per channel",
        ),
        ParamSpec::rgb(
            "eta",
            [1.5; 3],
            "Index of refraction below the surface over the one above",
        )
        .role(Role::Index)
        .hard(0.0, 1e4)
        .soft(0.0, 5.0)
        .relevant_when("fresnel", &["dielectric", "conductor"]),
        ParamSpec::rgb("k", [0.0; 3], "Absorption index of the metal")
            .role(Role::Absorption)
            .hard(0.0, 1e10)
            .soft(0.0, 10.0)
            .relevant_when("fresnel", &["conductor"]),
    ],
    properties: Properties::PLAIN,
    validate,
    builders: builders!(build),
    // Deltas alone: there is no value to evaluate for less.
    stand_ins: &[],
};

fn validate(params: &ParamSet) -> Result<()> {
    let [min, max] = DIELECTRIC_ETA_RANGE;
    match params.choice("fresnel") {
        "dielectric"
            if params
                .rgb("eta")
                .iter()
                .any(|eta| !(min..=max).contains(eta)) =>
        {
            Err(params.error("eta", format!("allowed for a dielectric is {min} to {max}")))
        }
        "conductor" => refuse_zero_index(params),
        _ => Ok(()),
    }
}

enum Fresnel<R> {
    One,
    Dielectric(Spectrum<R>),
    Conductor(conductor::Conductor<R>),
}

struct SpecularReflection<R> {
    reflectance: Spectrum<R>,
    fresnel: Fresnel<R>,
}

fn build<R: Real>(params: &ParamSet) -> Box<dyn Scatterer<R>> {
    let eta = Spectrum::of(params.rgb("eta"));
    let fresnel = match params.choice("fresnel") {
        "dielectric" => Fresnel::Dielectric(eta),
        "conductor" => {
            let Spectrum(k) = Spectrum::of(params.rgb("k"));
            Fresnel::Conductor(conductor::Conductor::new(eta.0, k))
        }
        _ => Fresnel::One,
    };
    Box::new(DeltaOnly(SpecularReflection {
        reflectance: Spectrum::of(params.rgb("reflectance")),
        fresnel,
    }))
}

impl<R: Real> DeltaLobes<R> for SpecularReflection<R> {
    #[inline(always)]
    fn deltas(&self, w: Vec3<R>) -> Deltas<R> {
        let cos = w.z.abs();
        let share = match &self.fresnel {
            Fresnel::One => Spectrum::grey(R::one()),
            Fresnel::Dielectric(eta) => eta.map(|n| fresnel::dielectric(cos, n).reflectance),
            Fresnel::Conductor(metal) => Spectrum(metal.reflectance(cos)),
        };
        let flux = self.reflectance * share;
        let direction = w.mirrored_about_normal();
        [
            Some(Delta {
                direction,
                flux,
                weight: flux,
                probability: R::one(),
                side: Side::Reflection,
            }),
            None,
        ]
    }
}
