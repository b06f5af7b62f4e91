//! Dirac deltas as every view draws them: a stem or a ring with its share, never a value.

use egui::{Align2, Color32, FontId, Painter, Pos2, Rect, Shape, Stroke, StrokeKind, Ui, vec2};

use super::draw;
use crate::theme::{Dash, Palette};
use bxdf::Side;
use bxdf_study::format;

/// The radius of the ring about a delta's direction, in points.
const RING: f32 = 7.0;

/// A share as the screen shows it: in thousandths, or where those would read as 0 as any value.
#[must_use]
pub fn share(share: f64) -> String {
    if share.abs() >= 0.001 {
        format!("{share:.3}")
    } else {
        format::value(share)
    }
}

/// What stands at a delta.
#[must_use]
pub fn label(flux: f64) -> String {
    format!("delta {}", share(flux))
}

/// Where a delta goes, in words.
#[must_use]
pub const fn side(side: Side) -> &'static str {
    match side {
        Side::Reflection => "reflected",
        Side::Transmission => "transmitted",
    }
}

/// An arrow with a filled head, which is no longer than the arrow: broken where the delta lies outside what is shown.
pub fn stem(painter: &Painter, [from, to]: [Pos2; 2], color: Color32, dash: Dash) {
    const HEAD: f32 = 13.0;
    const WIDTH: f32 = 3.5;
    let length = HEAD.min((to - from).length());
    let base = to - (to - from).normalized() * length;
    draw::line(painter, [from, base], (WIDTH, color), dash);
    head(painter, [base, to], length, color);
}

/// The filled head of an arrow, of this length in points and no longer than the arrow.
pub fn head(painter: &Painter, [from, to]: [Pos2; 2], length: f32, color: Color32) {
    let along = (to - from).normalized();
    let length = length.min((to - from).length());
    let (base, across) = (to - along * length, along.rot90() * 0.42 * length);
    painter.add(Shape::convex_polygon(
        vec![to, base + across, base - across],
        color,
        Stroke::NONE,
    ));
}

/// A ring about a delta's direction; a thin one where it goes to the side that is not shown.
pub fn ring(painter: &Painter, at: Pos2, (color, palette): (Color32, &Palette), is_on_side: bool) {
    let width = if is_on_side { 2.5 } else { 1.0 };
    // Seen on every colour of a map.
    painter.circle_stroke(at, RING, (width + 2.0, palette.background));
    painter.circle_stroke(at, RING, (width, color));
    if is_on_side {
        painter.circle_filled(at, 1.5, color);
    }
}

/// How far from a ring's middle its label stands, in points.
pub const BESIDE_RING: f32 = RING + 5.0;

/// Writes the label of a delta at `place`, or near it where none of `taken` stands, inside what can be seen; where there is no
/// such place, the ring stands alone.
pub fn write(
    ui: &Ui,
    painter: &Painter,
    taken: &mut Vec<Rect>,
    (place, anchor): (Pos2, Align2),
    text: &str,
    (color, palette): (Color32, &Palette),
) {
    let font = draw::body_font(ui);
    let galley = painter.layout_no_wrap(text.to_owned(), font.clone(), color);
    let wanted = anchor.anchor_size(place, galley.size() + vec2(6.0, 2.0));
    let wanted = draw::inside(wanted, painter.clip_rect());
    let rect = draw::free_place(taken, wanted);
    let is_taken = |other: &Rect| *other != rect && other.intersects(rect);
    if taken.iter().any(is_taken) || !painter.clip_rect().contains_rect(rect) {
        return;
    }
    let centre = (rect.center(), Align2::CENTER_CENTER);
    draw::haloed_text(painter, centre.0, centre.1, text, font, color, palette);
}

/// The label of a delta in a pill that covers `rect`.
pub fn pill(
    painter: &Painter,
    rect: Rect,
    text: &str,
    font: FontId,
    (color, palette): (Color32, &Palette),
) {
    let round = 0.5 * rect.height();
    painter.rect(
        rect,
        round,
        palette.background,
        (1.2, color),
        StrokeKind::Inside,
    );
    painter.text(
        rect.center(),
        Align2::CENTER_CENTER,
        text,
        font,
        palette.ink,
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_share_above_nothing_does_not_read_as_nothing() {
        assert_eq!(label(0.92), "delta 0.920");
        assert_eq!(label(-0.5), "delta -0.500");
        assert_eq!(label(4.2e-5), "delta 4.2\u{a0}×\u{a0}10⁻⁵");
    }
}
