//! A place of a map: what its axes move, and what they leave as it is.

use glam::DVec3;

use bxdf::Material;
use bxdf::math::frame::{self, direction_from_degrees};

/// A place of a map: a material and a pair of directions by their angles.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// The material.
    pub material: Material,
    /// The polar angle of wo from the normal of its side, in degrees.
    pub theta_o_deg: f64,
    /// The same of wi.
    pub theta_i_deg: f64,
    /// The azimuth of wo, in degrees.
    pub phi_o_deg: f64,
    /// That of wi less that of wo, in degrees.
    pub azimuth_deg: f64,
    /// Whether wo and wi are below the surface.
    pub is_below: [bool; 2],
}

impl Place {
    /// The place of a pair.
    #[must_use]
    pub fn of(material: &Material, wo: DVec3, wi: DVec3) -> Self {
        let from_normal = |w: DVec3| frame::theta(DVec3::new(w.x, w.y, w.z.abs())).to_degrees();
        let phi = |w: DVec3| frame::phi(w).to_degrees();
        Self {
            material: material.clone(),
            theta_o_deg: from_normal(wo),
            theta_i_deg: from_normal(wi),
            phi_o_deg: phi(wo),
            azimuth_deg: (phi(wi) - phi(wo)).rem_euclid(360.0),
            is_below: [wo.z < 0.0, wi.z < 0.0],
        }
    }

    /// wo and wi.
    #[must_use]
    pub fn pair(&self) -> (DVec3, DVec3) {
        let on_side = |w: DVec3, is_below: bool| {
            if is_below {
                DVec3::new(w.x, w.y, -w.z)
            } else {
                w
            }
        };
        let [below_o, below_i] = self.is_below;
        let wo = direction_from_degrees(self.theta_o_deg, self.phi_o_deg);
        let wi = direction_from_degrees(self.theta_i_deg, self.phi_o_deg + self.azimuth_deg);
        (on_side(wo, below_o), on_side(wi, below_i))
    }
}
