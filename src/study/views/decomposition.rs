//! The lobes and factors of values.

use serde::{Deserialize, Serialize};

use super::caption::{Caption, Subjects, value_of_f};
use super::kind::{Deltas, TableKind, ViewKind, ViewOptions};
use super::section::OwnSection;
use super::words::words;
use crate::answers::Answers;
use crate::export::names::{self, Names};
use crate::export::table::{Table, Value, shown};
use crate::number::Numbers;
use crate::session::Session;
use bxdf::{Category, Side};
use bxdf_lab::analysis::decomposition::Request;
use bxdf_lab::analysis::hemisphere::Quantity;

pub(super) const KIND: ViewKind = ViewKind {
    id: "decomposition",
    title: "Decomposition",
    what_you_see: "What the value is made of: lobes that sum to it, or the factors D, G and F \
        of a microfacet model",
    says_hidden: true,
    deltas: Deltas::Marked,
    with_cosine: true,
    table: TableKind::Computed,
    is_mesh: false,
};

words! {
    /// Into what a value is taken apart.
    Decomposed {
        /// Its lobes, which sum to it.
        #[default]
        Lobes = "Lobes",
        /// The factors of a microfacet model.
        Factors = "D, G, F",
    }
}

/// How the decomposition is shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Options {
    /// Into what.
    pub into: Decomposed,
    /// Whether lobes are stacked.
    pub is_stacked: bool,
    /// Whether values go by decades.
    pub is_logarithmic: bool,
    /// A section of its own.
    #[serde(skip_serializing_if = "OwnSection::is_absent")]
    pub own_section_deg: OwnSection,
}

impl Options {
    /// The decomposition in the section.
    #[must_use]
    pub fn request(&self, session: &Session) -> Request {
        Request {
            phi: self.own_section_deg.of(session).phi(),
            with_cosine: session.with_cosine,
        }
    }

    /// What the values of the lobes are called.
    fn names(&self, session: &Session) -> Names {
        let quantity = Quantity::of_f(session.with_cosine);
        let is_logarithmic = self.is_logarithmic && !self.is_stacked;
        Names::new(quantity.id(), quantity.unit(), is_logarithmic)
    }
}

impl ViewOptions for Options {
    fn caption(&self, session: &Session) -> Caption {
        // Small charts have no room for the name of their axis.
        let over =
            |what: &str| Caption::of(format!("{what} over θ of the {}", session.free_name()));
        match self.into {
            Decomposed::Lobes => over(value_of_f(session)).naming(Subjects::Apart),
            Decomposed::Factors => over("the factors D, G and F").naming(Subjects::Colors),
        }
    }

    fn own_section(&mut self) -> Option<&mut OwnSection> {
        Some(&mut self.own_section_deg)
    }

    fn numbers(&mut self) -> Numbers<'_> {
        self.own_section_deg.number().into_iter().collect()
    }

    /// The lobes, and the factors where there are any.
    fn table(&self, session: &Session, answers: &mut Answers) -> Table {
        let values = names::CHANNELS.map(|(_, channel)| format!("value_{channel}"));
        let first = ["material", "part", "side", "lobe", "angle (degrees)"];
        let columns = first.map(str::to_owned).into_iter().chain(values);
        let last = ["quantity", "unit"].map(str::to_owned);
        let mut table = Table::named(columns.chain(last).collect());
        let names = self.names(session);
        for (entry, title) in shown(session) {
            let parts = answers.ask(session, entry, self.request(session));
            let mut push = |[part, side, lobe]: [&str; 3],
                            angle: f64,
                            rgb: [f64; 3],
                            [quantity, unit]: [&str; 2]| {
                let text = |word: &str| Value::Text(word.to_owned());
                let channels = names::CHANNELS.map(|(channel, _)| channel.of(rgb));
                let numbers = [angle].into_iter().chain(channels).map(Value::Number);
                let words = [title.as_str(), part, side, lobe].map(text);
                let last = [quantity, unit].map(text);
                let row = words.into_iter().chain(numbers).chain(last);
                table.rows.push(row.collect());
            };
            for part in &parts.lobes {
                let words = [part.lobe.category.id(), part.lobe.side.id(), part.lobe.name];
                for (angle, value) in parts.angles_deg.iter().zip(&part.values) {
                    push(words, *angle, *value, [&names.quantity, &names.unit]);
                }
            }
            for stem in parts.stems.iter().filter(|stem| stem.is_inside) {
                let words = [Category::PerfectSpecular.id(), stem.side.id(), ""];
                push(words, stem.x_deg, stem.flux, [&names.delta, ""]);
            }
            let Some(factors) = &parts.factors else {
                continue;
            };
            let side = |angle: f64| {
                if angle.abs() <= 90.0 {
                    Side::Reflection.id()
                } else {
                    Side::Transmission.id()
                }
            };
            let rows = parts.angles_deg.iter().zip(&factors.is_defined).enumerate();
            for (index, (angle, is_defined)) in rows {
                let of = |values: &[f64]| values.get(index).map(|value| [*value; 3]);
                let fresnel = factors.fresnel.get(index).copied();
                let all = [
                    ("D", of(&factors.d), "1/sr"),
                    ("G", of(&factors.g), ""),
                    ("F", fresnel, ""),
                ];
                for (name, value, unit) in all {
                    if let Some(value) = value.filter(|_| *is_defined) {
                        push([name, side(*angle), ""], *angle, value, [name, unit]);
                    }
                }
            }
        }
        table
    }
}
