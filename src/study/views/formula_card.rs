//! The formula of the selected material, with its numbers at the cursor.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use super::caption::{Caption, Subjects};
use super::kind::{Deltas, TableKind, ViewKind, ViewOptions};
use super::words::words;
use crate::answers::Answers;
use crate::export::names;
use crate::export::table::{Table, Value};
use crate::number::{NumberSpec, Refused};
use crate::session::Session;
use bxdf::Component;
use bxdf::material::MAX_COMPONENTS;
use bxdf_lab::analysis::Hold;
use bxdf_lab::formula_card::{Reading, Term};
use std::f64::consts::PI;

pub(super) const KIND: ViewKind = ViewKind {
    id: "formula_card",
    title: "Formula card",
    what_you_see: "The formula of the selected material with the numbers at the cursor put in, term by \
        term down to f; the same value as other programs return it; where the formula comes from, and what it leaves out",
    says_hidden: false,
    deltas: Deltas::Summed,
    with_cosine: false,
    table: TableKind::Computed,
    is_mesh: false,
};

words! {
    /// What the card leads to.
    Unit {
        /// f, in 1/sr.
        #[default]
        F = "f",
        /// pi f, the reflectance factor: 1 is a white Lambertian surface.
        PiF = "π f",
    }
}

/// The place of the lobe among those of a material.
static LOBE: NumberSpec =
    NumberSpec::new("formula_card.lobe", [0.0, (MAX_COMPONENTS - 1) as f64]).whole();

/// What the card shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Options {
    /// What it leads to.
    pub unit: Unit,
    /// Whose formula it is, among several lobes of a material; of fewer the last.
    pub lobe: usize,
}

impl Options {
    /// The component of the selected material that the card is of.
    #[must_use]
    pub fn component<'a>(&self, session: &'a Session) -> Option<&'a Component> {
        let components = session.materials.selected().material.components();
        let last = components.len().checked_sub(1)?;
        components.get(self.lobe.min(last))
    }

    /// The formula worked out at the unit vectors to viewer and light; `None` for a model without a card.
    #[must_use]
    pub fn reading(&self, session: &Session, (wo, wi): (DVec3, DVec3)) -> Option<Reading> {
        let component = self.component(session)?;
        Reading::of(component, session.rotation_deg, wo, wi)
    }

    /// By what f is multiplied, and its unit.
    #[must_use]
    pub fn scale(&self) -> (f64, &'static str) {
        match self.unit {
            Unit::F => (1.0, "1/sr"),
            Unit::PiF => (PI, ""),
        }
    }

    /// The symbol and the number of a term as the card has it: the last one in its unit.
    #[must_use]
    pub fn shown(&self, term: &Term) -> (String, [f64; 3], &'static str) {
        let rgb = term.worth.channels();
        if term.is_f() {
            let (factor, unit) = self.scale();
            let symbol = match self.unit {
                Unit::F => term.symbol.to_owned(),
                Unit::PiF => format!(r"\pi\,{}", term.symbol),
            };
            (symbol, rgb.map(|x| x * factor), unit)
        } else {
            (term.symbol.to_owned(), rgb, term.unit)
        }
    }
}

/// The light and the viewer of the session, as wo and wi.
fn pair(session: &Session) -> (DVec3, DVec3) {
    let (held, other) = (session.held(), session.other());
    match session.hold {
        Hold::Light => (other, held),
        Hold::Viewer => (held, other),
    }
}

impl ViewOptions for Options {
    fn caption(&self, _: &Session) -> Caption {
        let of = match self.unit {
            Unit::F => "f (1/sr)",
            Unit::PiF => "π f",
        };
        Caption::of(format!("{of}, term by term")).naming(Subjects::Selected)
    }

    fn is_of_held(&self) -> bool {
        false
    }

    fn check_whole(&self) -> Result<(), Refused> {
        LOBE.checked(self.lobe as f64).map(|_| ())
    }

    /// The terms at the light and the viewer.
    fn table(&self, session: &Session, _: &mut Answers) -> Table {
        let values = names::CHANNELS.map(|(_, channel)| format!("value_{channel}"));
        let first = ["material", "symbol", "formula", "meaning"].map(str::to_owned);
        let columns = first.into_iter().chain(values).chain(["unit".to_owned()]);
        let mut table = Table::named(columns.collect());
        let title = session.materials.title(session.materials.selected());
        let reading = self.reading(session, pair(session));
        for term in reading.iter().flat_map(|reading| &reading.terms) {
            let (symbol, rgb, unit) = self.shown(term);
            let text = |word: &str| Value::Text(word.to_owned());
            let words = [title.as_str(), &symbol, term.formula, term.meaning].map(text);
            let numbers = names::CHANNELS.map(|(channel, _)| Value::Number(channel.of(rgb)));
            let row = words.into_iter().chain(numbers).chain([text(unit)]);
            table.rows.push(row.collect());
        }
        table
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_ends_in_the_value_of_the_selected_material() {
        let session = Session {
            rotation_deg: 25.0,
            ..Session::default()
        };
        let options = Options {
            unit: Unit::PiF,
            ..Options::default()
        };
        let mut answers = Answers::at_once();
        let table = options.table(&session, &mut answers);
        let (wo, wi) = pair(&session);
        let entry = session.materials.selected();
        let f = answers.with_subject(&session, entry, |subject| {
            let surface = subject.lobe.surface();
            surface.f(wo.into(), wi.into()).to_f64()
        });
        let last = table.rows.last().unwrap();
        let Value::Number(red) = last[4] else {
            panic!("a number")
        };
        assert!((red / (PI * f[0]) - 1.0).abs() < 1e-11, "{red} {f:?}");
        assert_eq!(table.columns.len(), last.len());
    }

    #[test]
    fn a_lobe_that_is_not_there_is_the_last() {
        let session = Session::default();
        let options = Options {
            lobe: 7,
            ..Options::default()
        };
        let component = options.component(&session).unwrap();
        let components = session.materials.selected().material.components();
        assert_eq!(Some(component), components.last());
    }
}
