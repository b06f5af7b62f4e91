//! What the window asks about the selected material besides its views.

use bxdf_lab::analysis::reflectance::SharesRequest;

/// The shares of light at the screen: an error below half a unit of the last digit shown, and evaluations for a few
/// milliseconds, whatever the material.
pub const SHARES: SharesRequest = SharesRequest {
    tolerance: 2e-4,
    max_evaluations: 60_000,
};
