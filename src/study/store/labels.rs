//! The size of the labels of plots.

use serde::{Deserialize, Serialize};

/// How large the labels of plots are, for one who sits far away.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum LabelSize {
    /// As other text.
    #[default]
    Normal,
    /// A quarter larger.
    Larger,
    /// Half as large again.
    Large,
    /// Twice as large.
    Double,
}

impl LabelSize {
    /// Every size, from the smallest.
    pub const ALL: [Self; 4] = [Self::Normal, Self::Larger, Self::Large, Self::Double];

    /// In percent of other text.
    #[must_use]
    pub const fn percent(self) -> u16 {
        match self {
            Self::Normal => 100,
            Self::Larger => 125,
            Self::Large => 150,
            Self::Double => 200,
        }
    }

    /// The next larger one; behind the largest the smallest.
    #[must_use]
    pub fn next(self) -> Self {
        let mut all = Self::ALL.into_iter().cycle();
        all.find(|size| *size == self);
        all.next().unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_come_round() {
        let mut size = LabelSize::default();
        let shown = [(); 5].map(|()| {
            let percent = size.percent();
            size = size.next();
            percent
        });
        assert_eq!(shown, [100, 125, 150, 200, 100]);
    }
}
