//! The "principled" model of Disney: few, forgiving parameters for every material of a film.
//!
//! # Source
//! Burley 2012, "Physically-Based Shading at Disney" (`burley2012`), as in the revised `disney.brdf` of the BRDF explorer
//! that came with it. Names: D_s is the paper's GTR2, D_r its GTR1, F_x the Schlick weight (1 - cos)^5 of mu_x or wi.h.
//!
//! # Departures
//! The shadowing of the specular lobe takes its own widths, as the revised code does, not (.5 + roughness/2)^2 as the
//! talk's notes do. `base_color` is linear: no gamma is taken off it. D_r of the clear coat uses sin^2 of the half
//! vector and the logarithm of the width: the textbook form loses 1e-3 in f32 at the default gloss.
//!
//! # Validity
//! A fit to measured materials and to taste, not to energy: diffuse, sheen, specular and coat are simply added. At
//! grazing incidence a rough white surface gives back 1.6 times the light (declared below).

use crate::common::*;
use crate::glossy::reflected;
use crate::math::warp;
use crate::microfacet::ggx::Ggx;
use crate::microfacet::gtr1::Gtr1;
use crate::microfacet::{Masking, Normals, Pair, evaluated_by_pair};
use crate::optics::Spectrum;
use crate::optics::fresnel::{schlick_rest, schlick_weight};
use crate::param::ParamSet;
use crate::{reflected_direction, sample_reflection};

/// The list entry.
pub(super) static SPEC: ModelSpec = ModelSpec {
    id: "principled",
    title: "Principled (Disney)",
    source: "Burley 2012, Physically-Based Shading at Disney, as in the revised disney.brdf",
    summary: "A bit of everything by sliders of 0 to 1: a matt body, a highlight, sheen for cloth, a clear coat, and metal \
              instead of it all",
    lobes: &[
        Lobe::reflection(Category::GlossySpecular).named("specular"),
        Lobe::reflection(Category::Diffuse).named("diffuse"),
        Lobe::reflection(Category::Diffuse).named("sheen"),
        Lobe::reflection(Category::GlossySpecular).named("clearcoat"),
    ],
    parameters: &[
        ParamSpec::rgb(
            "base_color",
            [0.82, 0.67, 0.16],
            "Linear colour of the body, and of the highlight of a metal",
        ),
        ParamSpec::number(
            "metallic",
            0.0,
            "0 is a dielectric over its body, 1 a metal",
        ),
        ParamSpec::number(
            "subsurface",
            0.0,
            "How much of the body looks as if light had travelled under the surface: flatter, like skin",
        ),
        ParamSpec::number(
            "specular",
            0.5,
            "Strength of the highlight: reflectance at normal incidence is .08 times this",
        ),
        ParamSpec::number(
            "roughness",
            0.5,
            "Roughness; the width of the highlight is its square",
        )
        .role(Role::Width),
        ParamSpec::number(
            "specular_tint",
            0.0,
            "How much the highlight of a dielectric takes the hue of the body",
        ),
        ParamSpec::number(
            "anisotropic",
            0.0,
            "How much the highlight is drawn out along s",
        ),
        ParamSpec::number(
            "sheen",
            0.0,
            "Strength of a glow at grazing angles, as of cloth",
        ),
        ParamSpec::number(
            "sheen_tint",
            0.5,
            "How much the sheen takes the hue of the body",
        ),
        ParamSpec::number(
            "clearcoat",
            0.0,
            "Strength of a second highlight, of a clear lacquer",
        ),
        ParamSpec::number(
            "clearcoat_gloss",
            1.0,
            "How narrow that highlight is: 0 satin, 1 gloss",
        ),
    ],
    properties: Properties {
        is_isotropic: |params| {
            let [x, y] = widths(params.number("roughness"), params.number("anisotropic"));
            x == y
        },
        declarations: &[Declaration {
            law: Law::Energy,
            parameters: "base_color=1,roughness=1",
            theta_deg: 89.9,
            note: "rho_dh reaches 1.60, 1.73 with sheen, specular and clearcoat at 1: the lobes are added without taking from \
                   one another, and the diffuse one alone brightens by 1.55 at grazing incidence",
            when: Declaration::always,
        }],
        ..Properties::PLAIN
    },
    validate: ModelSpec::any,
    builders: builders!(build),
    stand_ins: &[
        StandIn {
            name: "Without sheen",
            lost: "The glow of cloth at grazing angles",
            replace: |params| params.replaced(&[("sheen", Value::Number(0.0))]),
        },
        StandIn {
            name: "Without clearcoat",
            lost: "The second highlight, of the lacquer, and its brightening towards the horizon",
            replace: |params| params.replaced(&[("clearcoat", Value::Number(0.0))]),
        },
        StandIn {
            name: "Without subsurface",
            lost: "The flatter body of a material that light travels through",
            replace: |params| params.replaced(&[("subsurface", Value::Number(0.0))]),
        },
        StandIn {
            name: "Without specular tint",
            lost: "The hue of the body in the highlight of a dielectric",
            replace: |params| params.replaced(&[("specular_tint", Value::Number(0.0))]),
        },
        StandIn {
            name: "Without anisotropy",
            lost: "The length of the highlight along s: it no longer turns with the surface",
            replace: |params| params.replaced(&[("anisotropic", Value::Number(0.0))]),
        },
    ],
};

/// 2 int (1 - mu)^5 mu dmu: the mean of the Schlick weight, and the least that a lobe weighed by it is sampled.
const MEAN_SCHLICK: f64 = 1.0 / 21.0;

/// The mean of the Schlick weight of wi.h over cosine-weighted pairs of directions, times pi: the albedo of a white sheen.
const SHEEN_ALBEDO: f64 = 0.0116;

/// The widths of the specular lobe, and the least they may be (both of the paper).
#[inline(always)]
fn widths<R: Real>(roughness: R, anisotropic: R) -> [R; 2] {
    let aspect = (R::one() - tenths::<R>(9) * anisotropic).sqrt();
    let square = roughness * roughness;
    [square / aspect, square * aspect].map(|width| width.max(R::of(1.0) / R::of(1000.0)))
}

#[inline(always)]
fn tenths<R: Real>(n: u8) -> R {
    R::of(f64::from(n)) / R::of(10.0)
}

struct Principled<R> {
    /// (1 - metallic) base_color / pi.
    body: Spectrum<R>,
    subsurface: R,
    roughness: R,
    /// (1 - metallic) sheen times its colour.
    sheen: Spectrum<R>,
    /// The specular reflectance at normal incidence.
    f0: Spectrum<R>,
    specular: Ggx<R>,
    clearcoat: R,
    coat: Gtr1<R>,
    /// The clear coat is shadowed as a rougher surface would be: the paper's alpha of .25.
    coat_masking: Ggx<R>,
}

fn build<R: Real>(params: &ParamSet) -> Box<dyn Scatterer<R>> {
    let number = |name| R::of(params.number(name));
    let (zero, one) = (R::zero(), R::one());
    let base = Spectrum::<R>::of(params.rgb("base_color"));
    let [r, g, b] = base.0;
    let luminance = tenths::<R>(3) * r + tenths::<R>(6) * g + tenths::<R>(1) * b;
    let tint = base.map(|x| if luminance > zero { x / luminance } else { one });
    let tinted = |amount: R| tint.map(|x| mix(one, x, amount));
    let metallic = number("metallic");
    let dielectric = R::of(8.0) / R::of(100.0) * number("specular");
    let f0 =
        tinted(number("specular_tint")).zip(base, |t, base| mix(dielectric * t, base, metallic));
    let [alpha_x, alpha_y] = widths(number("roughness"), number("anisotropic"));
    let quarter = R::of(0.25);
    Box::new(Principled {
        body: base * ((one - metallic) * R::frac_1_pi()),
        subsurface: number("subsurface"),
        roughness: number("roughness"),
        sheen: tinted(number("sheen_tint")) * ((one - metallic) * number("sheen")),
        f0,
        specular: Ggx::new(alpha_x, alpha_y),
        clearcoat: quarter * number("clearcoat"),
        coat: Gtr1::new((R::of(100.0) - R::of(99.0) * number("clearcoat_gloss")) / R::of(1000.0)),
        coat_masking: Ggx::new(quarter, quarter),
    })
}

#[inline(always)]
fn mix<R: Real>(a: R, b: R, amount: R) -> R {
    a * (R::one() - amount) + b * amount
}

impl<R: Real> Principled<R> {
    #[inline(always)]
    fn diffuse(&self, pair: &Pair<R>) -> Spectrum<R> {
        let (one, half) = (R::one(), R::of(0.5));
        let (mu_o, mu_i) = (pair.wo.z, pair.wi.z);
        let (f_o, f_i) = (schlick_weight(mu_o), schlick_weight(mu_i));
        let retro = self.roughness * pair.cos_d * pair.cos_d;
        let f90 = half + R::of(2.0) * retro;
        let rough = mix(one, f90, f_o) * mix(one, f90, f_i);
        // mix(1, retro, weight): where both directions graze, retro and 1 - weight are both near 0.
        let flat = (schlick_rest(mu_o) + retro * f_o) * (schlick_rest(mu_i) + retro * f_i);
        // Saturated first: a black body stays black where both directions graze.
        let under = R::of(1.25) * (flat * (one / (mu_i + mu_o) - half) + half);
        self.body * mix(rough, under.saturated(), self.subsurface)
    }

    #[inline(always)]
    fn sheen(&self, pair: &Pair<R>) -> Spectrum<R> {
        self.sheen * schlick_weight(pair.cos_d)
    }

    #[inline(always)]
    fn specular(&self, pair: &Pair<R>) -> Spectrum<R> {
        let lobe = self.specular.lobe(pair, Masking::Separable);
        let weight = schlick_weight(pair.cos_d);
        self.f0.map(|f0| mix(f0, R::one(), weight) * lobe)
    }

    #[inline(always)]
    fn clearcoat(&self, pair: &Pair<R>) -> Spectrum<R> {
        let fresnel = mix(
            R::of(4.0) / R::of(100.0),
            R::one(),
            schlick_weight(pair.cos_d),
        );
        let inverse = self
            .coat_masking
            .inverse_visibility(pair.wo, pair.wi, Masking::Separable);
        let lobe = (self.coat.d(pair.wh) / inverse).saturated();
        Spectrum::grey(self.clearcoat * fresnel * lobe)
    }

    /// The density of a direction reflected at a normal of the coat, in 1/sr.
    #[inline(always)]
    fn coat_pdf(&self, pair: &Pair<R>) -> R {
        (self.coat.d(pair.wh) * pair.wh.z / (R::of(4.0) * pair.cos_d)).saturated()
    }

    /// The probabilities of sampling the specular lobe, diffuse and sheen, and the clear coat: their albedos, roughly.
    #[inline(always)]
    fn shares(&self, mu_o: R) -> [R; 3] {
        // Never 0 where the lobe is not: the weight at wi.h may exceed that at wo.
        let weight = schlick_weight(mu_o).max(R::of(MEAN_SCHLICK));
        let specular = mix(self.f0.max_channel(), R::one(), weight);
        let diffuse =
            self.body.max_channel() * R::pi() + self.sheen.max_channel() * R::of(SHEEN_ALBEDO);
        let coat = self.clearcoat * mix(R::of(4.0) / R::of(100.0), R::one(), weight);
        let sum = specular + diffuse + coat;
        [specular / sum, diffuse / sum, coat / sum]
    }

    #[inline(always)]
    fn value(&self, pair: &Pair<R>) -> Spectrum<R> {
        let body = self.diffuse(pair) + self.sheen(pair);
        (self.specular(pair) + body + self.clearcoat(pair)).saturated()
    }

    #[inline(always)]
    fn density(&self, pair: &Pair<R>) -> R {
        let [specular, diffuse, coat] = self.shares(pair.wo.z);
        let sum = specular * self.specular.reflection_pdf(pair)
            + diffuse * warp::cosine_hemisphere_pdf(pair.wi.z)
            + coat * self.coat_pdf(pair);
        sum.saturated()
    }
}

impl<R: Real> Bxdf<R> for Principled<R> {
    evaluated_by_pair!(Pair::above);

    #[inline(always)]
    fn sample_f(&self, wo: Vec3<R>, uc: R, u: [R; 2]) -> Option<Sample<R>> {
        sample_reflection(
            self,
            wo,
            #[inline(always)]
            |wo| {
                let [specular, diffuse, _] = self.shares(wo.z);
                if uc < specular {
                    self.specular.sample_reflection(wo, u)
                } else if uc < specular + diffuse {
                    Some(warp::cosine_hemisphere(u))
                } else {
                    Some(reflected(wo, self.coat.sample_normal(u)))
                }
            },
        )
    }
}

impl<R: Real> Lobes<R> for Principled<R> {
    fn lobes(&self) -> &[Lobe] {
        SPEC.lobes
    }

    #[inline(always)]
    fn lobe_f(&self, index: usize, wo: Vec3<R>, wi: Vec3<R>) -> Spectrum<R> {
        let Some(pair) = Pair::above(wo, wi) else {
            return Spectrum::black();
        };
        match index {
            0 => self.specular(&pair),
            1 => self.diffuse(&pair),
            2 => self.sheen(&pair),
            _ => self.clearcoat(&pair),
        }
    }

    #[inline(always)]
    fn lobe_pdf(&self, index: usize, wo: Vec3<R>, wi: Vec3<R>) -> R {
        let Some(pair) = Pair::above(wo, wi) else {
            return R::zero();
        };
        match index {
            0 => self.specular.reflection_pdf(&pair),
            1 | 2 => warp::cosine_hemisphere_pdf(pair.wi.z),
            _ => self.coat_pdf(&pair),
        }
    }

    #[inline(always)]
    fn sample_lobe(&self, index: usize, wo: Vec3<R>, u: [R; 2]) -> Option<Vec3<R>> {
        reflected_direction(
            wo,
            #[inline(always)]
            |wo| match index {
                0 => self.specular.sample_reflection(wo, u),
                1 | 2 => Some(warp::cosine_hemisphere(u)),
                _ => Some(reflected(wo, self.coat.sample_normal(u))),
            },
        )
    }
}

impl<R: Real> Scatterer<R> for Principled<R> {
    loops!(R, if true);
}

#[cfg(test)]
mod tests {
    use crate::Material;
    use crate::math::Vec3;

    const UP: Vec3<f64> = Vec3 {
        x: 0.0,
        y: 0.0,
        z: 1.0,
    };

    fn lobe(text: &str, index: usize, wi: Vec3<f64>) -> f64 {
        let material: Material = text.parse().unwrap();
        material.build::<f64>().lobe_f(index, UP, wi).0[0] * std::f64::consts::PI
    }

    #[test]
    fn the_lobes_at_normal_incidence() {
        // .04 / (4 alpha^2), alpha = .25; base_color; no sheen; .25 .04 D / 4, pi D = (1 - 1e-6) / (1e-6 ln 1e6).
        assert!((lobe("principled", 0, UP) - 0.16).abs() < 1e-14);
        assert!((lobe("principled", 1, UP) - 0.82).abs() < 1e-15);
        assert_eq!(lobe("principled:sheen=1", 2, UP), 0.0);
        let coat = 0.25 * 0.04 / 4.0 * (1.0 - 1e-6) / (1e-6 * 1e6_f64.ln());
        assert!((lobe("principled:clearcoat=1", 3, UP) / coat - 1.0).abs() < 1e-12);
    }

    #[test]
    fn a_metal_has_no_body() {
        let wi = Vec3::new(0.6, 0.0, 0.8);
        assert_eq!(lobe("principled:metallic=1", 1, wi), 0.0);
        assert!((lobe("principled:metallic=1", 0, UP) / 0.16 * 0.04 - 0.82).abs() < 1e-14);
    }

    #[test]
    fn subsurface_is_the_hanrahan_krueger_fit() {
        // 1.25 (1 (1/2 - 1/2) + 1/2) at normal incidence, where all Schlick weights are 0.
        assert!((lobe("principled:subsurface=1", 1, UP) - 0.82 * 0.625).abs() < 1e-15);
    }
}
