//! The points as a table: what programs read.

use super::report::{CostUnit, FamilyReport, Point, Report};

/// The names of the columns, with their units.
pub const COLUMNS: [&str; 16] = [
    "family",
    "choice",
    "n",
    "cost_unit",
    "cost_ns",
    "cost_low_ns",
    "cost_high_ns",
    "bytes",
    "error_rms",
    "error_rms_f32",
    "error_max",
    "albedo_error",
    "delta_e",
    "pareto",
    "lost",
    "material",
];

/// A row for each point of `report`; numbers have all their digits, and what does not apply is empty.
#[must_use]
pub fn rows(report: &Report) -> Vec<[String; COLUMNS.len()]> {
    let families = report.families.iter();
    let points = families.flat_map(|family| family.points.iter().map(move |point| (family, point)));
    points.map(|(family, point)| row(family, point)).collect()
}

fn row(family: &FamilyReport, point: &Point) -> [String; COLUMNS.len()] {
    fn text<T: ToString>(value: Option<&T>) -> String {
        value.map(ToString::to_string).unwrap_or_default()
    }
    let [low, high] = point.cost_spread_ns;
    [
        family.id.to_owned(),
        point.choice.clone(),
        text(point.n.as_ref()),
        family.cost_unit.name().to_owned(),
        point.cost_ns.to_string(),
        low.to_string(),
        high.to_string(),
        text(point.bytes.as_ref()),
        point.error_rms.to_string(),
        text(point.error_rms_f32.as_ref()),
        text(point.error_max.as_ref()),
        text(point.albedo_error.as_ref()),
        text(point.delta_e.as_ref()),
        point.pareto.to_string(),
        text(point.lost.as_ref()),
        text(point.material.as_ref().filter(|one| !one.has_data())),
    ]
}

impl CostUnit {
    /// Its name, as in the JSON.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Evaluation => "evaluation",
            Self::Estimate => "estimate",
            Self::Build => "build",
        }
    }
}
