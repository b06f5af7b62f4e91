//! The first microfacet model of computer graphics: Beckmann's normals in V-shaped grooves.
//!
//! # Source
//! Cook & Torrance 1982, "A Reflectance Model for Computer Graphics" (`cook1982`): f = F D G / (4 mu_o mu_i), D Beckmann's
//! distribution of rms slope `m`, G = min(1, 2 (n.wh) mu_o / (wo.wh), 2 (n.wh) mu_i / (wo.wh)) the masking of long grooves
//! (`torrance1967`), F exact for a dielectric whose index follows from the reflectance at normal incidence,
//! (1 + sqrt f0) / (1 - sqrt f0).
//!
//! # Departures
//! D is normalised and the prefactor 1/4: the paper's is 1/pi with a D that lacks 1/pi, four times as bright, with which a
//! white surface would reflect four times what it receives. The paper's index for a coloured metal is taken per channel,
//! and its diffuse part is left out (materials add one).
//!
//! # Validity
//! G is exact for V-cavities: the normals seen sum to the area seen, so energy is kept (`heitz2014`); its crease is visible
//! at grazing angles. f0 = 1 reflects all at every angle; f0 = 0 nothing, at every angle. m 1e-4..1.

use super::rough_conductor;
use crate::common::*;
use crate::glossy::gaussian_slopes::GaussianSlopes;
use crate::glossy::reflected;
use crate::microfacet::{Pair, alpha, evaluated_by_pair};
use crate::optics::Spectrum;
use crate::param::ParamSet;
use crate::{Microfacet, sample_reflection};

/// The list entry.
pub(super) static SPEC: ModelSpec = ModelSpec {
    id: "cook_torrance",
    title: "Cook-Torrance",
    source: "Cook & Torrance 1982, A Reflectance Model for Computer Graphics",
    summary: "The model that told metal from plastic: the highlight takes the metal's colour and whitens towards the \
              horizon; grooves cut it off with a crease",
    lobes: &[Lobe::reflection(Category::GlossySpecular)],
    parameters: &[
        ParamSpec::rgb(
            "f0",
            [0.9; 3],
            "Reflectance of a facet at normal incidence, per channel; the index of refraction follows from it",
        ),
        alpha(
            "m",
            0.2,
            "Root mean square slope of the facets: the larger, the wider the lobe",
        ),
    ],
    properties: Properties::PLAIN,
    validate: ModelSpec::any,
    builders: builders!(build),
    stand_ins: &[StandIn {
        name: "Smith masking and Schlick for grooves and exact Fresnel",
        lost: "Grooves no longer cut the highlight off with a crease, and the reflectance rises towards the horizon by a \
               power of the cosine",
        replace: |params| {
            let m = Value::Number(params.number("m"));
            rough_conductor::SPEC.text_at(&[
                ("fresnel", Value::Choice("schlick")),
                ("f0", Value::Rgb(params.rgb("f0"))),
                ("alpha_x", m),
                ("alpha_y", m),
                ("distribution", Value::Choice("beckmann")),
            ])
        },
    }],
};

struct CookTorrance<R> {
    f0: Spectrum<R>,
    slopes: GaussianSlopes<R>,
}

fn build<R: Real>(params: &ParamSet) -> Box<dyn Scatterer<R>> {
    let m = R::of(params.number("m"));
    Box::new(CookTorrance {
        f0: Spectrum::of(params.rgb("f0")),
        slopes: GaussianSlopes::new(m, m),
    })
}

/// Dielectric Fresnel reflectance from that at normal incidence, `f0`; 1 where that is 1.
///
/// With r = sqrt(f0), n^2 - 1 = 4 r / (1 - r)^2, and F is a function of c and n^2 - 1 alone (`optics::fresnel`): neither an
/// index near 1 nor a huge one loses digits. 1 - r comes from 1 - f0, which is exact near 1.
#[inline(always)]
fn reflectance<R: Real>(cos_d: R, f0: R) -> R {
    let one = R::one();
    if f0 >= one {
        return one;
    }
    let root = f0.sqrt();
    let one_minus_root = (one - f0) / (one + root);
    let d = R::of(4.0) * root / (one_minus_root * one_minus_root);
    let c = cos_d;
    let c_plus_g = c + (c * c + d).sqrt();
    // Two divisions: at index 1 and grazing incidence the square would underflow to 0/0.
    let r_s = d / c_plus_g / c_plus_g;
    let ratio_p_to_s = (c * c_plus_g - one) / (c * (d / c_plus_g) + one);
    (R::of(0.5) * r_s * r_s * (one + ratio_p_to_s * ratio_p_to_s)).min(one)
}

/// G of the V-cavities, `cos_o` and `cos_i` above 0.
#[inline(always)]
fn groove_masking<R: Real>(cos_o: R, cos_i: R, cos_h: R, cos_d: R) -> R {
    (R::of(2.0) * cos_h * (cos_o.min(cos_i) / cos_d)).min(R::one())
}

impl<R: Real> CookTorrance<R> {
    /// D G / (4 mu_o mu_i), saturated.
    #[inline(always)]
    fn lobe(&self, pair: &Pair<R>) -> R {
        let Pair { wo, wi, wh, cos_d } = *pair;
        let d = self.slopes.d(wh);
        let (smaller, larger) = (wo.z.min(wi.z), wo.z.max(wi.z));
        let value = if groove_masking(wo.z, wi.z, wh.z, cos_d) < R::one() {
            // G over the smaller cosine is 2 (n.wh) / (wo.wh): that cosine cancels.
            d * R::of(0.5) * wh.z / cos_d / larger
        } else {
            // One by one: the product of the cosines can underflow where the value is still a number.
            d * R::of(0.25) / smaller / larger
        };
        value.saturated()
    }

    #[inline(always)]
    fn value(&self, pair: &Pair<R>) -> Spectrum<R> {
        self.f0.map(|f0| reflectance(pair.cos_d, f0)) * self.lobe(pair)
    }

    #[inline(always)]
    fn density(&self, pair: &Pair<R>) -> R {
        (self.slopes.normal_pdf(pair.wh) * R::of(0.25) / pair.cos_d).saturated()
    }
}

impl<R: Real> Bxdf<R> for CookTorrance<R> {
    evaluated_by_pair!(Pair::above);

    #[inline(always)]
    fn sample_f(&self, wo: Vec3<R>, _uc: R, u: [R; 2]) -> Option<Sample<R>> {
        sample_reflection(
            self,
            wo,
            #[inline(always)]
            |wo| self.slopes.sample(u).map(|wh| reflected(wo, wh)),
        )
    }
}

impl<R: Real> Lobes<R> for CookTorrance<R> {
    fn lobes(&self) -> &[Lobe] {
        SPEC.lobes
    }

    fn microfacet(&self, wo: Vec3<R>, wi: Vec3<R>) -> Option<Microfacet<R>> {
        let Pair { wo, wi, wh, cos_d } = Pair::above(wo, wi)?;
        Some(Microfacet {
            d: self.slopes.d(wh),
            g: groove_masking(wo.z, wi.z, wh.z, cos_d),
            fresnel: self.f0.map(|f0| reflectance(cos_d, f0)),
        })
    }
}

impl<R: Real> Scatterer<R> for CookTorrance<R> {
    loops!(R, if true);
}

#[cfg(test)]
mod tests {
    use super::reflectance;
    use crate::Material;
    use crate::math::frame::direction_from_degrees;
    use crate::optics::fresnel;
    use std::f64::consts::PI;

    #[test]
    fn the_value_is_the_published_product() {
        let model: Material = "cook_torrance:f0=.04,m=.3".parse().unwrap();
        let model = model.build::<f64>();
        let cos = |degrees: f64| degrees.to_radians().cos();
        let tan = |degrees: f64| degrees.to_radians().tan();
        for (theta_o, theta_i, is_masked) in [(30.0, 10.0, false), (80.0, 20.0, true)] {
            let (theta_h, theta_d): (f64, f64) =
                (0.5 * (theta_o - theta_i), f64::midpoint(theta_o, theta_i));
            let wo = direction_from_degrees(theta_o, 180.0).into();
            let wi = direction_from_degrees(theta_i, 0.0).into();
            let d = (-(tan(theta_h) / 0.3).powi(2)).exp() / (PI * 0.09 * cos(theta_h).powi(4));
            let g = (2.0 * cos(theta_h) * cos(theta_o) / cos(theta_d)).min(1.0);
            assert_eq!(g < 1.0, is_masked);
            // sqrt(.04) = .2: the index is 1.2 / .8.
            let f = fresnel::dielectric(cos(theta_d), 1.5).reflectance;
            let expected = f * d * g / (4.0 * cos(theta_o) * cos(theta_i));
            assert!((model.f(wo, wi).0[0] / expected - 1.0).abs() < 1e-13);
            let parts = model.microfacet(wo, wi).unwrap();
            assert!((parts.d / d - 1.0).abs() < 1e-13 && (parts.g / g - 1.0).abs() < 1e-14);
            assert!((parts.fresnel.0[0] / f - 1.0).abs() < 1e-13);
        }
    }

    #[test]
    fn the_reflectance_comes_from_the_index_it_stands_for() {
        for f0 in [1e-4_f64, 0.04, 0.5, 0.9, 0.999] {
            let root = f0.sqrt();
            let n = (1.0 + root) / (1.0 - root);
            for c in [1e-3, 0.2, 0.7, 1.0] {
                let expected = fresnel::dielectric(c, n).reflectance;
                // The index itself loses digits near 1 and as it grows.
                assert!(
                    (reflectance(c, f0) / expected - 1.0).abs() < 1e-12,
                    "{f0} {c}"
                );
            }
            assert!((reflectance(1.0, f0) / f0 - 1.0).abs() < 1e-14);
        }
        assert_eq!(reflectance(0.3, 1.0), 1.0);
        for c in [1.0, 0.3, 1e-38, 1e-200] {
            assert_eq!(reflectance(c, 0.0), 0.0);
        }
        // The largest f0 below 1 in f32, and the smallest.
        for f0 in [1.0 - f32::EPSILON / 2.0, f32::MIN_POSITIVE] {
            assert!(
                [1.0, 0.5, 1e-30]
                    .iter()
                    .all(|c| (0.0..=1.0).contains(&reflectance(*c, f0)))
            );
        }
    }
}
