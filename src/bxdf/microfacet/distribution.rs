//! The choice among the distributions of microfacet normals.

use super::beckmann::Beckmann;
use super::beckmann_rational::BeckmannRational;
use super::ggx::Ggx;
use super::normals::Normals;
use super::{Masked, Masking, Pair};
use crate::math::{Real, Vec3};
use crate::param::{ParamSet, ParamSpec, Role, Value};
use crate::spec::StandIn;

/// A distribution of microfacet normals with its masking, chosen by the parameter `distribution`.
#[derive(Clone, Copy, Debug)]
pub enum Distribution<R> {
    /// GGX (Trowbridge-Reitz): a long tail.
    Ggx(Ggx<R>),
    /// Beckmann: slopes of a Gaussian.
    Beckmann(Beckmann<R>),
    /// Beckmann, its masking fitted.
    BeckmannRational(BeckmannRational<R>),
}

/// The parameter that chooses a [`Distribution`].
pub const DISTRIBUTION: ParamSpec = ParamSpec::choice(
    "distribution",
    &["ggx", "beckmann", "beckmann_rational"],
    "How the microfacet normals are spread: GGX has a sharp peak and a long tail, Beckmann is a Gaussian of slopes that \
     ends soon; beckmann_rational is the same with a cheap fit of the masking, off by up to .31 %",
)
.role(Role::Distribution);

/// What may replace Beckmann's masking.
pub const RATIONAL_MASKING: StandIn = StandIn {
    name: "Rational fit for exact Beckmann masking",
    lost: "Masking is off by up to .31 %, and no longer quite the one that samples are drawn by",
    replace: |params| {
        let is_exact = params.choice("distribution") == "beckmann";
        is_exact
            .then(|| params.replaced(&[("distribution", Value::Choice("beckmann_rational"))]))?
    },
};

impl<R: Real> Distribution<R> {
    /// The distribution in `params`, with its widths `alpha_x` and `alpha_y`, both above 0.
    #[must_use]
    pub fn from_params(params: &ParamSet) -> Self {
        let [alpha_x, alpha_y] = ["alpha_x", "alpha_y"].map(|name| R::of(params.number(name)));
        match params.choice("distribution") {
            "beckmann_rational" => {
                Self::BeckmannRational(BeckmannRational(Beckmann::new(alpha_x, alpha_y)))
            }
            word => Self::new(word == "beckmann", [alpha_x, alpha_y]),
        }
    }

    /// Whether the normals in `params` are Beckmann's, whatever their masking.
    #[must_use]
    pub fn is_beckmann(params: &ParamSet) -> bool {
        params.choice("distribution") != "ggx"
    }

    /// Beckmann or GGX with these widths along s and t.
    pub fn new(is_beckmann: bool, [alpha_x, alpha_y]: [R; 2]) -> Self {
        if is_beckmann {
            Self::Beckmann(Beckmann::new(alpha_x, alpha_y))
        } else {
            Self::Ggx(Ggx::new(alpha_x, alpha_y))
        }
    }
}

/// `$method` of the distribution that `$self` is.
macro_rules! dispatched {
    ($self:ident.$method:ident($($argument:expr),*)) => {
        match $self {
            Self::Ggx(normals) => normals.$method($($argument),*),
            Self::Beckmann(normals) => normals.$method($($argument),*),
            Self::BeckmannRational(normals) => normals.$method($($argument),*),
        }
    };
}

/// The one chosen when the program runs.
impl<R: Real> Normals<R> for Distribution<R> {
    const VECTORISES: bool = false;

    #[inline(always)]
    fn d(&self, wh: Vec3<R>) -> R {
        dispatched!(self.d(wh))
    }

    #[inline(always)]
    fn masked(&self, w: Vec3<R>) -> Masked<R> {
        dispatched!(self.masked(w))
    }

    fn masking_excess(&self, w: Vec3<R>) -> R {
        dispatched!(self.masking_excess(w))
    }

    fn sample_visible_normal(&self, wo: Vec3<R>, u: [R; 2]) -> Option<Vec3<R>> {
        dispatched!(self.sample_visible_normal(wo, u))
    }

    #[inline(always)]
    fn lobe(&self, pair: &Pair<R>, masking: Masking) -> R {
        dispatched!(self.lobe(pair, masking))
    }

    #[inline(always)]
    fn reflection_pdf(&self, pair: &Pair<R>) -> R {
        dispatched!(self.reflection_pdf(pair))
    }

    #[inline(always)]
    fn stretched_lobe(&self, pair: &Pair<R>, masking: Masking, factor: R) -> R {
        dispatched!(self.stretched_lobe(pair, masking, factor))
    }

    #[inline(always)]
    fn stretched_pdf(&self, pair: &Pair<R>, factor: R) -> R {
        dispatched!(self.stretched_pdf(pair, factor))
    }
}
