//! The formula card: a formula, its terms with their numbers, and what others make of the value.

use egui::{Label, RichText, ScrollArea, Ui};

use super::context::ViewContext;
use super::settings;
use crate::widgets::formula::{self, Look};
use crate::widgets::{choice, draw, still};
use bxdf_lab::formula_card::{Convention, Documentation, Reading, Term};
use bxdf_study::format;
use bxdf_study::parameters::labels;
use bxdf_study::views::formula_card::{Options, Unit};

/// The size of the letters of the formula, at most, and of those of the terms, in points.
const LARGE: f32 = 22.0;
const SMALL: f32 = 15.0;

/// No formula is drawn smaller than this: what is wider then is scrolled to.
const LEAST: f32 = 13.0;

/// The room of the sign between a symbol and its number, in points.
const ROOM_OF_SIGN: f32 = 24.0;

/// Between two terms, and above a section, in points.
const GAPS: [f32; 2] = [5.0, 12.0];

pub(super) fn show(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    settings::row(ui, cx, controls);
    let pair = cx.pair();
    let Some(reading) = cx.options.reading(cx.session, pair) else {
        draw::centred_note(ui, "The model has no formula card");
        return;
    };
    let area = ScrollArea::vertical().auto_shrink([false, false]);
    still::scroll(ui, area, |ui| {
        let card = Drawn {
            cx,
            reading: &reading,
        };
        card.show(ui);
    });
}

fn controls(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    let hint = "What the card leads to: f in 1/sr, or the reflectance factor π f, which is 1 for a white Lambertian surface";
    choice::choice(
        ui,
        ("Leads to", hint),
        &mut cx.options.unit,
        Unit::ALL,
        Unit::title,
    );
    let components = cx.session.materials.selected().material.components();
    if components.len() < 2 {
        return;
    }
    let names: Vec<String> = components
        .iter()
        .enumerate()
        .map(|(place, component)| format!("{}: {}", place + 1, component.model().title))
        .collect();
    let lobe = &mut cx.options.lobe;
    let chosen = names
        .get((*lobe).min(names.len() - 1))
        .cloned()
        .unwrap_or_default();
    let hint = "The lobe whose formula is shown, without its weight in the material";
    choice::named_combo(ui, ("Formula of", "Lobe", hint), &chosen, |ui| {
        for (place, name) in names.iter().enumerate() {
            ui.selectable_value(lobe, place, name);
        }
    });
}

/// A card that is drawn.
struct Drawn<'a, 'b> {
    cx: &'a ViewContext<'b, Options>,
    reading: &'a Reading,
}

impl Drawn<'_, '_> {
    fn show(&self, ui: &mut Ui) {
        self.head(ui);
        self.terms(ui);
        self.conventions(ui);
        self.documentation(ui);
    }

    /// Whether there is room for `height` points more: a picture has no more than it shows.
    fn has_room(ui: &Ui, height: f32) -> bool {
        !still::is(ui) || ui.available_height() >= height
    }

    fn look(&self, size: f32) -> Look<'_> {
        let slot = self.cx.session.materials.selected().slot();
        Look {
            size,
            palette: self.cx.palette,
            lobe: self.cx.palette.material(slot),
        }
    }

    /// The formula with the accessible names of its parameters' controls in place of the names they have in files.
    fn named(&self, tex: &str) -> String {
        let component = self.cx.options.component(self.cx.session);
        let specs = component.map_or(&[][..], |component| component.model().parameters);
        let mut text = tex.to_owned();
        for spec in specs {
            if let Some(label) = labels(spec).first() {
                let name = format!("\\param{{{}}}{{", spec.name);
                text = text.replace(&name, &format!("\\param{{{label}}}{{"));
            }
        }
        text
    }

    /// A formula by itself, as large as the room allows.
    fn formula(&self, ui: &mut Ui, tex: &str, most: f32) {
        let tex = self.named(tex);
        let width = formula::width(ui, &tex, false).max(1.0);
        let room = ui.available_width();
        let size = most.min(room / width);
        if size >= LEAST || still::is(ui) {
            formula::show(ui, &tex, false, self.look(size));
        } else {
            ScrollArea::horizontal().id_salt(&tex).show(ui, |ui| {
                formula::show(ui, &tex, false, self.look(LEAST));
            });
        }
    }

    /// The symbol that the formula is of.
    fn whole(&self) -> &'static str {
        match (self.reading.is_delta, self.cx.options.unit) {
            (true, _) => r"\lobe{w}",
            (false, Unit::F) => r"\lobe{f}",
            (false, Unit::PiF) => r"\pi\,\lobe{f}",
        }
    }

    fn head(&self, ui: &mut Ui) {
        let model = self
            .cx
            .options
            .component(self.cx.session)
            .map(bxdf::Component::model);
        if let Some(model) = model {
            ui.horizontal_wrapped(|ui| {
                let slot = self.cx.session.materials.selected().slot();
                draw::swatch(ui, self.cx.palette.material(slot));
                ui.label(RichText::new(model.title).strong());
            });
        }
        let whole = self.whole();
        for formula in &self.reading.formulas {
            let tex = match (self.reading.is_delta, self.cx.options.unit) {
                (false, Unit::PiF) => format!(r"{whole} = \pi \left[ {formula} \right]"),
                _ => format!("{whole} = {formula}"),
            };
            ui.add_space(GAPS[0]);
            self.formula(ui, &tex, LARGE);
        }
        ui.add_space(GAPS[0]);
        match self.reading.terms.last() {
            Some(last) => {
                let (symbol, rgb, unit) = self.cx.options.shown(last);
                ui.horizontal_wrapped(|ui| {
                    formula::show(ui, &symbol, true, self.look(SMALL));
                    ui.label(RichText::new(format!("= {}", written(rgb, unit))).strong());
                });
            }
            None => {
                ui.label("No light goes from this light to this viewer: the value is 0");
            }
        }
    }

    fn terms(&self, ui: &mut Ui) {
        if self.reading.terms.is_empty() {
            return;
        }
        if Self::has_room(ui, SECTION) {
            section(ui, "Term by term");
        }
        let mut terms = self.reading.terms.as_slice();
        while let Some((term, rest)) = terms.split_first() {
            let given = terms.iter().take_while(|term| term.is_parameter()).count();
            if !Self::has_room(ui, if given > 0 { LINE } else { ROW }) {
                return;
            }
            if let Some((parameters, rest)) = terms.split_at_checked(given).filter(|_| given > 0) {
                self.parameters(ui, parameters);
                terms = rest;
            } else {
                self.term(ui, term);
                terms = rest;
            }
            ui.add_space(GAPS[0]);
        }
    }

    /// Parameters, one after the other: what each means is told where it is set, too.
    fn parameters(&self, ui: &mut Ui, parameters: &[Term]) {
        ui.horizontal_wrapped(|ui| {
            for term in parameters {
                let (symbol, rgb, unit) = self.cx.options.shown(term);
                let (symbol, number) = (self.named(&symbol), written(rgb, unit));
                let width = formula::width(ui, &symbol, true) * SMALL
                    + choice::width_of(ui, &number, &egui::TextStyle::Body);
                choice::keep_together(ui, width + ROOM_OF_SIGN);
                ui.horizontal(|ui| {
                    let shown = formula::show(ui, &symbol, true, self.look(SMALL));
                    shown.on_hover_text(term.meaning);
                    ui.label(format!("= {number}")).on_hover_text(term.meaning);
                });
                ui.add_space(GAPS[1]);
            }
        });
    }

    fn term(&self, ui: &mut Ui, term: &Term) {
        let (symbol, rgb, unit) = self.cx.options.shown(term);
        let by = match (term.is_f(), self.cx.options.unit) {
            (true, Unit::PiF) => format!(r"\pi \left[ {} \right]", term.formula),
            _ => term.formula.to_owned(),
        };
        let tex = if by.is_empty() {
            symbol
        } else {
            format!("{symbol} = {by}")
        };
        let number = written(rgb, unit);
        let shown = self.named(&tex);
        let width = formula::width(ui, &shown, false) * SMALL;
        let beside = choice::width_of(ui, &number, &egui::TextStyle::Body) + ROOM_OF_SIGN;
        let value = |ui: &mut Ui| {
            let text = RichText::new(format!("= {number}"));
            ui.label(if term.is_last() { text.strong() } else { text });
        };
        if width + beside <= ui.available_width() {
            ui.horizontal(|ui| {
                formula::show(ui, &shown, false, self.look(SMALL));
                value(ui);
            });
        } else {
            self.formula(ui, &tex, SMALL);
            value(ui);
        }
        let meaning = RichText::new(term.meaning).small().weak();
        ui.add(Label::new(meaning).wrap());
    }

    fn conventions(&self, ui: &mut Ui) {
        if self.reading.terms.is_empty() || !Self::has_room(ui, SECTION + ROW) {
            return;
        }
        section(ui, "Conventions: the same value as others have it");
        for Convention {
            formula: tex,
            whose,
            unit,
            rgb,
        } in &self.reading.conventions
        {
            if !Self::has_room(ui, ROW) {
                return;
            }
            ui.horizontal_wrapped(|ui| {
                formula::show(ui, tex, true, self.look(SMALL));
                ui.label(format!("= {}", written(*rgb, unit)));
            });
            ui.add(Label::new(RichText::new(*whose).small().weak()).wrap());
            ui.add_space(GAPS[0]);
        }
    }

    /// What the file of the model says, and what is declared of it; a picture is of the numbers.
    fn documentation(&self, ui: &mut Ui) {
        if still::is(ui) {
            return;
        }
        let Documentation {
            source,
            departures,
            validity,
        } = self.reading.card.documentation();
        let component = self.cx.options.component(self.cx.session);
        let declared = component.map_or(&[][..], |component| {
            component.model().properties.declarations
        });
        let broken = declared
            .iter()
            .map(|declared| format!("{}: {}", declared.law, declared.note));
        for (title, paragraphs) in [
            ("Where it comes from", source),
            ("Where it departs from that", departures),
            ("How far it holds, and what it leaves out", validity),
            ("Laws that it breaks as published", broken.collect()),
        ] {
            if !paragraphs.is_empty() {
                section(ui, title);
            }
            for paragraph in paragraphs {
                ui.add(Label::new(paragraph).wrap());
            }
        }
    }
}

/// The room of a heading, of a line of parameters, and of a term with its meaning, in points.
const SECTION: f32 = 34.0;
const LINE: f32 = 24.0;
const ROW: f32 = 76.0;

fn section(ui: &mut Ui, title: &str) {
    ui.add_space(GAPS[1]);
    ui.label(RichText::new(title).strong());
    ui.add_space(GAPS[0]);
}

/// A number with its unit; the channels where they differ.
fn written(rgb: [f64; 3], unit: &str) -> String {
    let [red, green, blue] = rgb;
    let numbers = if red == green && green == blue {
        format::value(red)
    } else {
        let [red, green, blue] = rgb.map(format::value);
        format!("R\u{a0}{red}  G\u{a0}{green}  B\u{a0}{blue}")
    };
    match unit {
        "" => numbers,
        unit => format!("{numbers} {unit}"),
    }
}
