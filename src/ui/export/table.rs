//! The numbers behind each view as a table: one row for each point, the material first, units in the header.

use crate::analysis::cartesian::Abscissa;
use crate::analysis::hemisphere::Comparison;
use crate::analysis::lobe3d::Vertex;
use crate::analysis::polar::Point;
use crate::analysis::slice;
use crate::bxdf::Side;
use crate::error::{Error, Result};
use crate::lab::tradeoff::table::{COLUMNS, rows as tradeoff_rows};
use crate::ui::data::Data;
use crate::ui::session::{MaterialEntry, Session};

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
    pub columns: Vec<&'static str>,
    /// The rows, as long as the columns.
    pub rows: Vec<Vec<Value>>,
}

/// What fills a view's table.
pub type Fill = fn(&Session, &mut Data) -> Table;

impl Table {
    fn new(columns: &[&'static str]) -> Self {
        Self {
            columns: columns.to_vec(),
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

/// Of the polar plot: the section.
pub fn polar(session: &Session, data: &mut Data) -> Table {
    let mut table = Table::new(&[
        "material",
        "angle (degrees)",
        "f_r (1/sr)",
        "f_g (1/sr)",
        "f_b (1/sr)",
    ]);
    for (entry, title) in shown(session) {
        let section = data.ask(session, entry, session.section_request());
        for Point {
            angle,
            value: [r, g, b],
        } in section.lower.iter().chain(&section.upper)
        {
            table.push(&title, [angle.to_degrees(), *r, *g, *b]);
        }
    }
    table
}

/// Of the 3D lobe: the vertices of the mesh.
pub fn lobe3d(session: &Session, data: &mut Data) -> Table {
    let mut table = Table::new(&[
        "material",
        "w_x",
        "w_y",
        "w_z",
        "f_r (1/sr)",
        "f_g (1/sr)",
        "f_b (1/sr)",
    ]);
    for (entry, title) in shown(session) {
        let mesh = data.ask(session, entry, session.mesh_request());
        for Vertex {
            direction: w,
            value: [r, g, b],
        } in &mesh.vertices
        {
            table.push(&title, [w.x, w.y, w.z, *r, *g, *b]);
        }
    }
    table
}

/// Of the Cartesian plot: the curve.
pub fn cartesian(session: &Session, data: &mut Data) -> Table {
    let angle = match session.views.cartesian.abscissa {
        Abscissa::Free => "angle (degrees)",
        Abscissa::Half => "theta_h (degrees)",
        Abscissa::Difference => "theta_d (degrees)",
    };
    let mut table = Table::new(&["material", angle, "f_r (1/sr)", "f_g (1/sr)", "f_b (1/sr)"]);
    let reference = session
        .views
        .cartesian
        .is_residual
        .then(|| session.materials.reference());
    for (entry, title) in shown(session) {
        let curve = data.compare(session, entry, reference, session.cartesian_request());
        for point in curve.lines.iter().flatten() {
            let [r, g, b] = point.value;
            table.push(&title, [point.x_deg, r, g, b]);
        }
    }
    table
}

/// Of the hemisphere: the pixels of the disc.
pub fn hemisphere(session: &Session, data: &mut Data) -> Table {
    let mut table = Table::new(&[
        "material", "w_x", "w_y", "w_z", "value_r", "value_g", "value_b",
    ]);
    let request = session.hemisphere_request();
    let is_compared = request.comparison != Comparison::None;
    let reference = is_compared.then(|| session.materials.reference());
    for (entry, title) in shown(session) {
        let map = data.compare(session, entry, reference, request);
        let (width, height) = (map.raster.width, map.raster.height);
        for (index, [r, g, b]) in map.raster.pixels.iter().enumerate() {
            let place = |index: usize, n: usize| 2.0 * (index as f64 + 0.5) / n as f64 - 1.0;
            let place = [place(index % width, width), -place(index / width, height)];
            if let Some(w) = request.projection.direction(place, request.is_upper) {
                table.push(&title, [w.x, w.y, w.z, *r, *g, *b]);
            }
        }
    }
    table
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

/// Of the slice: its pixels that lie above the surface.
pub fn slice(session: &Session, data: &mut Data) -> Table {
    let mut table = Table::new(&[
        "material",
        "theta_h (degrees)",
        "theta_d (degrees)",
        "f_r (1/sr)",
        "f_g (1/sr)",
        "f_b (1/sr)",
    ]);
    let request = session.slice_request();
    for (entry, title) in shown(session) {
        let slice::Slice { raster } = &*data.ask(session, entry, request);
        for (index, [r, g, b]) in raster.pixels.iter().enumerate() {
            let share = |index: usize, n: usize| (index as f64 + 0.5) / n as f64;
            let (x, y) = (
                share(index % raster.width, raster.width),
                share(index / raster.width, raster.height),
            );
            let theta_h = 90.0 * if request.is_square_root { x * x } else { x };
            if r.is_finite() {
                table.push(&title, [theta_h, 90.0 * (1.0 - y), *r, *g, *b]);
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

/// Of the sampling: the samples.
pub fn sampling(session: &Session, data: &mut Data) -> Table {
    let mut table = Table::new(&[
        "material", "u0", "u1", "uc", "w_x", "w_y", "w_z", "weight_r", "weight_g", "weight_b",
        "delta",
    ]);
    for (entry, title) in shown(session) {
        let study = data.ask(session, entry, session.sampling_request());
        for point in &study.points {
            let ([u0, u1], w, [r, g, b]) = (point.u, point.direction, point.weight);
            let delta = f64::from(u8::from(point.is_delta));
            table.push(&title, [u0, u1, point.uc, w.x, w.y, w.z, r, g, b, delta]);
        }
    }
    table
}

/// Of the decomposition: the lobes, and the factors where there are any.
pub fn decomposition(session: &Session, data: &mut Data) -> Table {
    let mut table = Table::new(&[
        "material",
        "part",
        "side",
        "lobe",
        "angle (degrees)",
        "r",
        "g",
        "b",
        "unit",
    ]);
    for (entry, title) in shown(session) {
        let parts = data.ask(session, entry, session.decomposition_request());
        let mut push = |[part, side, lobe, unit]: [&str; 4], angle: f64, rgb: [f64; 3]| {
            let words = [title.as_str(), part, side, lobe].map(|word| Value::Text(word.to_owned()));
            let numbers = [angle].into_iter().chain(rgb).map(Value::Number);
            let unit = Value::Text(unit.to_owned());
            table
                .rows
                .push(words.into_iter().chain(numbers).chain([unit]).collect());
        };
        for part in &parts.lobes {
            let words = [
                part.lobe.category.id(),
                part.lobe.side.id(),
                part.lobe.name,
                "1/sr",
            ];
            for (angle, value) in parts.angles_deg.iter().zip(&part.values) {
                push(words, *angle, *value);
            }
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
                    push([name, side(*angle), "", unit], *angle, value);
                }
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
        columns: COLUMNS.to_vec(),
        rows: rows.map(|row| row.map(Value::Text).to_vec()).collect(),
    }
}
