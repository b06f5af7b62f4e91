//! What files call the values they hold: one scheme for tables, meshes and the inspector's copy.
//!
//! A column is named by its quantity (`f`, or `f_cos` with the cosine), the channel, and the unit in brackets; what is
//! shown by decades is written as it is, which the unit says: `f_cos_r (1/sr, linear)`. A Dirac delta is no value: its
//! share of the flux has columns of its own, `delta_r` and so on, which are empty in the rows of values, as theirs are in
//! its row.

use crate::session::Session;
use crate::views::Scale;
use bxdf_lab::analysis::Channel;
use bxdf_lab::analysis::hemisphere::Quantity;

/// The channels of a column, with what their names end in.
pub const CHANNELS: [(Channel, &str); 4] = [
    (Channel::Red, "r"),
    (Channel::Green, "g"),
    (Channel::Blue, "b"),
    (Channel::Luminance, "luminance"),
];

/// A quantity with its unit, at the screen; a number without one has none.
#[must_use]
pub(crate) fn with_unit(quantity: &str, unit: &str) -> String {
    let words = [quantity, unit].into_iter().filter(|word| !word.is_empty());
    words.collect::<Vec<_>>().join(", ")
}

/// What the values of a view are called.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Names {
    /// The quantity: `f`, `f_cos`.
    pub quantity: String,
    /// Its unit, and whether it is linear where the view is not; may be empty.
    pub unit: String,
    /// What is given of a delta.
    pub delta: String,
}

impl Names {
    /// Of a quantity with its unit, shown by decades or not.
    pub(crate) fn new(quantity: &str, unit: &str, is_logarithmic: bool) -> Self {
        let linear = if is_logarithmic { "linear" } else { "" };
        let words = [unit, linear].into_iter().filter(|word| !word.is_empty());
        Self {
            quantity: quantity.to_owned(),
            unit: words.collect::<Vec<_>>().join(", "),
            delta: "delta".to_owned(),
        }
    }

    /// Of the polar plot and the 3D lobe.
    #[must_use]
    pub fn of_lobe(session: &Session, scale: Scale) -> Self {
        let quantity = Quantity::of_f(session.with_cosine);
        let is_logarithmic = scale.lengths.is_logarithmic();
        Self::new(quantity.id(), quantity.unit(), is_logarithmic)
    }

    /// The name of the column of a channel.
    #[must_use]
    pub fn column(&self, channel: &str) -> String {
        column(&format!("{}_{channel}", self.quantity), &self.unit)
    }

    /// The names of the columns: `first`, those of the values, those of the deltas.
    #[must_use]
    pub fn columns(&self, first: &[&str]) -> Vec<String> {
        let first = first.iter().map(|name| (*name).to_owned());
        let values = CHANNELS.map(|(_, channel)| self.column(channel));
        let deltas = CHANNELS.map(|(_, channel)| format!("{}_{channel}", self.delta));
        first.chain(values).chain(deltas).collect()
    }
}

/// A column with its unit, if it has one.
#[must_use]
pub fn column(name: &str, unit: &str) -> String {
    if unit.is_empty() {
        name.to_owned()
    } else {
        format!("{name} ({unit})")
    }
}

/// No number in any channel.
const NONE: [f64; CHANNELS.len()] = [f64::NAN; CHANNELS.len()];

fn all(rgb: [f64; 3]) -> [f64; CHANNELS.len()] {
    CHANNELS.map(|(channel, _)| channel.of(rgb))
}

/// The columns of a value.
pub fn value(rgb: [f64; 3]) -> impl Iterator<Item = f64> {
    all(rgb).into_iter().chain(NONE)
}

/// The columns of a delta.
pub fn delta(rgb: [f64; 3]) -> impl Iterator<Item = f64> {
    NONE.into_iter().chain(all(rgb))
}
