//! The row of a parameter whose values come from a file, or were baked.

use egui::{Align, Label, Layout, RichText, Role, Ui, WidgetInfo};

use super::small;
use crate::theme::Palette;
use bxdf::resource::{Content, Origin};
use bxdf::{ParamSpec, Resource};
use bxdf_study::files;

/// What is done to the data of a parameter.
pub(super) enum Change {
    /// Its file is read again.
    ReadAgain(Resource),
    /// There is none any more.
    TakeAway,
}

/// What the row says and offers.
struct Words {
    /// What stands there: the name of the file, what was baked.
    text: String,
    /// All that is known of it.
    hint: String,
    /// Whether something is wrong with it.
    is_wrong: bool,
    /// Whether it may be looked for anew.
    can_read_again: bool,
}

impl Words {
    fn of(spec: &ParamSpec, resource: Option<&Resource>) -> Self {
        let Some(resource) = resource else {
            return Self {
                text: "none: open a file, or drop one on the window".to_owned(),
                hint: format!("{}\n{}", spec.meaning, spec.allowed()),
                is_wrong: false,
                can_read_again: false,
            };
        };
        let problem = resource.problem();
        let short = match resource.origin() {
            Origin::File(path) => path
                .file_name()
                .unwrap_or_default()
                .to_string_lossy()
                .into_owned(),
            Origin::Inline | Origin::Baked(_) => resource.name(),
        };
        let mut hint = vec![spec.meaning.to_owned(), resource.name()];
        hint.extend(resource.decoded().map(|decoded| {
            let size = files::in_words(decoded.size());
            format!("{size}, SHA-256 {}", decoded.hash())
        }));
        hint.extend(problem.clone());
        let text = match resource.content() {
            Content::Here(_) if resource.is_changed() => format!("{short} (changed)"),
            Content::Here(_) => short,
            Content::Pending => format!("{short} …"),
            Content::Missing(_) => format!("{short} (missing)"),
        };
        Self {
            text,
            hint: hint.join("\n"),
            is_wrong: problem.is_some() && !resource.is_pending(),
            can_read_again: matches!(resource.origin(), Origin::File(_)) && !resource.is_pending(),
        }
    }
}

/// The row: what it is called, where it comes from, and the buttons to read it again and to take it away. Returns what
/// is done to it. `name`: what assistive tools call it.
pub(super) fn show(
    ui: &mut Ui,
    spec: &ParamSpec,
    name: &str,
    resource: Option<&Resource>,
) -> Option<Change> {
    let words = Words::of(spec, resource);
    let mut changed = None;
    ui.horizontal(|ui| {
        ui.label(spec.label()).on_hover_text(&words.hint);
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let button = |ui: &mut Ui, icon: &str, verb: &str, hint: &str| {
                let button = small::button(ui, icon).frame(false);
                let response = ui.add(button).on_hover_text(hint);
                let name = format!("{verb} {name}");
                response.widget_info(|| WidgetInfo::labeled(Role::Button, true, &name));
                response.clicked()
            };
            if let Some(resource) = resource {
                if button(ui, "↺", "Reset", "Take the data away") {
                    changed = Some(Change::TakeAway);
                }
                if words.can_read_again && button(ui, "⟳", "Read again", "Read the file again") {
                    changed = Some(Change::ReadAgain(resource.again()));
                }
            }
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                let mut text = RichText::new(&words.text);
                if words.is_wrong {
                    text = text.color(Palette::of(ui.theme()).warning);
                }
                ui.add(Label::new(text).truncate())
                    .on_hover_text(&words.hint);
            });
        });
    });
    changed
}
