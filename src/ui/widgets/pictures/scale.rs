//! How values become colours.

use egui::{Color32, ColorImage};

use crate::theme;
use bxdf_lab::analysis::hemisphere::contour;
use bxdf_lab::analysis::raster::Raster;

/// How values become colours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ColorScale {
    /// The values at the ends, the lower one first.
    pub range: [f64; 2],
    /// What lies between.
    pub kind: ScaleKind,
}

/// How a [`ColorScale`] goes from end to end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ScaleKind {
    /// In proportion.
    Linear,
    /// By decades; both ends are above 0.
    Logarithmic,
    /// In proportion, from one colour over a neutral one at the middle to another.
    Diverging,
    /// By decades about the middle, which is 1: for ratios.
    DivergingLogarithmic,
}

impl ColorScale {
    /// Whether it goes by decades.
    fn is_logarithmic(self) -> bool {
        matches!(
            self.kind,
            ScaleKind::Logarithmic | ScaleKind::DivergingLogarithmic
        )
    }

    /// Where `value` lies between the ends, 0..1; beyond them at the nearer one.
    #[must_use]
    pub fn share(self, value: f64) -> f64 {
        let place = |x: f64| if self.is_logarithmic() { x.ln() } else { x };
        let [low, high] = self.range.map(place);
        let span = high - low;
        if span > 0.0 {
            ((place(value) - low) / span).clamp(0.0, 1.0)
        } else {
            0.5
        }
    }

    /// The value at this share.
    #[must_use]
    pub fn value(self, share: f64) -> f64 {
        let [low, high] = self.range;
        if self.is_logarithmic() {
            low * (high / low).powf(share)
        } else {
            low + share * (high - low)
        }
    }

    /// Round values to be written beside the colours, ascending.
    #[must_use]
    pub fn ticks(self) -> Vec<f64> {
        let [low, high] = self.range;
        let mut ticks = match self.kind {
            ScaleKind::Diverging => vec![low, 0.5 * low, 0.0, 0.5 * high, high],
            ScaleKind::DivergingLogarithmic => vec![low, low.sqrt(), 1.0, high.sqrt(), high],
            ScaleKind::Linear => contour::levels(low, high, false),
            ScaleKind::Logarithmic => contour::levels(low, high, true),
        };
        if ticks.len() < 2 {
            ticks = vec![low, high];
        }
        ticks
    }

    /// The colour of a value; none where there is no value.
    #[must_use]
    pub fn color(self, value: f64) -> Color32 {
        if value.is_nan() {
            return Color32::TRANSPARENT;
        }
        let share = self.share(value);
        match self.kind {
            ScaleKind::Linear | ScaleKind::Logarithmic => theme::viridis_color(share),
            ScaleKind::Diverging | ScaleKind::DivergingLogarithmic => theme::diverging_color(share),
        }
    }

    /// The picture of these values.
    #[must_use]
    pub fn paint(self, values: &Raster<f64>) -> ColorImage {
        let pixels = values.pixels.iter().map(|value| self.color(*value));
        ColorImage::new([values.width, values.height], pixels.collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scales_and_their_inverses_agree() {
        for (kind, range) in [
            (ScaleKind::Linear, [0.0, 4.0]),
            (ScaleKind::Logarithmic, [1e-3, 10.0]),
            (ScaleKind::Diverging, [-2.0, 2.0]),
            (ScaleKind::DivergingLogarithmic, [0.1, 10.0]),
        ] {
            let scale = ColorScale { range, kind };
            for share in [0.0, 0.3, 1.0] {
                assert!(
                    (scale.share(scale.value(share)) - share).abs() < 1e-12,
                    "{kind:?}"
                );
            }
        }
        let decades = ColorScale {
            range: [1e-3, 10.0],
            kind: ScaleKind::Logarithmic,
        };
        assert_eq!(decades.share(0.0), 0.0, "nothing lies at the low end");
        assert_eq!(decades.color(f64::NAN), Color32::TRANSPARENT);
    }
}
