//! What each view shows, as data: one file per view, without a window.

pub mod isotropy;
pub mod lobe;
pub mod lobe3d;
pub mod polar;
pub mod quadrature;
pub mod reflectance;
pub mod scale;
pub mod thumbnail;

pub use lobe::{HeldLobe, Hold};
pub use scale::{Channel, RadialScale};
