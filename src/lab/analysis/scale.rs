//! How a value becomes a length: the channel shown and the radial scale.

use serde::{Deserialize, Serialize};

use bxdf::optics::spectrum::luminance;

/// Which number of a spectrum is shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Channel {
    /// Relative luminance of the three channels.
    #[default]
    Luminance,
    /// The first channel.
    Red,
    /// The second channel.
    Green,
    /// The third channel.
    Blue,
}

impl Channel {
    /// Its letter; the luminance is no channel among others and has none.
    #[must_use]
    pub fn symbol(self) -> Option<&'static str> {
        match self {
            Self::Luminance => None,
            Self::Red => Some("R"),
            Self::Green => Some("G"),
            Self::Blue => Some("B"),
        }
    }

    /// The number of `rgb` that this channel shows.
    #[must_use]
    pub fn of(self, rgb: [f64; 3]) -> f64 {
        let [r, g, b] = rgb;
        match self {
            Self::Luminance => luminance(rgb),
            Self::Red => r,
            Self::Green => g,
            Self::Blue => b,
        }
    }
}

/// How a value maps to a radius.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum RadialScale {
    /// In proportion.
    #[default]
    Linear,
    /// By decades below the largest value; what lies below the last decade has radius 0.
    Logarithmic {
        /// How many decades the radius spans, above 0.
        decades: f64,
    },
}

impl RadialScale {
    /// The radius of `value`, 0..1, 1 at `full` (above 0). A value that is not positive has radius 0.
    #[must_use]
    pub fn radius(self, value: f64, full: f64) -> f64 {
        if value <= 0.0 || full <= 0.0 || value.is_nan() {
            return 0.0;
        }
        match self {
            Self::Linear => value / full,
            Self::Logarithmic { decades } => (1.0 + (value / full).log10() / decades).max(0.0),
        }
    }

    /// The value whose radius is `radius`.
    #[must_use]
    pub fn value(self, radius: f64, full: f64) -> f64 {
        match self {
            Self::Linear => radius * full,
            Self::Logarithmic { decades } => full * 10_f64.powf(decades * (radius - 1.0)),
        }
    }

    /// Whether the scale goes by decades.
    #[must_use]
    pub fn is_logarithmic(self) -> bool {
        matches!(self, Self::Logarithmic { .. })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn radius_and_value_are_inverse() {
        for scale in [
            RadialScale::Linear,
            RadialScale::Logarithmic { decades: 4.0 },
        ] {
            for value in [1e-3, 0.5, 7.0] {
                assert!((scale.value(scale.radius(value, 7.0), 7.0) - value).abs() < 1e-13);
            }
            assert_eq!(scale.radius(0.0, 7.0), 0.0);
            assert_eq!(scale.radius(7.0, 7.0), 1.0);
        }
        assert_eq!(
            RadialScale::Logarithmic { decades: 2.0 }.radius(1e-3, 1.0),
            0.0
        );
        assert_eq!(Channel::Luminance.of([0.5; 3]), 0.5);
    }
}
