//! The numbers behind each view as a table: one row for each point, the material first, units in the header.

use crate::error::{Error, Result};
use crate::lab::tradeoff::table::{COLUMNS, rows as tradeoff_rows};
use crate::ui::data::Data;
use crate::ui::session::{MaterialEntry, Session};
pub use lobes::{cartesian, decomposition, hemisphere, lobe3d, polar, slice};
pub use samples::sampling;

mod lobes;
mod samples;

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

/// What fills a view's table.
pub type Fill = fn(&Session, &mut Data) -> Table;

impl Table {
    fn new(columns: &[&str]) -> Self {
        Self::named(columns.iter().map(|name| (*name).to_owned()).collect())
    }

    fn named(columns: Vec<String>) -> Self {
        Self {
            columns,
            rows: Vec::new(),
        }
    }

    /// Adds a row: the material, then numbers.
    fn push(&mut self, title: &str, numbers: impl IntoIterator<Item = f64>) {
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
fn shown(session: &Session) -> impl Iterator<Item = (&MaterialEntry, String)> {
    let title = |entry| (entry, session.materials.title(entry));
    session.materials.shown().map(title)
}

/// Of the reflectance: what each lobe does at each angle.
pub fn reflectance(session: &Session, data: &mut Data) -> Table {
    let mut table = Table::new(&[
        "material",
        "category",
        "side",
        "lobe",
        "theta_i (degrees)",
        "rho_r",
        "rho_g",
        "rho_b",
        "error",
    ]);
    for (entry, title) in shown(session) {
        let curve = data.ask(session, entry, session.reflectance_request());
        for row in &curve.rows {
            for share in &row.shares {
                let [r, g, b] = share.value;
                let lobe = share.lobe;
                let words = [&title, lobe.category.id(), lobe.side.id(), lobe.name];
                let mut cells: Vec<Value> = words.map(|word| Value::Text(word.to_owned())).into();
                cells.extend([row.theta_deg, r, g, b, share.error].map(Value::Number));
                table.rows.push(cells);
            }
        }
    }
    table
}

/// Of the stability: the errors over the two axes, through the mirror direction of the held one.
pub fn stability(session: &Session, data: &mut Data) -> Table {
    let mut table = Table::new(&[
        "material",
        "x",
        "y",
        "error_f32",
        "error_f64",
        "of_bound_f32",
        "of_bound_f64",
        "condition_number",
    ]);
    let request = session.stability_request();
    let entry = session.materials.selected();
    let title = session.materials.title(entry);
    let map = data.ask(session, entry, request.clone());
    for (index, cell) in map.pixels.iter().enumerate() {
        let share = |index: usize, n: usize| (index as f64 + 0.5) / n as f64;
        let x = request.x.value(share(index % map.width, map.width));
        let y = request.y.value(1.0 - share(index / map.width, map.height));
        let ([e32, e64], [r32, r64]) = (cell.errors, cell.ratios);
        if cell.kappa.is_finite() {
            table.push(&title, [x, y, e32, e64, r32, r64, cell.kappa]);
        }
    }
    table
}

/// Of the lit sphere: the radiance of its pixels.
pub fn sphere(session: &Session, data: &mut Data) -> Table {
    let mut table = Table::new(&[
        "material",
        "x",
        "y",
        "radiance_r",
        "radiance_g",
        "radiance_b",
        "coverage",
    ]);
    let request = session.sphere_request(f32::INFINITY);
    for (entry, title) in shown(session) {
        let picture = data.ask(session, entry, request);
        for (index, [r, g, b, coverage]) in picture.pixels.iter().enumerate() {
            if *coverage > 0.0 {
                let place = |index: usize, n: usize| 2.0 * (index as f64 + 0.5) / n as f64 - 1.0;
                let (x, y) = (index % picture.width, index / picture.width);
                let place = [place(x, picture.width), -place(y, picture.height)];
                table.push(
                    &title,
                    place
                        .into_iter()
                        .chain([*r, *g, *b, *coverage].map(f64::from)),
                );
            }
        }
    }
    table
}

/// The points of the trade-off, measured if they are not yet.
#[must_use]
pub fn tradeoff(session: &Session, data: &mut Data) -> Table {
    if !data.tradeoff.is_of(session) {
        data.tradeoff.start(session, || {});
    }
    let report = data.tradeoff.report();
    let rows = report.iter().flat_map(|report| tradeoff_rows(report));
    Table {
        columns: COLUMNS.map(str::to_owned).to_vec(),
        rows: rows.map(|row| row.map(Value::Text).to_vec()).collect(),
    }
}
