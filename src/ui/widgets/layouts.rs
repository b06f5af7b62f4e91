//! The menu of the views: ready layouts, and views that can be added to those that are open.

use egui::Ui;

use bxdf::error::Result;
use bxdf_study::session::{MAX_VIEWS, READY_LAYOUTS, Session};
use bxdf_study::views::VIEWS;

/// The menu.
///
/// # Errors
/// Where a view that is chosen cannot be opened.
pub fn menu(ui: &mut Ui, session: &mut Session) -> Result<()> {
    let mut opened = Ok(());
    let views = &mut session.views;
    let menu = ui.menu_button("Views", |ui| {
        for ready in &READY_LAYOUTS {
            let choice = ui.selectable_label(views.is_ready(ready), ready.name);
            if choice.on_hover_text(ready.meaning).clicked() {
                views.show_ready(ready);
            }
        }
        ui.separator();
        ui.weak("Add a view");
        for view in &VIEWS {
            let button = ui.add_enabled(views.has_room(), egui::Button::new(view.title));
            ui.ctx().accesskit_node_builder(button.id, |node| {
                node.set_label(format!("Add {}", view.title));
            });
            let hint = if views.first(view).is_some() {
                format!("Another one. {}", view.what_you_see)
            } else {
                view.what_you_see.to_owned()
            };
            let button = button
                .on_hover_text(hint)
                .on_disabled_hover_text(format!("{MAX_VIEWS} views are open, and no more fit"));
            if button.clicked() {
                opened = views.add(view).map(|_| ());
            }
        }
    });
    menu.response.on_hover_text(
        "Ready-made layouts, and views to add; drag a view by its name onto another or beside it",
    );
    opened
}
