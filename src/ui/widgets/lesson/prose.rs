//! The text of a lesson on the screen: words that stand for things, numbers that follow the state, formulas.

use std::sync::Arc;

use egui::{Color32, Label, RichText, Sense, Stroke, Ui};

use crate::theme::Palette;
use crate::widgets::formula::{self, Look};
use crate::widgets::things::{self, By};
use bxdf_study::answers::Answers;
use bxdf_study::format;
use bxdf_study::lessons::{Block, Expression, Scenes, Span, Style, Thing, Worth};
use bxdf_study::session::Session;

/// Between two paragraphs, in points.
const PARAGRAPH_GAP: f32 = 8.0;

/// From the edge to the items of a list, in points.
const INDENT: f32 = 14.0;

/// What texts are drawn with.
pub struct Prose<'a> {
    /// What the numbers in it are computed of.
    pub scenes: &'a Arc<Scenes>,
    /// The session, to ask its answers.
    pub session: &'a Session,
    /// What computes them.
    pub answers: &'a mut Answers,
    /// The colours.
    pub palette: &'a Palette,
    /// The size of letters, in points.
    pub size: f32,
}

impl Prose<'_> {
    /// Blocks, one below the other.
    pub fn blocks(&mut self, ui: &mut Ui, blocks: &[Block]) {
        for block in blocks {
            match block {
                Block::Paragraph(spans) => self.line(ui, spans),
                Block::Formula(tex) => {
                    ui.vertical_centered(|ui| self.formula(ui, tex, false));
                }
                Block::List { first, items } => self.list(ui, *first, items),
            }
            ui.add_space(PARAGRAPH_GAP);
        }
    }

    fn list(&mut self, ui: &mut Ui, first: Option<u64>, items: &[Vec<Block>]) {
        for (index, item) in items.iter().enumerate() {
            ui.horizontal_top(|ui| {
                ui.spacing_mut().item_spacing.x = 0.0;
                let sign = match first {
                    Some(first) => format!("{}.", first + index as u64),
                    None => "•".to_owned(),
                };
                let sign = Label::new(RichText::new(sign).size(self.size));
                ui.add_sized([INDENT, self.size], sign);
                ui.vertical(|ui| {
                    for block in item {
                        match block {
                            Block::Paragraph(spans) => self.line(ui, spans),
                            other => self.blocks(ui, std::slice::from_ref(other)),
                        }
                    }
                });
            });
        }
    }

    /// Running text.
    pub fn line(&mut self, ui: &mut Ui, spans: &[Span]) {
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing = egui::vec2(0.0, 3.0);
            let mut is_behind = false;
            for (index, span) in spans.iter().enumerate() {
                // A full stop does not begin a line: it stands with what is before it.
                let tail = spans.get(index + 1).map_or("", closing);
                match span {
                    Span::Words { text, style } => {
                        let begin = if is_behind { closing(span).len() } else { 0 };
                        let text = text.get(begin..).unwrap_or_default();
                        let tail = if style.thing.is_some() { tail } else { "" };
                        self.words(ui, &format!("{text}{tail}"), style);
                    }
                    Span::Number(number) => self.number(ui, number, tail),
                    Span::Formula(tex) if tail.is_empty() => self.formula(ui, tex, true),
                    Span::Formula(tex) => {
                        self.formula(ui, &format!("{tex}\\text{{{tail}}}"), true);
                    }
                    Span::Code(text) => {
                        ui.label(RichText::new(text).code().size(self.size));
                    }
                }
                is_behind = match span {
                    Span::Words { style, .. } => style.thing.is_some(),
                    Span::Number(_) | Span::Formula(_) => true,
                    Span::Code(_) => false,
                };
            }
        });
    }

    /// The colour of the lobe: that of the selected material.
    fn lobe(&self) -> Color32 {
        let selected = self.session.materials.selected();
        self.palette.material(selected.slot())
    }

    /// The colour of a thing as text.
    fn ink(&self, thing: &Thing) -> Color32 {
        let lobe = match thing {
            Thing::Material(number) => {
                let mut entries = self.session.materials.iter();
                let entry = number.checked_sub(1).and_then(|index| entries.nth(index));
                entry.map_or(self.palette.ink, |entry| {
                    self.palette.material(entry.slot())
                })
            }
            _ => self.lobe(),
        };
        let color = things::color(thing, self.palette, lobe);
        self.palette.text_in(color)
    }

    fn words(&self, ui: &mut Ui, text: &str, style: &Style) {
        if text.is_empty() {
            return;
        }
        let mut rich = RichText::new(text).size(self.size);
        if style.is_strong {
            rich = rich.strong();
        }
        if style.is_emphasis {
            rich = rich.italics();
        }
        let Some(thing) = &style.thing else {
            ui.label(rich);
            return;
        };
        // Colour alone says nothing to everybody: words that stand for things are underlined too.
        rich = rich.color(self.ink(thing)).underline();
        let label = ui.add(Label::new(rich).sense(Sense::hover()));
        if label.hovered() {
            things::point(ui.ctx(), thing, By::Words);
        }
        if things::is_pointed(ui.ctx(), thing, By::Place) {
            let stroke = Stroke::new(1.5, self.palette.accent_line);
            let place = label.rect.expand(1.0);
            ui.painter()
                .rect_stroke(place, 2.0, stroke, egui::StrokeKind::Outside);
        }
    }

    fn number(&mut self, ui: &mut Ui, number: &Expression, tail: &str) {
        let worth = self.worth(number);
        let text = match &worth {
            None => "…".to_owned(),
            Some(Ok(value)) => written(*value, number.unit()),
            Some(Err(_)) => "–".to_owned(),
        };
        let text = format!("{text}{tail}");
        let label = ui.label(RichText::new(text).size(self.size).strong());
        let says = match worth {
            Some(Err(problem)) => problem,
            _ => format!("Computed from the state: {}", number.text()),
        };
        label.on_hover_text(says);
    }

    /// What an expression is worth, where that is known by now.
    fn worth(&mut self, number: &Expression) -> Option<Result<f64, String>> {
        let worth = Worth {
            expression: number.clone(),
            scenes: Arc::clone(self.scenes),
        };
        let selected = self.session.materials.selected();
        let answer = self.answers.ask(self.session, selected, worth);
        (*answer).clone()
    }

    fn formula(&self, ui: &mut Ui, tex: &str, is_inline: bool) {
        let look = Look {
            size: self.size * 1.1,
            palette: self.palette,
            lobe: self.lobe(),
        };
        formula::show(ui, tex, is_inline, look);
    }
}

/// The signs that a piece of text begins with, where they close what is before it.
fn closing(span: &Span) -> &str {
    let Span::Words { text, style } = span else {
        return "";
    };
    if style.thing.is_some() {
        return "";
    }
    let is_open = |c: char| !matches!(c, '.' | ',' | ';' | ':' | ')' | '?');
    text.split(is_open).next().unwrap_or_default()
}

/// A number with its unit as a text has it.
#[must_use]
pub fn written(value: f64, unit: &str) -> String {
    match unit {
        "" => format::value(value),
        "degrees" => format::degrees(value),
        unit => format!("{}\u{a0}{unit}", format::value(value)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn closing_signs_stand_with_what_is_before_them() {
        let words = |text: &str| Span::Words {
            text: text.to_owned(),
            style: Style::default(),
        };
        for (text, expected) in [
            (". So", "."),
            (") and", ")"),
            (" so.", ""),
            ("?", "?"),
            ("", ""),
        ] {
            assert_eq!(closing(&words(text)), expected);
        }
        assert_eq!(closing(&Span::Code(".".to_owned())), "");
    }
}
