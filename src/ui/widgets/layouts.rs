//! The arrangements that are ready, and the menu of views that can be added.

use egui::{Button, Ui};

use super::menus;
use bxdf::error::Result;
use bxdf_study::session::{MAX_VIEWS, READY_LAYOUTS, Views};
use bxdf_study::views::VIEWS;

/// The arrangements, for a window that has this `room` for views; the signs stand alone where there is none for words.
pub fn arrangements(ui: &mut Ui, views: &mut Views, room: [f32; 2], has_words: bool) {
    for ready in &READY_LAYOUTS {
        let text = if has_words {
            format!("{} {}", ready.icon, ready.name)
        } else {
            ready.icon.to_owned()
        };
        let choice = ui.add(Button::selectable(views.is_ready(ready, room), text));
        ui.ctx()
            .accesskit_node_builder(choice.id, |node| node.set_label(ready.name));
        let hint = format!("{}: {}", ready.name, ready.meaning);
        if choice.on_hover_text(hint).clicked() {
            views.show_ready(ready, room);
        }
    }
}

/// Lessons beside the views, which stand among the arrangements. Returns whether they are to be shown, or hidden.
pub fn learn(ui: &mut Ui, is_learning: bool, has_words: bool, hint: &str) -> bool {
    let text = if has_words { "🎓 Learn" } else { "🎓" };
    let choice = ui.add(Button::selectable(is_learning, text));
    ui.ctx()
        .accesskit_node_builder(choice.id, |node| node.set_label("Learn"));
    choice.on_hover_text(hint).clicked()
}

/// The menu of the views that can be added to those that are open, in a window that has this `room` for them.
///
/// # Errors
/// Where a view that is chosen cannot be opened.
pub fn menu(ui: &mut Ui, views: &mut Views, room: [f32; 2]) -> Result<()> {
    let mut opened = Ok(());
    let menu = ui.menu_button("Views", |ui| {
        menus::entries(ui, |ui| {
            ui.weak("Add a view");
            for view in &VIEWS {
                let button = ui.add_enabled(views.has_room(), Button::new(view.title));
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
                    opened = views.add(view, room).map(|_| ());
                }
            }
        });
    });
    menu.response.on_hover_text(
        "Views to add; drag a view by its name onto another or beside it, and double-click the name to give it all the room",
    );
    opened
}
