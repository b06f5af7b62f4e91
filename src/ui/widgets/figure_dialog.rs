//! The window in which a figure is chosen: what for, in which theme, with which title; and how it will look.

use egui::{
    Checkbox, Context, Id, Modal, Rect, RichText, ScrollArea, Sense, TextEdit, TextureHandle, Ui,
    Vec2, vec2,
};

use crate::theme;
use bxdf_study::colors::Theme;
use bxdf_study::export::figure::{FigureChoice, USES};
use bxdf_study::export::{FORMATS, Format};

/// What becomes of the window.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// It goes on.
    Open,
    /// It is left.
    Closed,
    /// The figure as a file of this format.
    File(Format),
    /// The figure in the clipboard.
    Copy,
}

/// What there is of the figure so far.
pub struct Preview<'a> {
    /// The picture of it, or of the one before it.
    pub picture: Option<&'a TextureHandle>,
    /// Whether it is being drawn.
    pub is_awaited: bool,
    /// Why it cannot be drawn.
    pub problem: Option<&'a str>,
}

/// The window. `title`: a title of the person's own, empty where it is `automatic`; `name`: that of the view.
pub fn show(
    ctx: &Context,
    choice: &mut FigureChoice,
    title: &mut String,
    (name, automatic): (&str, &str),
    preview: &Preview<'_>,
) -> Outcome {
    let modal = Modal::new(Id::unique("figure")).show(ctx, |ui| {
        ui.heading(format!("Figure of {name}"));
        ui.add_space(4.0);
        let room = theme::room_of_dialog(ctx);
        if theme::is_small(ctx.content_rect().size()) {
            ui.set_width(room.x.min(theme::PREVIEW.x));
            ScrollArea::vertical()
                .max_height(room.y - 2.0 * theme::CHROME)
                .show(ui, |ui| {
                    choices(ui, choice, title, automatic);
                    let width = ui.available_width();
                    let size = vec2(width, width * theme::PREVIEW.y / theme::PREVIEW.x);
                    show_preview(ui, size, preview);
                });
            return buttons(ui);
        }
        let picture = theme::PREVIEW.min(room - vec2(theme::CHOICES_WIDTH, 2.0 * theme::CHROME));
        ui.horizontal_top(|ui| {
            ui.vertical(|ui| {
                ui.set_width(theme::CHOICES_WIDTH);
                choices(ui, choice, title, automatic);
            });
            show_preview(ui, picture.max(Vec2::splat(1.0)), preview);
        });
        ui.add_space(4.0);
        buttons(ui)
    });
    match modal.inner {
        Outcome::Open if modal.should_close() => Outcome::Closed,
        outcome => outcome,
    }
}

fn choices(ui: &mut Ui, choice: &mut FigureChoice, title: &mut String, automatic: &str) {
    ui.label(RichText::new("Size").strong());
    for spec in &USES {
        let is_chosen = choice.purpose == spec.purpose;
        let radio = ui.radio(is_chosen, spec.title);
        if is_chosen && ui.memory(|memory| memory.focused().is_none()) {
            radio.request_focus();
        }
        if radio.on_hover_text(spec.meaning).clicked() {
            choice.purpose = spec.purpose;
        }
    }
    let meaning = choice.purpose.spec().meaning;
    // What is below stays where it is, whatever is chosen.
    let room = vec2(ui.available_width(), theme::MEANING_HEIGHT);
    ui.allocate_ui(room, |ui| {
        ui.set_min_size(room);
        ui.label(RichText::new(meaning).small().weak());
    });
    ui.add_space(6.0);
    ui.label(RichText::new("Theme").strong());
    ui.horizontal(|ui| {
        for (theme, name, hint) in [
            (Theme::Light, "Light", "For paper and bright rooms"),
            (Theme::Dark, "Dark", "For dark slides"),
        ] {
            ui.radio_value(&mut choice.theme, theme, name)
                .on_hover_text(hint);
        }
    });
    ui.add_space(6.0);
    let hint = "Say above the view what is shown, of which materials, for which directions";
    let has_title = Checkbox::new(&mut choice.has_title, "Title");
    ui.add(has_title).on_hover_text(hint);
    let field = TextEdit::singleline(title)
        .hint_text(automatic)
        .desired_width(f32::INFINITY);
    let field = ui.add_enabled(choice.has_title, field);
    ui.ctx()
        .accesskit_node_builder(field.id, |node| node.set_label("Words of the title"));
    field.on_hover_text("Words of your own for what is shown; empty: those written here");
}

/// The figure in a place of this size, as large as it goes.
fn show_preview(ui: &mut Ui, size: Vec2, preview: &Preview<'_>) {
    let (place, response) = ui.allocate_exact_size(size, Sense::hover());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, "Preview"));
    let mut inside = ui.new_child(egui::UiBuilder::new().max_rect(place));
    if let Some(problem) = preview.problem {
        inside.colored_label(ui.visuals().error_fg_color, problem);
    } else if let Some(texture) = preview.picture {
        let whole = texture.size_vec2();
        let scale = (size / whole).min_elem();
        let rect = Rect::from_center_size(place.center(), scale * whole);
        let tint = if preview.is_awaited {
            egui::Color32::from_white_alpha(FADED)
        } else {
            egui::Color32::WHITE
        };
        let whole = Rect::from_min_max(egui::Pos2::ZERO, egui::pos2(1.0, 1.0));
        ui.painter().image(texture.id(), rect, whole, tint);
        let stroke = ui.visuals().widgets.noninteractive.bg_stroke;
        ui.painter()
            .rect_stroke(rect, 0.0, stroke, egui::StrokeKind::Outside);
    } else if preview.is_awaited {
        inside.weak("Drawing…");
    }
}

/// The strength of a picture in whose place another one is being drawn, 0..255.
const FADED: u8 = 140;

fn buttons(ui: &mut Ui) -> Outcome {
    let mut outcome = Outcome::Open;
    ui.horizontal_wrapped(|ui| {
        let pictures = FORMATS.iter().filter(|spec| spec.format.is_picture());
        for spec in pictures {
            let button = ui.button(format!("{}…", spec.title));
            if button.on_hover_text(spec.meaning).clicked() {
                outcome = Outcome::File(spec.format);
            }
        }
        let hint = "Copy this figure as a picture";
        if ui.button("Copy picture").on_hover_text(hint).clicked() {
            outcome = Outcome::Copy;
        }
        if ui.button("Cancel").clicked() {
            outcome = Outcome::Closed;
        }
    });
    outcome
}
