//! The inspector: every material's numbers at what is pointed at, or at light and viewer.

use std::fmt::Write as _;
use std::ops::Range;

use egui::{Grid, Label, RichText, ScrollArea, TextStyle, Ui};
use glam::DVec3;

use super::context::ViewContext;
use crate::theme;
use crate::widgets::{choice, deltas as widgets_deltas, draw, small, status, still};
use bxdf::Side;
use bxdf_lab::analysis::half_difference::{HalfDifference, Spherical, half_difference};
use bxdf_lab::analysis::hemisphere::Quantity;
use bxdf_lab::analysis::inspector::{DeltaReading, Reading, deltas};
use bxdf_lab::analysis::reflectance::has_flux;
use bxdf_lab::analysis::{Channel, Hold};
use bxdf_study::export::names;
use bxdf_study::format;
use bxdf_study::views::inspector::Options;

/// The columns of numbers: name and meaning.
const COLUMNS: [(&str, &str); 13] = [
    (
        "f luminance",
        "The value f as the other views and the bar at the bottom have it: R, G and B weighted as the eye does, in 1/sr",
    ),
    ("f R", "The value f in the red channel, in 1/sr"),
    ("f G", "The value f in the green channel, in 1/sr"),
    ("f B", "The value f in the blue channel, in 1/sr"),
    ("f cos R", "f |cos θi| in the red channel, in 1/sr"),
    ("f cos G", "f |cos θi| in the green channel, in 1/sr"),
    ("f cos B", "f |cos θi| in the blue channel, in 1/sr"),
    (
        "pdf",
        "The density with which wi is sampled for wo, in 1/sr",
    ),
    (
        "D",
        "The density of microfacet normals at the half vector, in 1/sr",
    ),
    (
        "G",
        "The share of those microfacets that neither direction is masked from",
    ),
    (
        "F R",
        "The Fresnel reflectance (across the surface: transmittance) of a microfacet, red channel",
    ),
    ("F G", "The same in the green channel"),
    ("F B", "The same in the blue channel"),
];

/// The columns of deltas, which are shown where a material has one: name and meaning.
const DELTAS: [(&str, &str); 2] = [
    (
        "Delta, reflected",
        "The share of the flux that is mirrored as a Dirac delta, and where to: no part of f",
    ),
    (
        "Delta, transmitted",
        "The share of the flux that crosses the surface as a Dirac delta, and where to: no part of f",
    ),
];

/// A pair of directions and what each material does there.
struct Report {
    wo: DVec3,
    wi: DVec3,
    /// Whichever of the two is not held.
    free: DVec3,
    rows: Vec<Row>,
}

/// What a material does.
struct Row {
    name: String,
    color: egui::Color32,
    reading: Reading,
    deltas: [Option<DeltaReading>; 2],
}

pub(super) fn show(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    let report = report(cx);
    let area = ScrollArea::both().auto_shrink([false, false]);
    still::scroll(ui, area, |ui| {
        ui.horizontal_wrapped(|ui| {
            for (name, w) in report.angles() {
                let text = w.map_or_else(|| "-".to_owned(), spherical);
                let body = TextStyle::Body;
                let width = [name.0, &text].map(|text| choice::width_of(ui, text, &body));
                let gap = ui.spacing().item_spacing.x;
                choice::keep_together(ui, width.iter().sum::<f32>() + gap);
                let name_of = ui.label(RichText::new(name.0).strong());
                name_of.on_hover_text(name.1);
                ui.label(text);
                ui.add_space(8.0);
            }
            let hint = "Copy the table as comma-separated values, with all digits";
            // Nobody can click in a picture.
            let copy = small::button(ui, "Copy");
            if !cx.state.is_picture && ui.add(copy).on_hover_text(hint).clicked() {
                ui.ctx().copy_text(report.csv());
            }
        });
        if !has_flux(report.free) {
            ui.add(Label::new(RichText::new(status::IN_PLANE).weak()).wrap());
        }
        table(ui, &report);
    });
}

/// The readings at what is pointed at; at light and viewer while nobody points.
fn report(cx: &mut ViewContext<'_, Options>) -> Report {
    let session = &*cx.session;
    let (wo, wi) = cx.pair();
    let free = match session.hold {
        Hold::Light => wo,
        Hold::Viewer => wi,
    };
    let row = |entry| {
        let (reading, deltas) = cx.answers.with_subject(session, entry, |subject| {
            let lobe = &subject.lobe;
            (Reading::of(lobe, free), deltas(lobe, free))
        });
        Row {
            name: session.materials.title(entry),
            color: cx.palette.material(entry.slot()),
            reading,
            deltas,
        }
    };
    Report {
        wo,
        wi,
        free,
        rows: session.materials.shown().map(row).collect(),
    }
}

fn spherical(w: Spherical) -> String {
    format!(
        "θ {}  φ {}",
        format::degrees(w.theta_deg),
        format::degrees(w.phi_deg)
    )
}

/// A name and its meaning.
type Named = (&'static str, &'static str);

impl Report {
    fn angles(&self) -> [(Named, Option<Spherical>); 4] {
        let pair = half_difference(self.wo, self.wi);
        let (half, difference) = pair
            .map(|HalfDifference { half, difference }| (half, difference))
            .unzip();
        [
            (
                ("wo", "The direction to the viewer"),
                Some(Spherical::of(self.wo)),
            ),
            (
                ("wi", "The direction to the light"),
                Some(Spherical::of(self.wi)),
            ),
            (
                ("wh", "The half vector of both; none across the surface"),
                half,
            ),
            (
                ("wd", "wi seen from the half vector: the difference angles"),
                difference,
            ),
        ]
    }

    /// The table, with the angles in each row.
    fn csv(&self) -> String {
        let mut text = csv_columns().join(",") + "\n";
        let [wo, wi] = [self.wo, self.wi].map(Spherical::of);
        for row in &self.rows {
            let name = row.name.replace('"', "\"\"");
            let angles = [wo.theta_deg, wo.phi_deg, wi.theta_deg, wi.phi_deg].map(Some);
            let numbers = angles.into_iter().chain(numbers(&row.reading));
            let numbers = numbers.chain(row.deltas.into_iter().flat_map(delta_numbers));
            let numbers = numbers.map(|x| x.map_or_else(String::new, |x| x.to_string()));
            let numbers = numbers.collect::<Vec<_>>().join(",");
            // Writing to a string cannot fail.
            let _ = writeln!(text, "\"{name}\",{numbers}");
        }
        text
    }
}

/// The names of the columns of [`Report::csv`].
fn csv_columns() -> Vec<String> {
    let angles = ["theta_o", "phi_o", "theta_i", "phi_i"];
    let angles = angles.map(|name| names::column(name, "degrees"));
    let of = |quantity: Quantity| {
        let name = move |channel| format!("{}_{channel}", quantity.id());
        CHANNELS.map(|channel| names::column(&name(channel), quantity.unit()))
    };
    let densities = ["pdf", "d"].map(|name| names::column(name, "1/sr"));
    let fresnel = CHANNELS.map(|channel| format!("fresnel_{channel}"));
    let deltas = [Side::Reflection, Side::Transmission].into_iter();
    let deltas = deltas.flat_map(|side| {
        let shares = CHANNELS.map(|channel| format!("delta_{}_{channel}", side.id()));
        let place = ["theta", "phi"].map(|angle| {
            let name = format!("delta_{}_{angle}", side.id());
            names::column(&name, "degrees")
        });
        shares.into_iter().chain(place)
    });
    let first = ["material".to_owned()].into_iter().chain(angles);
    let luminance = names::column("f_luminance", Quantity::F.unit());
    let values = [luminance].into_iter();
    let values = values.chain(of(Quantity::F)).chain(of(Quantity::FCos));
    let factors = densities.into_iter().chain(["g".to_owned()]).chain(fresnel);
    first.chain(values).chain(factors).chain(deltas).collect()
}

/// What the names of channels end in.
const CHANNELS: [&str; 3] = ["r", "g", "b"];

/// The share of a delta, and its direction; nothing where there is none.
fn delta_numbers(delta: Option<DeltaReading>) -> [Option<f64>; 5] {
    delta.map_or([None; 5], |DeltaReading { arrow, .. }| {
        let ([r, g, b], place) = (arrow.flux, Spherical::of(arrow.direction));
        [r, g, b, place.theta_deg, place.phi_deg].map(Some)
    })
}

/// What stands in a cell where there is nothing.
const NOTHING: &str = "-";

/// A delta in the table.
fn delta_text(delta: Option<DeltaReading>) -> String {
    let Some(DeltaReading { arrow, is_here }) = delta else {
        return NOTHING.to_owned();
    };
    let share = widgets_deltas::share(Channel::Luminance.of(arrow.flux));
    let place = spherical(Spherical::of(arrow.direction));
    let here = if is_here { ", here" } else { "" };
    format!("{share} at {place}{here}")
}

/// The numbers of the columns; `None` where a surface has none.
fn numbers(reading: &Reading) -> impl Iterator<Item = Option<f64>> {
    let factors = reading.microfacet.map(|m| {
        let [r, g, b] = m.fresnel.0;
        [m.d, m.g, r, g, b]
    });
    let factors = factors.map_or([None; 5], |factors| factors.map(Some));
    let own = [Channel::Luminance.of(reading.f)]
        .into_iter()
        .chain(reading.f)
        .chain(reading.f_cos)
        .chain([reading.pdf]);
    own.map(Some).chain(factors)
}

/// A column of the table: its name, what it means, and the text of each row.
struct Column {
    name: &'static str,
    meaning: &'static str,
    cells: Vec<String>,
}

impl Report {
    /// The columns of the table; each of those of deltas where a material has one.
    fn columns(&self) -> Vec<Column> {
        let row = |row: &Row| -> Vec<String> {
            let numbers = numbers(&row.reading)
                .map(|number| number.map_or_else(|| NOTHING.to_owned(), format::value));
            row.deltas
                .map(delta_text)
                .into_iter()
                .chain(numbers)
                .collect()
        };
        let rows: Vec<Vec<String>> = self.rows.iter().map(row).collect();
        let cell = |row: &Vec<String>, index: usize| row.get(index).cloned().unwrap_or_default();
        let named = DELTAS.iter().chain(&COLUMNS).enumerate();
        let column = |(index, (name, meaning)): (usize, &Named)| Column {
            name,
            meaning,
            cells: rows.iter().map(|row| cell(row, index)).collect(),
        };
        let is_empty = |column: &Column| column.cells.iter().all(|cell| cell == NOTHING);
        let (deltas, others): (Vec<_>, Vec<_>) =
            named.partition(|(index, _)| *index < DELTAS.len());
        let deltas = deltas.into_iter().map(column);
        let deltas = deltas.filter(|column| !is_empty(column));
        deltas.chain(others.into_iter().map(column)).collect()
    }
}

/// The table.
fn table(ui: &mut Ui, report: &Report) {
    let columns = report.columns();
    if still::is(ui) {
        upright(ui, report, &columns);
        return;
    }

    Grid::new("inspector")
        .striped(true)
        .spacing([14.0, 4.0])
        .show(ui, |ui| {
            ui.label("");
            for column in &columns {
                ui.label(RichText::new(column.name).weak())
                    .on_hover_text(column.meaning);
            }
            ui.end_row();
            for (index, row) in report.rows.iter().enumerate() {
                ui.horizontal(|ui| {
                    draw::swatch(ui, row.color);
                    ui.label(&row.name);
                });
                for column in &columns {
                    let text = column.cells.get(index).map_or("", String::as_str);
                    ui.label(RichText::new(text).monospace());
                }
                ui.end_row();
            }
        });
}

/// The most characters of a name at the head of a column.
const LONGEST_HEAD: usize = 20;

/// Between columns and between rows of the upright table, in points.
const UPRIGHT_SPACING: [f32; 2] = [10.0, 2.0];

/// The table where nobody can scroll: a column for each material, and as many tables as its width asks for.
fn upright(ui: &mut Ui, report: &Report, columns: &[Column]) {
    let width = |text: &str, style: TextStyle| choice::width_of(ui, text, &style);
    let names = columns
        .iter()
        .map(|column| width(column.name, TextStyle::Body));
    let room = ui.available_width() - names.fold(0.0, f32::max);
    let width_of = |(index, row): (usize, &Row)| {
        let cells = columns.iter().filter_map(|column| column.cells.get(index));
        let lines = cells.flat_map(|cell| cell.split(BREAK));
        let cells = lines.map(|line| width(line, TextStyle::Monospace));
        let head = head(row);
        let words = head.lines().map(|word| width(word, TextStyle::Body));
        cells.chain(words).fold(theme::SWATCH.x, f32::max) + UPRIGHT_SPACING[0]
    };
    let widths: Vec<f32> = report.rows.iter().enumerate().map(width_of).collect();
    let (mut start, mut used, mut parts) = (0, 0.0, Vec::new());
    for (index, width) in widths.iter().enumerate() {
        used += width;
        if used > room && index > start {
            parts.push(start..index);
            (start, used) = (index, *width);
        }
    }
    parts.push(start..report.rows.len());
    for part in parts {
        ui.push_id(part.start, |ui| {
            upright_part(ui, report, columns, part);
        });
    }
}

/// Where the text of a cell goes on in another line.
const BREAK: &str = " at ";

/// A name over two lines, as at the head of a column.
fn head(row: &Row) -> String {
    draw::clipped(&row.name, LONGEST_HEAD).replacen(' ', "\n", 1)
}

fn upright_part(ui: &mut Ui, report: &Report, columns: &[Column], part: Range<usize>) {
    Grid::new("inspector")
        .striped(true)
        .spacing(UPRIGHT_SPACING)
        .min_row_height(0.0)
        .show(ui, |ui| {
            ui.label("");
            for row in report.rows.get(part.clone()).unwrap_or_default() {
                ui.vertical(|ui| {
                    draw::swatch(ui, row.color);
                    ui.add(Label::new(head(row)).extend());
                });
            }
            ui.end_row();
            for column in columns {
                ui.label(RichText::new(column.name).weak());
                for cell in column.cells.get(part.clone()).unwrap_or_default() {
                    let text = RichText::new(cell.replace(BREAK, "\n")).monospace();
                    ui.add(Label::new(text).extend());
                }
                ui.end_row();
            }
        });
}
