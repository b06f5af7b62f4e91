//! The inspector's data: everything there is to say of a surface at one pair of directions.

use glam::DVec3;

use crate::bxdf::math::frame;
use crate::bxdf::{Bxdf, Microfacet};

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
    let wh = if is_upper { sum } else { -sum };
    // Turned about n by -phi_h, then about t by -theta_h: wh becomes n.
    let (sin_phi, cos_phi) = frame::phi(wh).sin_cos();
    let (sin_theta, cos_theta) = (wh.x.hypot(wh.y), wh.z);
    let above = if is_upper { wi } else { -wi };
    let along = above.x * cos_phi + above.y * sin_phi;
    let difference = DVec3::new(
        along * cos_theta - above.z * sin_theta,
        above.y * cos_phi - above.x * sin_phi,
        along * sin_theta + above.z * cos_theta,
    );
    Some(HalfDifference {
        half: Spherical::of(wh),
        difference: Spherical::of(difference),
    })
}

/// What a surface does at a pair of directions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// f in 1/sr, per channel.
    pub f: [f64; 3],
    /// f |cos(theta_i)| in 1/sr, per channel.
    pub f_cos: [f64; 3],
    /// The density with which wi is sampled for wo, in 1/sr.
    pub pdf: f64,
    /// The factors of a microfacet model; `None` for other surfaces, and where there is no half vector.
    pub microfacet: Option<Microfacet<f64>>,
}

impl Reading {
    /// That of `bxdf` at the unit vectors `wo` and `wi`.
    #[must_use]
    pub fn of(bxdf: &dyn Bxdf<f64>, wo: DVec3, wi: DVec3) -> Self {
        let f = bxdf.f(wo.into(), wi.into()).to_f64();
        Self {
            f,
            f_cos: f.map(|f| f * wi.z.abs()),
            pdf: bxdf.pdf(wo.into(), wi.into()),
            microfacet: bxdf.microfacet(wo.into(), wi.into()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bxdf::Material;
    use crate::bxdf::math::frame::direction_from_degrees;

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

    #[test]
    fn the_factors_of_a_microfacet_model_make_up_its_value() {
        let material: Material = "rough_conductor:alpha=.4".parse().unwrap();
        let model = material.build::<f64>();
        let [wo, wi] = [40.0, 200.0].map(|phi| direction_from_degrees(55.0, phi));
        let reading = Reading::of(&*model, wo, wi);
        let factors = reading.microfacet.unwrap();
        let product = factors.fresnel.0[1] * factors.d * factors.g / (4.0 * wo.z * wi.z);
        assert!((reading.f[1] / product - 1.0).abs() < 1e-13);
        assert!((reading.f_cos[1] / (product * wi.z) - 1.0).abs() < 1e-13);
        assert!(reading.pdf > 0.0);
    }
}
