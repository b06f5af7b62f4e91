//! Parts that the rows of parameters have in common.

use egui::{Response, Role, Ui, WidgetInfo, accesskit};

use super::words::accessible;
use crate::widgets::small;

/// Gives the control of `response` its accessible name.
pub(super) fn name(response: &Response, label: &str, ordinal: Option<usize>) {
    let name = accessible(label, ordinal);
    let set_label = |node: &mut accesskit::Node| node.set_label(name);
    response.ctx.accesskit_node_builder(response.id, set_label);
}

/// The button at the end of a row that resets what is called `what`. Returns whether it is clicked.
pub(super) fn reset_button(
    ui: &mut Ui,
    what: &str,
    ordinal: Option<usize>,
    is_changed: bool,
    hint: &str,
) -> bool {
    let reset = small::button(ui, "↺").frame(false);
    let response = ui.add_enabled(is_changed, reset).on_hover_text(hint);
    let name = accessible(&format!("Reset {what}"), ordinal);
    response.widget_info(|| WidgetInfo::labeled(Role::Button, is_changed, &name));
    response.clicked()
}
