//! The views: one file each, and the one list of them.

use egui::Ui;

pub use context::{ViewContext, ViewState};

mod cartesian;
mod context;
mod decomposition;
mod hemisphere;
mod inspector;
mod lobe3d;
mod polar;
mod reflectance;
mod sampling;
mod slice;
mod sphere;
mod stability;
mod tradeoff;

/// What draws a view into the space left in the `Ui`.
type Show = fn(&mut Ui, &mut ViewContext<'_>);

macro_rules! list {
    ($($id:ident)*) => {
        /// What draws each kind of view, by its id.
        static SHOW: [(&str, Show); [$(stringify!($id)),*].len()] = [$((stringify!($id), $id::show)),*];
    };
}
bxdf_study::view_kinds!(list);

/// Draws the view.
pub fn show(ui: &mut Ui, cx: &mut ViewContext<'_>) {
    let mut all = SHOW.iter();
    if let Some((_, show)) = all.find(|(id, _)| *id == cx.view.id) {
        show(ui, cx);
    }
}

/// Where the held direction lies below opaque materials and the view is of it: says so, and offers the way back.
pub(crate) fn warn_of_held(ui: &mut egui::Ui, cx: &mut ViewContext<'_>) {
    let view = cx.view;
    let session = &mut *cx.session;
    let is_told = session.is_held_below() && (view.is_of_held)(session);
    if !is_told {
        return;
    }
    let name = session.held_name();
    ui.horizontal_wrapped(|ui| {
        let text = format!(
            "The {name} is below the surface, and nothing shown lets light through: all values above it are 0"
        );
        ui.colored_label(ui.visuals().error_fg_color, text);
        let hint = "As far above the surface as it is below now";
        let button = ui.button(format!("Bring the {name} above"));
        if button.on_hover_text(hint).clicked() {
            session.raise_held();
        }
    });
}
