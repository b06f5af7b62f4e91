//! Where digits are lost.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use super::caption::{Caption, Directions, Subjects};
use super::kind::{Deltas, TableKind, ViewKind, ViewOptions};
use super::words::words;
use crate::answers::Answers;
use crate::export::table::Table;
use crate::session::Session;
use bxdf_lab::formula_comparison::{self, Comparison, CurveRequest, MapRequest};
use bxdf_lab::stability::map::{Axis, Place, Request};

pub(super) const KIND: ViewKind = ViewKind {
    id: "stability",
    title: "Stability",
    what_you_see: "How far f32 and f64 are off, over two angles or parameters: bright where digits \
        are lost, contours where the inputs themselves explain it",
    says_hidden: false,
    deltas: Deltas::Told,
    with_cosine: false,
    table: TableKind::Computed,
    is_mesh: false,
};

/// Pixels along either side of a map of errors.
const SIZE: usize = 96;

words! {
    /// What the stability view shows.
    Plot {
        /// Errors of the selected material over two axes.
        #[default]
        Map = "This material",
        /// The errors of textbooks' formulas and of the core's.
        Formulas = "Formulas compared",
        /// Which Fresnel term a diffuse part under a coat is multiplied by, and what each breaks.
        Coat = "Under a coat",
    }
}

words! {
    /// How formulas compared are shown.
    Trial {
        /// Curves of both forms along the parameter.
        #[default]
        Curves = "Curves",
        /// Maps of them over both arguments, where there are two.
        Maps = "Maps",
    }
}

words! {
    /// What errors are counted in.
    ErrorUnit {
        /// Roundings of the precision: the same for both, so that they can be compared.
        #[default]
        Roundings = "In roundings",
        /// Shares of the value.
        Relative = "Relative",
        /// Shares of what the stability law allows.
        Bound = "Of what rounding explains",
    }
}

/// How the stability is shown.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Options {
    /// What of it.
    pub plot: Plot,
    /// The id of the axis to the right; the first that a material has instead, where it has no such axis.
    pub x: String,
    /// The id of the axis upwards; the first that a material has instead, where it has no such axis.
    pub y: String,
    /// What errors are counted in.
    pub unit: ErrorUnit,
    /// Whether lines of equal condition number are drawn.
    pub has_contours: bool,
    /// The id of the formula compared.
    pub trial: String,
    /// How it is shown.
    pub trial_as: Trial,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            plot: Plot::default(),
            x: "theta_i".to_owned(),
            y: "alpha".to_owned(),
            unit: ErrorUnit::default(),
            has_contours: true,
            trial: "ggx".to_owned(),
            trial_as: Trial::default(),
        }
    }
}

impl Options {
    /// The axes of the map of errors that the selected material has: those chosen, where it has them.
    #[must_use]
    pub fn axes(&self, session: &Session) -> (Axis, Axis) {
        let all = Axis::all(session.material());
        let find = |id: &str| all.iter().find(|axis| axis.id() == id).cloned();
        let x = find(&self.x).unwrap_or(Axis::ThetaI);
        (x, find(&self.y).unwrap_or(Axis::ThetaO))
    }

    /// The map of the selected material's errors, cut through the pair of light and viewer.
    #[must_use]
    pub fn request(&self, session: &Session) -> Request {
        let (x, y) = self.axes(session);
        Request {
            place: place(session, session.viewer(), session.light()),
            x,
            y,
            size: SIZE,
        }
    }
}

/// Values tried along the parameter of a formula, and of each argument in a map: the reference precision takes a few
/// microseconds for each.
const CURVE_COUNT: usize = 240;
/// See [`CURVE_COUNT`].
const MAP_COUNT: usize = 64;

impl Options {
    /// The formula compared.
    #[must_use]
    pub fn formula(&self) -> &'static Comparison {
        formula_comparison::find(&self.trial)
    }

    /// Whether it is shown over both of its arguments: it has two, and that is wanted.
    #[must_use]
    pub fn is_formula_mapped(&self) -> bool {
        self.trial_as == Trial::Maps && self.formula().second.is_some()
    }

    /// The errors of the formula along its parameter.
    #[must_use]
    pub fn curve_request(&self) -> CurveRequest {
        CurveRequest {
            of: self.formula(),
            count: CURVE_COUNT,
        }
    }

    /// The errors of the formula over both of its arguments.
    #[must_use]
    pub fn map_request(&self) -> MapRequest {
        MapRequest {
            of: self.formula(),
            size: MAP_COUNT,
        }
    }
}

/// The place of the selected material and a pair of directions.
#[must_use]
pub fn place(session: &Session, wo: DVec3, wi: DVec3) -> Place {
    let [wo, wi] = [wo, wi].map(|w| session.on_surface(w));
    Place::of(session.material(), wo, wi)
}

impl ViewOptions for Options {
    fn caption(&self, _: &Session) -> Caption {
        match self.plot {
            Plot::Map => Caption::of("rounding errors in f32 and f64")
                .naming(Subjects::Selected)
                .at(Directions::Held),
            Plot::Formulas => Caption::of("formulas compared")
                .naming(Subjects::None)
                .at(Directions::None),
            Plot::Coat => Caption::of("the diffuse part under a coat of index 1.5")
                .naming(Subjects::None)
                .at(Directions::None),
        }
    }

    fn is_of_held(&self) -> bool {
        self.plot == Plot::Map
    }

    fn texts(&self) -> Vec<&str> {
        vec![&self.x, &self.y, &self.trial]
    }

    /// The errors over the two axes, through the pair of light and viewer.
    fn table(&self, session: &Session, answers: &mut Answers) -> Table {
        let mut table = Table::new(&[
            "material",
            "x",
            "y",
            "error_f32",
            "error_f64",
            "of_bound_f32",
            "of_bound_f64",
            "condition_number",
        ]);
        let request = self.request(session);
        let entry = session.materials.selected();
        let title = session.materials.title(entry);
        let map = answers.ask(session, entry, request.clone());
        for (index, cell) in map.pixels.iter().enumerate() {
            let share = |index: usize, n: usize| (index as f64 + 0.5) / n as f64;
            let x = request.x.value(share(index % map.width, map.width));
            let y = request.y.value(1.0 - share(index / map.width, map.height));
            let ([e32, e64], [r32, r64]) = (cell.errors, cell.ratios);
            if cell.kappa.is_finite() {
                table.push(&title, [x, y, e32, e64, r32, r64, cell.kappa]);
            }
        }
        table
    }
}
