//! The worst of each model, as a table for the documentation.

use std::fmt::Write as _;

use glam::DVec3;

use super::{Extreme, ExtremeKind, Worst};
use crate::specimen::Specimen;
use bxdf::math::Real;
use bxdf::{Component, ModelSpec};

/// What the table says of a model in a precision.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The model's id.
    pub model: String,
    /// The precision.
    pub precision: String,
    /// The largest relative error.
    pub error: f64,
    /// The largest error over what the stability law allows.
    pub ratio: f64,
    /// Where that is; nothing where there is no error.
    pub worst: Option<Worst>,
}

/// The precisions of the table.
const PRECISIONS: [&str; 2] = [f32::NAME, f64::NAME];

/// The head of the table.
const HEAD: &str = "| model | precision | largest error | of its bound | where the ratio is largest |\n\
                    |---|---|---|---|---|\n";

/// The table of what was found of `models`. Widths inside the core, which no material has, are left out, and so are points
/// by chance.
#[must_use]
pub fn table(models: &[(&ModelSpec, &[Extreme])]) -> String {
    let mut text = HEAD.to_owned();
    for (model, extremes) in models {
        for precision in PRECISIONS {
            let row = Row::of(model, precision, extremes);
            // Writing to a string cannot fail.
            let _ = writeln!(
                text,
                "| {} | {} | {:.1e} | {:.2} | {} |",
                row.model,
                row.precision,
                row.error,
                row.ratio,
                row.worst.as_ref().map(place).unwrap_or_default()
            );
        }
    }
    text
}

/// A point in one cell of the table.
fn place(worst: &Worst) -> String {
    let vector = |w: DVec3| format!("{}, {}, {}", w.x, w.y, w.z);
    format!(
        "{} of `{}`; wo `{}`; wi `{}`",
        worst.what,
        worst.params,
        vector(worst.wo),
        vector(worst.wi)
    )
}

impl Row {
    fn of(model: &ModelSpec, precision: &str, extremes: &[Extreme]) -> Self {
        let of_values = extremes.iter().filter(|extreme| {
            let case = extreme.case;
            let is_left_out = matches!(case, ExtremeKind::Core | ExtremeKind::Random);
            extreme.precision == precision && case.is_of_values() && !is_left_out
        });
        let mut row = Self {
            model: model.id.to_owned(),
            precision: precision.to_owned(),
            error: 0.0,
            ratio: 0.0,
            worst: None,
        };
        for extreme in of_values {
            row.error = row.error.max(extreme.max_rel_error);
            if extreme.max_bound_ratio > row.ratio {
                row.ratio = extreme.max_bound_ratio;
                row.worst.clone_from(&extreme.worst);
            }
        }
        row
    }

    /// The row that a line of the table says; `None` for its head and for what is none.
    #[must_use]
    pub fn read(line: &str) -> Option<Self> {
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        let [_, model, precision, error, ratio, place, _] = cells[..] else {
            return None;
        };
        let quoted: Vec<&str> = place.split('`').skip(1).step_by(2).collect();
        let vector = |text: &str| {
            let mut numbers = text.split(", ").map(|number| number.parse().ok());
            Some(DVec3::new(
                numbers.next()??,
                numbers.next()??,
                numbers.next()??,
            ))
        };
        let worst = match quoted[..] {
            [params, wo, wi] => Some(Worst {
                params: params.to_owned(),
                wo: vector(wo)?,
                wi: vector(wi)?,
                what: place.split(' ').next().unwrap_or_default().to_owned(),
            }),
            _ => None,
        };
        Some(Self {
            model: model.to_owned(),
            precision: precision.to_owned(),
            error: error.parse().ok()?,
            ratio: ratio.parse().ok()?,
            worst,
        })
    }

    /// The ratio found anew at the place of this row; `None` where there is none.
    #[must_use]
    pub fn measured_anew(&self) -> Option<f64> {
        let worst = self.worst.as_ref()?;
        let component: Component = worst.params.parse().ok()?;
        let specimen = Specimen::new(component.model(), component.params());
        let pair = (worst.wo, worst.wi);
        let finding = if self.precision == f32::NAME {
            super::point::single(&specimen).compare(pair, 0.0)
        } else {
            super::point::double(&specimen).compare(pair, 0.0)
        };
        Some(finding.ratio)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_read_as_they_are_written() {
        let model = bxdf::Catalogue::current().find("oren_nayar").unwrap();
        let worst = Worst {
            params: "oren_nayar:sigma=90".to_owned(),
            wo: DVec3::new(0.6, 0.0, 0.8),
            wi: DVec3::new(1e-23, -0.5, 0.25),
            what: "f".to_owned(),
        };
        let extreme = |case, ratio| Extreme {
            case,
            precision: f32::NAME,
            n: 7,
            non_finite: 0,
            negative: 0,
            misplaced: 0,
            max_rel_error: 2e-7,
            max_bound_ratio: ratio,
            allowed_ratio: 1.0,
            max_weight: None,
            worst: Some(worst.clone()),
        };
        let found = [
            extreme(ExtremeKind::Retro, 0.25),
            extreme(ExtremeKind::Random, 9.0),
        ];
        let text = table(&[(model, &found)]);
        let rows: Vec<Row> = text.lines().filter_map(Row::read).collect();
        assert_eq!(rows.len(), 2, "{text}");
        assert_eq!((rows[0].error, rows[0].ratio), (2e-7, 0.25));
        assert_eq!(rows[0].worst.as_ref(), Some(&worst));
        assert_eq!((rows[1].error, rows[1].worst.as_ref()), (0.0, None));
        assert!(rows[0].measured_anew().is_some_and(|ratio| ratio < 1.0));
    }
}
