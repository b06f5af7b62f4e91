//! Light at an interface: spectra of three channels and Fresnel's equations.

pub(crate) mod conductor;
pub(crate) mod diffuse_fresnel;
pub(crate) mod facet_fresnel;
pub(crate) mod fresnel;
pub(crate) mod interface;
pub(crate) mod metal;
pub mod spectrum;

pub use spectrum::Spectrum;
