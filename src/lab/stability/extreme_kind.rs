//! The extremes, by name.

use serde::{Serialize, Serializer};

/// An extreme that models are taken to. A point is counted under that of its parameters and under that of its directions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum ExtremeKind {
    /// Parameters as they usually are: the defaults, with each word of each choice.
    Usual,
    /// Widths at the narrow end of their range.
    Narrow,
    /// Widths of 1e-8 inside the core, far below their range.
    Core,
    /// One width 1e4 times the other.
    Anisotropic,
    /// Indices from 1e-1 down to 1e-7 on both sides of 1, and 1.
    IndexNearOne,
    /// The smallest and the largest index.
    LargeIndex,
    /// Absorption from none to 1e10.
    Absorbing,
    /// Colours 0 and 1.
    Colours,
    /// All other numbers at the ends of their ranges.
    RangeEnds,
    /// Pairs of the ladder of polar angles, on both sides of the surface.
    Ladder,
    /// Both directions within 1e-4 degrees of the normal.
    Normal,
    /// Both directions within .1 degrees of the horizon.
    Grazing,
    /// A direction in the horizon plane itself.
    Horizon,
    /// wi = wo, and within 1e-7 to 1e-3 of it.
    Retro,
    /// wi = -wo, and within 1e-7 to 1e-3 of it.
    Opposed,
    /// wi in the mirror direction of wo, and within 1e-7 to 1e-3 of it.
    Mirror,
    /// About the critical angle of total reflection.
    Critical,
    /// Components that are subnormal numbers, or become so when squared.
    Subnormal,
    /// Pairs that samples make: inside the lobes, however narrow.
    Sampled,
    /// Samples at the ends of the unit cube and where samplers' inner functions have their poles.
    SamplerEnds,
    /// The two ways of a pair.
    Reciprocity,
    /// Steps of the value along an angle or a parameter, where a formula changes over to another.
    Jumps,
    /// Parameters and directions by chance.
    Random,
    /// The worst points, followed uphill.
    Climb,
    /// Many more points by chance, without the reference: only whether they are finite and not negative.
    Crowd,
}

impl ExtremeKind {
    /// All cases, in the order of reports.
    pub const ALL: [Self; 25] = [
        Self::Usual,
        Self::Narrow,
        Self::Core,
        Self::Anisotropic,
        Self::IndexNearOne,
        Self::LargeIndex,
        Self::Absorbing,
        Self::Colours,
        Self::RangeEnds,
        Self::Ladder,
        Self::Normal,
        Self::Grazing,
        Self::Horizon,
        Self::Retro,
        Self::Opposed,
        Self::Mirror,
        Self::Critical,
        Self::Subnormal,
        Self::Sampled,
        Self::SamplerEnds,
        Self::Reciprocity,
        Self::Jumps,
        Self::Random,
        Self::Climb,
        Self::Crowd,
    ];

    /// The name at the screen.
    #[must_use]
    pub const fn title(self) -> &'static str {
        match self {
            Self::Usual => "Usual parameters",
            Self::Narrow => "Narrowest lobes",
            Self::Core => "Widths inside the core",
            Self::Anisotropic => "Blades",
            Self::IndexNearOne => "Index near 1",
            Self::LargeIndex => "Extreme index",
            Self::Absorbing => "Absorption",
            Self::Colours => "Black and white",
            Self::RangeEnds => "Ends of ranges",
            Self::Ladder => "Polar angles",
            Self::Normal => "About the normal",
            Self::Grazing => "Both grazing",
            Self::Horizon => "In the horizon",
            Self::Retro => "Retro-reflection",
            Self::Opposed => "Opposed directions",
            Self::Mirror => "Mirror direction",
            Self::Critical => "Critical angle",
            Self::Subnormal => "Subnormal numbers",
            Self::Sampled => "Samples",
            Self::SamplerEnds => "Ends of the sampler",
            Self::Reciprocity => "Reciprocity",
            Self::Jumps => "Jumps",
            Self::Random => "Chance",
            Self::Climb => "Worst found by search",
            Self::Crowd => "Crowd",
        }
    }

    /// What it is, a sentence without a full stop.
    #[must_use]
    pub const fn meaning(self) -> &'static str {
        match self {
            Self::Usual => "The defaults, with each word of each choice",
            Self::Narrow => "Widths at the narrow end of their range",
            Self::Core => "Widths of 1e-8, far below their range",
            Self::Anisotropic => "One width up to 1e4 times the other",
            Self::IndexNearOne => "Indices from .1 down to 1e-7 on both sides of 1, and 1",
            Self::LargeIndex => "The smallest and the largest index",
            Self::Absorbing => "Absorption from none to 1e10",
            Self::Colours => "Colours 0 and 1",
            Self::RangeEnds => "Other numbers at the ends of their ranges",
            Self::Ladder => {
                "Pairs of polar angles from the normal to 1e-7 degrees above the horizon, on both sides"
            }
            Self::Normal => "Both directions within 1e-4 degrees of the normal",
            Self::Grazing => "Both directions within .1 degrees of the horizon",
            Self::Horizon => "A direction in the horizon plane itself: nothing is seen there",
            Self::Retro => "wi at wo, and down to 1e-7 from it",
            Self::Opposed => "wi opposed to wo, and down to 1e-7 from that",
            Self::Mirror => "wi in the mirror direction, and down to 1e-7 from it",
            Self::Critical => "About the angle from which all light is reflected",
            Self::Subnormal => "Components next to the smallest numbers there are",
            Self::Sampled => "Pairs that samples make: inside the lobes, however narrow",
            Self::SamplerEnds => "Samples where the sampler's functions end or have their poles",
            Self::Reciprocity => "The two ways of a pair against each other",
            Self::Jumps => "Steps where a formula changes over to another",
            Self::Random => "Parameters and directions by chance",
            Self::Crowd => "Many points by chance, without the reference",
            Self::Climb => "From the worst points on to where the error uses up more of its bound",
        }
    }

    /// Whether its points are values at pairs, held against the reference.
    pub(super) const fn is_of_values(self) -> bool {
        !matches!(
            self,
            Self::SamplerEnds | Self::Reciprocity | Self::Jumps | Self::Crowd
        )
    }

    /// The word for it in reports.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Usual => "usual",
            Self::Narrow => "narrow",
            Self::Core => "core_width",
            Self::Anisotropic => "anisotropic",
            Self::IndexNearOne => "index_near_one",
            Self::LargeIndex => "large_index",
            Self::Absorbing => "absorbing",
            Self::Colours => "colours",
            Self::RangeEnds => "range_ends",
            Self::Ladder => "ladder",
            Self::Normal => "normal",
            Self::Grazing => "grazing",
            Self::Horizon => "horizon",
            Self::Retro => "retro",
            Self::Opposed => "opposed",
            Self::Mirror => "mirror",
            Self::Critical => "critical",
            Self::Subnormal => "subnormal",
            Self::Sampled => "sampled",
            Self::SamplerEnds => "sampler_ends",
            Self::Reciprocity => "reciprocity",
            Self::Jumps => "jumps",
            Self::Random => "random",
            Self::Climb => "climb",
            Self::Crowd => "crowd",
        }
    }
}

impl Serialize for ExtremeKind {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.id())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cases_are_listed_once_each_in_their_order() {
        assert!(ExtremeKind::ALL.is_sorted_by(|a, b| a < b));
        let words: std::collections::BTreeSet<_> =
            ExtremeKind::ALL.map(ExtremeKind::id).into_iter().collect();
        assert_eq!(words.len(), ExtremeKind::ALL.len());
    }
}
