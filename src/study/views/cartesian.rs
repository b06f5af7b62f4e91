//! f over an angle.

use serde::{Deserialize, Serialize};

use super::caption::{Caption, Directions};
use super::kind::{Deltas, TableKind, ViewKind, ViewOptions};
use super::scale::Scale;
use super::section::OwnSection;
use crate::answers::Answers;
use crate::export::names::{self, Names};
use crate::export::table::{Table, shown};
use crate::number::{NumberSpec, Numbers};
use crate::session::Session;
use bxdf_lab::analysis::RadialScale;
use bxdf_lab::analysis::cartesian::{Abscissa, Curve, Request};
use bxdf_lab::analysis::hemisphere::Quantity;

pub(super) const KIND: ViewKind = ViewKind {
    id: "cartesian",
    title: "Cartesian plot",
    what_you_see: "The value f over an angle, as papers print it: peaks, tails and what two \
        models differ by",
    says_hidden: true,
    deltas: Deltas::Marked,
    with_cosine: true,
    table: TableKind::Computed,
    is_mesh: false,
};

/// The angle that is held.
pub static FIXED_ANGLE: NumberSpec =
    NumberSpec::new("cartesian.fixed_deg", [0.0, 90.0]).unit("degrees");

/// How f is shown.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(from = "Stored")]
pub struct Options {
    /// Over which angle.
    pub abscissa: Abscissa,
    /// The angle that is held, where there is one: theta_d or theta_h, in degrees.
    pub fixed_deg: f64,
    /// How values become heights.
    #[serde(skip_serializing_if = "Scale::is_first")]
    pub scale: Scale,
    /// Whether the difference from the reference is shown.
    pub is_residual: bool,
    /// A section of its own.
    #[serde(skip_serializing_if = "OwnSection::is_absent")]
    pub own_section_deg: OwnSection,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            abscissa: Abscissa::default(),
            fixed_deg: 30.0,
            scale: Scale::default(),
            is_residual: false,
            own_section_deg: OwnSection::default(),
        }
    }
}

/// The options as files have them: before version 3 the scale was two switches.
#[derive(Deserialize)]
#[serde(default, deny_unknown_fields)]
struct Stored {
    abscissa: Abscissa,
    fixed_deg: f64,
    is_logarithmic: bool,
    is_normalised: bool,
    scale: Scale,
    is_residual: bool,
    own_section_deg: OwnSection,
}

impl Default for Stored {
    fn default() -> Self {
        let first = Options::default();
        Self {
            abscissa: first.abscissa,
            fixed_deg: first.fixed_deg,
            is_logarithmic: false,
            is_normalised: false,
            scale: first.scale,
            is_residual: first.is_residual,
            own_section_deg: first.own_section_deg,
        }
    }
}

impl From<Stored> for Options {
    fn from(stored: Stored) -> Self {
        let mut scale = stored.scale;
        scale.set_logarithmic(stored.is_logarithmic || scale.lengths.is_logarithmic());
        scale.is_each_to_peak |= stored.is_normalised;
        Self {
            abscissa: stored.abscissa,
            fixed_deg: stored.fixed_deg,
            scale,
            is_residual: stored.is_residual,
            own_section_deg: stored.own_section_deg,
        }
    }
}

impl Options {
    /// The curve; its residual is that against the reference.
    #[must_use]
    pub fn request(&self, session: &Session) -> Request {
        Request {
            abscissa: self.abscissa,
            fixed_deg: self.fixed_deg,
            phi: self.own_section_deg.of(session).phi(),
            with_cosine: session.with_cosine,
            scale: if self.is_residual {
                RadialScale::Linear
            } else {
                self.scale.lengths
            },
            is_residual: self.is_residual,
        }
    }

    /// What is drawn upwards, with its unit.
    #[must_use]
    pub fn quantity(&self, session: &Session) -> String {
        let quantity = if session.with_cosine {
            "f |cos θ|"
        } else {
            "f"
        };
        let reference = session.materials.title(session.materials.reference());
        match (self.is_residual, self.scale.is_each_to_peak) {
            (false, false) => format!("{quantity} (1/sr)"),
            (false, true) => format!("{quantity} over its peak"),
            (true, false) => format!("{quantity} less that of {reference} (1/sr)"),
            (true, true) => format!("{quantity} less that of {reference}, over its peak"),
        }
    }

    /// What the values are called.
    fn names(&self, session: &Session) -> Names {
        let is_logarithmic = self.request(session).scale.is_logarithmic();
        let quantity = Quantity::of_f(session.with_cosine);
        let compared = if self.is_residual { "_difference" } else { "" };
        let (over, unit) = if self.scale.is_each_to_peak {
            ("_over_peak", "")
        } else {
            ("", quantity.unit())
        };
        let name = format!("{}{compared}{over}", quantity.id());
        Names {
            delta: format!("delta{compared}"),
            ..Names::new(&name, unit, is_logarithmic)
        }
    }
}

impl ViewOptions for Options {
    fn caption(&self, session: &Session) -> Caption {
        Caption::of(self.quantity(session)).at(if self.is_of_held() {
            Directions::Both
        } else {
            Directions::None
        })
    }

    fn is_of_held(&self) -> bool {
        self.abscissa == Abscissa::Free
    }

    fn own_section(&mut self) -> Option<&mut OwnSection> {
        Some(&mut self.own_section_deg)
    }

    fn numbers(&mut self) -> Numbers<'_> {
        let mut all = vec![(&FIXED_ANGLE, &mut self.fixed_deg)];
        all.extend(self.scale.numbers());
        all.extend(self.own_section_deg.number());
        all
    }

    /// The curve.
    fn table(&self, session: &Session, answers: &mut Answers) -> Table {
        let angle = match self.abscissa {
            Abscissa::Free => "angle (degrees)",
            Abscissa::Half => "theta_h (degrees)",
            Abscissa::Difference => "theta_d (degrees)",
        };
        let names = self.names(session);
        let mut table = Table::named(names.columns(&["material", angle]));
        let reference = self.is_residual.then(|| session.materials.reference());
        for (entry, title) in shown(session) {
            let curve = answers.compare(session, entry, reference, self.request(session));
            let peaks = self.scale.is_each_to_peak.then(|| peaks(&curve));
            for point in curve.lines.iter().flatten() {
                let row = names::value(point.value);
                let over = |(index, x): (usize, f64)| {
                    let peak = peaks.and_then(|peaks| peaks.get(index).copied());
                    x / peak.filter(|peak| *peak > 0.0).unwrap_or(1.0)
                };
                let row = row.enumerate().map(over);
                table.push(&title, std::iter::once(point.x_deg).chain(row));
            }
            table.push_stems(&title, &curve.stems);
        }
        table
    }
}

/// The largest magnitude of each channel of a curve.
fn peaks(curve: &Curve) -> [f64; names::CHANNELS.len()] {
    names::CHANNELS.map(|(channel, _)| {
        let points = curve.lines.iter().flatten();
        let values = points.map(|point| channel.of(point.value).abs());
        values.fold(0.0, f64::max)
    })
}
