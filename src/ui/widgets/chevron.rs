//! Chevrons: what folds something away, and brings it back.

use egui::{Color32, Painter, Rect, Response, Role, Sense, Shape, Ui, WidgetInfo, vec2};

use super::focus;
use crate::theme;

/// Where a chevron points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Points {
    /// Folded: what is hidden comes to the right or below.
    Right,
    /// Unfolded: what it brought stands below.
    Down,
    /// Unfolded: it goes away to the left.
    Left,
}

impl Points {
    /// Of a heading whose content stands below it where it `is_open`.
    #[must_use]
    pub const fn of_heading(is_open: bool) -> Self {
        if is_open { Self::Down } else { Self::Right }
    }
}

/// Half the length of an arm, in points.
const ARM: f32 = 3.5;

/// Strokes of a chevron, in points.
const STROKE: f32 = 1.5;

/// A button that shows a chevron alone; `name` says what it does to those who do not see, `is_open` whether the rest is
/// there.
pub fn button(ui: &mut Ui, points: Points, is_open: bool, name: &str, hint: &str) -> Response {
    let side = ui.spacing().interact_size.y.max(theme::CHEVRON);
    let (rect, response) = ui.allocate_exact_size(vec2(theme::CHEVRON, side), Sense::click());
    response.widget_info(|| WidgetInfo::selected(Role::Button, true, is_open, name));
    let visuals = ui.style().interact(&response);
    paint(ui.painter(), rect, points, visuals.text_color());
    focus::ring(ui, &response);
    response.on_hover_text(hint)
}

/// A line of text with a chevron before it, which folds and unfolds what stands below.
pub fn heading(ui: &mut Ui, is_open: &mut bool, text: &str, name: &str, hint: &str) {
    let points = Points::of_heading(*is_open);
    let row = ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = theme::ROW_SPACING;
        let chevron = button(ui, points, *is_open, name, hint);
        let label = egui::Label::new(text)
            .selectable(false)
            .sense(Sense::click());
        let label = ui.add(label).on_hover_text(hint);
        chevron.clicked() || label.clicked()
    });
    *is_open ^= row.inner;
}

/// The strokes in the middle of `rect`.
fn paint(painter: &Painter, rect: Rect, points: Points, color: Color32) {
    let (along, across) = match points {
        Points::Right => (vec2(ARM, 0.0), vec2(0.0, ARM)),
        Points::Down => (vec2(0.0, ARM), vec2(ARM, 0.0)),
        Points::Left => (vec2(-ARM, 0.0), vec2(0.0, ARM)),
    };
    let tip = rect.center() + 0.5 * along;
    let arms = vec![tip - along - across, tip, tip - along + across];
    painter.add(Shape::line(arms, (STROKE, color)));
}
