//! Angles and directions in a section: a plane that contains the normal.

use glam::DVec3;

use bxdf::math::frame;

/// The direction at signed angle `angle` of the section at azimuth `phi`, both in radians.
#[must_use]
pub fn direction(angle: f64, phi: f64) -> DVec3 {
    let (sin, cos) = angle.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    DVec3::new(sin * cos_phi, sin * sin_phi, cos)
}

/// The signed angle of `w` in the section at azimuth `phi`, as if `w` lay in it.
#[must_use]
pub fn signed_angle(w: DVec3, phi: f64) -> f64 {
    let is_positive = w.x * phi.cos() + w.y * phi.sin() >= 0.0;
    if is_positive {
        frame::theta(w)
    } else {
        -frame::theta(w)
    }
}
