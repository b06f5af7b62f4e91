//! The menu of the views: ready layouts, and views that can be added to the one that stands.

use egui::Ui;

use bxdf_study::session::{READY_LAYOUTS, Session, ViewId};
use bxdf_study::views::VIEWS;

/// The menu.
pub fn menu(ui: &mut Ui, session: &mut Session) {
    let menu = ui.menu_button("Views", |ui| {
        for ready in &READY_LAYOUTS {
            let is_chosen = session.layout == (ready.layout)();
            let choice = ui.selectable_label(is_chosen, ready.name);
            if choice.on_hover_text(ready.meaning).clicked() {
                session.layout = (ready.layout)();
            }
        }
        ui.separator();
        ui.weak("Add a view");
        let open = session.layout.views();
        for view in &VIEWS {
            let is_closed = !open.contains(&ViewId::of(view));
            let button = ui.add_enabled(is_closed, egui::Button::new(view.title));
            ui.ctx().accesskit_node_builder(button.id, |node| {
                node.set_label(format!("Add {}", view.title));
            });
            let button = button
                .on_hover_text(view.what_you_see)
                .on_disabled_hover_text("It is open");
            if button.clicked() {
                session.layout = session.layout.clone().with(ViewId::of(view));
            }
        }
    });
    menu.response.on_hover_text(
        "Ready layouts, and views to add; views are moved by their names, onto another or beside it",
    );
}
