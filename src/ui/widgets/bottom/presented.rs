//! The bar while the views are presented: the light or the viewer, and the pinned parameters.

use egui::{Align, Layout, Popup, PopupCloseBehavior, Ui};

use super::{MORE, text_width};
use crate::theme;
use crate::widgets::directions::Angle;
use crate::widgets::params::pinned::{self, Pinned};
use bxdf_study::session::{MaterialEntry, Session};

/// The angles in it.
const ANGLES: [Angle; 2] = [Angle::Theta, Angle::Phi];

/// The bar. Returns what it has made of the selected material.
#[must_use]
pub fn show(ui: &mut Ui, session: &mut Session) -> MaterialEntry {
    let mut edited = session.materials.selected().clone();
    let [_, rail] = theme::BAR_RAIL;
    ui.horizontal_centered(|ui| {
        ui.label(format!("{}:", capital(session.held_name())));
        for angle in ANGLES {
            angle.show(ui, session, Some(rail));
        }
        let all = pinned::all(&edited.material, &session.pinned);
        let gap = ui.spacing().item_spacing.x;
        let more = text_width(ui, MORE) + 2.0 * ui.spacing().button_padding.x + gap;
        let widths = all.iter().map(|one| one.width(ui, rail) + 2.0 * gap);
        let count = fitting(widths, ui.available_width(), more);
        let (here, rest) = all.split_at(count);
        for one in here {
            ui.separator();
            one.show(ui, &mut edited.material, rail);
        }
        if !rest.is_empty() {
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                show_rest(ui, rest, &mut edited, rail);
            });
        }
    });
    edited
}

/// The button with those that do not fit.
fn show_rest(ui: &mut Ui, rest: &[Pinned], edited: &mut MaterialEntry, rail: f32) {
    let button = ui.button(MORE).on_hover_text("More pinned parameters");
    ui.ctx()
        .accesskit_node_builder(button.id, |node| node.set_label("Rest of the bar"));
    Popup::menu(&button)
        .close_behavior(PopupCloseBehavior::CloseOnClickOutside)
        .show(|ui| {
            for one in rest {
                ui.horizontal(|ui| one.show(ui, &mut edited.material, rail));
            }
        });
}

/// How many of these widths fit into `room`, beside a button of the width `more` where not all do.
fn fitting(widths: impl Iterator<Item = f32> + Clone, room: f32, more: f32) -> usize {
    if widths.clone().sum::<f32>() <= room {
        return widths.count();
    }
    let mut left = room - more;
    widths
        .take_while(|width| {
            left -= width;
            left >= 0.0
        })
        .count()
}

fn capital(name: &str) -> String {
    let mut letters = name.chars();
    letters.next().map_or_else(String::new, |first| {
        first.to_uppercase().chain(letters).collect()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_does_not_fit_leaves_room_for_its_button() {
        let fits = |room| fitting([30.0, 30.0, 30.0].into_iter(), room, 10.0);
        assert_eq!([90.0, 89.0, 69.0, 39.0, 0.0].map(fits), [3, 2, 1, 0, 0]);
    }
}
