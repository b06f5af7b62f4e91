//! What a map shows: which quantity, how compared, and how laid out.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::analysis::{HeldLobe, Subject};

/// How directions of one side of the surface are laid out over the unit disc, n in the middle.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Projection {
    /// Equal solid angles take equal areas.
    #[default]
    EqualArea,
    /// As seen from far above: areas are solid angles times |cos(theta)|.
    Orthographic,
}

impl Projection {
    /// All projections.
    pub const ALL: [Self; 2] = [Self::EqualArea, Self::Orthographic];

    /// The name at the screen.
    #[must_use]
    pub const fn title(self) -> &'static str {
        match self {
            Self::EqualArea => "Equal area",
            Self::Orthographic => "Orthographic",
        }
    }

    /// The unit vector that stands at `place`, x along s and y along t; `None` outside the unit disc.
    #[must_use]
    pub fn direction(self, place: [f64; 2], is_upper: bool) -> Option<DVec3> {
        let [x, y] = place;
        let square = x * x + y * y;
        let (stretch, z) = match self {
            Self::EqualArea => ((2.0 - square).max(0.0).sqrt(), 1.0 - square),
            Self::Orthographic => (1.0, (1.0 - square).max(0.0).sqrt()),
        };
        let z = if is_upper { z } else { -z };
        (square <= 1.0).then(|| DVec3::new(x * stretch, y * stretch, z))
    }

    /// Where the unit vector `w` stands, whichever side it is on.
    #[must_use]
    pub fn place(self, w: DVec3) -> [f64; 2] {
        let shrink = match self {
            Self::EqualArea => 1.0 / (1.0 + w.z.abs()).sqrt(),
            Self::Orthographic => 1.0,
        };
        [w.x * shrink, w.y * shrink]
    }
}

/// What is shown of a lobe. The density and the weight are those of `sample_f`, which draws the free direction for the
/// held one in wo's place, whichever is held.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Quantity {
    /// f in 1/sr, the held direction in its own place.
    #[default]
    F,
    /// f |cos(theta)| of the free direction, in 1/sr, the held direction in its own place.
    FCos,
    /// The density of the sampler in 1/sr, the same in all channels.
    Pdf,
    /// The weight of a sample, f |cos(theta)| / pdf with the held direction in wo's place; undefined where the density
    /// is 0.
    Weight,
}

impl Quantity {
    /// All quantities.
    pub const ALL: [Self; 4] = [Self::F, Self::FCos, Self::Pdf, Self::Weight];

    /// The name at the screen.
    #[must_use]
    pub const fn title(self) -> &'static str {
        match self {
            Self::F => "f",
            Self::FCos => "f cos",
            Self::Pdf => "pdf",
            Self::Weight => "f cos / pdf",
        }
    }

    /// The word for it in files.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::F => "f",
            Self::FCos => "f_cos",
            Self::Pdf => "pdf",
            Self::Weight => "weight",
        }
    }

    /// f, or f |cos(theta)|.
    #[must_use]
    pub const fn of_f(with_cosine: bool) -> Self {
        if with_cosine { Self::FCos } else { Self::F }
    }

    /// The unit; empty for a number without one.
    #[must_use]
    pub const fn unit(self) -> &'static str {
        match self {
            Self::F | Self::FCos | Self::Pdf => "1/sr",
            Self::Weight => "",
        }
    }

    /// Its values for `lobe` in the directions `free` of one side; NaN where it is undefined.
    fn of(self, lobe: &HeldLobe<'_>, free: &[DVec3], is_upper: bool) -> Vec<[f64; 3]> {
        let densities = || lobe.densities_or_limits(free, is_upper);
        let values = |lobe: &HeldLobe<'_>| lobe.values_or_limits(free, is_upper);
        match self {
            Self::F => values(lobe),
            Self::FCos => with_cosine(values(lobe), free),
            Self::Pdf => densities().into_iter().map(|pdf| [pdf; 3]).collect(),
            Self::Weight => with_cosine(values(&lobe.as_sampled()), free)
                .into_iter()
                .zip(densities())
                .map(|(f_cos, pdf)| {
                    f_cos.map(|f_cos| if pdf > 0.0 { f_cos / pdf } else { f64::NAN })
                })
                .collect(),
        }
    }
}

fn with_cosine(values: Vec<[f64; 3]>, free: &[DVec3]) -> Vec<[f64; 3]> {
    let all = values.into_iter().zip(free);
    all.map(|(f, w)| f.map(|f| f * w.z.abs())).collect()
}

/// How a surface is compared with that of [`Subject::against`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Comparison {
    /// Not at all: the quantity itself.
    #[default]
    None,
    /// The quantity less the other's.
    Difference,
    /// The quantity over the other's: infinite where only the other's is 0, undefined where both are.
    Ratio,
}

impl Comparison {
    /// All comparisons.
    pub const ALL: [Self; 3] = [Self::None, Self::Difference, Self::Ratio];

    /// The name at the screen.
    #[must_use]
    pub const fn title(self) -> &'static str {
        match self {
            Self::None => "None",
            Self::Difference => "Difference",
            Self::Ratio => "Ratio",
        }
    }

    pub(super) fn of(self, value: [f64; 3], other: [f64; 3]) -> [f64; 3] {
        let ([a, b, c], [x, y, z]) = (value, other);
        match self {
            Self::None => value,
            Self::Difference => [a - x, b - y, c - z],
            // 0 / 0 is no number, by the rules of division.
            Self::Ratio => [a / x, b / y, c / z],
        }
    }
}

/// What a map shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Request {
    /// How the disc is laid out.
    pub projection: Projection,
    /// What is shown.
    pub quantity: Quantity,
    /// How it is compared.
    pub comparison: Comparison,
    /// Whether the side of n is shown, or else the one below.
    pub is_upper: bool,
    /// Pixels along either side.
    pub size: usize,
}

impl Request {
    /// The values in the directions `free`, which are on the side shown, per channel; NaN where undefined. `None` where
    /// there is nothing to compare with.
    #[must_use]
    pub fn values(&self, subject: &Subject<'_>, free: &[DVec3]) -> Option<Vec<[f64; 3]>> {
        let of = |lobe: &HeldLobe<'_>| self.quantity.of(lobe, free, self.is_upper);
        if self.comparison == Comparison::None {
            return Some(of(&subject.lobe));
        }
        let pairs = of(&subject.lobe).into_iter().zip(of(&subject.against?));
        Some(pairs.map(|(a, b)| self.comparison.of(a, b)).collect())
    }
}
