//! Drawing that several views share.

use egui::{
    Align2, Color32, FontId, Painter, Pos2, Rect, Sense, Shape, Stroke, TextStyle, Ui, vec2,
};
use egui_plot::{MarkerShape, PlotUi};

use crate::theme::{self, Dash, Palette};
use bxdf_lab::analysis::Channel;
use bxdf_lab::analysis::half_difference::Spherical;
use bxdf_study::cursor::Cursor;
use bxdf_study::format;
use bxdf_study::session::{Curves, Session};

/// Scrolling by this many points zooms by a factor e to this times them.
pub const ZOOM_PER_POINT: f32 = 0.003;

/// The wheel zooms about the pointer, as in the 3D view; egui_plot would pan.
pub fn zoom_by_scrolling(plot_ui: &mut PlotUi<'_>) {
    let scroll = plot_ui.ctx().input(|input| input.smooth_scroll_delta().y);
    if scroll != 0.0 && plot_ui.response().hovered() {
        plot_ui.zoom_bounds_around_hovered(egui::Vec2::splat((ZOOM_PER_POINT * scroll).exp()));
    }
}

/// The font of labels of secondary rank.
#[must_use]
pub fn small_font(ui: &Ui) -> FontId {
    TextStyle::Small.resolve(ui.style())
}

/// The font of names.
#[must_use]
pub fn body_font(ui: &Ui) -> FontId {
    TextStyle::Body.resolve(ui.style())
}

/// By how much labels are larger than other text here: the room beside plots that holds them grows as they do.
#[must_use]
pub fn label_scale(ui: &Ui) -> f32 {
    small_font(ui).size / theme::SMALL_TEXT
}

/// Text on a patch of background, so that it stays readable over lines. It is moved to stay inside the clip rectangle,
/// and broken into lines where that is too narrow for it. Returns where it stands.
#[expect(clippy::must_use_candidate, reason = "most only want it to be drawn")]
pub fn haloed_text(
    painter: &Painter,
    position: Pos2,
    anchor: Align2,
    text: &str,
    font: FontId,
    color: Color32,
    palette: &Palette,
) -> Rect {
    let (room, halo) = (painter.clip_rect(), vec2(3.0, 1.0));
    let width = room.width() - 2.0 * halo.x;
    let mut galley = painter.layout_no_wrap(text.to_owned(), font.clone(), color);
    if galley.size().x > width {
        galley = painter.layout(text.to_owned(), font, color, width);
    }
    let rect = inside(anchor.anchor_size(position, galley.size()), room);
    painter.rect_filled(
        rect.expand2(halo),
        3.0,
        palette.background.gamma_multiply(0.8),
    );
    painter.galley(rect.min, galley, color);
    rect
}

/// `rect` moved by as little as possible to lie inside `bounds`.
#[must_use]
pub fn inside(rect: Rect, bounds: Rect) -> Rect {
    let low = (bounds.min - rect.min).max(egui::Vec2::ZERO);
    let high = (bounds.max - rect.max).min(egui::Vec2::ZERO);
    rect.translate(low + high)
}

/// `text`, or as much of it as this many characters hold.
#[must_use]
pub fn clipped(text: &str, most: usize) -> String {
    let start: String = text.chars().take(most).collect();
    if start == text { start } else { start + "…" }
}

/// `rect`, or the same up to four lines above or below, where none of `taken` stands; it is taken then.
pub fn free_place(taken: &mut Vec<Rect>, rect: Rect) -> Rect {
    let is_free = |place: &Rect| taken.iter().all(|other| !other.intersects(*place));
    let place = [0.0, -1.0, 1.0, -2.0, 2.0, -3.0, 3.0, -4.0, 4.0]
        .map(|lines| rect.translate(vec2(0.0, lines * rect.height())))
        .into_iter()
        .find(is_free)
        .unwrap_or(rect);
    taken.push(place);
    place
}

/// A straight line drawn so.
pub fn line(painter: &Painter, ends: [Pos2; 2], stroke: impl Into<Stroke>, dash: Dash) {
    let stroke = stroke.into();
    match dash {
        Dash::Solid => {
            painter.line_segment(ends, stroke);
        }
        Dash::Dashed => {
            let [length, gap] = theme::DASH;
            painter.extend(Shape::dashed_line(&ends, stroke, length, gap));
        }
        Dash::Dotted => {
            let [spacing, radius] = theme::DOTS;
            painter.extend(Shape::dotted_line(&ends, stroke.color, spacing, radius));
        }
    }
}

/// The direction pointed at in another view, as strong as it is marked: a thin line from the centre with a cross at its end.
pub fn cursor_mark(painter: &Painter, ends: [Pos2; 2], dash: Dash, look: (&Palette, f32)) {
    line(painter, ends, (0.8, cursor_color(look)), dash);
    cross(painter, ends[1], look);
}

/// The place of the direction pointed at in another view: a cross, which nobody takes for a handle.
pub fn cross(painter: &Painter, at: Pos2, look: (&Palette, f32)) {
    const ARM: f32 = 4.5;
    let color = cursor_color(look);
    for arm in [vec2(ARM, ARM), vec2(ARM, -ARM)] {
        painter.line_segment([at - arm, at + arm], (1.2, color));
    }
}

/// The colour of what is pointed at, at a strength of 0 to 1.
#[must_use]
pub fn cursor_color((palette, strength): (&Palette, f32)) -> Color32 {
    palette.faint_ink.gamma_multiply(strength)
}

/// A mark of a chart, as large as `rect`.
pub fn marker(painter: &Painter, rect: Rect, shape: MarkerShape, color: Color32) {
    let (centre, [left, right]) = (rect.center(), [rect.left_center(), rect.right_center()]);
    let [top, bottom] = [rect.center_top(), rect.center_bottom()];
    let corners = match shape {
        MarkerShape::Square => vec![
            rect.left_top(),
            rect.right_top(),
            rect.right_bottom(),
            rect.left_bottom(),
        ],
        MarkerShape::Diamond => vec![top, right, bottom, left],
        MarkerShape::Up => vec![top, rect.right_bottom(), rect.left_bottom()],
        MarkerShape::Down => vec![bottom, rect.left_top(), rect.right_top()],
        MarkerShape::Cross => {
            painter.line_segment([rect.left_top(), rect.right_bottom()], (1.5, color));
            painter.line_segment([rect.right_top(), rect.left_bottom()], (1.5, color));
            return;
        }
        _ => {
            painter.circle_filled(centre, 0.5 * rect.width(), color);
            return;
        }
    };
    painter.add(Shape::convex_polygon(corners, color, Stroke::NONE));
}

/// A patch of a material's colour.
pub fn swatch(ui: &mut Ui, color: Color32) {
    let (rect, _) = ui.allocate_exact_size(theme::SWATCH, Sense::hover());
    ui.painter().rect_filled(rect, 2.0, color);
}

/// A note beside the pointer.
pub fn pointer_note(ui: &Ui, pointer: Pos2, frame: Rect, text: &str, palette: &Palette) {
    let painter = ui.painter_at(frame);
    let galley = painter.layout_no_wrap(text.to_owned(), body_font(ui), palette.ink);
    let size = galley.size() + vec2(12.0, 8.0);
    let rect = inside(
        Rect::from_min_size(pointer + vec2(14.0, -size.y - 8.0), size),
        frame,
    );
    painter.rect(
        rect,
        4.0,
        palette.background,
        (1.0, palette.axis),
        egui::StrokeKind::Inside,
    );
    painter.galley(rect.min + vec2(6.0, 4.0), galley, palette.ink);
}

/// A note in the middle of the room that is left: why there is nothing to see.
pub fn centred_note(ui: &mut Ui, text: &str) {
    let room = ui.available_size();
    ui.allocate_ui_with_layout(
        room,
        egui::Layout::centered_and_justified(egui::Direction::TopDown),
        |ui| ui.label(text),
    );
}

/// The angles of a direction pointed at; and of which material, where there are several.
#[must_use]
pub fn cursor_place(cursor: &Cursor, session: &Session) -> String {
    let name = if session.materials.is_overlay() {
        session.materials.title(cursor.entry(session)) + ":  "
    } else {
        String::new()
    };
    let place = Spherical::of(cursor.direction);
    format!(
        "{name}θ {}  φ {}",
        format::degrees(place.theta_deg),
        format::degrees(place.phi_deg)
    )
}

/// The read-out of a direction: angles and value, per channel where these are shown; and of which material, where there
/// are several.
#[must_use]
pub fn cursor_text(cursor: &Cursor, session: &Session, value: [f64; 3]) -> String {
    let entry = cursor.entry(session);
    let angles = cursor_place(cursor, session);
    if entry.material.is_delta_only() {
        return format!("{angles}  f 0, all light is in the deltas");
    }
    let quantity = if session.with_cosine { "f cos θ" } else { "f" };
    match session.shown_curves() {
        Curves::Luminance => {
            format!(
                "{angles}  {quantity} {} 1/sr",
                format::value(Channel::Luminance.of(value))
            )
        }
        Curves::Rgb => {
            let [r, g, b] = value.map(format::value);
            format!("{angles}  {quantity} R {r}  G {g}  B {b} 1/sr")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use bxdf::math::frame::direction_from_degrees;

    #[test]
    fn notes_stay_inside() {
        let bounds = Rect::from_min_size(Pos2::ZERO, vec2(100.0, 100.0));
        let moved = inside(
            Rect::from_min_size(Pos2::new(90.0, -5.0), vec2(20.0, 10.0)),
            bounds,
        );
        assert_eq!(
            moved,
            Rect::from_min_size(Pos2::new(80.0, 0.0), vec2(20.0, 10.0))
        );
    }

    #[test]
    fn a_note_that_is_too_wide_is_broken_into_lines() {
        let context = egui::Context::default();
        let mut output = context.run_ui(egui::RawInput::default(), |ui| {
            let room = Rect::from_min_size(Pos2::new(5.0, 5.0), vec2(120.0, 90.0));
            let (painter, corner) = (ui.painter_at(room), room.left_bottom());
            let note = "Channels are clipped where it is brightest: lower the exposure";
            let (font, palette) = (small_font(ui), Palette::of(ui.theme()));
            let (anchor, ink) = (Align2::LEFT_BOTTOM, palette.ink);
            let rect = haloed_text(&painter, corner, anchor, note, font.clone(), ink, &palette);
            assert!(room.contains_rect(rect), "{rect}");
            assert!(rect.height() > 2.0 * font.size);
        });
        output.textures_delta.clear();
    }

    #[test]
    fn read_outs_name_angle_value_and_unit() {
        let cursor = Cursor {
            material: Session::default().materials.selected().id(),
            direction: direction_from_degrees(30.0, -0.0),
        };
        let value = [0.25; 3];
        assert_eq!(
            cursor_text(&cursor, &Session::default(), value),
            "θ 30°  φ 0°  f 0.25 1/sr"
        );
        let session = Session {
            curves: Curves::Rgb,
            with_cosine: true,
            ..Session::default()
        };
        assert_eq!(
            cursor_text(&cursor, &session, value),
            "θ 30°  φ 0°  f cos θ R 0.25  G 0.25  B 0.25 1/sr"
        );
    }
}
