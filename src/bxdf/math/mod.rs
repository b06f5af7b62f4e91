//! Numbers, vectors, frames and warps: generic over the precision, free of optics.

pub mod fast;
pub mod frame;
pub mod quadrature;
pub mod real;
pub mod special;
pub mod vec3;
pub mod warp;

pub use fast::Fast;
pub use real::Real;
pub use vec3::Vec3;
