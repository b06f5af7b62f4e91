//! Perfect refraction without loss: what crosses goes in the refracted direction.
//!
//! # Source
//! Snell's law; the radiance factor 1/e^2 of Veach 1997, section 5.2 (`veach1997`).
//!
//! # Departures
//! No Fresnel factor: the share of the flux that crosses is `transmittance` at every angle. `fresnel_specular` has it.
//!
//! # Validity
//! A Dirac delta: `f` and `pdf` are 0. No sample at total internal reflection. At grazing incidence a true interface
//! transmits nothing, this one still does.

use crate::common::*;
use crate::delta_only::{DeltaLobes, DeltaOnly};
use crate::optics::{Spectrum, fresnel};
use crate::param::ParamSet;
use crate::{Delta, Deltas};

/// The list entry.
pub(super) static SPEC: ModelSpec = ModelSpec {
    id: "specular_transmission",
    title: "Specular transmission",
    source: "Snell's law; radiance across an interface, Veach 1997, section 5.2",
    summary: "One refracted arrow below the surface, bent towards the normal; from inside it vanishes beyond the critical angle",
    lobes: &[Lobe::transmission(Category::PerfectSpecular)],
    parameters: &[
        ParamSpec::rgb(
            "transmittance",
            [1.0; 3],
            "Share of the light that is transmitted, per channel",
        ),
        DIELECTRIC_ETA,
    ],
    properties: Properties {
        relative_index: |params| params.number("eta"),
        ..Properties::PLAIN
    },
    validate: ModelSpec::any,
    builders: builders!(build),
    // Deltas alone: there is no value to evaluate for less.
    stand_ins: &[],
};

struct SpecularTransmission<R> {
    transmittance: Spectrum<R>,
    eta: R,
}

fn build<R: Real>(params: &ParamSet) -> Box<dyn Scatterer<R>> {
    Box::new(DeltaOnly(SpecularTransmission {
        transmittance: Spectrum::of(params.rgb("transmittance")),
        eta: R::of(params.number("eta")),
    }))
}

impl<R: Real> DeltaLobes<R> for SpecularTransmission<R> {
    #[inline(always)]
    fn deltas(&self, w: Vec3<R>) -> Deltas<R> {
        let e = if w.z > R::zero() {
            self.eta
        } else {
            R::one() / self.eta
        };
        let cos_t = fresnel::dielectric_along(w, e).cos_t;
        if w.z == R::zero() || cos_t == R::zero() {
            return [None, None];
        }
        let delta = Delta {
            direction: fresnel::refracted(w, e, cos_t),
            flux: self.transmittance,
            weight: self.transmittance * (R::one() / (e * e)),
            probability: R::one(),
            side: Side::Transmission,
        };
        [Some(delta), None]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Material;
    use crate::math::frame::direction_from_degrees;

    #[test]
    fn beyond_the_critical_angle_nothing_crosses() {
        let glass: Material = "specular_transmission".parse().unwrap();
        let glass = glass.build::<f64>();
        // The critical angle of 1.5 is 41.81 degrees.
        for (theta, crosses) in [(41.8, true), (41.9, false)] {
            let from_inside = direction_from_degrees(180.0 - theta, 0.0).into();
            assert_eq!(glass.deltas(from_inside)[0].is_some(), crosses, "{theta}");
        }
    }

    #[test]
    fn a_delta_and_its_way_back_are_reciprocal() {
        let glass: Material = "specular_transmission:transmittance=0.9".parse().unwrap();
        let glass = glass.build::<f64>();
        let w: Vec3<f64> = direction_from_degrees(50.0, 20.0).into();
        let there = glass.deltas(w)[0].unwrap();
        let back = glass.deltas(there.direction)[0].unwrap();
        assert!((back.direction - w).length_squared() < 1e-30);
        assert!((there.weight.0[0] * back.weight.0[0] - 0.81).abs() < 1e-15);
        assert_eq!(there.flux, back.flux);
    }
}
