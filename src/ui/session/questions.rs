//! What the views ask about each material, as the session has it.

use super::Session;
use crate::analysis::reflectance::SharesRequest;
use crate::analysis::{lobe3d, polar};

/// The shares of light at the screen: an error below half a unit of the last digit shown, and evaluations for a few
/// milliseconds, whatever the material.
pub const SHARES: SharesRequest = SharesRequest {
    tolerance: 2e-4,
    max_evaluations: 60_000,
};

impl Session {
    /// The section of the polar plot.
    #[must_use]
    pub fn section_request(&self) -> polar::Request {
        polar::Request {
            phi: self.section_azimuth_deg().to_radians(),
            with_cosine: self.with_cosine,
            scale: self.scale,
        }
    }

    /// The mesh of the 3D view.
    #[must_use]
    pub fn mesh_request(&self) -> lobe3d::Request {
        lobe3d::Request {
            scale: self.scale,
            with_cosine: self.with_cosine,
        }
    }
}
