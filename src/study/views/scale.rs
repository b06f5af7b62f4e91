//! How the values of a view become lengths.

use serde::{Deserialize, Serialize};

use super::caption::Subjects;
use crate::number::{NumberSpec, Numbers};
use bxdf_lab::analysis::RadialScale;

/// How many decades a logarithmic scale shows.
pub const DECADES: f64 = 4.0;

/// Those of a file: beyond 16 a double has no digits left to show.
static DECADES_SPEC: NumberSpec = NumberSpec::new("scale.lengths.logarithmic.decades", [1.0, 16.0]);

/// The value at the full length: from where nothing is seen to the peaks of the narrowest lobes.
static FULL: NumberSpec = NumberSpec::new("scale.locked_at", [1e-12, 1e12]);

/// How values become lengths.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Scale {
    /// In proportion, or by decades.
    pub lengths: RadialScale,
    /// Whether each material has the full length at its own peak; else all share one scale.
    pub is_each_to_peak: bool,
    /// The value at the full length, where it stays whatever is shown.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub locked_at: Option<f64>,
}

/// The choices of a scale that have a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ScaleChoice {
    /// One for all, in proportion.
    Same,
    /// Each material to its own peak, in proportion.
    EachToPeak,
    /// By decades.
    Logarithmic,
}

impl ScaleChoice {
    /// All of them, in the order of the window.
    pub const ALL: [Self; 3] = [Self::Same, Self::EachToPeak, Self::Logarithmic];

    /// Its name at the screen.
    #[must_use]
    pub fn title(self) -> &'static str {
        match self {
            Self::Same => "Same scale",
            Self::EachToPeak => "Each to its peak",
            Self::Logarithmic => "Logarithmic",
        }
    }
}

impl Scale {
    /// By decades, or in proportion.
    #[must_use]
    pub fn of(lengths: RadialScale) -> Self {
        Self {
            lengths,
            ..Self::default()
        }
    }

    /// Which of the named choices it is.
    #[must_use]
    pub fn choice(self) -> ScaleChoice {
        match (self.lengths, self.is_each_to_peak) {
            (RadialScale::Logarithmic { .. }, _) => ScaleChoice::Logarithmic,
            (RadialScale::Linear, true) => ScaleChoice::EachToPeak,
            (RadialScale::Linear, false) => ScaleChoice::Same,
        }
    }

    /// Goes over to one of the named choices. A value locked for lengths of another kind is given up.
    pub fn choose(&mut self, choice: ScaleChoice) {
        if choice != self.choice() {
            *self = Self {
                lengths: match choice {
                    ScaleChoice::Logarithmic => RadialScale::Logarithmic { decades: DECADES },
                    ScaleChoice::Same | ScaleChoice::EachToPeak => RadialScale::Linear,
                },
                is_each_to_peak: choice == ScaleChoice::EachToPeak,
                locked_at: None,
            };
        }
    }

    /// Goes by decades, or in proportion.
    pub fn set_logarithmic(&mut self, is_logarithmic: bool) {
        if is_logarithmic != self.lengths.is_logarithmic() {
            self.choose(if is_logarithmic {
                ScaleChoice::Logarithmic
            } else {
                ScaleChoice::Same
            });
        }
    }

    /// Keeps the full length at this value, or lets it follow what is shown.
    pub fn lock(&mut self, at: Option<f64>) {
        self.locked_at = at.map(|at| {
            let mut allowed = 1.0;
            FULL.put(&mut allowed, at);
            allowed
        });
    }

    /// Whether it is the one that views have at first.
    pub(super) fn is_first(&self) -> bool {
        *self == Self::default()
    }

    /// Its numbers.
    pub(super) fn numbers(&mut self) -> Numbers<'_> {
        let mut all = Vec::new();
        if let RadialScale::Logarithmic { decades } = &mut self.lengths {
            all.push((&DECADES_SPEC, decades));
        }
        all.extend(self.locked_at.as_mut().map(|at| (&FULL, at)));
        all
    }
}

/// How several materials stand in a view.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Arrangement {
    /// All in one picture.
    #[default]
    Overlaid,
    /// Each in a picture of its own, with the same directions.
    SideBySide,
}

impl Arrangement {
    /// Both, in the order of the window.
    pub const ALL: [Self; 2] = [Self::Overlaid, Self::SideBySide];

    /// Its name at the screen.
    #[must_use]
    pub fn title(self) -> &'static str {
        match self {
            Self::Overlaid => "Overlaid",
            Self::SideBySide => "Side by side",
        }
    }

    /// Where materials are named that are named so in one picture.
    pub(super) const fn subjects(self, overlaid: Subjects) -> Subjects {
        match self {
            Self::Overlaid => overlaid,
            Self::SideBySide => Subjects::Apart,
        }
    }

    /// Whether it is the one that views have at first.
    #[expect(
        clippy::trivially_copy_pass_by_ref,
        reason = "serde hands over a reference"
    )]
    pub(super) fn is_first(&self) -> bool {
        *self == Self::default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_choice_is_what_it_says() {
        let mut scale = Scale::default();
        for choice in ScaleChoice::ALL {
            scale.choose(choice);
            assert_eq!(scale.choice(), choice);
        }
        scale.lock(Some(2.5));
        let locked = scale;
        scale.choose(ScaleChoice::Logarithmic);
        assert_eq!(scale, locked, "chosen already");
        scale.choose(ScaleChoice::Same);
        assert_eq!(scale, Scale::default());
        scale.lock(Some(0.0));
        assert_eq!(scale.locked_at, Some(1e-12));
    }

    #[test]
    fn a_scale_of_its_own_by_decades_keeps_what_it_is() {
        let mut scale = Scale {
            is_each_to_peak: true,
            ..Scale::of(RadialScale::Logarithmic { decades: 6.0 })
        };
        let before = scale;
        scale.set_logarithmic(true);
        assert_eq!(scale, before);
        scale.set_logarithmic(false);
        assert_eq!(scale.choice(), ScaleChoice::Same);
    }
}
