//! Microfacet distributions: D, the masking functions and visible normals.

pub mod ggx;

use crate::bxdf::math::{Real, Vec3};
use crate::bxdf::param::{ParamSet, ParamSpec, Scale};

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

/// The width of the normal distribution along s and t with the common default, a logarithmic slider each.
pub const ALPHA_X: ParamSpec = alpha(
    "alpha_x",
    0.3,
    "Width of the distribution of microfacet normals along s",
);
/// See [`ALPHA_X`]; along t.
pub const ALPHA_Y: ParamSpec = alpha(
    "alpha_y",
    0.3,
    "Width of the distribution of microfacet normals along t",
);

/// A width parameter of hard range 1e-4..1 with the given default.
#[must_use]
pub const fn alpha(name: &'static str, default: f64, meaning: &'static str) -> ParamSpec {
    ParamSpec::number(name, default, meaning)
        .hard(1e-4, 1.0)
        .soft(0.01, 1.0)
        .scale(Scale::Logarithmic)
}

/// The half vector wi + wo, as the unit vector `wh` and the cosine `cos_d` of `wo` (and `wi`) with it.
///
/// For unit `wi` and `wo` that cosine is half the length of the sum, which keeps its digits where the dot product
/// does not. `None` where the two directions are opposed.
#[inline(always)]
pub fn half_vector<R: Real>(wo: Vec3<R>, wi: Vec3<R>) -> Option<(Vec3<R>, R)> {
    let (wh, length) = (wo + wi).unit_and_length()?;
    Some((wh, (length * R::of(0.5)).min(R::one())))
}
