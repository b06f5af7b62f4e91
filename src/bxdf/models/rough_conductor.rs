//! A rough metal: microfacet mirrors with GGX- or Beckmann-distributed normals.
//!
//! # Source
//! Torrance & Sparrow 1967 for the facet model (`torrance1967`), Walter et al. 2007 for the distributions
//! (`walter2007`), Heitz 2014 for the masking (`heitz2014`): f = F D G2 / (4 mu_o mu_i). Light that meets several facets
//! is given back, if wanted, by the lobe of Kulla & Conty 2017 (`kulla2017`), or by the factor 1 + F0 (1 - E) / E of
//! Turquin 2019 (`turquin2019`). Instead of its exact reflectance a metal may have Schlick's approximation (`schlick1994`), or
//! that with the term of Lazanyi & Szirmay-Kalos (`lazanyi2005`, `hoffman2019`).
//!
//! # Departures
//! None in value for one reflection; the formulas are rearranged to keep their digits (see `microfacet::ggx`). The colour
//! of the multiple-scattering lobe is the sum of its geometric series, Fbar^2 Ebar / (1 - Fbar (1 - Ebar)), as Hill 2018
//! corrects it (`hill2018`): the form of the talk of 2017 has one factor Fbar less, too bright for F < 1. E is that of
//! the isotropic lobe with alpha = sqrt(alpha_x alpha_y), tabulated to 1e-5, of the exact masking also where that is
//! fitted; Turquin fits it.
//!
//! # Validity
//! Without compensation light that meets several facets is lost: at alpha 1 69 % at normal incidence with F = 1. Kulla &
//! Conty's lobe closes the white furnace to 1e-5 where alpha_x = alpha_y; else it returns too much along one axis and too
//! little along the other (declared below). Turquin's factor is not reciprocal, and as it is made for light leaving
//! along wo, it returns more than arrives for some wi (both declared). alpha 1e-4 is the narrowest lobe; 0 is the
//! business of `specular_reflection`. In f32 the value saturates where both directions graze.

use std::marker::PhantomData;

use crate::common::*;
use crate::math::warp;
use crate::microfacet::compensation::{
    COMPENSATION, Compensation, DECLARATIONS, SeveralFacets, Uncompensated,
};
use crate::microfacet::distribution::{DISTRIBUTION, RATIONAL_MASKING};
use crate::microfacet::{
    ALPHA_X, ALPHA_Y, Distribution, Masking, Normals, ONE_WIDTH, Pair, evaluated_by_pair,
};
use crate::optics::Spectrum;
use crate::optics::conductor::Conductor;
use crate::optics::facet_fresnel::{AnyFresnel, FacetFresnel};
use crate::optics::metal::Metal;
use crate::param::ParamSet;
use crate::{Microfacet, reflected_direction, sample_reflection};

/// The list entry.
pub(super) static SPEC: ModelSpec = ModelSpec {
    id: "rough_conductor",
    title: "Rough conductor",
    source: "Torrance & Sparrow 1967; Walter et al. 2007; Heitz 2014; Kulla & Conty 2017; Turquin 2019",
    summary: "A metal of tiny mirrors: the lobe follows the mirror direction, narrow when smooth, wide when rough, a blade \
              when the two widths differ",
    lobes: &[Lobe::reflection(Category::GlossySpecular)],
    parameters: &[
        ParamSpec::choice(
            "fresnel",
            &["conductor", "schlick", "one", "lazanyi"],
            "Reflectance of a facet: exact for a metal of index eta and k, Schlick's approximation from f0, 1, or \
             Schlick's for eta and k with a term that makes it exact at 82 degrees (Lazanyi)",
        )
        .role(Role::Fresnel),
        CONDUCTOR_ETA.relevant_when("fresnel", OF_A_METAL),
        CONDUCTOR_K.relevant_when("fresnel", OF_A_METAL),
        ParamSpec::rgb("f0", [0.9; 3], "Reflectance of a facet at normal incidence")
            .relevant_when("fresnel", &["schlick"]),
        ALPHA_X,
        ALPHA_Y,
        DISTRIBUTION,
        Masking::PARAM,
        COMPENSATION,
    ],
    properties: Properties {
        declarations: DECLARATIONS,
        ..Properties::TWO_WIDTHS
    },
    validate: |params| {
        if OF_A_METAL.contains(&params.choice("fresnel")) {
            refuse_zero_index(params)
        } else {
            Ok(())
        }
    },
    builders: builders!(build),
    stand_ins: &[
        StandIn {
            name: "Schlick with Lazanyi's term for exact Fresnel",
            lost: "The reflectance is exact at 0 and 82 degrees alone: good for metals with a dip before the horizon, hardly \
                   better than Schlick's for the blue of gold",
            replace: |params| {
                let lazanyi = [("fresnel", Value::Choice("lazanyi"))];
                is_exact(params).then(|| params.replaced(&lazanyi))?
            },
        },
        StandIn {
            name: "Schlick for exact Fresnel",
            lost: "The reflectance rises steadily towards the horizon: the dip that many metals have there is gone",
            replace: |params| {
                let metal = Conductor::new(params.rgb("eta"), params.rgb("k"));
                let f0 = Value::Rgb(metal.reflectance(1.0));
                let schlick = [("fresnel", Value::Choice("schlick")), ("f0", f0)];
                is_exact(params).then(|| params.replaced(&schlick))?
            },
        },
        RATIONAL_MASKING,
        Masking::STAND_IN,
        StandIn {
            name: "Turquin for Kulla-Conty compensation",
            lost: "Light of several facets has no wide lobe of its own: it brightens the one lobe, and the two ways between \
                   two directions differ",
            replace: |params| {
                let is_it = params.choice("compensation") == "kulla_conty";
                let turquin = [("compensation", Value::Choice("turquin"))];
                is_it.then(|| params.replaced(&turquin))?
            },
        },
        StandIn {
            name: "No compensation",
            lost: "Light that meets several facets is lost: rough metals are too dark, and their colours too pale",
            replace: |params| params.replaced(&[("compensation", Value::Choice("none"))]),
        },
        ONE_WIDTH,
    ],
};

/// The lobes where several reflections have one of their own, which knows no mirror direction.
const COMPENSATED: &[Lobe] = &[
    Lobe::reflection(Category::GlossySpecular).named("single scattering"),
    Lobe::reflection(Category::Diffuse).named("multiple scattering"),
];

/// The choices of `fresnel` that need the index of a metal.
const OF_A_METAL: &[&str] = &["conductor", "lazanyi"];

fn is_exact(params: &ParamSet) -> bool {
    params.choice("fresnel") == "conductor"
}

struct RoughConductor<R, N, F, C> {
    normals: N,
    masking: Masking,
    fresnel: F,
    compensation: C,
    precision: PhantomData<R>,
}

/// The common choices become types, so that each is compiled by itself and its loops carry no choice. The rare ones, and all
/// where loops gain nothing by it, share one.
fn build<R: Real>(params: &ParamSet) -> Box<dyn Scatterer<R>> {
    let spectrum = |name| Spectrum::of(params.rgb(name));
    let metal = Metal::new(spectrum("eta").0, spectrum("k").0);
    let fresnel = AnyFresnel::from_params(params);
    let (normals, masking) = (
        Distribution::from_params(params),
        Masking::from_params(params),
    );
    let compensation = Compensation::from_params(params, &fresnel, masking);
    if R::VECTORISES && matches!(compensation, Compensation::None) {
        let own = match normals {
            Distribution::Ggx(ggx) => {
                if R::FUNCTIONS_VECTORISE
                    && let (AnyFresnel::Conductor(_), Some(metal)) = (fresnel, metal)
                    && let Some(grey) = metal.grey()
                {
                    return boxed(ggx, masking, grey, Uncompensated);
                }
                own(ggx, masking, fresnel, metal)
            }
            Distribution::Beckmann(normals) => own(normals, masking, fresnel, metal),
            Distribution::BeckmannRational(normals) => own(normals, masking, fresnel, metal),
        };
        if let Some(own) = own {
            return own;
        }
    }
    boxed(normals, masking, fresnel, compensation)
}

/// The model with loops of its own, where this choice has them.
fn own<R: Real, N: Normals<R>>(
    normals: N,
    masking: Masking,
    fresnel: AnyFresnel<R>,
    metal: Option<Metal<R>>,
) -> Option<Box<dyn Scatterer<R>>> {
    if !N::VECTORISES {
        return None;
    }
    if R::FUNCTIONS_VECTORISE {
        Some(match fresnel {
            AnyFresnel::Conductor(_) => boxed(normals, masking, metal?, Uncompensated),
            AnyFresnel::Schlick(fresnel) => boxed(normals, masking, fresnel, Uncompensated),
            AnyFresnel::Lazanyi(fresnel) => boxed(normals, masking, fresnel, Uncompensated),
        })
    } else {
        Some(match fresnel {
            AnyFresnel::Conductor(fresnel) => boxed(normals, masking, fresnel, Uncompensated),
            AnyFresnel::Schlick(fresnel) => boxed(normals, masking, fresnel, Uncompensated),
            AnyFresnel::Lazanyi(_) => return None,
        })
    }
}

fn boxed<R: Real>(
    normals: impl Normals<R>,
    masking: Masking,
    fresnel: impl FacetFresnel<R>,
    compensation: impl SeveralFacets<R>,
) -> Box<dyn Scatterer<R>> {
    Box::new(RoughConductor {
        normals,
        masking,
        fresnel,
        compensation,
        precision: PhantomData,
    })
}

impl<R, N, F, C> RoughConductor<R, N, F, C>
where
    R: Real,
    N: Normals<R>,
    F: FacetFresnel<R>,
    C: SeveralFacets<R>,
{
    const IS_WIDE: bool = N::VECTORISES && F::VECTORISES && C::VECTORISES;

    /// The reflectance of the facet that mirrors one direction into the other.
    #[inline(always)]
    fn fresnel_at(&self, pair: &Pair<R>) -> Spectrum<R> {
        self.fresnel.with_sine(
            pair.cos_d,
            #[inline(always)]
            || pair.sin2_d(),
        )
    }

    /// The lobe of one reflection.
    #[inline(always)]
    fn single(&self, pair: &Pair<R>) -> Spectrum<R> {
        let lobe = self.normals.lobe(pair, self.masking);
        let value = self.fresnel_at(pair) * self.compensation.factor(pair.wo.z);
        (value * lobe).saturated()
    }

    #[inline(always)]
    fn value(&self, pair: &Pair<R>) -> Spectrum<R> {
        let sum = self.single(pair) + self.compensation.lobe(pair.wo.z, pair.wi.z);
        sum.saturated()
    }

    #[inline(always)]
    fn density(&self, pair: &Pair<R>) -> R {
        let single = self.normals.reflection_pdf(pair);
        match self.compensation.choice(pair.wo.z) {
            Some((table, share)) => (R::one() - share) * single + share * table.pdf(pair.wi.z),
            None => single,
        }
    }
}

impl<R, N, F, C> Bxdf<R> for RoughConductor<R, N, F, C>
where
    R: Real,
    N: Normals<R>,
    F: FacetFresnel<R>,
    C: SeveralFacets<R>,
{
    evaluated_by_pair!(Pair::above);

    #[inline(always)]
    fn sample_f(&self, wo: Vec3<R>, uc: R, u: [R; 2]) -> Option<Sample<R>> {
        sample_reflection(
            self,
            wo,
            #[inline(always)]
            |wo| match self.compensation.choice(wo.z) {
                Some((table, share)) if uc < share => Some(table.sample(u)),
                _ => self.normals.sample_reflection(wo, u),
            },
        )
    }
}

impl<R, N, F, C> Lobes<R> for RoughConductor<R, N, F, C>
where
    R: Real,
    N: Normals<R>,
    F: FacetFresnel<R>,
    C: SeveralFacets<R>,
{
    fn lobes(&self) -> &[Lobe] {
        if self.compensation.has_lobe() {
            COMPENSATED
        } else {
            SPEC.lobes
        }
    }

    #[inline(always)]
    fn lobe_f(&self, index: usize, wo: Vec3<R>, wi: Vec3<R>) -> Spectrum<R> {
        let Some(pair) = Pair::above(wo, wi) else {
            return Spectrum::black();
        };
        match index {
            0 => self.single(&pair),
            _ => self.compensation.lobe(pair.wo.z, pair.wi.z),
        }
    }

    #[inline(always)]
    fn lobe_pdf(&self, index: usize, wo: Vec3<R>, wi: Vec3<R>) -> R {
        let Some(pair) = Pair::above(wo, wi) else {
            return R::zero();
        };
        match index {
            0 => self.normals.reflection_pdf(&pair),
            _ => warp::cosine_hemisphere_pdf(pair.wi.z),
        }
    }

    #[inline(always)]
    fn sample_lobe(&self, index: usize, wo: Vec3<R>, u: [R; 2]) -> Option<Vec3<R>> {
        reflected_direction(
            wo,
            #[inline(always)]
            |wo| match index {
                0 => self.normals.sample_reflection(wo, u),
                _ => Some(warp::cosine_hemisphere(u)),
            },
        )
    }

    fn microfacet(&self, wo: Vec3<R>, wi: Vec3<R>) -> Option<Microfacet<R>> {
        let pair = Pair::above(wo, wi)?;
        Some(Microfacet {
            d: self.normals.d(pair.wh),
            g: self.normals.g2(pair.wo, pair.wi, self.masking),
            fresnel: self.fresnel_at(&pair),
        })
    }
}

impl<R, N, F, C> Scatterer<R> for RoughConductor<R, N, F, C>
where
    R: Real,
    N: Normals<R>,
    F: FacetFresnel<R>,
    C: SeveralFacets<R>,
{
    loops!(R, if Self::IS_WIDE);
}

#[cfg(test)]
mod tests {
    use crate::Material;
    use crate::math::Vec3;

    #[test]
    fn the_peak_at_normal_incidence_is_f_over_four_pi_alpha_squared() {
        let gold: Material = "rough_conductor:alpha=0.1,eta=0.143,k=3.983"
            .parse()
            .unwrap();
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
