//! The half vector of light and viewer, which is shown while words point at it.

use egui::{Align2, Pos2, Ui, Vec2};
use glam::DVec3;

use crate::theme::{Dash, HANDLE_RADIUS, Palette};
use crate::widgets::draw;
use crate::widgets::things::{self, By};
use bxdf::math::frame;
use bxdf_lab::analysis::half_difference::half_difference;
use bxdf_study::lessons::Thing;
use bxdf_study::session::Session;

/// From the end of the vector to its name, in points.
const BESIDE: f32 = HANDLE_RADIUS + 15.0;

/// The half vector, where words point at it and there is one.
pub(super) fn pointed(ui: &Ui, session: &Session) -> Option<DVec3> {
    if !things::is_pointed(ui.ctx(), &Thing::Half, By::Words) {
        return None;
    }
    let pair = half_difference(session.viewer(), session.light())?;
    let half = pair.half;
    Some(frame::direction_from_degrees(half.theta_deg, half.phi_deg))
}

/// Marks it where it ends, at `tip`; with a line from `foot`, where the picture has the place that it begins at.
pub(super) fn mark(ui: &Ui, [foot, tip]: [Option<Pos2>; 2], dash: Dash, palette: &Palette) {
    let Some(tip) = tip else { return };
    if let Some(foot) = foot {
        draw::line(ui.painter(), [foot, tip], (3.0, palette.geometry), dash);
    }
    things::ring(ui, tip, &Thing::Half, palette);
    ui.painter().circle_filled(tip, 3.0, palette.geometry);
    // Across the line: at its end stands n where the two are one.
    let along = foot.map_or(Vec2::UP, |foot| (tip - foot).normalized());
    let (at, font) = (tip + BESIDE * along.rot90(), draw::body_font(ui));
    let ink = palette.text_in(palette.geometry);
    draw::haloed_text(
        ui.painter(),
        at,
        Align2::CENTER_CENTER,
        "h",
        font,
        ink,
        palette,
    );
}
