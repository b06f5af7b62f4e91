//! Light at an interface: spectra of three channels and Fresnel's equations.

pub mod conductor;
pub mod diffuse_fresnel;
pub mod facet_fresnel;
pub mod fresnel;
pub mod interface;
pub mod metal;
pub mod spectrum;

pub use spectrum::Spectrum;
