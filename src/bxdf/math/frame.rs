//! Spherical coordinates of the shading frame: theta from n, phi from s in the s-t plane.

use glam::DVec3;

/// The cosine and sine of an angle in degrees, exact at the multiples of 90 degrees (so that 90 degrees is the horizon
/// itself, and not 6e-17 above it).
#[must_use]
pub fn cos_sin_deg(angle_deg: f64) -> (f64, f64) {
    let turn = angle_deg.rem_euclid(360.0);
    let quarter = (turn / 90.0).round();
    let (sin, cos) = (turn - 90.0 * quarter).to_radians().sin_cos();
    match quarter as u8 {
        1 => (-sin, cos),
        2 => (-cos, -sin),
        3 => (sin, -cos),
        _ => (cos, sin),
    }
}

/// The unit direction at polar angle `theta_deg` from n and azimuth `phi_deg` from s, both in degrees.
///
/// ```
/// use bxdf::{Vec3, math::frame::direction_from_degrees};
///
/// let light: Vec3<f32> = direction_from_degrees(90.0, 180.0).into();
/// assert_eq!(light, Vec3::new(-1.0, 0.0, 0.0));
/// ```
#[must_use]
pub fn direction_from_degrees(theta_deg: f64, phi_deg: f64) -> DVec3 {
    let (cos_theta, sin_theta) = cos_sin_deg(theta_deg);
    let (cos_phi, sin_phi) = cos_sin_deg(phi_deg);
    DVec3::new(sin_theta * cos_phi, sin_theta * sin_phi, cos_theta)
}

/// The polar angle of `w` from n, in radians, 0 to pi. Accurate for every direction, poles included.
#[must_use]
pub fn theta(w: DVec3) -> f64 {
    w.x.hypot(w.y).atan2(w.z)
}

/// The azimuth of `w` from s, in radians, -pi to pi; 0 for a direction along n.
#[must_use]
pub fn phi(w: DVec3) -> f64 {
    if w.x == 0.0 && w.y == 0.0 {
        0.0
    } else {
        w.y.atan2(w.x)
    }
}

/// The angle between two directions, in radians, 0 to pi, accurate for nearly equal and nearly opposed ones.
#[must_use]
pub fn angle_between(a: DVec3, b: DVec3) -> f64 {
    a.cross(b).length().atan2(a.dot(b))
}

/// `w` turned about n by `angle` radians, counter-clockwise seen from above.
#[must_use]
pub fn turned_about_normal(w: DVec3, angle: f64) -> DVec3 {
    let (sin, cos) = angle.sin_cos();
    DVec3::new(cos * w.x - sin * w.y, sin * w.x + cos * w.y, w.z)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quarter_turns_are_exact() {
        assert_eq!(direction_from_degrees(90.0, 0.0), DVec3::X);
        assert_eq!(direction_from_degrees(90.0, 90.0), DVec3::Y);
        assert_eq!(direction_from_degrees(180.0, 45.0), DVec3::NEG_Z);
        assert_eq!(direction_from_degrees(90.0, -180.0), DVec3::NEG_X);
        assert_eq!(cos_sin_deg(-90.0), (0.0, -1.0));
    }

    #[test]
    fn angles_come_back() {
        for (theta_deg, phi_deg) in [
            (1e-7, 10.0),
            (30.0, -120.0),
            (89.999_999, 45.0),
            (135.0, 179.0),
        ] {
            let w = direction_from_degrees(theta_deg, phi_deg);
            assert!((theta(w).to_degrees() - theta_deg).abs() < 1e-13 * theta_deg.max(1e-2));
            assert!((phi(w).to_degrees() - phi_deg).abs() < 1e-12);
            assert!((w.length() - 1.0).abs() < 2e-16);
        }
        assert_eq!(phi(DVec3::Z), 0.0);
        assert!(
            (angle_between(DVec3::Z, direction_from_degrees(1e-6, 0.0)) - 1e-6_f64.to_radians())
                .abs()
                < 1e-22
        );
        assert!(
            (turned_about_normal(DVec3::X, 0.5)
                - direction_from_degrees(90.0, 0.5_f64.to_degrees()))
            .length()
                < 1e-15
        );
    }
}
