//! The tables of what a lobe is: values, and the shares of its deltas.

use super::{Table, Value, shown};
use crate::analysis::Subject;
use crate::analysis::cartesian::{Abscissa, Curve};
use crate::analysis::deltas::Stem;
use crate::analysis::hemisphere::Comparison;
use crate::analysis::lobe3d::Vertex;
use crate::analysis::polar::Point;
use crate::analysis::slice::{self, mirrored_at};
use crate::bxdf::{Category, Side};
use crate::ui::data::Data;
use crate::ui::export::names::{self, Names};
use crate::ui::session::Session;

impl Table {
    /// Adds a row: the material, where a value stands, the value.
    fn push_value(&mut self, title: &str, at: impl IntoIterator<Item = f64>, rgb: [f64; 3]) {
        self.push(title, at.into_iter().chain(names::value(rgb)));
    }

    /// Adds a row: the material, where a delta stands, its share.
    fn push_delta(&mut self, title: &str, at: impl IntoIterator<Item = f64>, rgb: [f64; 3]) {
        self.push(title, at.into_iter().chain(names::delta(rgb)));
    }

    /// Adds the rows of deltas over an angle; those that lie outside what is shown are not among them.
    fn push_stems(&mut self, title: &str, stems: &[Stem]) {
        for stem in stems.iter().filter(|stem| stem.is_inside) {
            self.push_delta(title, [stem.x_deg], stem.flux);
        }
    }
}

/// Of the polar plot: the section.
pub fn polar(session: &Session, data: &mut Data) -> Table {
    let columns = ["material", "angle (degrees)"];
    let mut table = Table::named(Names::of_lobe(session).columns(&columns));
    for (entry, title) in shown(session) {
        let section = data.ask(session, entry, session.section_request());
        for Point { angle, value } in section.lower.iter().chain(&section.upper) {
            table.push_value(&title, [angle.to_degrees()], *value);
        }
        table.push_stems(&title, &section.stems);
    }
    table
}

/// Of the 3D lobe: the vertices of the mesh.
pub fn lobe3d(session: &Session, data: &mut Data) -> Table {
    let columns = ["material", "w_x", "w_y", "w_z"];
    let mut table = Table::named(Names::of_lobe(session).columns(&columns));
    for (entry, title) in shown(session) {
        let mesh = data.ask(session, entry, session.mesh_request());
        for Vertex {
            direction: w,
            value,
        } in &mesh.vertices
        {
            let cosine = if session.with_cosine { w.z.abs() } else { 1.0 };
            table.push_value(&title, [w.x, w.y, w.z], value.map(|f| f * cosine));
        }
        for arrow in data.arrows(session, entry).iter() {
            table.push_delta(&title, arrow.direction.to_array(), arrow.flux);
        }
    }
    table
}

/// Of the Cartesian plot: the curve.
pub fn cartesian(session: &Session, data: &mut Data) -> Table {
    let options = session.views.cartesian;
    let angle = match options.abscissa {
        Abscissa::Free => "angle (degrees)",
        Abscissa::Half => "theta_h (degrees)",
        Abscissa::Difference => "theta_d (degrees)",
    };
    let names = Names::of_cartesian(session);
    let mut table = Table::named(names.columns(&["material", angle]));
    let reference = options.is_residual.then(|| session.materials.reference());
    for (entry, title) in shown(session) {
        let curve = data.compare(session, entry, reference, session.cartesian_request());
        let peaks = options.is_normalised.then(|| peaks(&curve));
        for point in curve.lines.iter().flatten() {
            let row = names::value(point.value);
            let over = |(index, x): (usize, f64)| {
                let peak = peaks.and_then(|peaks| peaks.get(index).copied());
                x / peak.filter(|peak| *peak > 0.0).unwrap_or(1.0)
            };
            let row = row.enumerate().map(over);
            table.push(&title, std::iter::once(point.x_deg).chain(row));
        }
        table.push_stems(&title, &curve.stems);
    }
    table
}

/// The largest magnitude of each channel of a curve.
fn peaks(curve: &Curve) -> [f64; names::CHANNELS.len()] {
    names::CHANNELS.map(|(channel, _)| {
        let points = curve.lines.iter().flatten();
        let values = points.map(|point| channel.of(point.value).abs());
        values.fold(0.0, f64::max)
    })
}

/// Of the hemisphere: the pixels of the disc, and the deltas on its side.
pub fn hemisphere(session: &Session, data: &mut Data) -> Table {
    let columns = ["material", "w_x", "w_y", "w_z"];
    let mut table = Table::named(Names::of_hemisphere(session).columns(&columns));
    let request = session.hemisphere_request();
    let is_compared = request.comparison != Comparison::None;
    let reference = is_compared.then(|| session.materials.reference());
    for (entry, title) in shown(session) {
        let map = data.compare(session, entry, reference, request);
        let (width, height) = (map.raster.width, map.raster.height);
        for (index, rgb) in map.raster.pixels.iter().enumerate() {
            let place = |index: usize, n: usize| 2.0 * (index as f64 + 0.5) / n as f64 - 1.0;
            let place = [place(index % width, width), -place(index / width, height)];
            if let Some(w) = request.projection.direction(place, request.is_upper) {
                table.push_value(&title, w.to_array(), *rgb);
            }
        }
        for delta in &map.deltas {
            if (delta.direction.z > 0.0) == request.is_upper {
                table.push_delta(&title, delta.direction.to_array(), delta.value);
            }
        }
    }
    table
}

/// Of the slice: its pixels that lie above the surface, and what is mirrored at each theta_d.
pub fn slice(session: &Session, data: &mut Data) -> Table {
    let columns = ["material", "theta_h (degrees)", "theta_d (degrees)"];
    let mut table = Table::named(Names::of_slice(session).columns(&columns));
    let request = session.slice_request();
    for (entry, title) in shown(session) {
        let slice::Slice { raster } = &*data.ask(session, entry, request);
        let share = |index: usize, n: usize| (index as f64 + 0.5) / n as f64;
        let theta_d = |row: usize| 90.0 * (1.0 - share(row, raster.height));
        for (index, rgb) in raster.pixels.iter().enumerate() {
            let x = share(index % raster.width, raster.width);
            let theta_h = 90.0 * if request.is_square_root { x * x } else { x };
            if rgb.iter().all(|x| x.is_finite()) {
                table.push_value(&title, [theta_h, theta_d(index / raster.width)], *rgb);
            }
        }
        for theta_d in (0..raster.height).map(theta_d) {
            let of = |subject: &Subject<'_>| mirrored_at(&request, subject, theta_d);
            if let Some(flux) = data.with_subject(session, entry, of) {
                table.push_delta(&title, [0.0, theta_d], flux);
            }
        }
    }
    table
}

/// Of the decomposition: the lobes, and the factors where there are any.
pub fn decomposition(session: &Session, data: &mut Data) -> Table {
    let values = names::CHANNELS.map(|(_, channel)| format!("value_{channel}"));
    let first = ["material", "part", "side", "lobe", "angle (degrees)"];
    let columns = first.map(str::to_owned).into_iter().chain(values);
    let last = ["quantity", "unit"].map(str::to_owned);
    let mut table = Table::named(columns.chain(last).collect());
    let names = Names::of_decomposition(session);
    for (entry, title) in shown(session) {
        let parts = data.ask(session, entry, session.decomposition_request());
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
