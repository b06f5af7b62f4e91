//! The share of light that leaves.

use serde::{Deserialize, Serialize};

use super::caption::{Caption, Directions, Subjects};
use super::kind::{Deltas, TableKind, ViewKind, ViewOptions};
use super::words::words;
use crate::answers::Answers;
use crate::export::table::{Table, Value, shown};
use crate::session::Session;
use bxdf_lab::analysis::reflectance::CurveRequest;

pub(super) const KIND: ViewKind = ViewKind {
    id: "reflectance",
    title: "Reflectance",
    what_you_see: "The share of the light arriving at an angle that leaves, in all directions \
        together: above 1 energy is created",
    says_hidden: true,
    deltas: Deltas::Summed,
    with_cosine: false,
    table: TableKind::Computed,
    is_mesh: false,
};

words! {
    /// What the reflectance is split into.
    Split {
        /// Not at all.
        #[default]
        Total = "Total",
        /// Reflection and transmission.
        Side = "Side",
        /// Diffuse, glossy, perfect specular, retro-reflective.
        Category = "Category",
        /// Each lobe by itself.
        Lobe = "Lobe",
    }
}

/// How the reflectance is shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Options {
    /// Into which parts.
    pub split: Split,
    /// Whether what is missing from 1 is shown instead.
    pub is_furnace: bool,
}

impl Options {
    /// What is shown.
    #[must_use]
    pub fn quantity(&self) -> &'static str {
        if self.is_furnace && self.split == Split::Total {
            "1 - ρ, share missing"
        } else {
            "ρ, share that leaves"
        }
    }
}

/// The reflectance over the angle of incidence, at the azimuth of the held direction: a value for each degree, with a tenth
/// of the error that a curve of its width shows.
#[must_use]
pub fn request(session: &Session) -> CurveRequest {
    CurveRequest {
        phi_deg: session.phi_deg,
        angles: 91,
        tolerance: 1e-4,
        max_evaluations: 400_000,
    }
}

impl ViewOptions for Options {
    fn caption(&self, _: &Session) -> Caption {
        Caption::of(self.quantity())
            .naming(Subjects::Legend)
            .at(Directions::Held)
    }

    fn is_of_held(&self) -> bool {
        false
    }

    /// What each lobe does at each angle.
    fn table(&self, session: &Session, answers: &mut Answers) -> Table {
        let mut table = Table::new(&[
            "material",
            "category",
            "side",
            "lobe",
            "theta_i (degrees)",
            "rho_r",
            "rho_g",
            "rho_b",
            "error",
        ]);
        for (entry, title) in shown(session) {
            let curve = answers.ask(session, entry, request(session));
            for row in &curve.rows {
                for share in &row.shares {
                    let [r, g, b] = share.value;
                    let lobe = share.lobe;
                    let words = [&title, lobe.category.id(), lobe.side.id(), lobe.name];
                    let mut cells: Vec<Value> =
                        words.map(|word| Value::Text(word.to_owned())).into();
                    cells.extend([row.theta_deg, r, g, b, share.error].map(Value::Number));
                    table.rows.push(cells);
                }
            }
        }
        table
    }
}
