//! The bar at the bottom: the fixed direction, the turn of the surface, where the light goes, the value under the pointer.
//!
//! It is one line. What does not fit is behind the button at its end, in the order of `fit::LEAVING`.

use egui::{Align, Layout, Popup, PopupCloseBehavior, TextStyle, Ui, vec2};

use super::choice::width_of;
use super::directions::{self, Angle};
use super::shares::Energy;
use super::status;
use crate::theme;
use bxdf_study::answers::Progress;
use bxdf_study::cursor::Cursor;
use bxdf_study::session::Session;
use fit::Part;

mod fit;
pub mod presented;

/// The room for the mark that all is computed, in points.
const MARK: f32 = 20.0;

/// The room of a separator, in points.
const SEPARATOR: f32 = 6.0;

/// The height of the line of the value in a narrow window, in points, and the gap between the angles below it.
const VALUE_LINE: f32 = 24.0;
/// See [`VALUE_LINE`].
const NARROW_GAP: f32 = 4.0;

/// What the button with what does not fit shows.
const MORE: &str = "…";

/// What the bar shows beside the session.
pub struct Bar<'a> {
    /// The direction pointed at, and the value there.
    pub cursor: Option<(&'a Cursor, [f64; 3])>,
    /// Where the light of the selected material goes.
    pub energy: Energy<'a>,
    /// How far the answers are.
    pub progress: Progress,
}

impl Bar<'_> {
    /// Its height in the room that there is, in points.
    #[must_use]
    pub fn height(ui: &Ui) -> f32 {
        if has_line_of_value(ui) {
            theme::BAR_HEIGHT + VALUE_LINE + ui.spacing().item_spacing.y
        } else {
            theme::BAR_HEIGHT
        }
    }

    /// The bar; it changes the session.
    pub fn show(&self, ui: &mut Ui, session: &mut Session) {
        if has_line_of_value(ui) {
            self.show_lines(ui, session);
            return;
        }
        let gap = ui.spacing().item_spacing.x;
        let room = ui.available_width() - MARK - 2.0 * (SEPARATOR + gap);
        let width = |part| self.width(ui, session, part);
        let (gone, rest) = fit::left_out(width, room, more_width(ui));
        let is_here = |part: Part| !gone.contains(&part);
        let [least, most] = theme::BAR_RAIL;
        // Half of what is left is for the value.
        let each = least + 0.5 * rest / Angle::ALL.len() as f32;
        let rail = is_here(Part::Rails).then_some(each.min(most));
        ui.horizontal_centered(|ui| {
            directions::fixed(ui, session);
            if is_here(Part::Shown) {
                ui.weak(directions::shown(session));
            }
            for angle in Angle::ALL
                .into_iter()
                .filter(|angle| is_here(Part::Of(*angle)))
            {
                angle.show(ui, session, rail);
            }
            if is_here(Part::Turning) {
                ui.weak(directions::turning(ui, session));
            }
            if is_here(Part::Energy) {
                ui.add(egui::Separator::default().spacing(SEPARATOR));
                self.energy.bar(ui);
            }
            if is_here(Part::Words) {
                self.energy.words(ui);
            }
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                status::progress(ui, self.progress);
                if !gone.is_empty() {
                    self.rest(ui, session, gone);
                }
                if is_here(Part::Value) {
                    ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                        ui.add(egui::Separator::default().spacing(SEPARATOR));
                        status::value(ui, session, self.cursor);
                    });
                }
            });
        });
    }

    /// The value under the pointer in a line of its own, above the angles.
    fn show_lines(&self, ui: &mut Ui, session: &mut Session) {
        let line = vec2(ui.available_width(), VALUE_LINE);
        let at_end = Layout::right_to_left(Align::Center);
        ui.allocate_ui_with_layout(line, at_end, |ui| {
            status::progress(ui, self.progress);
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                status::value(ui, session, self.cursor);
            });
        });
        ui.spacing_mut().item_spacing.x = NARROW_GAP;
        let width = |part| match part {
            Part::Value => 0.0,
            _ => self.width(ui, session, part),
        };
        // What is behind the button is there for the thumb too: sliders have no room in the line.
        let (gone, _) = fit::left_out(width, ui.available_width(), more_width(ui));
        let is_here = |part: &Part| !gone.contains(part);
        ui.horizontal_centered(|ui| {
            directions::fixed(ui, session);
            for angle in Angle::ALL {
                if is_here(&Part::Of(angle)) {
                    angle.show(ui, session, None);
                }
            }
            ui.with_layout(at_end, |ui| {
                let gone: Vec<Part> = gone
                    .iter()
                    .copied()
                    .filter(|part| *part != Part::Value)
                    .collect();
                self.rest(ui, session, &gone);
            });
        });
    }

    /// The button with the parts that do not fit.
    fn rest(&self, ui: &mut Ui, session: &mut Session, gone: &[Part]) {
        let button = ui
            .button(MORE)
            .on_hover_text("What does not fit into this line");
        ui.ctx()
            .accesskit_node_builder(button.id, |node| node.set_label("Rest of the bar"));
        Popup::menu(&button)
            .close_behavior(PopupCloseBehavior::CloseOnClickOutside)
            .show(|ui| {
                // The last to go stands first.
                for part in gone.iter().rev() {
                    self.part(ui, session, *part);
                }
            });
    }

    /// A part in a line of its own.
    fn part(&self, ui: &mut Ui, session: &mut Session, part: Part) {
        let [_, most] = theme::BAR_RAIL;
        match part {
            Part::Fixed => {
                ui.horizontal(|ui| directions::fixed(ui, session));
            }
            Part::Shown => {
                ui.label(directions::shown(session));
            }
            Part::Of(angle) => {
                ui.horizontal(|ui| angle.show(ui, session, Some(most)));
            }
            // They stand beside the numbers that are here too.
            Part::Rails => {}
            Part::Turning => {
                ui.label(directions::turning(ui, session));
            }
            Part::Energy => self.energy.bar(ui),
            Part::Words => {
                ui.horizontal(|ui| self.energy.words(ui));
            }
            Part::Value => status::value(ui, session, self.cursor),
        }
    }

    /// The room of a part with the gap behind it, in points.
    fn width(&self, ui: &Ui, session: &Session, part: Part) -> f32 {
        let spacing = ui.spacing();
        let gap = spacing.item_spacing.x;
        let [rail, _] = theme::BAR_RAIL;
        match part {
            Part::Fixed => directions::fixed_width(ui),
            Part::Shown => text_width(ui, directions::shown(session)) + gap,
            Part::Of(angle) => text_width(ui, angle.symbol()) + theme::NUMBER_WIDTH + 2.0 * gap,
            Part::Rails => Angle::ALL.len() as f32 * (rail + gap),
            Part::Turning => text_width(ui, directions::turning(ui, session)) + gap,
            Part::Energy => theme::SHARE_BAR.x + gap,
            Part::Words => {
                let texts = self.energy.texts().into_iter();
                texts.map(|text| text_width(ui, &text) + gap).sum()
            }
            Part::Value => {
                let [of_one, of_several] = theme::BAR_VALUE;
                let is_named = session.materials.is_overlay();
                gap + if is_named { of_several } else { of_one }
            }
        }
    }
}

/// Whether the value has a line of its own: beside the angles there is no room for it.
fn has_line_of_value(ui: &Ui) -> bool {
    ui.ctx().content_rect().width() < theme::SMALL_WINDOW.x
}

/// The room of the button with what does not fit, in points.
fn more_width(ui: &Ui) -> f32 {
    let spacing = ui.spacing();
    text_width(ui, MORE) + 2.0 * spacing.button_padding.x + spacing.item_spacing.x
}

fn text_width(ui: &Ui, text: &str) -> f32 {
    width_of(ui, text, &TextStyle::Body)
}
