//! Half and difference angles: a pair of directions by what lies midway between them, and by how far they are from it.

use glam::DVec3;

use bxdf::math::frame;

/// A direction in spherical coordinates, in degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spherical {
    /// The angle from n, 0..180.
    pub theta_deg: f64,
    /// The azimuth from s, -180..180.
    pub phi_deg: f64,
}

impl Spherical {
    /// Those of the unit vector `w`.
    #[must_use]
    pub fn of(w: DVec3) -> Self {
        let phi_deg = frame::phi(w).to_degrees();
        Self {
            theta_deg: frame::theta(w).to_degrees(),
            // The rounding of a sine of 180 degrees must not turn it into -180.
            phi_deg: if phi_deg <= -180.0 + 1e-9 {
                180.0
            } else {
                phi_deg
            },
        }
    }
}

/// A pair of directions by its half vector and the difference from it (`rusinkiewicz1998`).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HalfDifference {
    /// The half vector wh, on the upper side.
    pub half: Spherical,
    /// The direction wi in the frame in which wh is the normal: theta_d, 0..90, and phi_d.
    pub difference: Spherical,
}

/// The half and difference angles of two unit vectors on one side of the surface; `None` where they are on different
/// sides, or opposed.
#[must_use]
pub fn half_difference(wo: DVec3, wi: DVec3) -> Option<HalfDifference> {
    let is_one_side = (wo.z > 0.0) == (wi.z > 0.0);
    let sum = (wo + wi).try_normalize().filter(|_| is_one_side)?;
    let is_upper = sum.z >= 0.0;
    let (wh, wo, wi) = if is_upper {
        (sum, wo, wi)
    } else {
        (-sum, -wo, -wi)
    };
    // Turned about n by -phi_h, then about t by -theta_h, wh becomes n. Half of wi - wo is what wi has across wh, and half
    // of wi + wo what it has along it: neither loses digits where the directions nearly meet.
    let (sin_phi, cos_phi) = frame::phi(wh).sin_cos();
    let (sin_theta, cos_theta) = (wh.x.hypot(wh.y), wh.z);
    let across = 0.5 * (wi - wo);
    let radial = across.x * cos_phi + across.y * sin_phi;
    let difference = DVec3::new(
        radial * cos_theta - across.z * sin_theta,
        across.y * cos_phi - across.x * sin_phi,
        0.5 * (wi + wo).length(),
    );
    Some(HalfDifference {
        half: Spherical::of(wh),
        difference: Spherical::of(difference),
    })
}

/// The pair (wo, wi) with these half and difference angles, the inverse of [`half_difference`]; a direction lies below
/// the surface where there is no such pair above it.
#[must_use]
pub fn pair(half: Spherical, difference: Spherical) -> (DVec3, DVec3) {
    let (cos_h, sin_h) = frame::cos_sin_deg(half.theta_deg);
    let (cos_d, sin_d) = frame::cos_sin_deg(difference.theta_deg);
    let (cos_half, sin_half) = frame::cos_sin_deg(0.5 * difference.phi_deg);
    let (cos_azimuth, sin_azimuth) = frame::cos_sin_deg(difference.phi_deg);
    // The heights cos_h cos_d -+ sin_h sin_d cos(phi_d), as sums that do not cancel above the surface: a direction in
    // the horizon plane comes out in it.
    let grazing = frame::cos_sin_deg(half.theta_deg + difference.theta_deg).0;
    let height = |part: f64| grazing + 2.0 * sin_h * sin_d * part * part;
    let (cos_phi, sin_phi) = frame::cos_sin_deg(half.phi_deg);
    let place = |sign: f64, z: f64| {
        let radial = sign * sin_d * cos_azimuth * cos_h + cos_d * sin_h;
        let across = sign * sin_d * sin_azimuth;
        let x = radial * cos_phi - across * sin_phi;
        DVec3::new(x, radial * sin_phi + across * cos_phi, z)
    };
    (place(-1.0, height(cos_half)), place(1.0, height(sin_half)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use bxdf::math::frame::direction_from_degrees;

    #[test]
    fn mirrored_directions_meet_at_the_normal() {
        let [wo, wi] = [20.0, -160.0].map(|phi| direction_from_degrees(35.0, phi));
        let found = half_difference(wo, wi).unwrap();
        assert!(found.half.theta_deg < 1e-12);
        assert!((found.difference.theta_deg - 35.0).abs() < 1e-12);
        let below = half_difference(-wo, -wi).unwrap();
        assert!((below.difference.theta_deg - 35.0).abs() < 1e-12);
        assert_eq!(half_difference(wo, -wi), None);
        assert_eq!(half_difference(DVec3::X, DVec3::NEG_X), None);
    }

    #[test]
    fn one_direction_twice_is_its_own_half() {
        let w = direction_from_degrees(50.0, 130.0);
        let HalfDifference { half, difference } = half_difference(w, w).unwrap();
        assert!((half.theta_deg - 50.0).abs() < 1e-12 && (half.phi_deg - 130.0).abs() < 1e-12);
        assert!(difference.theta_deg < 1e-12);
    }

    #[test]
    fn the_difference_in_the_plane_of_incidence_is_half_the_opening() {
        // 70 and 10 degrees to the same side: the half vector at 40, wi 30 beyond it towards the horizon.
        let [wo, wi] = [10.0, 70.0].map(|theta| direction_from_degrees(theta, 0.0));
        let HalfDifference { half, difference } = half_difference(wo, wi).unwrap();
        assert!((half.theta_deg - 40.0).abs() < 1e-12);
        assert!((difference.theta_deg - 30.0).abs() < 1e-12 && difference.phi_deg.abs() < 1e-9);
    }

    fn angles(theta_deg: f64, phi_deg: f64) -> Spherical {
        Spherical { theta_deg, phi_deg }
    }

    #[test]
    fn angles_of_a_pair_come_back() {
        let halves = [(0.0, 0.0), (1e-9, 20.0), (40.0, 180.0), (89.0, -100.0)];
        let differences = [
            (0.0, 0.0),
            (1e-9, 70.0),
            (30.0, 90.0),
            (89.999_999, -90.0),
            (0.5, -170.0),
        ];
        for (theta_h, phi_h) in halves {
            for (theta_d, phi_d) in differences {
                let (half, difference) = (angles(theta_h, phi_h), angles(theta_d, phi_d));
                let (wo, wi) = pair(half, difference);
                let unit = |w: DVec3| (w.length() - 1.0).abs() < 4e-16;
                assert!(unit(wo) && unit(wi), "{half:?} {difference:?}");
                let found = half_difference(wo, wi).unwrap();
                // Half vectors are known worse where the directions are all but opposed, and what their azimuth does not
                // know about n is not known of phi_d.
                let opposed = theta_d.to_radians().cos();
                let near = |a: Spherical, b: Spherical, tolerance: f64| {
                    let theta = (a.theta_deg - b.theta_deg).abs();
                    let phi = (a.phi_deg - b.phi_deg).rem_euclid(360.0);
                    let arc = phi.min(360.0 - phi) * b.theta_deg.to_radians().sin();
                    assert!(
                        theta < tolerance.max(1e-13) && arc < tolerance,
                        "{a:?} {b:?}"
                    );
                };
                near(found.half, half, 1e-13 / opposed);
                let pole = if theta_h == 0.0 {
                    1.0
                } else {
                    theta_h.to_radians().sin()
                };
                near(found.difference, difference, 1e-13 / (opposed * pole));
            }
        }
    }

    #[test]
    fn near_directions_keep_the_digits_of_their_difference() {
        // 1e-9 degrees from the half vector: wi - wo has seven digits in any of its components.
        let difference = angles(1e-9, 35.0);
        let (wo, wi) = pair(angles(50.0, 130.0), difference);
        let found = half_difference(wo, wi).unwrap().difference;
        assert!((found.theta_deg / 1e-9 - 1.0).abs() < 1e-4, "{found:?}");
        assert!((found.phi_deg - 35.0).abs() < 1e-3, "{found:?}");
    }

    #[test]
    fn pairs_end_at_the_horizon() {
        // In the plane of n the angles from n are theta_h + theta_d and theta_h - theta_d.
        let (wo, wi) = pair(angles(30.0, 0.0), angles(60.0, 0.0));
        assert!(wi.z == 0.0 && (wo - direction_from_degrees(-30.0, 0.0)).length() < 1e-15);
        let (_, wi) = pair(angles(30.0, 0.0), angles(60.0 - 1e-9, 0.0));
        let height = 1e-9_f64.to_radians();
        // The angles' sum is rounded to 1.4e-14 degrees.
        assert!((wi.z / height - 1.0).abs() < 2e-5, "{wi:?}");
        // Across the plane both are equally high.
        let (wo, wi) = pair(angles(30.0, 40.0), angles(60.0, 90.0));
        assert!((wo.z - 0.75_f64.sqrt() / 2.0).abs() < 1e-15 && (wo.z - wi.z).abs() < 1e-15);
        assert!(pair(angles(50.0, 0.0), angles(60.0, 0.0)).1.z < 0.0);
    }
}
