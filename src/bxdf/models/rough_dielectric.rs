//! Frosted glass: microfacets that each mirror a part of the light and refract the rest.
//!
//! # Source
//! Walter et al. 2007 (`walter2007`), eqs. 19 to 21 and 33 to 38, with the masking of Heitz 2014 (`heitz2014`). Viewed
//! along wo, with e the index on wi's side over that on wo's, g = wo + wi in reflection and wo + e wi in transmission is
//! along the microfacet's normal h, and f = F D G2 / (4 mu_o mu_i) or, for radiance,
//! (1 - F) D G2 |wo.h wi.h| / (mu_o mu_i |g|^2). F is exact, or Schlick's approximation (`schlick1994`), or that with the term
//! of Lazanyi & Szirmay-Kalos (`lazanyi2005`), by the cosine on the side of the lower index.
//!
//! # Departures
//! Correlated masking is 1 / (1 + Lambda_o + Lambda_i) across the surface too, as is common; heights that mask one side
//! bare the other, and the exact factor is the smaller Beta(1 + Lambda_o, 1 + Lambda_i) of Heitz et al. 2016
//! (`heitz2016`).
//! 1 - F is a formula of its own, not a difference, and sin^2 comes from the vectors, not from a cosine near 1.
//!
//! # Validity
//! As `rough_conductor`, one meeting with a facet only. eta = 1 exactly is no surface: f and pdf are 0, light goes
//! straight on as a delta. Close to 1 the transmitted lobe narrows to (eta - 1) alpha, below what f32 resolves of a
//! direction where that is under 1e-7.

use crate::common::*;
use crate::delta_only::{DeltaOnly, Unscattered};
use crate::microfacet::choices::with_choices;
use crate::microfacet::distribution::{DISTRIBUTION, RATIONAL_MASKING};
use crate::microfacet::refraction::{Facet, upright};
use crate::microfacet::{ALPHA_X, ALPHA_Y, Masking, Normals, ONE_WIDTH};
use crate::optics::Spectrum;
use crate::optics::fresnel::RelativeIndex;
use crate::optics::interface::{self, INTERFACE, Interface};
use crate::param::ParamSet;
use crate::{Microfacet, are_across};

/// The list entry.
pub(super) static SPEC: ModelSpec = ModelSpec {
    id: "rough_dielectric",
    title: "Rough dielectric",
    source: "Walter et al. 2007, Microfacet Models for Refraction through Rough Surfaces; Heitz 2014",
    summary: "Frosted glass: one lobe about the mirror direction, one about the refracted one, that share the light as \
              Fresnel's equations say",
    lobes: &[
        Lobe::reflection(Category::GlossySpecular),
        Lobe::transmission(Category::GlossySpecular),
    ],
    parameters: &[
        DIELECTRIC_ETA,
        INTERFACE,
        ALPHA_X,
        ALPHA_Y,
        DISTRIBUTION,
        Masking::PARAM,
    ],
    properties: Properties {
        is_isotropic: |params| {
            params.number("alpha_x") == params.number("alpha_y") || params.number("eta") == 1.0
        },
        relative_index: |params| params.number("eta"),
        ..Properties::PLAIN
    },
    validate: ModelSpec::any,
    builders: builders!(build),
    stand_ins: &[
        interface::LAZANYI,
        interface::SCHLICK,
        RATIONAL_MASKING,
        Masking::STAND_IN,
        ONE_WIDTH,
    ],
};

struct RoughDielectric<R, N, I> {
    /// Seen from above, and from below.
    indices: [RelativeIndex<R>; 2],
    normals: N,
    masking: Masking,
    interface: I,
}

fn build<R: Real>(params: &ParamSet) -> Box<dyn Scatterer<R>> {
    if R::of(params.number("eta")) == R::one() {
        return Box::new(DeltaOnly(Unscattered));
    }
    with_choices!(R, params, |normals, interface| build_with(
        params, normals, interface
    ))
}

fn build_with<R: Real>(
    params: &ParamSet,
    normals: impl Normals<R>,
    interface: impl Interface<R>,
) -> Box<dyn Scatterer<R>> {
    let from_above = RelativeIndex::new(R::of(params.number("eta")));
    Box::new(RoughDielectric {
        indices: [from_above, from_above.inverse()],
        normals,
        masking: Masking::from_params(params),
        interface,
    })
}

impl<R: Real, N: Normals<R>, I: Interface<R>> RoughDielectric<R, N, I> {
    const IS_WIDE: bool = N::VECTORISES && I::VECTORISES;

    /// The index on the other side over that on the side of `w`.
    #[inline(always)]
    fn index_across(&self, w: Vec3<R>) -> RelativeIndex<R> {
        let [from_above, from_below] = self.indices;
        if w.z > R::zero() {
            from_above
        } else {
            from_below
        }
    }

    #[inline(always)]
    fn facet(&self, wo: Vec3<R>, wi: Vec3<R>) -> Option<Facet<R>> {
        Facet::between(wo, wi, self.index_across(wo), &self.interface)
    }

    #[inline(always)]
    fn value(&self, facet: &Facet<R>) -> Spectrum<R> {
        let lobe = self
            .normals
            .stretched_lobe(&facet.pair, self.masking, facet.factor);
        Spectrum::grey(facet.share * lobe)
    }

    #[inline(always)]
    fn density(&self, facet: &Facet<R>) -> R {
        facet.share * self.normals.stretched_pdf(&facet.pair, facet.stretch)
    }

    #[inline(always)]
    fn value_of(&self, facet: Option<Facet<R>>) -> Spectrum<R> {
        let Some(facet) = facet else {
            return Spectrum::black();
        };
        self.value(&facet)
    }

    /// The facet of the lobe at `index`.
    #[inline(always)]
    fn facet_of(&self, index: usize, wo: Vec3<R>, wi: Vec3<R>) -> Option<Facet<R>> {
        if (index == 0) == are_across(wo, wi) {
            return None;
        }
        self.facet(wo, wi)
    }

    /// A direction for `wo`, on whichever side it is, drawn at a visible normal; whether it is reflected there
    /// is decided by `is_reflected` from the reflectance of the facet.
    #[inline(always)]
    fn draw(
        &self,
        wo: Vec3<R>,
        u: [R; 2],
        is_reflected: impl FnOnce(R) -> bool,
    ) -> Option<Vec3<R>> {
        let across = self.index_across(wo);
        let (above, _) = upright(wo, wo);
        if above.z <= R::zero() || above.z.is_nan() {
            return None;
        }
        let wi = self.draw_above(above, across, u, is_reflected)?;
        Some(upright(wo, wi).1)
    }

    /// [`Self::draw`] for a `wo` above.
    #[inline(always)]
    fn draw_above(
        &self,
        wo: Vec3<R>,
        across: RelativeIndex<R>,
        u: [R; 2],
        is_reflected: impl FnOnce(R) -> bool,
    ) -> Option<Vec3<R>> {
        let wh = self.normals.sample_visible_normal(wo, u)?;
        let cos = wo.dot(wh);
        if cos <= R::zero() {
            return None;
        }
        let tangent = wo - wh * cos;
        let share = self
            .interface
            .with_sine(cos, tangent.length_squared(), across);
        if is_reflected(share.reflectance) {
            let wi = wh * (R::of(2.0) * cos) - wo;
            if wi.z > R::zero() { Some(wi) } else { None }
        } else if share.cos_t <= R::zero() {
            None
        } else {
            // Through an index below 1 the tangent is stretched, and the rounding of wo with it.
            let through = -(tangent * (R::one() / across.n)) - wh * share.cos_t;
            let (wi, _) = through.unit_and_length_of_short()?;
            if wi.z < R::zero() { Some(wi) } else { None }
        }
    }
}

impl<R: Real, N: Normals<R>, I: Interface<R>> Bxdf<R> for RoughDielectric<R, N, I> {
    #[inline(always)]
    fn f(&self, wo: Vec3<R>, wi: Vec3<R>) -> Spectrum<R> {
        self.value_of(self.facet(wo, wi))
    }

    #[inline(always)]
    fn pdf(&self, wo: Vec3<R>, wi: Vec3<R>) -> R {
        let Some(facet) = self.facet(wo, wi) else {
            return R::zero();
        };
        self.density(&facet)
    }

    #[inline(always)]
    fn f_pdf(&self, wo: Vec3<R>, wi: Vec3<R>) -> (Spectrum<R>, R) {
        let Some(facet) = self.facet(wo, wi) else {
            return (Spectrum::black(), R::zero());
        };
        (self.value(&facet), self.density(&facet))
    }

    #[inline(always)]
    fn sample_f(&self, wo: Vec3<R>, uc: R, u: [R; 2]) -> Option<Sample<R>> {
        let wi = self.draw(
            wo,
            u,
            #[inline(always)]
            |reflectance| uc < reflectance,
        )?;
        // At the edge of total reflection the way back from wi to its facet may fail by a rounding.
        self.sample_at(wo, wi)
    }
}

impl<R: Real, N: Normals<R>, I: Interface<R>> Lobes<R> for RoughDielectric<R, N, I> {
    fn lobes(&self) -> &[Lobe] {
        SPEC.lobes
    }

    #[inline(always)]
    fn lobe_f(&self, index: usize, wo: Vec3<R>, wi: Vec3<R>) -> Spectrum<R> {
        self.value_of(self.facet_of(index, wo, wi))
    }

    #[inline(always)]
    fn lobe_pdf(&self, index: usize, wo: Vec3<R>, wi: Vec3<R>) -> R {
        let Some(facet) = self.facet_of(index, wo, wi) else {
            return R::zero();
        };
        self.normals.stretched_pdf(&facet.pair, facet.stretch)
    }

    #[inline(always)]
    fn sample_lobe(&self, index: usize, wo: Vec3<R>, u: [R; 2]) -> Option<Vec3<R>> {
        self.draw(
            wo,
            u,
            #[inline(always)]
            |_| index == 0,
        )
    }

    fn microfacet(&self, wo: Vec3<R>, wi: Vec3<R>) -> Option<Microfacet<R>> {
        let facet = self.facet(wo, wi)?;
        Some(Microfacet {
            d: self.normals.d(facet.pair.wh),
            g: self.normals.g2(facet.pair.wo, facet.pair.wi, self.masking),
            fresnel: Spectrum::grey(facet.share),
        })
    }
}

impl<R: Real, N: Normals<R>, I: Interface<R>> Scatterer<R> for RoughDielectric<R, N, I> {
    loops!(R, if Self::IS_WIDE);
}

#[cfg(test)]
mod tests {
    use crate::math::Vec3;
    use crate::{Material, Scatterer};

    fn glass(parameters: &str) -> Box<dyn Scatterer<f64>> {
        format!("rough_dielectric:{parameters}")
            .parse::<Material>()
            .unwrap()
            .build()
    }

    const UP: Vec3<f64> = Vec3 {
        x: 0.0,
        y: 0.0,
        z: 1.0,
    };

    #[test]
    fn the_peaks_at_normal_incidence() {
        // D = 1/(pi alpha^2), G2 = 1, F = .04: f = F D / 4 and, through the surface, (1 - F) D / (e - 1)^2.
        let model = glass("alpha=0.1");
        let d = 1.0 / (std::f64::consts::PI * 0.01);
        let reflected = model.f(UP, UP).0[0];
        let transmitted = model.f(UP, -UP).0[0];
        let back = model.f(-UP, UP).0[0];
        assert!((reflected / (0.04 * d / 4.0) - 1.0).abs() < 1e-13);
        assert!((transmitted / (0.96 * d / 0.25) - 1.0).abs() < 1e-13);
        assert!((back / transmitted / 2.25 - 1.0).abs() < 1e-13, "radiance");
    }

    #[test]
    fn no_surface_is_no_surface() {
        let model = glass("eta=1");
        let w = Vec3::new(0.6, 0.0, 0.8);
        assert_eq!((model.f(w, UP).0, model.f(w, -w).0), ([0.0; 3], [0.0; 3]));
        let straight = model.sample_f(w, 0.7, [0.2, 0.9]).unwrap();
        assert!(straight.is_delta && straight.wi == -w && straight.weight().0 == [1.0; 3]);
    }

    #[test]
    fn samples_across_a_tiny_step_of_the_index_stay_unit_and_valid() {
        for eta in ["0.25", "0.999999", "1.000001", "1000"] {
            let model = glass(&format!("alpha=0.01,eta={eta}"));
            for wo in [Vec3::new(0.6, 0.0, 0.8), Vec3::new(0.0, 0.6, -0.8)] {
                for i in 0..100 {
                    let u = f64::from(i) / 100.0;
                    let Some(sample) = model.sample_f(wo, 1.0 - u, [u, 0.7]) else {
                        continue;
                    };
                    assert!((sample.wi.length_squared() - 1.0).abs() < 4e-15);
                    assert!(sample.pdf > 0.0 && sample.weight().0[0] <= 2.0 * 1e6);
                }
            }
        }
    }
}
