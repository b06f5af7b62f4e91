//! A smooth dielectric interface: mirror and refraction, shared by Fresnel's equations.
//!
//! # Source
//! Fresnel's equations, Born & Wolf 1999, section 1.5 (`born1999`); the radiance factor 1/e^2 of Veach 1997
//! (`veach1997`).
//!
//! # Departures
//! None.
//!
//! # Validity
//! Two Dirac deltas, chosen with the probability of their flux: `f` and `pdf` are 0. Total internal reflection leaves
//! the mirror alone.

use crate::common::*;
use crate::delta_only::{DeltaLobes, DeltaOnly};
use crate::optics::{Spectrum, fresnel};
use crate::param::ParamSet;
use crate::{Delta, Deltas};

/// The list entry.
pub(super) static SPEC: ModelSpec = ModelSpec {
    id: "fresnel_specular",
    title: "Fresnel specular",
    source: "Fresnel's equations, Born & Wolf 1999, section 1.5",
    summary: "Clear glass or water: two arrows share the light, the mirror's grows towards grazing incidence",
    lobes: &[
        Lobe::reflection(Category::PerfectSpecular),
        Lobe::transmission(Category::PerfectSpecular),
    ],
    parameters: &[DIELECTRIC_ETA],
    properties: Properties {
        relative_index: |params| params.number("eta"),
        ..Properties::PLAIN
    },
    validate: ModelSpec::any,
    builders: builders!(build),
    // Deltas alone: there is no value to evaluate for less.
    stand_ins: &[],
};

struct FresnelSpecular<R> {
    eta: R,
}

fn build<R: Real>(params: &ParamSet) -> Box<dyn Scatterer<R>> {
    Box::new(DeltaOnly(FresnelSpecular {
        eta: R::of(params.number("eta")),
    }))
}

impl<R: Real> DeltaLobes<R> for FresnelSpecular<R> {
    #[inline(always)]
    fn deltas(&self, w: Vec3<R>) -> Deltas<R> {
        let e = if w.z > R::zero() {
            self.eta
        } else {
            R::one() / self.eta
        };
        let share = fresnel::dielectric_along(w, e);
        let reflected = Delta {
            direction: w.mirrored_about_normal(),
            flux: Spectrum::grey(share.reflectance),
            weight: Spectrum::grey(share.reflectance),
            probability: share.reflectance,
            side: Side::Reflection,
        };
        let transmitted = Delta {
            direction: fresnel::refracted(w, e, share.cos_t),
            flux: Spectrum::grey(share.transmittance),
            weight: Spectrum::grey(share.transmittance / (e * e)),
            // Not 1 - reflectance, which rounds to 0 where little crosses.
            probability: share.transmittance,
            side: Side::Transmission,
        };
        let carries = |delta: Delta<R>| (delta.flux.max_channel() > R::zero()).then_some(delta);
        [carries(reflected), carries(transmitted)]
    }
}

#[cfg(test)]
mod tests {
    use crate::Material;
    use crate::math::Vec3;

    #[test]
    fn glass_at_normal_incidence_shares_four_to_ninety_six() {
        let glass: Material = "fresnel_specular".parse().unwrap();
        let [reflected, transmitted] = glass
            .build::<f64>()
            .deltas(Vec3::new(0.0, 0.0, 1.0))
            .map(Option::unwrap);
        assert!((reflected.flux.0[0] - 0.04).abs() < 1e-15);
        assert!((transmitted.flux.0[0] - 0.96).abs() < 1e-15);
        assert!(
            (transmitted.weight.0[0] - 0.96 / 2.25).abs() < 1e-15,
            "radiance carries 1/e^2"
        );
        let inside = glass.build::<f64>().deltas(Vec3::new(0.8, 0.0, -0.6));
        assert!(inside[0].is_some_and(|delta| delta.flux.0[0] == 1.0) && inside[1].is_none());
    }

    #[test]
    fn equal_indices_leave_the_light_alone() {
        let nothing: Material = "fresnel_specular:eta=1".parse().unwrap();
        let [reflected, transmitted] = nothing.build::<f64>().deltas(Vec3::new(0.6, 0.0, 0.8));
        assert!(reflected.is_none());
        assert!(
            transmitted
                .is_some_and(|d| d.flux.0 == [1.0; 3] && d.direction == Vec3::new(-0.6, 0.0, -0.8))
        );
    }
}
