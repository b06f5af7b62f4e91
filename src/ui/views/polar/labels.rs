//! What is written in the plot: the numbers of the grid, the names of directions.

use std::f64::consts::FRAC_PI_2;

use egui::{Align2, Pos2, Rect, vec2};

use super::super::context::Named;
use super::canvas::{Canvas, RAY_STEP_DEG, Way, named_directions};
use super::radial::Rings;
use crate::theme;
use crate::widgets::draw;
use bxdf_lab::analysis::polar;
use bxdf_study::format;
use bxdf_study::session::{Section, Session};

/// Radius of the angle labels.
const ANGLE_LABEL_RADIUS: f64 = 1.075;
/// Radius of the names of directions.
const NAME_RADIUS: f64 = 1.15;
/// How far from the circle they stand at least, in points: clear of handles and angles.
const NAME_GAP: f32 = 16.0;
/// Names nearer to one another than this, in radians, would overlap.
const NAME_SPACING: f64 = 0.16;
/// Plots that are narrower, or circles of a smaller radius, in points, have every other angle and the outermost ring alone
/// numbered; those of the least radius every sixth angle.
const SMALL_WIDTH: f32 = 300.0;
const SMALL_RADIUS: f32 = 104.0;
const LEAST_RADIUS: f32 = 52.0;
/// In circles of a smaller radius, in points, n stands where 0 would.
const RADIUS_OF_ZERO: f32 = 74.0;

impl Canvas<'_> {
    /// The numbers of the grid, but those that would lie below what is `taken`: a share is worth more than one of many angles.
    /// Returns where they stand.
    pub(super) fn label_grid(
        &self,
        rings: &Rings,
        taken: &[Rect],
        palette: &theme::Palette,
        has_lower: bool,
    ) -> Vec<Rect> {
        let painter = self.painter();
        let mut written = Vec::new();
        let mut text = |position: Pos2, anchor: Align2, text: String| {
            let font = draw::small_font(self.ui);
            let galley = painter.layout_no_wrap(text, font, palette.faint_ink);
            let rect = anchor.anchor_size(position, galley.size());
            let mut others = taken.iter().chain(&written);
            if !others.any(|other| other.intersects(rect)) {
                painter.galley(rect.min, galley, palette.faint_ink);
                written.push(rect);
            }
        };
        let limit: i32 = if has_lower { 180 } else { 90 };
        // Larger labels leave as little room as a smaller plot does.
        let scale = draw::label_scale(self.ui);
        let (radius, width) = (
            self.radius() / scale,
            self.transform.frame().width() / scale,
        );
        let is_small = width < SMALL_WIDTH || radius < SMALL_RADIUS;
        let step = if radius < LEAST_RADIUS {
            6 * RAY_STEP_DEG
        } else if is_small {
            2 * RAY_STEP_DEG
        } else {
            RAY_STEP_DEG
        };
        for angle_deg in (-limit..=limit)
            .step_by(step as usize)
            .filter(|a| *a != -180)
            .filter(|a| *a != 0 || radius >= RADIUS_OF_ZERO)
        {
            let angle = f64::from(angle_deg).to_radians();
            text(
                self.position(self.outside(ANGLE_LABEL_RADIUS), angle),
                Align2::CENTER_CENTER,
                format!("{}°", angle_deg.abs()),
            );
        }
        let below = vec2(0.0, 4.0);
        let skipped = if is_small {
            rings.ticks.len().saturating_sub(1)
        } else {
            0
        };
        let of_value = |tick: &f64| rings.radius(*tick);
        let mut ticks = rings.ticks.clone();
        ticks.sort_by(|a, b| of_value(a).total_cmp(&of_value(b)));
        for tick in ticks.iter().skip(skipped) {
            let place = self.position(rings.radius(*tick), FRAC_PI_2) + below;
            text(place, Align2::CENTER_TOP, format::value(*tick));
        }
        if !is_small {
            text(
                self.position(0.5, -FRAC_PI_2) + below,
                Align2::CENTER_TOP,
                rings.quantity.clone(),
            );
        }
        written
    }

    /// What the handles of these directions cover.
    pub(super) fn handles(&self, directions: &[Named], section: Section) -> Vec<Rect> {
        let size = vec2(theme::HANDLE_RADIUS, theme::HANDLE_RADIUS) * 2.0;
        let place = |one: &Named| {
            let angle = polar::signed_angle(one.direction, section.phi());
            Rect::from_center_size(self.position(1.0, angle), size)
        };
        directions.iter().map(place).collect()
    }

    /// The radius of the circle, in points.
    fn radius(&self) -> f32 {
        let [middle, rim] = [0.0, 1.0].map(|radius| self.position(radius, 0.0));
        middle.distance(rim)
    }

    /// Returns where the names stand.
    pub(super) fn name_directions(
        &self,
        session: &Session,
        directions: &[Named],
        section: Section,
        palette: &theme::Palette,
    ) -> Vec<Rect> {
        let painter = self.painter();
        let mut covered = Vec::new();
        let handles = self.handles(directions, section);
        let name_radius = self.outside(NAME_RADIUS.max(1.0 + f64::from(NAME_GAP / self.radius())));
        let mut taken: Vec<f64> = Vec::new();
        for way in named_directions(session, directions, section, palette) {
            let Way {
                name, angle, color, ..
            } = way;
            // Where directions fall together, the first named stands for all.
            if taken
                .iter()
                .any(|other| (angle - other).abs() < NAME_SPACING)
            {
                continue;
            }
            taken.push(angle);
            let position = self.position(name_radius, angle);
            // Outwards from the circle, so that the text stays clear of the angle labels.
            let anchor = match angle.sin() {
                x if x > 0.3 => Align2::LEFT_CENTER,
                x if x < -0.3 => Align2::RIGHT_CENTER,
                _ if angle.cos() < 0.0 => Align2::CENTER_TOP,
                _ => Align2::CENTER_BOTTOM,
            };
            let font = draw::body_font(self.ui);
            let galley = painter.layout_no_wrap(name.to_owned(), font.clone(), color);
            let wanted = anchor.anchor_size(position, galley.size());
            let place = beside_handles(wanted, painter.clip_rect(), &handles);
            let (at, anchor) = (place.center(), Align2::CENTER_CENTER);
            let text = draw::haloed_text(&painter, at, anchor, name, font, color, palette);
            covered.push(text);
        }
        covered
    }
}

/// A name inside `room` where it covers none of `handles`: in its place, else above or below it.
fn beside_handles(name: Rect, room: Rect, handles: &[Rect]) -> Rect {
    let at = |rows: f32| draw::inside(name.translate(vec2(0.0, rows * name.height())), room);
    let is_clear = |rect: &Rect| !handles.iter().any(|handle| handle.intersects(*rect));
    let mut places = [0.0, -1.0, 1.0, -1.5, 1.5, -2.0, 2.0].map(at).into_iter();
    places.find(is_clear).unwrap_or_else(|| at(0.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::pos2;

    /// Enlarged names at the horizon are wider than the margin of the plot.
    #[test]
    fn a_name_at_the_edge_stands_above_its_handle() {
        let room = Rect::from_min_size(Pos2::ZERO, vec2(300.0, 200.0));
        let handle = Rect::from_center_size(pos2(270.0, 150.0), vec2(16.0, 16.0));
        for height in [15.0, 30.0] {
            let wanted = Align2::LEFT_CENTER.anchor_size(pos2(284.0, 150.0), vec2(80.0, height));
            let place = beside_handles(wanted, room, &[handle]);
            assert!(
                room.contains_rect(place) && !place.intersects(handle),
                "{place}"
            );
        }
        let free = Rect::from_min_size(pos2(10.0, 10.0), vec2(40.0, 15.0));
        assert_eq!(beside_handles(free, room, &[handle]), free);
    }
}
