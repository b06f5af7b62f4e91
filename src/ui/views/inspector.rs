//! The inspector: every material's numbers at the cursor.

use std::fmt::Write as _;

use egui::{Grid, RichText, ScrollArea, Ui};
use glam::DVec3;

use super::{ViewContext, ViewSpec};
use crate::analysis::half_difference::{HalfDifference, Spherical, half_difference};
use crate::analysis::inspector::Reading;
use crate::ui::format;
use crate::ui::widgets::draw;

/// The list entry.
pub(super) const SPEC: ViewSpec = ViewSpec {
    id: "inspector",
    title: "Inspector",
    is_of_held: |_| true,
    what_you_see: "Every material's numbers at the held direction and the one last pointed at \
        in any view; at first the mirror direction",
    show,
    table: None,
    is_mesh: false,
};

/// The columns of numbers: name and meaning.
const COLUMNS: [(&str, &str); 12] = [
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

/// A pair of directions and what each material does there.
struct Report {
    wo: DVec3,
    wi: DVec3,
    rows: Vec<(String, egui::Color32, Reading)>,
}

fn show(ui: &mut Ui, cx: &mut ViewContext<'_>) {
    let report = report(cx);
    let area = ScrollArea::both().auto_shrink([false, false]);
    area.show(ui, |ui| {
        ui.horizontal_wrapped(|ui| {
            for (name, w) in report.angles() {
                ui.label(RichText::new(name.0).strong())
                    .on_hover_text(name.1);
                let text = w.map_or_else(|| "-".to_owned(), spherical);
                ui.label(text);
                ui.add_space(8.0);
            }
            let hint = "Copy the table as comma-separated values, with all digits";
            if ui.small_button("Copy").on_hover_text(hint).clicked() {
                ui.ctx().copy_text(report.csv());
            }
        });
        table(ui, &report);
    });
}

/// The readings at the cursor; at the mirror direction before anything was pointed at.
fn report(cx: &mut ViewContext<'_>) -> Report {
    let session = &*cx.session;
    let (wo, wi) = cx.pair();
    let row = |entry| {
        let surface = cx.data.surface(session, entry);
        let color = cx.palette.material(entry.slot());
        (
            session.materials.title(entry),
            color,
            Reading::of(&*surface.bxdf, wo, wi),
        )
    };
    Report {
        wo,
        wi,
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
        let mut text = String::from(
            "material,theta_o_deg,phi_o_deg,theta_i_deg,phi_i_deg,f_r,f_g,f_b,f_cos_r,f_cos_g,f_cos_b,pdf,d,g,fresnel_r,fresnel_g,fresnel_b\n",
        );
        let [wo, wi] = [self.wo, self.wi].map(Spherical::of);
        for (name, _, reading) in &self.rows {
            let name = name.replace('"', "\"\"");
            let angles = [wo.theta_deg, wo.phi_deg, wi.theta_deg, wi.phi_deg].map(Some);
            let numbers = angles.into_iter().chain(numbers(reading));
            let numbers = numbers.map(|x| x.map_or_else(String::new, |x| x.to_string()));
            let numbers = numbers.collect::<Vec<_>>().join(",");
            // Writing to a string cannot fail.
            let _ = writeln!(text, "\"{name}\",{numbers}");
        }
        text
    }
}

/// The numbers of the columns; `None` where a surface has none.
fn numbers(reading: &Reading) -> impl Iterator<Item = Option<f64>> {
    let factors = reading.microfacet.map(|m| {
        let [r, g, b] = m.fresnel.0;
        [m.d, m.g, r, g, b]
    });
    let factors = factors.map_or([None; 5], |factors| factors.map(Some));
    let own = reading
        .f
        .into_iter()
        .chain(reading.f_cos)
        .chain([reading.pdf]);
    own.map(Some).chain(factors)
}

fn table(ui: &mut Ui, report: &Report) {
    Grid::new("inspector")
        .striped(true)
        .spacing([14.0, 4.0])
        .show(ui, |ui| {
            ui.label("");
            for (name, meaning) in COLUMNS {
                ui.label(RichText::new(name).weak()).on_hover_text(meaning);
            }
            ui.end_row();
            for (name, color, reading) in &report.rows {
                ui.horizontal(|ui| {
                    draw::swatch(ui, *color);
                    ui.label(name);
                });
                for number in numbers(reading) {
                    let text = number.map_or_else(|| "-".to_owned(), format::value);
                    ui.label(RichText::new(text).monospace());
                }
                ui.end_row();
            }
        });
}
