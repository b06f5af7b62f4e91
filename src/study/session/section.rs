//! The section that views show: a plane that contains n.

use super::{Session, folded_deg};

/// A plane that contains n, as a view shows it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Section {
    /// Its azimuth, in degrees, -90 (excluded) to 90: that of the half which is drawn to the right.
    pub azimuth_deg: f64,
    /// Whether the held direction lies in it.
    pub holds_held: bool,
}

impl Section {
    /// Its azimuth, in radians.
    #[must_use]
    pub fn phi(self) -> f64 {
        self.azimuth_deg.to_radians()
    }
}

impl Session {
    /// The section of all views that have none of their own.
    #[must_use]
    pub fn section(&self) -> Section {
        self.section_at(self.section_phi_deg.unwrap_or(self.phi_deg))
    }

    /// The section at this azimuth, in degrees.
    #[must_use]
    pub fn section_at(&self, azimuth_deg: f64) -> Section {
        let azimuth_deg = folded_deg(azimuth_deg);
        let difference = (self.phi_deg - azimuth_deg).rem_euclid(180.0);
        Section {
            azimuth_deg,
            holds_held: self.theta_deg == 0.0
                || self.theta_deg == 180.0
                || difference.min(180.0 - difference) < 1e-9,
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use bxdf::math::frame;

    #[test]
    fn the_section_keeps_its_right_side_while_the_light_crosses_n() {
        let mut session = Session::default();
        assert_eq!(session.section().azimuth_deg, 0.0);
        session.set_held(frame::direction_from_degrees(20.0, 0.0));
        assert_eq!(
            (
                session.theta_deg,
                session.phi_deg,
                session.section().azimuth_deg
            ),
            (20.0, 0.0, 0.0)
        );
        session.set_held(DVec3::Z);
        assert_eq!(session.phi_deg, 0.0);
        session.phi_deg = -90.0;
        assert_eq!(session.section().azimuth_deg, 90.0);
    }

    #[test]
    fn the_held_direction_lies_in_some_sections() {
        let mut session = Session::default();
        for (azimuth, holds_held) in [(0.0, true), (180.0, true), (30.0, false)] {
            assert_eq!(session.section_at(azimuth).holds_held, holds_held);
        }
        session.theta_deg = 0.0;
        assert!(session.section_at(30.0).holds_held, "n lies in all");
    }
}
