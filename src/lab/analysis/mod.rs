//! What each view shows, as data: one file per view, without a window.

pub mod cartesian;
mod chart;
pub mod decomposition;
pub mod deltas;
pub mod fresnel;
pub mod half_difference;
pub mod hemisphere;
pub mod inspector;
pub mod integral;
pub mod isotropy;
pub mod lobe;
pub mod lobe3d;
pub mod polar;
pub mod quadrature;
pub mod query;
pub mod raster;
mod refine;
pub mod reflectance;
pub mod sampling;
pub mod scale;
mod section;
pub mod slice;
pub mod sphere;
pub mod statistics;
pub mod thumbnail;

pub use lobe::{HeldLobe, Hold};
pub use query::{Basis, IsWanted, Pace, Query, Steps, Subject, Tell, finish, pause, step};
pub use raster::Raster;
pub use scale::{Channel, RadialScale};

/// How carefully something is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Detail {
    /// In a few milliseconds, to have something to show.
    Coarse,
    /// As good as a screen can show.
    Full,
}
