//! How much work a run of the laws takes.

/// How much work a check may take.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effort {
    /// Some 10^4 samples and 10^5 evaluations per direction: catches a density wrong by 1 %.
    Quick,
    /// 10^6 samples per direction: catches a density wrong by .1 %.
    Thorough,
}

impl Effort {
    /// Strata along each axis of the unit square, two samples in each.
    pub(super) const fn strata(self) -> u32 {
        match self {
            Self::Quick => 48,
            Self::Thorough => 708,
        }
    }

    /// Independent samples of a chi-square test.
    pub(super) const fn samples(self) -> u32 {
        match self {
            Self::Quick => 8192,
            Self::Thorough => 131_072,
        }
    }

    /// Random pairs of directions per law and parameter set.
    pub(super) const fn pairs(self) -> u32 {
        match self {
            Self::Quick => 64,
            Self::Thorough => 1024,
        }
    }
}

/// What a run of the laws shares.
#[derive(Clone, Copy, Debug)]
pub struct Plan {
    /// How much work it may take.
    pub effort: Effort,
    /// Number of chi-square tests of the run, for Sidak's correction.
    pub tests: usize,
}
