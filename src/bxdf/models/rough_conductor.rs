//! A rough metal: microfacet mirrors with GGX-distributed normals.
//!
//! # Source
//! Torrance & Sparrow 1967 for the facet model (`torrance1967`), Walter et al. 2007 for GGX (`walter2007`), Heitz 2014
//! for the masking (`heitz2014`): f = F D G2 / (4 mu_o mu_i).
//!
//! # Departures
//! None in value; the formulas are rearranged to keep their digits (see `microfacet::ggx`).
//!
//! # Validity
//! Light that meets several facets is lost: at alpha 1 up to 31 % at normal incidence with F = 1. alpha 1e-4 is the
//! narrowest lobe; 0 is the business of `specular_reflection`. In f32 the value saturates where both directions graze.

use super::*;
use crate::bxdf::microfacet::ggx::Ggx;
use crate::bxdf::microfacet::{ALPHA_X, ALPHA_Y, Masking, half_vector};
use crate::bxdf::optics::{Spectrum, fresnel};
use crate::bxdf::param::ParamSet;
use crate::bxdf::{both_above, sample_reflection};

/// The list entry.
pub(super) static SPEC: ModelSpec = ModelSpec {
    id: "rough_conductor",
    title: "Rough conductor",
    source: "Torrance & Sparrow 1967; Walter et al. 2007; Heitz 2014",
    summary: "A metal of tiny mirrors: the lobe follows the mirror direction, narrow when smooth, wide when rough, a blade \
              when the two widths differ",
    lobes: &[Lobe::reflection(Category::GlossySpecular)],
    parameters: &[
        ParamSpec::choice(
            "fresnel",
            &["conductor", "schlick", "one"],
            "Reflectance of a facet: exact for a metal of index eta and k, Schlick's approximation from f0, or 1",
        ),
        CONDUCTOR_ETA.relevant_when("fresnel", &["conductor"]),
        CONDUCTOR_K.relevant_when("fresnel", &["conductor"]),
        ParamSpec::rgb("f0", [0.9; 3], "Reflectance of a facet at normal incidence")
            .relevant_when("fresnel", &["schlick"]),
        ALPHA_X,
        ALPHA_Y,
        Masking::PARAM,
    ],
    properties: Properties::TWO_WIDTHS,
    validate: |params| {
        if params.choice("fresnel") == "conductor" {
            refuse_zero_index(params)
        } else {
            Ok(())
        }
    },
    builders: Builders {
        f32: build,
        f64: build,
        reference: build,
    },
};

enum Fresnel<R> {
    Conductor(Spectrum<R>, Spectrum<R>),
    Schlick(Spectrum<R>),
    One,
}

impl<R: Real> Fresnel<R> {
    #[inline(always)]
    fn at(&self, cos_d: R) -> Spectrum<R> {
        match self {
            Self::Conductor(eta, k) => eta.zip(*k, |n, k| fresnel::conductor(cos_d, n, k)),
            Self::Schlick(f0) => f0.map(|f0| fresnel::schlick(cos_d, f0)),
            Self::One => Spectrum::grey(R::one()),
        }
    }
}

struct RoughConductor<R> {
    ggx: Ggx<R>,
    masking: Masking,
    fresnel: Fresnel<R>,
}

fn build<R: Real>(params: &ParamSet) -> Box<dyn Bxdf<R>> {
    let fresnel = match params.choice("fresnel") {
        "schlick" => Fresnel::Schlick(Spectrum::of(params.rgb("f0"))),
        "one" => Fresnel::One,
        _ => Fresnel::Conductor(
            Spectrum::of(params.rgb("eta")),
            Spectrum::of(params.rgb("k")),
        ),
    };
    Box::new(RoughConductor {
        ggx: Ggx::new(
            R::of(params.number("alpha_x")),
            R::of(params.number("alpha_y")),
        ),
        masking: Masking::from_params(params),
        fresnel,
    })
}

impl<R: Real> Bxdf<R> for RoughConductor<R> {
    fn f(&self, wo: Vec3<R>, wi: Vec3<R>) -> Spectrum<R> {
        let Some((wo, wi)) = both_above(wo, wi) else {
            return Spectrum::black();
        };
        let Some((wh, cos_d)) = half_vector(wo, wi) else {
            return Spectrum::black();
        };
        self.fresnel.at(cos_d) * self.ggx.lobe(wo, wi, wh, self.masking)
    }

    fn pdf(&self, wo: Vec3<R>, wi: Vec3<R>) -> R {
        both_above(wo, wi)
            .and_then(|(wo, wi)| half_vector(wo, wi).map(|(wh, _)| self.ggx.reflection_pdf(wo, wh)))
            .unwrap_or(R::zero())
    }

    fn sample_f(&self, wo: Vec3<R>, _uc: R, u: [R; 2]) -> Option<Sample<R>> {
        sample_reflection(self, wo, |wo| self.ggx.sample_reflection(wo, u))
    }
}

#[cfg(test)]
mod tests {
    use crate::bxdf::Material;
    use crate::bxdf::math::Vec3;

    #[test]
    fn the_peak_at_normal_incidence_is_f_over_four_pi_alpha_squared() {
        let gold: Material = "rough_conductor:alpha=0.1".parse().unwrap();
        let up = Vec3::new(0.0, 0.0, 1.0);
        let f = gold.build::<f64>().f(up, up).0[0];
        let (n, k): (f64, f64) = (0.143, 3.983);
        let reflectance = ((n - 1.0).powi(2) + k * k) / ((n + 1.0).powi(2) + k * k);
        assert!((f / (reflectance / (4.0 * std::f64::consts::PI * 0.01)) - 1.0).abs() < 1e-14);
    }

    #[test]
    fn opposed_and_doubly_grazing_directions_stay_finite() {
        let mirror: Material = "rough_conductor:fresnel=one,alpha=0.0001".parse().unwrap();
        let model = mirror.build::<f32>();
        for z in [1e-38_f32, 1e-30, 1e-20, 1e-7] {
            for x in [-1.0_f32, 1.0] {
                let (wo, wi) = (Vec3::new(1.0, 0.0, z), Vec3::new(x, 0.0, z));
                let (f, pdf) = (model.f(wo, wi).0[0], model.pdf(wo, wi));
                assert!(
                    f.is_finite() && f >= 0.0 && pdf.is_finite() && pdf >= 0.0,
                    "{wo:?} {wi:?}: {f} {pdf}"
                );
            }
        }
    }
}
