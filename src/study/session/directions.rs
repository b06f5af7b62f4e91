//! The two directions of a session: the one that is held, which the lobe is over, and the other one.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use super::{PHI, Session, THETA};
use bxdf::Side;
use bxdf::math::frame;
use bxdf_lab::analysis::Hold;

/// A direction by its angles.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Direction {
    /// Polar angle from n, in degrees, 0..180.
    pub theta_deg: f64,
    /// Azimuth from s, in degrees, -180..180.
    pub phi_deg: f64,
}

/// The nearest tenth of a degree.
fn tenth_deg(angle: f64) -> f64 {
    (angle.to_degrees() * 10.0).round() / 10.0
}

impl Session {
    /// The held direction, a unit vector.
    #[must_use]
    pub fn held(&self) -> DVec3 {
        frame::direction_from_degrees(self.theta_deg, self.phi_deg)
    }

    /// The other direction, a unit vector: where it was put, else where most of the light of a smooth surface is: at the
    /// mirror direction, or straight on where everything shown lets light through and mirrors none.
    #[must_use]
    pub fn other(&self) -> DVec3 {
        if let Some(Direction { theta_deg, phi_deg }) = self.other {
            return frame::direction_from_degrees(theta_deg, phi_deg);
        }
        let held = self.held();
        let mut shown = self.materials.shown().peekable();
        let is_any = shown.peek().is_some();
        if is_any && shown.all(|entry| !entry.material.has_side(Side::Reflection)) {
            return -held;
        }
        DVec3::new(-held.x, -held.y, held.z)
    }

    /// Holds the direction nearest to `w` in tenths of a degree.
    pub fn set_held(&mut self, w: DVec3) {
        self.set_theta_deg(tenth_deg(frame::theta(w)));
        // Along n the azimuth is of no effect: the old one stays, so that the plots do not jump.
        if has_azimuth(w) {
            PHI.put(&mut self.phi_deg, tenth_deg(frame::phi(w)));
        }
    }

    /// Puts the other direction nearest to `w` in tenths of a degree.
    pub fn set_other(&mut self, w: DVec3) {
        let (mut theta_deg, mut phi_deg) = (0.0, self.phi_deg);
        let spec = self.theta_spec();
        spec.put(&mut theta_deg, tenth_deg(frame::theta(w)));
        if has_azimuth(w) {
            PHI.put(&mut phi_deg, tenth_deg(frame::phi(w)));
        }
        self.other = Some(Direction { theta_deg, phi_deg });
    }

    /// Puts the other direction exactly at `w`.
    pub fn put_other(&mut self, w: DVec3) {
        let mut other = Direction {
            theta_deg: 0.0,
            phi_deg: 0.0,
        };
        THETA.put(&mut other.theta_deg, frame::theta(w).to_degrees());
        PHI.put(&mut other.phi_deg, frame::phi(w).to_degrees());
        self.other = Some(other);
    }

    /// Holds the light or the viewer, each where it is: if it was the other one, they exchange.
    pub fn set_hold(&mut self, hold: Hold) {
        if hold == self.hold {
            return;
        }
        self.hold = hold;
        let held = Direction {
            theta_deg: self.theta_deg,
            phi_deg: self.phi_deg,
        };
        if let Some(other) = self.other.replace(held) {
            (self.theta_deg, self.phi_deg) = (other.theta_deg, other.phi_deg);
        } else {
            // Each is the mirror direction of the other, before and afterwards.
            self.other = None;
            let across = self.other();
            self.set_held(across);
        }
    }

    /// The light, a unit vector.
    #[must_use]
    pub fn light(&self) -> DVec3 {
        match self.hold {
            Hold::Light => self.held(),
            Hold::Viewer => self.other(),
        }
    }

    /// The viewer, a unit vector.
    #[must_use]
    pub fn viewer(&self) -> DVec3 {
        match self.hold {
            Hold::Light => self.other(),
            Hold::Viewer => self.held(),
        }
    }
}

/// Whether a direction is far enough from n to have an azimuth.
fn has_azimuth(w: DVec3) -> bool {
    w.x.hypot(w.y) > 1e-3
}

#[cfg(test)]
mod tests {
    use super::*;

    fn is_near(a: DVec3, b: DVec3) -> bool {
        a.distance(b) < 1e-9
    }

    #[test]
    fn the_other_direction_is_across_until_it_is_put() {
        let mut session = Session::default();
        let held = session.held();
        assert!(is_near(
            session.other(),
            DVec3::new(-held.x, -held.y, held.z)
        ));
        session.set_theta_deg(20.0);
        assert!(is_near(
            session.other(),
            frame::direction_from_degrees(20.0, 0.0)
        ));
        session.set_other(frame::direction_from_degrees(70.04, 33.0));
        session.set_theta_deg(40.0);
        assert!(is_near(
            session.other(),
            frame::direction_from_degrees(70.0, 33.0)
        ));
        let text = session.to_toml().unwrap();
        assert_eq!(Session::from_toml(&text, "s").unwrap(), session);
        // What only lets light through sends it straight on.
        let through = Session::of("lambertian_transmission".parse().unwrap());
        assert!(is_near(through.other(), -through.held()));
    }

    #[test]
    fn light_and_viewer_stay_where_they_are_whichever_is_held() {
        for put in [None, Some((70.0, 33.0))] {
            let mut session = Session::default();
            if let Some((theta_deg, phi_deg)) = put {
                session.other = Some(Direction { theta_deg, phi_deg });
            }
            let (light, viewer) = (session.held(), session.other());
            session.set_hold(Hold::Viewer);
            assert!(is_near(session.held(), viewer) && is_near(session.other(), light));
            assert!(is_near(session.light(), light));
            let before = session.clone();
            session.set_hold(Hold::Viewer);
            assert_eq!(session, before);
            session.set_hold(Hold::Light);
            assert!(is_near(session.held(), light) && is_near(session.other(), viewer));
            assert_eq!(session.other.is_some(), put.is_some());
        }
    }
}
