//! Where directions lie on the disc.

use egui::{Rect, Ui};
use glam::DVec3;

use crate::widgets::{draw, pictures};
use bxdf_lab::analysis::hemisphere::Projection;

/// Room for labels around a disc, in points.
pub(super) fn label_room(ui: &Ui) -> f32 {
    15.0 * draw::label_scale(ui)
}

/// A place of the unit disc in the picture, x to the right and y up, as a share from its upper left; and back.
pub(super) fn mirrored([x, y]: [f64; 2]) -> [f64; 2] {
    [0.5 + 0.5 * x, 0.5 - 0.5 * y]
}

/// Where a direction lies in a picture.
pub(super) fn position(rect: Rect, w: DVec3, projection: Projection) -> egui::Pos2 {
    let place = projection.place(w);
    pictures::position_of(rect, mirrored(place))
}
