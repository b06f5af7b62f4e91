//! Numbers, vectors, frames and warps: generic over the precision, free of optics.

pub mod frame;
pub(crate) mod library;
mod precisions;
pub(crate) mod quadrature;
mod real;
pub(crate) mod special;
mod vec3;
pub mod warp;

pub use real::Real;
pub use vec3::Vec3;
