//! What the labs, the document and the command line look at inside the models, and nobody else needs: no part of the
//! interface, and free to change.

pub use crate::glossy::cosine_power;
pub use crate::math::library::Libm;
pub use crate::math::quadrature::gauss_legendre;
pub use crate::microfacet::multiple_scattering::EnergyTable;
pub use crate::microfacet::{Masking, Normals, ggx, gtr1};
pub use crate::optics::conductor::Conductor;
pub use crate::optics::diffuse_fresnel::diffuse_transmittance;
pub use crate::optics::facet_fresnel::{AnyFresnel, FacetFresnel};
pub use crate::optics::interface::{AnyInterface, Interface};
pub use crate::sample::sample_deltas;

use crate::math::{Real, Vec3};
use crate::models::eon;
use crate::param::ParamSet;

/// Fresnel's equations and what is taken for them.
pub mod fresnel {
    pub use crate::optics::fresnel::*;
}

/// Text from files, in whatever encoding.
#[cfg(feature = "files")]
pub mod files {
    pub use crate::encoding::utf8;
    pub use crate::files::{data_at, read_bytes, text_at, text_of};
}

/// The part of the energy-preserving Oren-Nayar model's compensation that loses digits in the textbook's form.
#[inline(always)]
pub fn eon_loss<R: Real>(w: Vec3<R>) -> R {
    eon::loss(w)
}

/// The set with the number `name` where its range need not reach: for a look inside a model's core, whose formulas hold on
/// beyond what is allowed. `None` where the model has no such number.
#[must_use]
pub fn beyond_range(set: &ParamSet, name: &str, value: f64) -> Option<ParamSet> {
    set.beyond_range(name, value)
}
