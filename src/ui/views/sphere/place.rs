//! Where points of the sphere lie on the screen.

use egui::{Pos2, Rect, Vec2};
use glam::DVec3;

use crate::widgets::pictures;
use bxdf::math::frame;
use bxdf_lab::analysis::sphere;

/// How far outside the disc a direction is drawn that leads right behind the sphere, in radii.
const BEHIND: f64 = 0.3;

/// Where a place of the sphere, in radii, x to the right and y up, is drawn.
pub(super) fn position(rect: Rect, [x, y]: [f64; 2]) -> Pos2 {
    let radius = 0.5 * rect.width() * sphere::RADIUS as f32;
    rect.center() + radius * Vec2::new(x as f32, -y as f32)
}

/// Where the sphere faces the direction `w`, as [`position`] has it; outside of it where that is behind.
pub(super) fn facing(w: DVec3) -> [f64; 2] {
    let theta_deg = frame::theta(w).to_degrees();
    if theta_deg <= 90.0 {
        return [w.x, w.y];
    }
    let (sin, cos) = frame::phi(w).sin_cos();
    let reach = 1.0 + BEHIND * (theta_deg - 90.0) / 90.0;
    [reach * cos, reach * sin]
}

/// The direction that the sphere faces where `place` of the screen is, the inverse of [`facing`].
pub(super) fn faced(rect: Rect, place: Pos2) -> DVec3 {
    let [x, y] = pictures::share_of(rect, place).map(|share| (2.0 * share - 1.0) / sphere::RADIUS);
    let square = x * x + y * y;
    if square <= 1.0 {
        return DVec3::new(x, -y, (1.0 - square).sqrt());
    }
    let theta_deg = 90.0 + 90.0 * ((square.sqrt() - 1.0) / BEHIND).min(1.0);
    let phi_deg = frame::phi(DVec3::new(x, -y, 0.0)).to_degrees();
    frame::direction_from_degrees(theta_deg, phi_deg)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_direction_is_faced_where_it_is_drawn() {
        let rect = Rect::from_min_size(Pos2::new(30.0, 20.0), Vec2::splat(400.0));
        for (theta, phi) in [
            (0.0, 0.0),
            (50.0, 130.0),
            (89.0, -20.0),
            (91.0, 80.0),
            (170.0, 10.0),
        ] {
            let w = frame::direction_from_degrees(theta, phi);
            let found = faced(rect, position(rect, facing(w)));
            assert!(found.distance(w) < 1e-3, "{theta} {phi} {found}");
        }
    }
}
