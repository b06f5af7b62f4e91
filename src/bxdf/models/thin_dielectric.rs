//! A thin slab of a clear dielectric, a window pane: mirror, and light straight through.
//!
//! # Source
//! Stokes 1862, "On the Intensity of the Light Reflected from or Transmitted through a Pile of Plates" (`stokes1862`), for
//! one plate that absorbs nothing: the bounces between its two faces sum to R' = 2 R / (1 + R), T' = 1 - R', R being the
//! Fresnel reflectance of one face (`born1999`).
//!
//! # Departures
//! None. R and T are of unpolarised light, as everywhere here; the sum over the bounces is taken of them, not of each
//! polarisation apart. The slab's thickness, and with it the sideways shift of the light, is 0.
//!
//! # Validity
//! Thick beside the wavelength (no interference), thin beside all else. The medium is the same on both sides: radiance
//! carries no 1/e^2. Two Dirac deltas, chosen with the probability of their flux: `f` and `pdf` are 0. An index below 1,
//! a film of air in glass, reflects totally beyond its critical angle; light that tunnels through is left out.

use crate::common::*;
use crate::delta_only::{DeltaLobes, DeltaOnly};
use crate::optics::{Spectrum, fresnel};
use crate::param::ParamSet;
use crate::{Delta, Deltas};

/// The list entry.
pub(super) static SPEC: ModelSpec = ModelSpec {
    id: "thin_dielectric",
    title: "Thin dielectric",
    source: "Stokes 1862, On the Intensity of the Light Reflected from or Transmitted through a Pile of Plates",
    summary: "A window pane: one arrow goes straight through, the other is the mirror's, stronger than that of one face",
    lobes: &[
        Lobe::reflection(Category::PerfectSpecular),
        Lobe::transmission(Category::PerfectSpecular),
    ],
    parameters: &[ParamSpec::number(
        "eta",
        1.5,
        "Index of refraction of the slab over that of the medium around it: 1.33 a soap film, 1.5 glass",
    )
    .role(Role::Index)
    .hard(DIELECTRIC_ETA_RANGE[0], DIELECTRIC_ETA_RANGE[1])
    .soft(1.0, 3.0)],
    properties: Properties::PLAIN,
    validate: ModelSpec::any,
    builders: builders!(build),
    // Deltas alone: there is no value to evaluate for less.
    stand_ins: &[],
};

struct ThinDielectric<R> {
    eta: R,
}

fn build<R: Real>(params: &ParamSet) -> Box<dyn Scatterer<R>> {
    Box::new(DeltaOnly(ThinDielectric {
        eta: R::of(params.number("eta")),
    }))
}

impl<R: Real> DeltaLobes<R> for ThinDielectric<R> {
    #[inline(always)]
    fn deltas(&self, w: Vec3<R>) -> Deltas<R> {
        let one = R::one();
        let face = fresnel::dielectric_along(w, self.eta);
        let reflectance = R::of(2.0) * face.reflectance / (one + face.reflectance);
        let transmittance = face.transmittance / (one + face.reflectance);
        let delta = |direction, flux, probability, side| {
            (flux > R::zero()).then(|| Delta {
                direction,
                flux: Spectrum::grey(flux),
                weight: Spectrum::grey(flux),
                probability,
                side,
            })
        };
        // The rest, so that the two probabilities sum to 1 without a gap for uc to fall into; near total reflection that
        // rest may round to 0 where the transmittance does not.
        let rest = (one - reflectance).max(transmittance);
        [
            delta(
                w.mirrored_about_normal(),
                reflectance,
                reflectance,
                Side::Reflection,
            ),
            delta(-w, transmittance, rest, Side::Transmission),
        ]
    }
}

#[cfg(test)]
mod tests {
    use crate::math::Vec3;
    use crate::math::frame::direction_from_degrees;
    use crate::optics::fresnel;
    use crate::{Delta, Material};

    fn deltas(material: &str, w: Vec3<f64>) -> [Option<Delta<f64>>; 2] {
        material
            .parse::<Material>()
            .unwrap()
            .build::<f64>()
            .deltas(w)
    }

    #[test]
    fn a_pane_of_glass_reflects_two_twenty_sixths_at_normal_incidence() {
        let [reflected, transmitted] = deltas("thin_dielectric", Vec3::new(0.0, 0.0, 1.0));
        assert!(reflected.is_some_and(|d| (d.flux.0[0] - 1.0 / 13.0).abs() < 1e-15));
        assert!(
            transmitted.is_some_and(|d| {
                (d.flux.0[0] - 12.0 / 13.0).abs() < 1e-15 && d.flux == d.weight
            })
        );
    }

    #[test]
    fn the_bounces_inside_sum_to_the_closed_form() {
        let w: Vec3<f64> = direction_from_degrees(70.0, 20.0).into();
        let face = fresnel::dielectric(w.z, 1.5);
        let (r, t) = (face.reflectance, face.transmittance);
        // Out of the second face at once, or after an even number of bounces inside.
        let through: f64 = (0..60).map(|bounces| t * t * r.powi(2 * bounces)).sum();
        let [reflected, transmitted] = deltas("thin_dielectric", w);
        let transmitted = transmitted.unwrap();
        assert!((transmitted.flux.0[0] - through).abs() < 1e-15);
        assert_eq!(transmitted.direction, -w, "straight through");
        assert!((reflected.unwrap().flux.0[0] + through - 1.0).abs() < 1e-15);
    }

    #[test]
    fn no_slab_and_total_reflection() {
        let w: Vec3<f64> = direction_from_degrees(60.0, 0.0).into();
        let [reflected, transmitted] = deltas("thin_dielectric:eta=1", w);
        assert!(reflected.is_none() && transmitted.is_some_and(|d| d.flux.0 == [1.0; 3]));
        // sin(60 degrees) is above .8: a film of air.
        let [reflected, transmitted] = deltas("thin_dielectric:eta=0.8", w);
        assert!(transmitted.is_none() && reflected.is_some_and(|d| d.flux.0 == [1.0; 3]));
    }

    #[test]
    fn grazing_light_always_finds_its_way() {
        for z in [1e-8, 1e-17, 1e-300] {
            for delta in deltas("thin_dielectric", Vec3::new(1.0, 0.0, z))
                .iter()
                .flatten()
            {
                assert!(
                    delta.probability > 0.0 && delta.probability <= 1.0,
                    "{delta:?}"
                );
            }
        }
    }
}
