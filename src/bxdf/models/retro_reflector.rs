//! A retro-reflective sheet: the lobe points back to where the light came from.
//!
//! # Source
//! Belcour, Pacanowski, Delahaie, Laville-Geay, Eupherte 2014, "BRDF Measurements and Analysis of Retroreflective
//! Materials" (`belcour2014`), hal-01083366: the back vector parametrisation. A glossy lobe of the direction to the
//! viewer and the mirrored direction to the light peaks at wi = wo.
//!
//! # Departures
//! The lobe put behind the back vector is GGX with correlated masking and no Fresnel factor, scaled by `reflectance`;
//! the paper fits several.
//!
//! # Validity
//! As `rough_conductor`: light lost to repeated facets, saturation where both directions graze.

use crate::common::*;
use crate::microfacet::ggx::Ggx;
use crate::microfacet::{Masking, Normals, ONE_WIDTH, Pair, alpha, evaluated_by_pair};
use crate::optics::Spectrum;
use crate::param::ParamSet;
use crate::sample_reflection;

/// The list entry.
pub(super) static SPEC: ModelSpec = ModelSpec {
    id: "retro_reflector",
    title: "Retro-reflector",
    source: "Belcour et al. 2014, BRDF Measurements and Analysis of Retroreflective Materials",
    summary: "A road sign or a bicycle reflector: the lobe points back at the light, wherever it stands",
    lobes: &[Lobe::reflection(Category::RetroReflective)],
    parameters: &[
        REFLECTANCE,
        alpha("alpha_x", 0.15, "Width of the returned lobe along s").role(Role::WidthS),
        alpha("alpha_y", 0.15, "Width of the returned lobe along t").role(Role::WidthT),
    ],
    properties: Properties::TWO_WIDTHS,
    validate: ModelSpec::any,
    builders: builders!(build),
    stand_ins: &[ONE_WIDTH],
};

struct RetroReflector<R> {
    reflectance: Spectrum<R>,
    ggx: Ggx<R>,
}

fn build<R: Real>(params: &ParamSet) -> Box<dyn Scatterer<R>> {
    Box::new(RetroReflector {
        reflectance: Spectrum::of(params.rgb("reflectance")),
        ggx: Ggx::new(
            R::of(params.number("alpha_x")),
            R::of(params.number("alpha_y")),
        ),
    })
}

impl<R: Real> RetroReflector<R> {
    /// `wo` and `wi` turned back about the normal.
    #[inline(always)]
    fn pair(wo: Vec3<R>, wi: Vec3<R>) -> Option<Pair<R>> {
        Pair::above(wo, wi.mirrored_about_normal())
    }

    #[inline(always)]
    fn value(&self, pair: &Pair<R>) -> Spectrum<R> {
        self.reflectance * self.ggx.lobe(pair, Masking::Correlated)
    }

    #[inline(always)]
    fn density(&self, pair: &Pair<R>) -> R {
        self.ggx.reflection_pdf(pair)
    }
}

impl<R: Real> Bxdf<R> for RetroReflector<R> {
    evaluated_by_pair!(Self::pair);

    #[inline(always)]
    fn sample_f(&self, wo: Vec3<R>, _uc: R, u: [R; 2]) -> Option<Sample<R>> {
        sample_reflection(
            self,
            wo,
            #[inline(always)]
            |wo| Some(self.ggx.sample_reflection(wo, u)?.mirrored_about_normal()),
        )
    }
}

impl<R: Real> Lobes<R> for RetroReflector<R> {
    fn lobes(&self) -> &[Lobe] {
        SPEC.lobes
    }
}

impl<R: Real> Scatterer<R> for RetroReflector<R> {
    loops!(R, if true);
}

#[cfg(test)]
mod tests {
    use crate::Material;
    use crate::math::frame::direction_from_degrees;

    #[test]
    fn the_light_gets_most_of_it_back() {
        let sign: Material = "retro_reflector".parse().unwrap();
        let sign = sign.build::<f64>();
        let light = direction_from_degrees(40.0, 25.0).into();
        let f = |theta, phi| sign.f(direction_from_degrees(theta, phi).into(), light).0[0];
        assert!(f(40.0, 25.0) > f(35.0, 25.0) && f(40.0, 25.0) > f(40.0, 35.0));
        assert!(f(40.0, 25.0) > 100.0 * f(40.0, 205.0));
    }
}
