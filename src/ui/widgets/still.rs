//! What nobody can act in: pictures are drawn by the views themselves, whose controls are not there then.

use egui::style::ScrollStyle;
use egui::{Context, Id, Rect, ScrollArea, Sense, Ui};

/// Leaves only what is to be seen of all that is drawn into `ui` from now on: nothing takes the pointer or the focus, and no
/// text can be selected.
pub fn make(ui: &mut Ui) {
    let style = ui.style_mut();
    style.interaction.selectable_labels = false;
    // It looks as it does elsewhere.
    style.visuals.disabled_alpha = 1.0;
    ui.disable();
}

/// Whether `ui` is such a place.
#[must_use]
pub fn is(ui: &Ui) -> bool {
    !ui.is_enabled()
}

/// What something in `ui` senses that senses this where it can be acted in.
#[must_use]
pub fn sense(ui: &Ui, sense: Sense) -> Sense {
    if is(ui) { Sense::hover() } else { sense }
}

/// What `add` draws, in `area` where it can be scrolled: that there is more is seen by its bars before a pointer is near.
pub fn scroll(ui: &mut Ui, area: ScrollArea, add: impl FnOnce(&mut Ui)) {
    if is(ui) {
        add(ui);
    } else {
        let bars = &mut ui.spacing_mut().scroll;
        let before = std::mem::replace(bars, ScrollStyle::thin());
        area.show(ui, |ui| {
            ui.spacing_mut().scroll = before;
            add(ui);
        });
        ui.spacing_mut().scroll = before;
    }
}

/// What a pass has that follows the page, whatever its size.
#[derive(Clone, Default)]
struct Followers {
    pass: u64,
    places: Vec<Rect>,
}

/// Says that what covers `rect` follows the edges of the room: where a page is cut to what there is to see, it does not count.
pub fn follows_room(ui: &Ui, rect: Rect) {
    let pass = ui.ctx().cumulative_pass_nr();
    ui.data_mut(|data| {
        let followers: &mut Followers = data.get_temp_mut_or_default(Id::unique(FOLLOWERS));
        if followers.pass != pass {
            *followers = Followers {
                pass,
                places: Vec::new(),
            };
        }
        followers.places.push(rect);
    });
}

/// What followed the edges of the room in the last pass that had such.
#[must_use]
pub fn followers(ctx: &Context) -> Vec<Rect> {
    let followers: Option<Followers> = ctx.data(|data| data.get_temp(Id::unique(FOLLOWERS)));
    followers.unwrap_or_default().places
}

const FOLLOWERS: &str = "follows the room";
