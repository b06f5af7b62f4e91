//! The numbers behind each view as a table: one row for each point, the material first, units in the header.

use super::names;
use crate::session::{MaterialEntry, Session};
use bxdf::error::{Error, Result};
use bxdf_lab::analysis::deltas::Stem;

/// A cell of a table.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A number; the file has all its digits.
    Number(f64),
    /// A name.
    Text(String),
}

/// A table.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// The names of the columns, with their units.
    pub columns: Vec<String>,
    /// The rows, as long as the columns.
    pub rows: Vec<Vec<Value>>,
}

impl Table {
    pub(crate) fn new(columns: &[&str]) -> Self {
        Self::named(columns.iter().map(|name| (*name).to_owned()).collect())
    }

    pub(crate) fn named(columns: Vec<String>) -> Self {
        Self {
            columns,
            rows: Vec::new(),
        }
    }

    /// Adds a row: the material, then numbers.
    pub(crate) fn push(&mut self, title: &str, numbers: impl IntoIterator<Item = f64>) {
        let mut row = vec![Value::Text(title.to_owned())];
        row.extend(numbers.into_iter().map(Value::Number));
        self.rows.push(row);
    }

    /// The table as comma-separated values.
    ///
    /// # Errors
    /// Where it cannot be written.
    pub fn csv(&self) -> Result<Vec<u8>> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        let failed = |error: csv::Error| Error::parse("table", error.to_string());
        writer.write_record(&self.columns).map_err(failed)?;
        for row in &self.rows {
            let cells = row.iter().map(|value| match value {
                // NaN is no value: a direction that is not shown.
                Value::Number(number) if number.is_nan() => String::new(),
                Value::Number(number) => number.to_string(),
                Value::Text(text) => text.clone(),
            });
            writer.write_record(cells).map_err(failed)?;
        }
        let failed = |error: csv::IntoInnerError<_>| Error::parse("table", error.to_string());
        writer.into_inner().map_err(failed)
    }
}

/// The shown materials with their names.
pub(crate) fn shown(session: &Session) -> impl Iterator<Item = (&MaterialEntry, String)> {
    let title = |entry| (entry, session.materials.title(entry));
    session.materials.shown().map(title)
}

impl Table {
    /// Adds a row: the material, where a value stands, the value.
    pub(crate) fn push_value(
        &mut self,
        title: &str,
        at: impl IntoIterator<Item = f64>,
        rgb: [f64; 3],
    ) {
        self.push(title, at.into_iter().chain(names::value(rgb)));
    }

    /// Adds a row: the material, where a delta stands, its share.
    pub(crate) fn push_delta(
        &mut self,
        title: &str,
        at: impl IntoIterator<Item = f64>,
        rgb: [f64; 3],
    ) {
        self.push(title, at.into_iter().chain(names::delta(rgb)));
    }

    /// Adds the rows of deltas over an angle; those that lie outside what is shown are not among them.
    pub(crate) fn push_stems(&mut self, title: &str, stems: &[Stem]) {
        for stem in stems.iter().filter(|stem| stem.is_inside) {
            self.push_delta(title, [stem.x_deg], stem.flux);
        }
    }
}
