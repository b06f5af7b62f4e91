//! The points of a sphere and the pairs of directions that they show.

use std::f64::consts::PI;

use glam::DVec3;

use super::scene::Frame;
use crate::analysis::half_difference::half_difference;
use crate::analysis::{HeldLobe, deltas};
use bxdf::math::frame;

/// The pair of directions (wo, wi) in the shading frame at the point `place` of the sphere, which is lit from the unit
/// vector `light` of the picture; x to the right and y up, in radii. `None` outside the disc and on its rim.
#[must_use]
pub fn pair_at(light: DVec3, place: [f64; 2]) -> Option<(DVec3, DVec3)> {
    let [x, y] = place;
    let square = x * x + y * y;
    let frame = (square < 1.0).then(|| Frame::at(DVec3::new(x, y, (1.0 - square).sqrt())))?;
    Some((frame.local(DVec3::Z).into(), frame.local(light).into()))
}

/// Where a mirror shows the light itself, x to the right and y up, in radii, and the share of its flux that the surface of
/// `lobe` mirrors there, per channel: a Dirac delta, which is no radiance. `None` where it mirrors nothing, and where the
/// sphere, lit from the unit vector `light`, hides the light.
#[must_use]
pub fn glint(lobe: &HeldLobe<'_>, light: DVec3) -> Option<([f64; 2], [f64; 3])> {
    let half = (light + DVec3::Z).try_normalize()?;
    let theta_d = 0.5 * frame::angle_between(light, DVec3::Z).to_degrees();
    let flux = deltas::mirrored(lobe, frame::direction_from_degrees(theta_d, 0.0))?;
    Some(([half.x, half.y], flux))
}

/// A point of the sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Normal {
    /// Where it is seen: x to the right and y up, in radii.
    pub place: [f64; 2],
    /// Whether the light stands as far from the viewer there as in the pair, within half a degree of theta_d.
    pub is_exact: bool,
}

/// How far theta_d may differ where a point shows a pair as it is, in degrees.
const EXACT_DEG: f64 = 0.5;

/// The point of a sphere lit from the unit vector `light` of the picture that shows the pair (`wo`, `wi`): the one with
/// its theta_h and phi_d (`rusinkiewicz1998`). `None` where it is on the far side, and where the pair or light and viewer
/// have no half vector.
///
/// A sphere under one light shows but one theta_d, half the angle between light and viewer, and each azimuth phi_h at a
/// place of its own: what an anisotropic surface shows there is not the pair's value.
#[must_use]
pub fn normal_of(light: DVec3, wo: DVec3, wi: DVec3) -> Option<Normal> {
    let pair = half_difference(wo, wi)?;
    let half = (light + DVec3::Z).try_normalize()?;
    // The light's direction about the half vector, any where both are the same.
    let across = light - half * light.dot(half);
    let towards_light = across
        .try_normalize()
        .filter(|_| across.length() > 1e-12)
        .unwrap_or_else(|| half.any_orthonormal_vector());
    // phi_d is measured from the direction that leads away from n.
    let (sin_phi, cos_phi) = (PI - pair.difference.phi_deg.to_radians()).sin_cos();
    let (sin, cos) = pair.half.theta_deg.to_radians().sin_cos();
    let aside = towards_light * cos_phi + half.cross(towards_light) * sin_phi;
    let n = half * cos + aside * sin;
    let theta_d_deg = 0.5 * frame::angle_between(light, DVec3::Z).to_degrees();
    (n.z > 0.0).then(|| Normal {
        place: [n.x, n.y],
        is_exact: (theta_d_deg - pair.difference.theta_deg).abs() < EXACT_DEG,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use bxdf::math::frame::direction_from_degrees;

    #[test]
    fn a_point_shows_its_own_pair() {
        let light = direction_from_degrees(50.0, 130.0);
        for place in [
            [0.1, 0.2],
            [-0.6, 0.3],
            [0.0, 0.7],
            [-0.2, -0.4],
            [0.3, 0.0],
        ] {
            let (wo, wi) = pair_at(light, place).unwrap();
            assert!((wo.length() - 1.0).abs() < 1e-14 && wo.z > 0.0);
            if wi.z <= 0.0 {
                assert_eq!(normal_of(light, wo, wi), None);
                continue;
            }
            let found = normal_of(light, wo, wi).unwrap();
            let [dx, dy] = [found.place[0] - place[0], found.place[1] - place[1]];
            assert!(
                found.is_exact && dx.hypot(dy) < 1e-12,
                "{place:?} {found:?}"
            );
        }
        assert_eq!(pair_at(light, [0.8, 0.6]), None);
    }

    #[test]
    fn the_mirrored_pair_stands_halfway_to_the_light() {
        let light = direction_from_degrees(60.0, 0.0);
        let [wo, wi] = [20.0, 200.0].map(|phi| direction_from_degrees(10.0, phi));
        let found = normal_of(light, wo, wi).unwrap();
        assert!((found.place[0] - 0.5).abs() < 1e-12 && found.place[1].abs() < 1e-12);
        assert!(!found.is_exact);
        let [wo, wi] = [20.0, 200.0].map(|phi| direction_from_degrees(30.2, phi));
        assert!(normal_of(light, wo, wi).unwrap().is_exact);
        assert_eq!(normal_of(DVec3::NEG_Z, wo, wi), None);
    }

    #[test]
    fn the_middle_shows_the_viewer_along_n() {
        let light = direction_from_degrees(30.0, 45.0);
        let (wo, wi) = pair_at(light, [0.0; 2]).unwrap();
        assert_eq!(wo, DVec3::Z);
        // At the middle s is the picture's x.
        assert!(wi.distance(light) < 1e-15);
    }
}
