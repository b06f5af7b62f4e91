//! A rough metal: microfacet mirrors with GGX- or Beckmann-distributed normals.
//!
//! # Source
//! Torrance & Sparrow 1967 for the facet model (`torrance1967`), Walter et al. 2007 for the distributions
//! (`walter2007`), Heitz 2014 for the masking (`heitz2014`): f = F D G2 / (4 mu_o mu_i). Light that meets several facets
//! is given back, if wanted, by the lobe of Kulla & Conty 2017 (`kulla2017`), or by the factor 1 + F0 (1 - E) / E of
//! Turquin 2019 (`turquin2019`).
//!
//! # Departures
//! None in value for one reflection; the formulas are rearranged to keep their digits (see `microfacet::ggx`). The colour
//! of the multiple-scattering lobe is the sum of its geometric series, Fbar^2 Ebar / (1 - Fbar (1 - Ebar)), as Hill 2018
//! corrects it (`hill2018`): the form of the talk of 2017 has one factor Fbar less, too bright for F < 1. E is that of
//! the isotropic lobe with alpha = sqrt(alpha_x alpha_y), tabulated to 1e-5; Turquin fits it.
//!
//! # Validity
//! Without compensation light that meets several facets is lost: at alpha 1 69 % at normal incidence with F = 1. Kulla &
//! Conty's lobe closes the white furnace to 1e-5 where alpha_x = alpha_y; else it returns too much along one axis and too
//! little along the other (declared below). Turquin's factor is not reciprocal, and as it is made for light leaving
//! along wo, it returns more than arrives for some wi (both declared). alpha 1e-4 is the narrowest lobe; 0 is the
//! business of `specular_reflection`. In f32 the value saturates where both directions graze.

use std::sync::Arc;

use super::*;
use crate::bxdf::math::warp;
use crate::bxdf::microfacet::distribution::DISTRIBUTION;
use crate::bxdf::microfacet::multiple_scattering::{EnergyTable, gauss_legendre};
use crate::bxdf::microfacet::{ALPHA_X, ALPHA_Y, Distribution, Masking, half_vector};
use crate::bxdf::optics::{Spectrum, fresnel};
use crate::bxdf::param::ParamSet;
use crate::bxdf::{Microfacet, both_above, reflected_direction, sample_reflection};

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
            &["conductor", "schlick", "one"],
            "Reflectance of a facet: exact for a metal of index eta and k, Schlick's approximation from f0, or 1",
        ),
        CONDUCTOR_ETA.relevant_when("fresnel", &["conductor"]),
        CONDUCTOR_K.relevant_when("fresnel", &["conductor"]),
        ParamSpec::rgb("f0", [0.9; 3], "Reflectance of a facet at normal incidence")
            .relevant_when("fresnel", &["schlick"]),
        ALPHA_X,
        ALPHA_Y,
        DISTRIBUTION,
        Masking::PARAM,
        ParamSpec::choice(
            "compensation",
            &["none", "kulla_conty", "turquin"],
            "What becomes of light that meets several facets: lost, given back in a wide lobe of its own (Kulla & Conty), \
             or by making the lobe brighter (Turquin)",
        ),
    ],
    properties: Properties {
        declarations: DECLARATIONS,
        ..Properties::TWO_WIDTHS
    },
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

/// The laws that the compensations break.
const DECLARATIONS: &[Declaration] = &[
    Declaration {
        law: Law::Reciprocity,
        parameters: "fresnel=one,alpha=1,compensation=turquin",
        theta_deg: 89.9,
        note: "Turquin's factor depends on wo alone: the two ways differ by up to 69 %",
    },
    Declaration {
        law: Law::Energy,
        parameters: "fresnel=one,alpha=1,compensation=turquin",
        theta_deg: 89.9,
        note: "rho_dh reaches 2.18: the factor is made for the light leaving along wo, and brightens a lobe that grazing \
               light fills already",
    },
    Declaration {
        law: Law::Energy,
        parameters: "fresnel=one,alpha_x=1,alpha_y=.0001,compensation=kulla_conty",
        theta_deg: 89.5,
        note: "rho_dh reaches 1.08: the lobe gives back what an isotropic surface of alpha = sqrt(alpha_x alpha_y) loses",
    },
];

enum Fresnel<R> {
    Conductor(Spectrum<R>, Spectrum<R>),
    Schlick(Spectrum<R>),
    One,
}

impl<R: Real> Fresnel<R> {
    fn from_params(params: &ParamSet) -> Self {
        match params.choice("fresnel") {
            "schlick" => Self::Schlick(Spectrum::of(params.rgb("f0"))),
            "one" => Self::One,
            _ => Self::Conductor(
                Spectrum::of(params.rgb("eta")),
                Spectrum::of(params.rgb("k")),
            ),
        }
    }

    #[inline(always)]
    fn at(&self, cos_d: R) -> Spectrum<R> {
        match self {
            Self::Conductor(eta, k) => eta.zip(*k, |n, k| fresnel::conductor(cos_d, n, k)),
            Self::Schlick(f0) => f0.map(|f0| fresnel::schlick(cos_d, f0)),
            Self::One => Spectrum::grey(R::one()),
        }
    }

    /// The cosine-weighted mean Fbar = 2 int F(mu) mu dmu.
    fn mean(&self) -> Spectrum<R> {
        match self {
            // 2 int (1 - mu)^5 mu dmu = 1/21.
            Self::Schlick(f0) => f0.map(|f0| f0 + (R::one() - f0) / R::of(21.0)),
            Self::One => Spectrum::grey(R::one()),
            // mu = x^2 puts the nodes where a good conductor's reflectance bends, near grazing.
            Self::Conductor(..) => gauss_legendre(FRESNEL_NODES).into_iter().fold(
                Spectrum::black(),
                |sum, (node, weight)| {
                    let x = (R::one() + R::of(node)) * R::of(0.5);
                    let measure = R::of(2.0) * x * x * x * R::of(weight);
                    sum + self.at(x * x) * measure
                },
            ),
        }
    }
}

/// Nodes of the mean Fresnel reflectance: 1e-6 for metals; 1e-4 where the reflectance has the kink of a critical angle.
const FRESNEL_NODES: usize = 32;

/// What becomes of light that meets several facets.
enum Compensation<R> {
    None,
    /// F_ms / (pi (1 - Ebar)) times (1 - E(mu_o)) (1 - E(mu_i)).
    KullaConty {
        table: Arc<EnergyTable>,
        factor: Spectrum<R>,
        /// Largest channels of F_ms and of Fbar, by which the two lobes are chosen.
        weights: [R; 2],
    },
    /// One reflection times 1 + F0 (1 - E(mu_o)) / E(mu_o).
    Turquin {
        table: Arc<EnergyTable>,
        f0: Spectrum<R>,
    },
}

impl<R: Real> Compensation<R> {
    fn from_params(params: &ParamSet, fresnel: &Fresnel<R>, masking: Masking) -> Self {
        let table = || {
            let alpha = (params.number("alpha_x") * params.number("alpha_y")).sqrt();
            EnergyTable::of(params.choice("distribution") == "beckmann", alpha, masking)
        };
        match params.choice("compensation") {
            "kulla_conty" => {
                let table = table();
                let lost = R::of(table.one_minus_mean());
                let mean = fresnel.mean();
                let one = R::one();
                let colour = mean.map(|f| f * f * (one - lost) / (one - f * lost));
                let scale = if lost > R::zero() {
                    R::FRAC_1_PI() / lost
                } else {
                    R::zero()
                };
                Self::KullaConty {
                    table,
                    factor: colour * scale,
                    weights: [colour.max_channel(), mean.max_channel()],
                }
            }
            "turquin" => Self::Turquin {
                table: table(),
                f0: fresnel.at(R::one()),
            },
            _ => Self::None,
        }
    }

    /// The lobe of several reflections.
    fn lobe(&self, mu_o: R, mu_i: R) -> Spectrum<R> {
        match self {
            Self::KullaConty { table, factor, .. } => {
                *factor * (table.one_minus_e(mu_o) * table.one_minus_e(mu_i))
            }
            Self::None | Self::Turquin { .. } => Spectrum::black(),
        }
    }

    /// The factor on the lobe of one reflection.
    fn factor(&self, mu_o: R) -> Spectrum<R> {
        match self {
            Self::Turquin { table, f0 } => {
                let lost = table.one_minus_e(mu_o);
                let ratio = lost / (R::one() - lost);
                f0.map(|f0| R::one() + f0 * ratio)
            }
            Self::None | Self::KullaConty { .. } => Spectrum::grey(R::one()),
        }
    }

    /// The table and the probability with which the lobe of several reflections is sampled: its share of the albedo.
    fn choice(&self, mu_o: R) -> Option<(&EnergyTable, R)> {
        let Self::KullaConty { table, weights, .. } = self else {
            return None;
        };
        let [several, one] = *weights;
        let lost = table.one_minus_e(mu_o);
        let several = several * lost;
        let both = several + one * (R::one() - lost);
        (several > R::zero()).then(|| (&**table, several / both))
    }
}

/// The lobes where several reflections have one of their own, which knows no mirror direction.
const COMPENSATED: &[Lobe] = &[
    Lobe::reflection(Category::GlossySpecular).named("single scattering"),
    Lobe::reflection(Category::Diffuse).named("multiple scattering"),
];

struct RoughConductor<R> {
    distribution: Distribution<R>,
    masking: Masking,
    fresnel: Fresnel<R>,
    compensation: Compensation<R>,
}

fn build<R: Real>(params: &ParamSet) -> Box<dyn Bxdf<R>> {
    let fresnel = Fresnel::from_params(params);
    let masking = Masking::from_params(params);
    Box::new(RoughConductor {
        distribution: Distribution::from_params(params),
        masking,
        compensation: Compensation::from_params(params, &fresnel, masking),
        fresnel,
    })
}

impl<R: Real> RoughConductor<R> {
    /// The lobe of one reflection, of directions above the surface.
    #[inline(always)]
    fn single(&self, wo: Vec3<R>, wi: Vec3<R>) -> Spectrum<R> {
        half_vector(wo, wi).map_or(Spectrum::black(), |(wh, cos_d)| {
            let lobe = self.distribution.lobe(wo, wi, wh, self.masking);
            let value = self.fresnel.at(cos_d) * self.compensation.factor(wo.z);
            (value * lobe).map(Real::saturated)
        })
    }

    /// The density of the visible normals that reflect the one direction into the other, both above the surface.
    #[inline(always)]
    fn single_pdf(&self, wo: Vec3<R>, wi: Vec3<R>) -> R {
        half_vector(wo, wi).map_or(R::zero(), |(wh, _)| {
            self.distribution.reflection_pdf(wo, wh)
        })
    }
}

impl<R: Real> Bxdf<R> for RoughConductor<R> {
    fn f(&self, wo: Vec3<R>, wi: Vec3<R>) -> Spectrum<R> {
        both_above(wo, wi).map_or(Spectrum::black(), |(wo, wi)| {
            let sum = self.single(wo, wi) + self.compensation.lobe(wo.z, wi.z);
            sum.map(Real::saturated)
        })
    }

    fn pdf(&self, wo: Vec3<R>, wi: Vec3<R>) -> R {
        let Some((wo, wi)) = both_above(wo, wi) else {
            return R::zero();
        };
        let single = self.single_pdf(wo, wi);
        match self.compensation.choice(wo.z) {
            Some((table, share)) => (R::one() - share) * single + share * table.pdf(wi.z),
            None => single,
        }
    }

    fn sample_f(&self, wo: Vec3<R>, uc: R, u: [R; 2]) -> Option<Sample<R>> {
        let sample = sample_reflection(self, wo, |wo| match self.compensation.choice(wo.z) {
            Some((table, share)) if uc < share => Some(table.sample(u)),
            _ => self.distribution.sample_reflection(wo, u),
        });
        // The table's density begins at 0 where the loss does: the very end of a cell has none.
        sample.filter(|sample| sample.pdf > R::zero())
    }

    fn lobes(&self) -> &[Lobe] {
        match self.compensation {
            Compensation::KullaConty { .. } => COMPENSATED,
            Compensation::None | Compensation::Turquin { .. } => SPEC.lobes,
        }
    }

    fn lobe_f(&self, index: usize, wo: Vec3<R>, wi: Vec3<R>) -> Spectrum<R> {
        both_above(wo, wi).map_or(Spectrum::black(), |(wo, wi)| match index {
            0 => self.single(wo, wi),
            _ => self.compensation.lobe(wo.z, wi.z),
        })
    }

    fn lobe_pdf(&self, index: usize, wo: Vec3<R>, wi: Vec3<R>) -> R {
        both_above(wo, wi).map_or(R::zero(), |(wo, wi)| match index {
            0 => self.single_pdf(wo, wi),
            _ => warp::cosine_hemisphere_pdf(wi.z),
        })
    }

    fn sample_lobe(&self, index: usize, wo: Vec3<R>, u: [R; 2]) -> Option<Vec3<R>> {
        reflected_direction(wo, |wo| match index {
            0 => self.distribution.sample_reflection(wo, u),
            _ => Some(warp::cosine_hemisphere(u)),
        })
    }

    fn microfacet(&self, wo: Vec3<R>, wi: Vec3<R>) -> Option<Microfacet<R>> {
        let (wo, wi) = both_above(wo, wi)?;
        let (wh, cos_d) = half_vector(wo, wi)?;
        Some(Microfacet {
            d: self.distribution.d(wh),
            g: self.distribution.g2(wo, wi, self.masking),
            fresnel: self.fresnel.at(cos_d),
        })
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
