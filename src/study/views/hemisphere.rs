//! The disc of directions.

use serde::{Deserialize, Serialize};

use super::caption::{Caption, Subjects};
use super::kind::{Deltas, MAP_SIZE, TableKind, ViewKind, ViewOptions};
use crate::answers::Answers;
use crate::export::names::{self, Names};
use crate::export::table::{Table, shown};
use crate::session::Session;
use bxdf_lab::analysis::hemisphere::{Comparison, Projection, Quantity, Request};

pub(super) const KIND: ViewKind = ViewKind {
    id: "hemisphere",
    title: "Hemisphere",
    what_you_see: "The value in every direction of one side: n in the middle, the horizon at \
        the rim, colours for values",
    says_hidden: true,
    deltas: Deltas::Marked,
    with_cosine: false,
    table: TableKind::Computed,
    is_mesh: false,
};

/// What the disc of directions shows.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Options {
    /// How directions are projected onto the disc.
    pub projection: Projection,
    /// Which number is shown.
    pub quantity: Quantity,
    /// With the reference, or by itself.
    pub comparison: Comparison,
    /// Whether colours go by decades.
    pub is_logarithmic: bool,
    /// Whether lines of equal value are drawn.
    pub has_contours: bool,
    /// Whether the lower half is shown, in place of the upper one.
    pub is_lower: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            projection: Projection::default(),
            quantity: Quantity::default(),
            comparison: Comparison::default(),
            is_logarithmic: true,
            has_contours: true,
            is_lower: false,
        }
    }
}

impl Options {
    /// The map; its comparison is that with the reference.
    #[must_use]
    pub fn request(&self) -> Request {
        Request {
            projection: self.projection,
            quantity: self.quantity,
            comparison: self.comparison,
            is_upper: !self.is_lower,
            size: MAP_SIZE,
        }
    }

    /// What the colours mean, with the unit.
    #[must_use]
    pub fn quantity_name(&self) -> String {
        let (title, unit) = (self.quantity.title(), self.quantity.unit());
        match self.comparison {
            Comparison::Ratio => format!("ratio of {title}"),
            Comparison::Difference => names::with_unit(&format!("difference of {title}"), unit),
            Comparison::None => names::with_unit(title, unit),
        }
    }

    /// What the values are called.
    fn names(self) -> Names {
        let quantity = self.quantity;
        let (compared, unit) = match self.comparison {
            Comparison::None => ("", quantity.unit()),
            Comparison::Difference => ("_difference", quantity.unit()),
            Comparison::Ratio => ("_ratio", ""),
        };
        let is_logarithmic = self.is_logarithmic && self.comparison == Comparison::None;
        let delta = match quantity {
            Quantity::F | Quantity::FCos => "delta",
            Quantity::Pdf => "delta_probability",
            Quantity::Weight => "delta_weight",
        };
        Names {
            delta: format!("{delta}{compared}"),
            ..Names::new(
                &format!("{}{compared}", quantity.id()),
                unit,
                is_logarithmic,
            )
        }
    }
}

impl ViewOptions for Options {
    fn caption(&self, _: &Session) -> Caption {
        Caption::of(self.quantity_name()).naming(Subjects::Apart)
    }

    /// The pixels of the disc, and the deltas on its side.
    fn table(&self, session: &Session, answers: &mut Answers) -> Table {
        let columns = ["material", "w_x", "w_y", "w_z"];
        let mut table = Table::named(self.names().columns(&columns));
        let request = self.request();
        let is_compared = request.comparison != Comparison::None;
        let reference = is_compared.then(|| session.materials.reference());
        for (entry, title) in shown(session) {
            let map = answers.compare(session, entry, reference, request);
            let (width, height) = (map.raster.width, map.raster.height);
            for (index, rgb) in map.raster.pixels.iter().enumerate() {
                let place = |index: usize, n: usize| 2.0 * (index as f64 + 0.5) / n as f64 - 1.0;
                let place = [place(index % width, width), -place(index / width, height)];
                if let Some(w) = request.projection.direction(place, request.is_upper) {
                    table.push_value(&title, w.to_array(), *rgb);
                }
            }
            for delta in &map.deltas {
                if (delta.direction.z > 0.0) == request.is_upper {
                    table.push_delta(&title, delta.direction.to_array(), delta.value);
                }
            }
        }
        table
    }
}
