//! What the glossy models of the empirical kind share: powers of cosines, Gaussian slopes, and a glossy lobe that stands
//! over a diffuse one.

pub mod cosine_power;
pub mod gaussian_slopes;

use super::batch::{Scatterer, loops};
use super::lobe::{Category, Lobe};
use super::lobes::Lobes;
use super::math::{Real, Vec3, warp};
use super::microfacet::{Pair, evaluated_by_pair};
use super::optics::Spectrum;
use super::param::{ParamSet, ParamSpec, Scale};
use super::sample::Sample;
use super::scattering::{Bxdf, reflected_direction, sample_reflection};

/// The lobes of a [`Mixture`], in its order.
pub const LOBES: &[Lobe] = &[
    Lobe::reflection(Category::GlossySpecular),
    Lobe::reflection(Category::Diffuse),
];

/// The reflectance of the diffuse lobe, none at first.
pub const DIFFUSE: ParamSpec = ParamSpec::rgb(
    "diffuse",
    [0.0; 3],
    "Share of the light that is reflected in all directions, per channel; with the specular share at most 1 in nature",
);

/// The reflectance of the glossy lobe.
pub const SPECULAR: ParamSpec = ParamSpec::rgb(
    "specular",
    [1.0; 3],
    "Share of the light that is reflected into the glossy lobe, per channel",
);

/// Whether [`DIFFUSE`] and [`SPECULAR`] are more than 1 together in a channel: the two are free.
#[must_use]
pub fn exceeds_one(params: &ParamSet) -> bool {
    let channels = params
        .rgb("diffuse")
        .into_iter()
        .zip(params.rgb("specular"));
    channels
        .into_iter()
        .any(|(diffuse, specular)| diffuse + specular > 1.0)
}

/// An exponent of hard range 1..1e4 with the given default, a logarithmic slider.
#[must_use]
pub const fn exponent(name: &'static str, default: f64, meaning: &'static str) -> ParamSpec {
    ParamSpec::number(name, default, meaning)
        .hard(1.0, 1e4)
        .soft(1.0, 1000.0)
        .scale(Scale::Logarithmic)
}

/// A glossy lobe and a diffuse one, both reflecting. All directions are above the surface.
pub trait OverDiffuse<R: Real>: Send + Sync {
    /// The value of the glossy lobe in 1/sr, saturated.
    fn glossy(&self, pair: &Pair<R>) -> Spectrum<R>;

    /// The density per solid angle of [`Self::sample_glossy`], in 1/sr, saturated.
    fn glossy_pdf(&self, pair: &Pair<R>) -> R;

    /// A direction distributed as the glossy lobe; it may leave below the horizon. `u` uniform in [0, 1).
    fn sample_glossy(&self, wo: Vec3<R>, u: [R; 2]) -> Option<Vec3<R>>;

    /// The value of the diffuse lobe in 1/sr.
    fn diffuse(&self, pair: &Pair<R>) -> Spectrum<R>;

    /// The probabilities with which a sample for `wo` is drawn from the glossy and from the diffuse lobe; see [`shares`].
    fn shares(&self, wo: Vec3<R>) -> [R; 2];
}

/// The probabilities of two lobes that reflect `glossy` and `diffuse`, in proportion to the sum of their channels. All
/// to the glossy one where both are black.
///
/// Both are formed as quotients: 1 - p would lose a faint lobe's density, and in f32 the whole lobe.
#[inline(always)]
pub fn shares<R: Real>(glossy: Spectrum<R>, diffuse: Spectrum<R>) -> [R; 2] {
    let sum = |Spectrum([r, g, b]): Spectrum<R>| r + g + b;
    let (glossy, diffuse) = (sum(glossy), sum(diffuse));
    let both = glossy + diffuse;
    if both > R::zero() {
        [glossy / both, diffuse / both]
    } else {
        [R::one(), R::zero()]
    }
}

/// `w` (above the surface) reflected at the microfacet normal `wh`; it may leave below the horizon.
#[inline(always)]
pub fn reflected<R: Real>(w: Vec3<R>, wh: Vec3<R>) -> Vec3<R> {
    wh * (R::of(2.0) * w.dot(wh)) - w
}

/// The two-sided model of a glossy lobe over a diffuse one.
pub struct Mixture<M>(pub M);

impl<M> Mixture<M> {
    #[inline(always)]
    fn value<R: Real>(&self, pair: &Pair<R>) -> Spectrum<R>
    where
        M: OverDiffuse<R>,
    {
        (self.0.glossy(pair) + self.0.diffuse(pair)).saturated()
    }

    #[inline(always)]
    fn density<R: Real>(&self, pair: &Pair<R>) -> R
    where
        M: OverDiffuse<R>,
    {
        let [glossy, diffuse] = self.0.shares(pair.wo);
        (glossy * self.0.glossy_pdf(pair) + diffuse * warp::cosine_hemisphere_pdf(pair.wi.z))
            .saturated()
    }
}

impl<R: Real, M: OverDiffuse<R>> Bxdf<R> for Mixture<M> {
    evaluated_by_pair!(Pair::above);

    #[inline(always)]
    fn sample_f(&self, wo: Vec3<R>, uc: R, u: [R; 2]) -> Option<Sample<R>> {
        sample_reflection(
            self,
            wo,
            #[inline(always)]
            |wo| {
                let [glossy, _] = self.0.shares(wo);
                if uc < glossy {
                    self.0.sample_glossy(wo, u)
                } else {
                    Some(warp::cosine_hemisphere(u))
                }
            },
        )
    }
}

impl<R: Real, M: OverDiffuse<R>> Lobes<R> for Mixture<M> {
    fn lobes(&self) -> &[Lobe] {
        LOBES
    }

    #[inline(always)]
    fn lobe_f(&self, index: usize, wo: Vec3<R>, wi: Vec3<R>) -> Spectrum<R> {
        let Some(pair) = Pair::above(wo, wi) else {
            return Spectrum::black();
        };
        match index {
            0 => self.0.glossy(&pair),
            _ => self.0.diffuse(&pair),
        }
    }

    #[inline(always)]
    fn lobe_pdf(&self, index: usize, wo: Vec3<R>, wi: Vec3<R>) -> R {
        let Some(pair) = Pair::above(wo, wi) else {
            return R::zero();
        };
        match index {
            0 => self.0.glossy_pdf(&pair),
            _ => warp::cosine_hemisphere_pdf(pair.wi.z),
        }
    }

    #[inline(always)]
    fn sample_lobe(&self, index: usize, wo: Vec3<R>, u: [R; 2]) -> Option<Vec3<R>> {
        reflected_direction(
            wo,
            #[inline(always)]
            |wo| match index {
                0 => self.0.sample_glossy(wo, u),
                _ => Some(warp::cosine_hemisphere(u)),
            },
        )
    }
}

impl<R: Real, M: OverDiffuse<R>> Scatterer<R> for Mixture<M> {
    loops!(R, if true);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_faint_lobe_keeps_its_share() {
        let faint = shares(Spectrum::grey(1.0_f32), Spectrum::grey(1e-12));
        assert_eq!(faint, [1.0, 1e-12]);
        assert_eq!(shares(Spectrum::grey(0.0), Spectrum::grey(0.3)), [0.0, 1.0]);
        assert_eq!(
            shares(Spectrum::<f64>::black(), Spectrum::black()),
            [1.0, 0.0]
        );
    }
}
