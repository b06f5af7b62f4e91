//! Quantities: single numbers about a surface, a light and a viewer, each with a name, a unit and a meaning, so that a text
//! can name what is computed for it in place of the number.

use bxdf::error::{Error, Result};

mod alpha_of_roughness;
mod angle;
mod delta;
mod deviation;
mod error_of;
mod f;
mod f_cos;
mod facet;
mod integral;
mod jacobian;
mod lost_samples;
mod normals;
mod parameter;
mod pdf;
mod pi_f;
mod quantity;
mod reflectance;
mod rho_dh;
mod rho_hd;
mod rho_hh;
mod scene;
mod share;
mod theta_m;
mod variance;

pub use quantity::{Argument, Given, Quantity, Takes, Value};
pub use scene::Scene;

/// The one list of quantities, in the order in which they are documented: each is one constant of one file.
pub static QUANTITIES: [Quantity; 26] = [
    f::QUANTITY,
    pi_f::QUANTITY,
    f_cos::QUANTITY,
    pdf::QUANTITY,
    facet::DENSITY,
    facet::MASKING,
    facet::MASKING_OF_ONE,
    facet::FRESNEL,
    reflectance::QUANTITY,
    rho_dh::QUANTITY,
    rho_hd::QUANTITY,
    rho_hh::QUANTITY,
    share::QUANTITY,
    delta::QUANTITY,
    angle::QUANTITY,
    integral::QUANTITY,
    theta_m::QUANTITY,
    theta_m::MODE,
    theta_m::MEAN,
    theta_m::DENSITY,
    lost_samples::QUANTITY,
    variance::QUANTITY,
    jacobian::QUANTITY,
    deviation::QUANTITY,
    error_of::QUANTITY,
    parameter::QUANTITY,
];

/// Quantities that are of no surface.
pub static CONVERSIONS: [Quantity; 1] = [alpha_of_roughness::QUANTITY];

/// Every quantity.
pub fn all() -> impl Iterator<Item = &'static Quantity> {
    QUANTITIES.iter().chain(&CONVERSIONS)
}

/// The quantity of this id.
///
/// # Errors
/// [`Error::UnknownId`], with the nearest ids.
pub fn find(id: &str) -> Result<&'static Quantity> {
    let found = all().find(|quantity| quantity.id == id);
    found.ok_or_else(|| Error::unknown("quantity", id, all().map(|quantity| quantity.id)))
}

#[cfg(test)]
mod tests;
