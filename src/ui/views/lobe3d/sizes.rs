//! Sizes that the scene and what is painted over it have in common, in world units.

/// Where axes end, beyond the unit dome.
pub(super) const AXIS_LENGTH: f32 = 1.22;
/// Radius of the arcs of theta and phi.
pub(super) const ARC_RADIUS: f32 = 0.42;
/// A shorter projection of the held direction has no azimuth worth drawing.
pub(super) const FLAT: f32 = 1e-3;
