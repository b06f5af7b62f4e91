//! The points of a sphere and the pairs of directions that they show.

use std::f64::consts::{FRAC_PI_2, PI};

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
    /// Its normal, in the frame of the picture: it is seen where z is positive.
    pub normal: DVec3,
    /// Whether the light stands as far from the viewer there as in the pair, within half a degree of theta_d.
    pub is_exact: bool,
}

/// How far theta_d may differ where a point shows a pair as it is, in degrees.
const EXACT_DEG: f64 = 0.5;

/// The half vector of the picture with the direction of the light about it and the third axis: the frame in which all points of
/// the sphere have the same pair, and differ in n alone. `None` where the light stands right behind the sphere.
fn difference_frame(light: DVec3) -> Option<[DVec3; 3]> {
    let half = (light + DVec3::Z).try_normalize()?;
    // Any direction where both are the same.
    let across = light - half * light.dot(half);
    let towards_light = across
        .try_normalize()
        .filter(|_| across.length() > 1e-12)
        .unwrap_or_else(|| half.any_orthonormal_vector());
    Some([towards_light, half.cross(towards_light), half])
}

/// The point of a sphere lit from the unit vector `light` of the picture that shows the pair (`wo`, `wi`): the one with
/// its theta_h and phi_d (`rusinkiewicz1998`). `None` where the pair or light and viewer have no half vector.
///
/// A sphere under one light shows but one theta_d, half the angle between light and viewer, and each azimuth phi_h at a
/// place of its own: what an anisotropic surface shows there is not the pair's value.
#[must_use]
pub fn normal_of(light: DVec3, wo: DVec3, wi: DVec3) -> Option<Normal> {
    let pair = half_difference(wo, wi)?;
    let [towards_light, side, half] = difference_frame(light)?;
    // phi_d is measured from the direction that leads away from n.
    let (sin_phi, cos_phi) = (PI - pair.difference.phi_deg.to_radians()).sin_cos();
    let (sin, cos) = pair.half.theta_deg.to_radians().sin_cos();
    let aside = towards_light * cos_phi + side * sin_phi;
    let theta_d_deg = 0.5 * frame::angle_between(light, DVec3::Z).to_degrees();
    Some(Normal {
        normal: half * cos + aside * sin,
        is_exact: (theta_d_deg - pair.difference.theta_deg).abs() < EXACT_DEG,
    })
}

/// How much a viewer that is near the one before is preferred, against one whose point is nearer to the one that is wanted.
const KEEPING: f64 = 1e-3;

/// The viewer that makes with the light `wi` a pair which is shown where the normal is `normal`, by a sphere lit from the unit
/// vector `light` of the picture: the inverse of [`normal_of`]. Of two such viewers it is the one nearer to `wo`, the viewer
/// before; where there is none, one whose point is near. `None` where the light stands right behind the sphere.
#[must_use]
pub fn viewer_of(light: DVec3, normal: DVec3, (wo, wi): (DVec3, DVec3)) -> Option<DVec3> {
    if wi.z < 0.0 {
        return viewer_of(light, normal, (-wo, -wi)).map(|w| -w);
    }
    let axes = difference_frame(light)?;
    let n = DVec3::from(axes.map(|axis| normal.dot(axis)));
    // Light and viewer stand at plus and minus theta_d in the plane of the first and the third axis; what is known is
    // n . wi = cos theta_i.
    let middle = n.x.atan2(n.z);
    let aside = (n.x * n.x + n.z * n.z - wi.z * wi.z).max(0.0).sqrt();
    let spread = aside.atan2(wi.z);
    let viewers = [1.0, -1.0].map(|sign| {
        let theta_d = (middle + sign * spread).clamp(0.0, FRAC_PI_2);
        let (sin, cos) = theta_d.sin_cos();
        let [there, here] = [-1.0, 1.0].map(|sign| DVec3::new(sign * sin, 0.0, cos));
        turned_to(n, (there, here), wi)
    });
    let missed = |w: DVec3| {
        let shown = normal_of(light, w, wi);
        shown.map_or(2.0, |shown| shown.normal.distance(normal))
    };
    let worth = |w: &DVec3| missed(*w) + KEEPING * w.distance(wo);
    viewers
        .into_iter()
        .min_by(|a, b| worth(a).total_cmp(&worth(b)))
}

/// The direction `wo` of a frame with the normal `n`, turned so that n becomes the third axis and `here` gets the azimuth of
/// `wi`.
fn turned_to(n: DVec3, (wo, here): (DVec3, DVec3), wi: DVec3) -> DVec3 {
    let across = |w: DVec3| {
        let across = w - n * w.dot(n);
        // What rounding leaves is no direction.
        across.try_normalize().filter(|_| across.length() > 1e-9)
    };
    // With the light along n any azimuth will do: the viewer stands across.
    let x = across(here).or_else(|| across(-wo));
    let x = x.unwrap_or_else(|| n.any_orthonormal_vector());
    let local = DVec3::new(wo.dot(x), wo.dot(n.cross(x)), wo.dot(n));
    frame::turned_about_normal(local, frame::phi(wi))
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
            let [dx, dy] = [found.normal.x - place[0], found.normal.y - place[1]];
            assert!(
                found.is_exact && dx.hypot(dy) < 1e-12 && found.normal.z > 0.0,
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
        assert!((found.normal.x - 0.5).abs() < 1e-12 && found.normal.y.abs() < 1e-12);
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

    #[test]
    fn a_viewer_is_found_again_by_the_point_that_shows_it() {
        let light = direction_from_degrees(50.0, 130.0);
        for (theta_i, phi_i) in [(50.0, 180.0), (20.0, -33.0), (75.0, 10.0), (0.0, 0.0)] {
            let wi = direction_from_degrees(theta_i, phi_i);
            for (theta, phi) in [(50.0, 0.0), (10.0, 77.0), (80.0, 190.0), (33.0, -33.0)] {
                let wo = direction_from_degrees(theta, phi);
                for [wo, wi] in [[wo, wi], [-wo, -wi]] {
                    let normal = normal_of(light, wo, wi).unwrap().normal;
                    let found = viewer_of(light, normal, (wo, wi)).unwrap();
                    let again = normal_of(light, found, wi).unwrap().normal;
                    assert!(again.distance(normal) < 1e-7, "{theta_i} {theta} {phi}");
                    if theta_i > 0.0 {
                        assert!(found.distance(wo) < 1e-6, "{theta_i} {theta} {phi}");
                    }
                }
            }
        }
        // Beyond what the light allows it is a direction all the same.
        let wi = direction_from_degrees(10.0, 0.0);
        for phi in [0.0, 70.0, 150.0, 260.0] {
            let normal = direction_from_degrees(85.0, phi);
            let found = viewer_of(light, normal, (DVec3::Z, wi)).unwrap();
            assert!((found.length() - 1.0).abs() < 1e-12);
        }
        assert_eq!(viewer_of(DVec3::NEG_Z, DVec3::X, (wi, wi)), None);
    }
}
