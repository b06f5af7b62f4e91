//! What a chart draws: curves, areas and lines across.

use egui::Color32;
use egui_plot::{LineStyle, MarkerShape};

use crate::theme::Dash;

/// A curve, perhaps in several pieces.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// What it shows.
    pub name: String,
    /// Its colour.
    pub color: Color32,
    /// Its line.
    pub dash: Dash,
    /// Its width in points.
    pub width: f32,
    /// Its pieces: points of x and y.
    pub lines: Vec<Vec<[f64; 2]>>,
}

/// An area between two curves.
#[derive(Clone, Debug, PartialEq)]
pub struct Band {
    /// What it shows.
    pub name: String,
    /// Its colour.
    pub color: Color32,
    /// For each x the lower and the upper y.
    pub points: Vec<[f64; 3]>,
}

/// Single values of one kind.
#[derive(Clone, Debug, PartialEq)]
pub struct Dots {
    /// What they show.
    pub name: String,
    /// Their colour.
    pub color: Color32,
    /// Their shape.
    pub shape: MarkerShape,
    /// Their radius in points.
    pub radius: f32,
    /// Whether they are filled.
    pub is_filled: bool,
    /// x and y.
    pub points: Vec<[f64; 2]>,
}

/// A line across the chart.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// What is there.
    pub name: String,
    /// At which value of its axis.
    pub at: f64,
    /// Its colour.
    pub color: Color32,
    /// Its line.
    pub dash: Dash,
}

/// A Dirac delta: a share of the flux at an x, on a scale of its own.
#[derive(Clone, Debug, PartialEq)]
pub struct Stem {
    /// What stands at its tip.
    pub name: String,
    /// Whose it is, for the read-out; may be empty.
    pub of: String,
    /// At which x.
    pub at: f64,
    /// Its share of the flux; below 0 where another's is taken off.
    pub share: f64,
    /// Its colour.
    pub color: Color32,
    /// Its line: broken where it lies outside what is shown.
    pub dash: Dash,
}

impl Series {
    /// Whether it is 0 everywhere.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.lines.iter().flatten().all(|[_, y]| *y == 0.0)
    }

    /// Its y at `x`, between its points; `None` where it has no piece.
    #[must_use]
    pub fn value_at(&self, x: f64) -> Option<f64> {
        let piece = self.lines.iter().find(|line| {
            let ends = line.first().zip(line.last());
            ends.is_some_and(|([first, _], [last, _])| (*first..=*last).contains(&x))
        })?;
        let after = piece.partition_point(|[at, _]| *at < x);
        let [x1, y1] = *piece.get(after)?;
        let [x0, y0] = *piece.get(after.saturating_sub(1))?;
        Some(if x1 > x0 {
            y0 + (y1 - y0) * (x - x0) / (x1 - x0)
        } else {
            y1
        })
    }
}

/// A line of egui_plot's.
#[must_use]
pub fn style(dash: Dash) -> LineStyle {
    match dash {
        Dash::Solid => LineStyle::Solid,
        Dash::Dashed => LineStyle::dashed_loose(),
        Dash::Dotted => LineStyle::dotted_dense(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn curves_are_read_between_their_points_and_not_beyond() {
        let series = Series {
            name: String::new(),
            color: Color32::WHITE,
            dash: Dash::Solid,
            width: 1.0,
            lines: vec![
                vec![[0.0, 0.0], [1.0, 2.0], [3.0, 2.0]],
                vec![[5.0, 1.0], [6.0, 1.0]],
            ],
        };
        assert_eq!(series.value_at(0.5), Some(1.0));
        assert_eq!(series.value_at(0.0), Some(0.0));
        assert_eq!(series.value_at(3.0), Some(2.0));
        assert_eq!(series.value_at(4.0), None);
        assert_eq!(series.value_at(5.5), Some(1.0));
    }
}
