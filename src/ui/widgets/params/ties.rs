//! What ties parameters together, and pins them, and the buttons for that.

use std::collections::BTreeSet;

use egui::{CornerRadius, Rect, Response, Role, Sense, StrokeKind, Ui, WidgetInfo, vec2};

use super::controls::name;
use super::words::accessible;
use crate::theme;
use crate::widgets::focus;
use bxdf::param::{Kind, ParamSpec};
use bxdf_study::parameters::label;

/// What the button that links a parameter across materials is for.
const LINK: &str = "One slider for all: a change then sets it in every material that has it";

/// What the button that pins a parameter is for.
const PIN: &str = "Pin it: while the views are presented, the bar below them has this slider";

/// The same while it is pinned.
const UNPIN: &str =
    "Pinned: while the views are presented, the bar below them has this slider. Click to unpin it";

/// The same while it is linked.
const UNLINK: &str = "One slider for all: a change sets it in every material that has it. Click to set it here alone";

/// What ties parameters together, changed by the buttons beside them.
pub struct Ties<'a> {
    /// Whether the widths along s and t move together.
    pub has_linked_widths: &'a mut bool,
    /// The names of the parameters that are locked across materials.
    pub locked: &'a mut BTreeSet<String>,
    /// The names of the parameters that are pinned.
    pub pinned: &'a mut BTreeSet<String>,
    /// Whether other materials have a parameter too, so that it can be locked.
    pub is_shared: &'a dyn Fn(&ParamSpec) -> bool,
}

impl Ties<'_> {
    /// The button that links the parameter across materials, where others have it.
    pub(super) fn link_button(&mut self, ui: &mut Ui, spec: &ParamSpec, ordinal: Option<usize>) {
        if !(self.is_shared)(spec) {
            return;
        }
        let is_linked = self.locked.contains(spec.name);
        let hint = if is_linked { UNLINK } else { LINK };
        let side = ui.spacing().interact_size.y;
        let (rect, response) =
            ui.allocate_exact_size(vec2(theme::RESET_WIDTH, side), Sense::click());
        paint_link(ui, rect, &response, is_linked);
        let response = response.on_hover_text(hint);
        let known = accessible(&format!("Link {}", label(spec)), ordinal);
        response.widget_info(|| WidgetInfo::selected(Role::Button, true, is_linked, &known));
        if response.clicked() && !self.locked.remove(spec.name) {
            self.locked.insert(spec.name.to_owned());
        }
    }

    /// The button that pins a number, seen while it is pinned, and while the row has the pointer or the button the focus.
    pub(super) fn pin_button(&mut self, ui: &mut Ui, spec: &ParamSpec, ordinal: Option<usize>) {
        if spec.kind != Kind::Number {
            return;
        }
        let is_pinned = self.pinned.contains(spec.name);
        let side = ui.spacing().interact_size.y;
        let size = vec2(theme::RESET_WIDTH, side);
        let (rect, response) = ui.allocate_exact_size(size, Sense::click());
        // The slider stands below the name.
        let panel = ui.clip_rect().x_range();
        let row = Rect::from_x_y_ranges(panel, rect.top()..=rect.bottom() + side);
        if is_pinned || response.has_focus() || ui.rect_contains_pointer(row) {
            paint_pin(ui, rect, &response, is_pinned);
        }
        let response = response.on_hover_text(if is_pinned { UNPIN } else { PIN });
        let known = accessible(&format!("Pin {}", label(spec)), ordinal);
        response.widget_info(|| WidgetInfo::selected(Role::Button, true, is_pinned, &known));
        if response.clicked() && !self.pinned.remove(spec.name) {
            self.pinned.insert(spec.name.to_owned());
        }
    }

    /// The box that links the widths, below the second one.
    pub(super) fn widths_box(&mut self, ui: &mut Ui, ordinal: Option<usize>) {
        let checkbox = ui
            .checkbox(self.has_linked_widths, "Same along s and t")
            .on_hover_text("Move both widths together: the lobe stays isotropic. Unlink them for brushed surfaces");
        name(&checkbox, "Same along s and t", ordinal);
    }
}

/// Two links of a chain, on a ground of their own while it holds.
fn paint_link(ui: &Ui, rect: Rect, response: &Response, is_linked: bool) {
    /// The size of a link, how far each is from the middle, and the width of its line, in points.
    const LINK: (egui::Vec2, f32, f32) = (vec2(9.0, 6.0), 3.0, 1.3);
    let (size, aside, width) = LINK;
    let mut color = ui.style().interact(response).text_color();
    if is_linked {
        let ground = Rect::from_center_size(rect.center(), vec2(theme::RESET_WIDTH, 14.0));
        ui.painter()
            .rect_filled(ground, 3.0, ui.visuals().selection.bg_fill);
        color = ui.visuals().strong_text_color();
    }
    for side in [-aside, aside] {
        let link = Rect::from_center_size(rect.center() + vec2(side, 0.0), size);
        let round = CornerRadius::same(3);
        ui.painter()
            .rect_stroke(link, round, (width, color), StrokeKind::Middle);
    }
    focus::ring(ui, response);
}

/// A drawing pin, on a ground of its own while it holds.
fn paint_pin(ui: &Ui, rect: Rect, response: &Response, is_pinned: bool) {
    /// The ends of its lines from the middle: the head, the neck on both sides, the collar, the needle; and their width, in points.
    const PIN: ([[f32; 4]; 5], f32) = (
        [
            [-2.5, -6.0, 2.5, -6.0],
            [-1.5, -6.0, -1.5, -1.0],
            [1.5, -6.0, 1.5, -1.0],
            [-4.0, -0.5, 4.0, -0.5],
            [0.0, -0.5, 0.0, 5.5],
        ],
        1.3,
    );
    let (lines, width) = PIN;
    let mut color = ui.style().interact(response).text_color();
    if is_pinned {
        let ground = Rect::from_center_size(rect.center(), vec2(14.0, 16.0));
        ui.painter()
            .rect_filled(ground, 3.0, ui.visuals().selection.bg_fill);
        color = ui.visuals().strong_text_color();
    }
    for [x, y, to_x, to_y] in lines {
        let ends = [vec2(x, y), vec2(to_x, to_y)].map(|by| rect.center() + by);
        ui.painter().line_segment(ends, (width, color));
    }
    focus::ring(ui, response);
}
