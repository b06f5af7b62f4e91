//! Where points of the sphere lie on the screen.

use egui::{Rect, Vec2};

use bxdf_lab::analysis::sphere;

/// Where a place of the sphere, in radii, x to the right and y up, is drawn.
pub(super) fn position(rect: Rect, [x, y]: [f64; 2]) -> egui::Pos2 {
    let radius = 0.5 * rect.width() * sphere::RADIUS as f32;
    rect.center() + radius * Vec2::new(x as f32, -y as f32)
}
