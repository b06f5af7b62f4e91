//! What ties parameters together, and the buttons for that.

use std::collections::BTreeSet;

use egui::{Button, Role, Ui, WidgetInfo};

use super::controls::name;
use super::words::{accessible, label};
use bxdf::param::ParamSpec;

/// What the button that links a parameter across materials is for.
const LINK: &str = "One slider for all: a change then sets it in every material that has it";

/// The same while it is linked.
const UNLINK: &str = "One slider for all: a change sets it in every material that has it. Click to set it here alone";

/// What ties parameters together, changed by the buttons beside them.
pub struct Ties<'a> {
    /// Whether the widths along s and t move together.
    pub has_linked_widths: &'a mut bool,
    /// The names of the parameters that are locked across materials.
    pub locked: &'a mut BTreeSet<String>,
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
        let button = Button::selectable(is_linked, "🔗").small();
        let response = ui.add(button).on_hover_text(hint);
        let known = accessible(&format!("Link {}", label(spec)), ordinal);
        response.widget_info(|| WidgetInfo::selected(Role::Button, true, is_linked, &known));
        if response.clicked() && !self.locked.remove(spec.name) {
            self.locked.insert(spec.name.to_owned());
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
