//! Plastic: a clear dielectric coat, rough or smooth, over a matt ground.
//!
//! # Source
//! A Fresnel-weighted microfacet coat (Walter et al. 2007, `walter2007`) over a Lambertian ground whose light crosses
//! the coat twice and bounces below it any number of times, summed as a geometric series (Saunderson 1942,
//! `saunderson1942`): f = F D V + rho/pi T(mu_i) T(mu_o) / (n^2 (1 - d Fdr_int)), with d = rho (`nonlinear`: the
//! bounces saturate the colour) or 1 (they do not). Fdr_int is the mean Fresnel reflectance from inside. F may be Schlick's
//! approximation (`schlick1994`), or that with the term of Lazanyi & Szirmay-Kalos (`lazanyi2005`), T its rest to 1 and Fdr_int
//! its mean.
//!
//! # Departures
//! The smooth T(mu) stands under the rough coat too. There the coat's own albedo is not F(mu), and the two need not sum
//! to 1. Measured at rho = 1, where a smooth coat returns all: at n = 1.5 between .05 % too much (alpha .1, 45 degrees)
//! and 59, 79, 90 % too little at 89.9 degrees for alpha .1, .3, 1, at 60 degrees .3, 3, 7 %; for indices far from any
//! plastic's it creates up to 45 % (declared below).
//!
//! # Validity
//! Both widths 0 make the coat a Dirac delta; else both are at least 1e-4. Where n < 1 the coat reflects totally from
//! outside beyond the critical angle, and nothing reaches the ground.

use crate::common::*;
use crate::math::warp;
use crate::microfacet::choices::with_choices;
use crate::microfacet::distribution::{DISTRIBUTION, RATIONAL_MASKING};
use crate::microfacet::{Masking, Normals, ONE_WIDTH, Pair, evaluated_by_pair};
use crate::optics::Spectrum;
use crate::optics::fresnel::RelativeIndex;
use crate::optics::interface::{self, INTERFACE, Interface};
use crate::param::{ParamSet, Scale};
use crate::{Delta, Deltas, Microfacet, reflected_direction, sample_reflection};

/// The smallest width of a rough coat.
const SMALLEST_ALPHA: f64 = 1e-4;

/// A stand-in where the coat is rough.
macro_rules! of_rough_coat {
    ($stand_in:expr) => {
        StandIn {
            replace: |params| {
                let is_rough = params.number("alpha_x") > 0.0;
                is_rough.then(|| ($stand_in.replace)(params))?
            },
            ..$stand_in
        }
    };
}

/// The list entry.
pub(super) static SPEC: ModelSpec = ModelSpec {
    id: "plastic",
    title: "Plastic",
    source: "A dielectric coat (Walter et al. 2007) over Lambert, internal bounces summed (Saunderson 1942)",
    summary: "A coloured ground under a clear coat: the highlight is white and grows towards grazing angles, where the \
              colour fades",
    lobes: &[
        Lobe::reflection(Category::GlossySpecular).named("coat"),
        Lobe::reflection(Category::Diffuse).named("ground"),
    ],
    parameters: &[
        DIELECTRIC_ETA,
        INTERFACE,
        ParamSpec::rgb(
            "diffuse",
            [0.5; 3],
            "Share of the light that the ground reflects, under the coat",
        ),
        coat_alpha(
            "alpha_x",
            "Width of the coat's microfacet normals along s; 0 with alpha_y is a smooth coat",
        )
        .role(Role::WidthS),
        coat_alpha(
            "alpha_y",
            "Width of the coat's microfacet normals along t; 0 with alpha_x is a smooth coat",
        )
        .role(Role::WidthT),
        DISTRIBUTION,
        Masking::PARAM,
        ParamSpec::flag(
            "nonlinear",
            true,
            "Whether light that bounces below the coat meets the colour each time, and saturates it",
        ),
    ],
    properties: Properties {
        declarations: &[Declaration {
            law: Law::Energy,
            parameters: "diffuse=1,eta=1000,alpha=.3",
            theta_deg: 89.9,
            note: "rho_dh reaches 1.45: the ground gets what a smooth coat would let through, also where the rough one has \
                   reflected it",
            when: Declaration::always,
        }],
        ..Properties::TWO_WIDTHS
    },
    validate,
    builders: builders!(build),
    stand_ins: &[
        interface::LAZANYI,
        interface::SCHLICK,
        of_rough_coat!(RATIONAL_MASKING),
        of_rough_coat!(Masking::STAND_IN),
        ONE_WIDTH,
        StandIn {
            name: "Bounces that do not saturate",
            lost: "Light that bounces below the coat meets the colour only once: the ground is brighter, and its colours paler",
            replace: |params| params.replaced(&[("nonlinear", Value::Bool(false))]),
        },
    ],
};

const fn coat_alpha(name: &'static str, meaning: &'static str) -> ParamSpec {
    ParamSpec::number(name, 0.1, meaning)
        .hard(0.0, 1.0)
        .soft(0.01, 1.0)
        .scale(Scale::Logarithmic)
}

/// Both widths 0, or neither and both in the range of a microfacet normals.
fn validate(params: &ParamSet) -> Result<()> {
    let alphas = ["alpha_x", "alpha_y"].map(|name| (name, params.number(name)));
    if alphas.iter().all(|(_, alpha)| *alpha == 0.0) {
        return Ok(());
    }
    match alphas.iter().find(|(_, alpha)| *alpha < SMALLEST_ALPHA) {
        Some((name, _)) => Err(params.error(
            name,
            format!("allowed is {SMALLEST_ALPHA} to 1, or 0 for both alpha_x and alpha_y"),
        )),
        None => Ok(()),
    }
}

struct Plastic<R, N, I> {
    index: RelativeIndex<R>,
    interface: I,
    /// `None` where the coat is smooth.
    coat: Option<(N, Masking)>,
    /// f of the ground less T(mu_i) T(mu_o).
    ground: Spectrum<R>,
    /// The albedo of the ground, largest channel, less T(mu_o).
    ground_albedo: R,
}

fn build<R: Real>(params: &ParamSet) -> Box<dyn Scatterer<R>> {
    with_choices!(R, params, |normals, interface| build_with(
        params, normals, interface
    ))
}

fn build_with<R: Real>(
    params: &ParamSet,
    normals: impl Normals<R>,
    interface: impl Interface<R>,
) -> Box<dyn Scatterer<R>> {
    let one = R::one();
    let eta = R::of(params.number("eta"));
    let diffuse_t = interface.diffuse_transmittance(eta);
    let is_nonlinear = params.flag("nonlinear");
    let ground = Spectrum::of(params.rgb("diffuse")).map(|rho| {
        let d = if is_nonlinear { rho } else { one };
        // n^2 (1 - d Fdr_int), n^2 (1 - Fdr_int) being the diffuse transmittance.
        rho * R::frac_1_pi() / (eta * eta * (one - d) + d * diffuse_t)
    });
    let is_rough = params.number("alpha_x") > 0.0;
    Box::new(Plastic {
        index: RelativeIndex::new(eta),
        interface,
        coat: is_rough.then(|| (normals, Masking::from_params(params))),
        ground,
        ground_albedo: ground.max_channel() * R::pi() * diffuse_t,
    })
}

impl<R: Real, N: Normals<R>, I: Interface<R>> Plastic<R, N, I> {
    const IS_WIDE: bool = N::VECTORISES && I::VECTORISES;

    /// The coat's lobe; 0 where it is a delta.
    #[inline(always)]
    fn coat_value(&self, pair: &Pair<R>) -> Spectrum<R> {
        let Some((normals, masking)) = &self.coat else {
            return Spectrum::black();
        };
        Spectrum::grey(
            pair.dielectric(&self.interface, self.index).reflectance * normals.lobe(pair, *masking),
        )
    }

    /// The density of the coat's visible normals; 0 where it is a delta.
    #[inline(always)]
    fn coat_pdf(&self, pair: &Pair<R>) -> R {
        let Some((normals, _)) = &self.coat else {
            return R::zero();
        };
        normals.reflection_pdf(pair)
    }

    #[inline(always)]
    fn ground_value(&self, pair: &Pair<R>) -> Spectrum<R> {
        let through = |w| self.interface.along(w, self.index).transmittance;
        self.ground * (through(pair.wo) * through(pair.wi))
    }

    #[inline(always)]
    fn value(&self, pair: &Pair<R>) -> Spectrum<R> {
        (self.coat_value(pair) + self.ground_value(pair)).saturated()
    }

    #[inline(always)]
    fn density(&self, pair: &Pair<R>) -> R {
        let [coat, ground] = self.shares(pair.wo);
        coat * self.coat_pdf(pair) + ground * warp::cosine_hemisphere_pdf(pair.wi.z)
    }

    /// The probabilities of sampling the coat and the ground: their shares of the light seen along `w`. Neither is 1 less
    /// the other, which would lose the digits of a small one.
    #[inline(always)]
    fn shares(&self, w: Vec3<R>) -> [R; 2] {
        let interface = self.interface.along(w, self.index);
        let (coat, ground) = (
            interface.reflectance,
            interface.transmittance * self.ground_albedo,
        );
        let both = coat + ground;
        if both > R::zero() {
            [coat / both, ground / both]
        } else {
            [R::one(), R::zero()]
        }
    }
}

impl<R: Real, N: Normals<R>, I: Interface<R>> Bxdf<R> for Plastic<R, N, I> {
    evaluated_by_pair!(Pair::above);

    #[inline(always)]
    fn sample_f(&self, wo: Vec3<R>, uc: R, u: [R; 2]) -> Option<Sample<R>> {
        let [share, _] = self.shares(wo);
        if self.coat.is_none() && uc < share {
            let [delta, _] = self.deltas(wo);
            return delta.map(|delta| delta.sample());
        }
        sample_reflection(
            self,
            wo,
            #[inline(always)]
            |wo| match &self.coat {
                Some((normals, _)) if uc < share => normals.sample_reflection(wo, u),
                _ => Some(warp::cosine_hemisphere(u)),
            },
        )
    }

    #[inline(always)]
    fn deltas(&self, w: Vec3<R>) -> Deltas<R> {
        let reflectance = self.interface.along(w, self.index).reflectance;
        let [share, _] = self.shares(w);
        let mirror = Delta {
            direction: w.mirrored_about_normal(),
            flux: Spectrum::grey(reflectance),
            weight: Spectrum::grey(reflectance),
            probability: share,
            side: Side::Reflection,
        };
        let is_there = self.coat.is_none() && w.z != R::zero() && reflectance > R::zero();
        [is_there.then_some(mirror), None]
    }
}

impl<R: Real, N: Normals<R>, I: Interface<R>> Lobes<R> for Plastic<R, N, I> {
    fn lobes(&self) -> &[Lobe] {
        SPEC.lobes
    }

    #[inline(always)]
    fn lobe_f(&self, index: usize, wo: Vec3<R>, wi: Vec3<R>) -> Spectrum<R> {
        let Some(pair) = Pair::above(wo, wi) else {
            return Spectrum::black();
        };
        match index {
            0 => self.coat_value(&pair),
            _ => self.ground_value(&pair),
        }
    }

    #[inline(always)]
    fn lobe_pdf(&self, index: usize, wo: Vec3<R>, wi: Vec3<R>) -> R {
        let Some(pair) = Pair::above(wo, wi) else {
            return R::zero();
        };
        match index {
            0 => self.coat_pdf(&pair),
            _ => warp::cosine_hemisphere_pdf(pair.wi.z),
        }
    }

    #[inline(always)]
    fn sample_lobe(&self, index: usize, wo: Vec3<R>, u: [R; 2]) -> Option<Vec3<R>> {
        reflected_direction(
            wo,
            #[inline(always)]
            |wo| match (index, &self.coat) {
                (0, Some((normals, _))) => normals.sample_reflection(wo, u),
                (0, None) => None,
                _ => Some(warp::cosine_hemisphere(u)),
            },
        )
    }

    fn microfacet(&self, wo: Vec3<R>, wi: Vec3<R>) -> Option<Microfacet<R>> {
        let (normals, masking) = self.coat.as_ref()?;
        let pair = Pair::above(wo, wi)?;
        Some(Microfacet {
            d: normals.d(pair.wh),
            g: normals.g2(pair.wo, pair.wi, *masking),
            fresnel: Spectrum::grey(pair.dielectric(&self.interface, self.index).reflectance),
        })
    }
}

impl<R: Real, N: Normals<R>, I: Interface<R>> Scatterer<R> for Plastic<R, N, I> {
    loops!(R, if Self::IS_WIDE);
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

    #[test]
    fn values_at_normal_incidence() {
        // Coat .04 / (4 pi .01); ground .5/pi .96^2 / (2.25 (1 - .5 Fdr_int)), Fdr_int = .59634575970771 at 1.5.
        let f = |text: &str| {
            let material: Material = text.parse().unwrap();
            let model = material.build::<f64>();
            [0, 1].map(|lobe| model.lobe_f(lobe, UP, UP).0[0] * std::f64::consts::PI)
        };
        let fdr_int = 0.596_345_759_707_711_6;
        let [coat, ground] = f("plastic");
        assert!((coat - 1.0).abs() < 1e-13);
        assert!(
            (ground / (0.5 * 0.96 * 0.96 / (2.25 * (1.0 - 0.5 * fdr_int))) - 1.0).abs() < 1e-13
        );
        let [_, linear] = f("plastic:nonlinear=false");
        assert!((linear / (0.5 * 0.96 * 0.96 / (2.25 * (1.0 - fdr_int))) - 1.0).abs() < 1e-13);
    }

    #[test]
    fn a_smooth_coat_is_a_delta() {
        let material: Material = "plastic:alpha=0".parse().unwrap();
        let model = material.build::<f64>();
        let sample = model.sample_f(UP, 0.0, [0.5, 0.5]).unwrap();
        assert!(sample.is_delta && (sample.f.0[0] - 0.04).abs() < 1e-15);
        assert_eq!(model.lobe_f(0, UP, UP).0, [0.0; 3]);
    }

    #[test]
    fn one_smooth_axis_is_refused() {
        for text in ["plastic:alpha_x=0", "plastic:alpha=.00001"] {
            let line = text.parse::<Material>().unwrap_err().to_string();
            assert!(line.contains("or 0 for both"), "{line}");
        }
    }
}
