//! Microfacet distributions: D, the masking functions and visible normals.

pub mod beckmann;
pub mod beckmann_rational;
pub(crate) mod choices;
pub mod compensation;
pub mod distribution;
pub mod ggx;
pub mod gtr1;
mod lost_energy;
pub mod multiple_scattering;
mod normals;
pub mod refraction;
mod visible_slope;

pub use distribution::Distribution;
pub use normals::Normals;

use crate::both_above;
use crate::math::{Real, Vec3};
use crate::optics::fresnel::{Dielectric, RelativeIndex};
use crate::optics::interface::Interface;
use crate::param::{ParamSet, ParamSpec, Role, Scale, Value};
use crate::spec::StandIn;

/// How masking (towards the viewer) and shadowing (towards the light) go together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Masking {
    /// Smith, correlated by the height of the facet (Heitz 2014, eq. 99).
    Correlated,
    /// Smith, the product of two independent factors.
    Separable,
}

impl Masking {
    /// The parameter that chooses it.
    pub const PARAM: ParamSpec = ParamSpec::choice(
        "masking",
        &["correlated", "separable"],
        "How shadowing and masking combine: a low facet is hidden from both sides at once (correlated), or the two are \
         taken as independent (separable, darker at grazing angles)",
    );

    /// What may replace [`Self::Correlated`] where `masking` chooses it.
    pub const STAND_IN: StandIn = StandIn {
        name: "Separable for correlated masking",
        lost: "A low facet counts as hidden from both sides twice: the lobe is too dark at grazing angles, the more so \
               the rougher it is",
        replace: |params| params.replaced(&[("masking", Value::Choice("separable"))]),
    };

    /// The choice in `params`.
    #[must_use]
    pub fn from_params(params: &ParamSet) -> Self {
        if params.choice("masking") == "separable" {
            Self::Separable
        } else {
            Self::Correlated
        }
    }
}

/// How much of a direction is masked: its cosine and t = mu (1 + 2 Lambda), with which every Smith factor is written
/// without a tangent and without a division by a cosine.
#[derive(Clone, Copy, Debug)]
pub struct Masked<R> {
    /// |cos(theta)|.
    pub mu: R,
    /// mu (1 + 2 Lambda).
    pub t: R,
}

impl<R: Real> Masked<R> {
    /// 4 mu_o mu_i / G2, above 0: correlated 2 (t_i mu_o + t_o mu_i), separable (mu_i + t_i)(mu_o + t_o).
    #[inline(always)]
    fn inverse_visibility(self, other: Self, masking: Masking) -> R {
        let inverse = match masking {
            Masking::Correlated => R::of(2.0) * (other.t * self.mu + self.t * other.mu),
            Masking::Separable => (other.mu + other.t) * (self.mu + self.t),
        };
        // Double grazing can underflow it to 0; the smallest normal number makes the quotients by it saturate.
        inverse.at_least(R::min_positive_value())
    }

    /// Masking and shadowing together, 0..1.
    #[inline(always)]
    fn g2(self, other: Self, masking: Masking) -> R {
        let ratio = |m: Self| m.mu / m.t.at_least(R::min_positive_value());
        let (o, i) = (ratio(self), ratio(other));
        let (one, two) = (R::one(), R::of(2.0));
        let g2 = match masking {
            Masking::Correlated => two * o * i / (o + i).at_least(R::min_positive_value()),
            Masking::Separable => two * o / (one + o) * (two * i / (one + i)),
        };
        g2.min(one)
    }

    /// What the density D of a visible normal is divided by for that of the direction into which it mirrors this one:
    /// D G1 (wo.wh) / mu_o over 4 (wo.wh) is D / (2 (mu_o + t_o)).
    #[inline(always)]
    fn normals_per_direction(self) -> R {
        (R::of(2.0) * (self.mu + self.t)).at_least(R::min_positive_value())
    }
}

/// The width of the normal distribution along s and t with the common default, a logarithmic slider each.
pub const ALPHA_X: ParamSpec = alpha(
    "alpha_x",
    0.3,
    "Width of the distribution of microfacet normals along s",
)
.role(Role::WidthS);
/// See [`ALPHA_X`]; along t.
pub const ALPHA_Y: ParamSpec = alpha(
    "alpha_y",
    0.3,
    "Width of the distribution of microfacet normals along t",
)
.role(Role::WidthT);

/// What may replace two different widths, `alpha_x` and `alpha_y`: one that leaves the peak as high.
pub const ONE_WIDTH: StandIn = StandIn {
    name: "One width for two",
    lost: "The lobe no longer turns with the surface: a blade becomes a round lobe with a peak as high",
    replace: |params| {
        let width = (params.number("alpha_x") * params.number("alpha_y")).sqrt();
        params.replaced(&["alpha_x", "alpha_y"].map(|name| (name, Value::Number(width))))
    },
};

/// A width parameter of hard range 1e-4..1 with the given default.
#[must_use]
pub const fn alpha(name: &'static str, default: f64, meaning: &'static str) -> ParamSpec {
    ParamSpec::number(name, default, meaning)
        .role(Role::Width)
        .hard(1e-4, 1.0)
        .soft(0.01, 1.0)
        .scale(Scale::Logarithmic)
}

/// Two directions above the surface, and the microfacet that mirrors the one into the other.
#[derive(Clone, Copy, Debug)]
pub struct Pair<R> {
    /// The outgoing direction.
    pub wo: Vec3<R>,
    /// The incident direction.
    pub wi: Vec3<R>,
    /// Their half vector.
    pub wh: Vec3<R>,
    /// Its cosine with both.
    pub cos_d: R,
}

impl<R: Real> Pair<R> {
    /// `wo` and `wi`, mirrored in the surface where both are below. `None` as of [`both_above`] and of [`half_vector`].
    #[inline(always)]
    pub fn above(wo: Vec3<R>, wi: Vec3<R>) -> Option<Self> {
        let (wo, wi) = both_above(wo, wi)?;
        let (wh, cos_d) = half_vector(wo, wi)?;
        Some(Self { wo, wi, wh, cos_d })
    }

    /// What a facet that is such an `interface` does with light between the two.
    #[inline(always)]
    pub fn dielectric(
        &self,
        interface: &impl Interface<R>,
        index: RelativeIndex<R>,
    ) -> Dielectric<R> {
        interface.with_sine(self.cos_d, self.sin2_d(), index)
    }

    /// The square of the sine to [`Self::cos_d`], half the angle between the two: |wo - wi| / 2 is the sine.
    #[inline(always)]
    pub fn sin2_d(&self) -> R {
        (self.wo - self.wi).length_squared() * R::of(0.25)
    }
}

/// The methods `f`, `pdf` and `f_pdf` of a model that has methods `value` and `density` of a [`Pair`], which the function
/// given makes of two directions.
macro_rules! evaluated_by_pair {
    ($pair:path) => {
        #[inline(always)]
        fn f(&self, wo: Vec3<R>, wi: Vec3<R>) -> Spectrum<R> {
            let Some(pair) = $pair(wo, wi) else {
                return Spectrum::black();
            };
            self.value(&pair)
        }

        #[inline(always)]
        fn pdf(&self, wo: Vec3<R>, wi: Vec3<R>) -> R {
            let Some(pair) = $pair(wo, wi) else {
                return R::zero();
            };
            self.density(&pair)
        }

        #[inline(always)]
        fn f_pdf(&self, wo: Vec3<R>, wi: Vec3<R>) -> (Spectrum<R>, R) {
            let Some(pair) = $pair(wo, wi) else {
                return (Spectrum::black(), R::zero());
            };
            (self.value(&pair), self.density(&pair))
        }
    };
}

pub(crate) use evaluated_by_pair;

/// The half vector wi + wo, as the unit vector `wh` and the cosine `cos_d` of `wo` (and `wi`) with it.
///
/// For unit `wi` and `wo` that cosine is half the length of the sum, which keeps its digits where the dot product
/// does not. `None` where the two directions are opposed.
#[inline(always)]
pub fn half_vector<R: Real>(wo: Vec3<R>, wi: Vec3<R>) -> Option<(Vec3<R>, R)> {
    let (wh, length) = (wo + wi).unit_and_length_of_short()?;
    Some((wh, (length * R::of(0.5)).at_most(R::one())))
}
