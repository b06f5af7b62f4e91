//! f over the angles of half vector and difference.

use serde::{Deserialize, Serialize};

use super::caption::{Caption, Directions, Subjects};
use super::kind::{Deltas, MAP_SIZE, TableKind, ViewKind, ViewOptions};
use super::section::OwnSection;
use crate::answers::Answers;
use crate::export::names::Names;
use crate::export::table::{Table, shown};
use crate::format;
use crate::number::{NumberSpec, Numbers};
use crate::session::Session;
use bxdf_lab::analysis::Subject;
use bxdf_lab::analysis::hemisphere::Quantity;
use bxdf_lab::analysis::slice::{Request, Slice, mirrored_at};

pub(super) const KIND: ViewKind = ViewKind {
    id: "slice",
    title: "Slice",
    what_you_see: "f over the angles of half vector (to the right) and difference (upwards): \
        the fingerprint of a material",
    says_hidden: true,
    deltas: Deltas::Marked,
    with_cosine: false,
    table: TableKind::Computed,
    is_mesh: false,
};

/// The azimuth of the difference vector: beyond half a turn the directions change places.
pub static DIFFERENCE_AZIMUTH: NumberSpec =
    NumberSpec::new("slice.phi_d_deg", [0.0, 180.0]).unit("degrees");

/// How the slice is shown.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Options {
    /// The azimuth of the difference vector, in degrees; 90 holds the half vector in the plane of both directions.
    pub phi_d_deg: f64,
    /// Whether theta_h is spaced by its square root.
    pub is_square_root: bool,
    /// Whether colours go by decades.
    pub is_logarithmic: bool,
    /// Whether the regions are named.
    pub has_regions: bool,
    /// A section of its own, which holds the half vector.
    #[serde(skip_serializing_if = "OwnSection::is_absent")]
    pub own_section_deg: OwnSection,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            phi_d_deg: 90.0,
            is_square_root: false,
            is_logarithmic: true,
            has_regions: true,
            own_section_deg: OwnSection::default(),
        }
    }
}

impl Options {
    /// The slice, at the azimuth of the section.
    #[must_use]
    pub fn request(&self, session: &Session) -> Request {
        Request {
            phi_d_deg: self.phi_d_deg,
            phi_h_deg: self.own_section_deg.of(session).azimuth_deg,
            is_square_root: self.is_square_root,
            size: MAP_SIZE,
        }
    }

    /// What the values are called: it is of f whatever the other views show.
    fn names(&self) -> Names {
        let quantity = Quantity::F;
        Names::new(quantity.id(), quantity.unit(), self.is_logarithmic)
    }
}

impl ViewOptions for Options {
    fn caption(&self, _: &Session) -> Caption {
        let phi_d = format::degrees(self.phi_d_deg);
        Caption::of(format!("f (1/sr) at φd {phi_d}"))
            .naming(Subjects::Apart)
            .at(Directions::None)
    }

    fn is_of_held(&self) -> bool {
        false
    }

    fn own_section(&mut self) -> Option<&mut OwnSection> {
        Some(&mut self.own_section_deg)
    }

    fn numbers(&mut self) -> Numbers<'_> {
        let mut all = vec![(&DIFFERENCE_AZIMUTH, &mut self.phi_d_deg)];
        all.extend(self.own_section_deg.number());
        all
    }

    /// Its pixels that lie above the surface, and what is mirrored at each theta_d.
    fn table(&self, session: &Session, answers: &mut Answers) -> Table {
        let columns = ["material", "theta_h (degrees)", "theta_d (degrees)"];
        let mut table = Table::named(self.names().columns(&columns));
        let request = self.request(session);
        for (entry, title) in shown(session) {
            let Slice { raster } = &*answers.ask(session, entry, request);
            let share = |index: usize, n: usize| (index as f64 + 0.5) / n as f64;
            let theta_d = |row: usize| 90.0 * (1.0 - share(row, raster.height));
            for (index, rgb) in raster.pixels.iter().enumerate() {
                let x = share(index % raster.width, raster.width);
                let theta_h = 90.0 * if request.is_square_root { x * x } else { x };
                if rgb.iter().all(|x| x.is_finite()) {
                    table.push_value(&title, [theta_h, theta_d(index / raster.width)], *rgb);
                }
            }
            for theta_d in (0..raster.height).map(theta_d) {
                let of = |subject: &Subject<'_>| mirrored_at(&request, subject, theta_d);
                if let Some(flux) = answers.with_subject(session, entry, of) {
                    table.push_delta(&title, [0.0, theta_d], flux);
                }
            }
        }
        table
    }
}
