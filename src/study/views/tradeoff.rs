//! What accuracy costs.

use std::borrow::Cow;

use serde::{Deserialize, Serialize};

use super::caption::{Caption, Directions, Subjects};
use super::kind::{Deltas, TableKind, ViewKind, ViewOptions};
use crate::answers::Answers;
use crate::export::table::{Table, Value};
use crate::number::{NumberSpec, Numbers};
use crate::session::Session;
use bxdf_lab::timing::Stopwatch;
use bxdf_lab::tradeoff::table::{COLUMNS, rows as tradeoff_rows};
use bxdf_lab::tradeoff::{Accuracy, FAMILIES, Report, Request};

pub(super) const KIND: ViewKind = ViewKind {
    id: "tradeoff",
    title: "Trade-off",
    what_you_see: "What accuracy costs: each mark is a choice, its measured error over its measured \
        cost; what lies lowest and furthest left is worth choosing",
    says_hidden: false,
    deltas: Deltas::Summed,
    with_cosine: false,
    table: TableKind::Measured,
    is_mesh: false,
};

/// The tolerated error: below a few roundings of f64 no choice can be, above 1 all are.
pub static TOLERANCE: NumberSpec = NumberSpec::new("tradeoff.tolerance", [1e-12, 1.0]);

/// How the trade-off of cost and error is measured and shown.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Options {
    /// The largest error that is good enough: relative, root mean square.
    pub tolerance: f64,
    /// The ids of the families that are not wanted.
    pub left_out: Vec<String>,
    /// Whether a material is measured as soon as it is shown; else when asked for.
    pub is_immediate: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            tolerance: 0.01,
            left_out: Vec::new(),
            is_immediate: false,
        }
    }
}

impl Options {
    /// Whether the family of this id is wanted.
    #[must_use]
    pub fn wants(&self, family: &str) -> bool {
        self.left_out.iter().all(|out| out != family)
    }

    /// What is wanted of a report: it may have been made for other views too.
    #[must_use]
    pub fn wanted<'a>(&self, report: &'a Report) -> Cow<'a, Report> {
        if report.families.iter().all(|family| self.wants(family.id)) {
            return Cow::Borrowed(report);
        }
        let mut report = report.clone();
        report.families.retain(|family| self.wants(family.id));
        Cow::Owned(report)
    }
}

/// The trade-off of the selected material, seen along the held direction: what any of the session's trade-offs wants is
/// measured together, once for all.
#[must_use]
pub fn request(session: &Session, stopwatch: Stopwatch) -> Request {
    Request {
        held: session.on_surface(session.held()),
        families: wanted(session),
        stopwatch,
    }
}

/// How far the choices of the selected material are off whose errors are found in a moment, among those that any of the session's
/// trade-offs wants.
#[must_use]
pub fn accuracy(session: &Session) -> Accuracy {
    let wanted = wanted(session);
    let quick = FAMILIES.iter().filter(|family| family.has_quick_errors());
    let ids = quick.map(|family| family.id());
    Accuracy {
        held: session.on_surface(session.held()),
        families: ids.filter(|id| wanted.contains(id)).collect(),
    }
}

/// The ids of the families that any of the session's trade-offs wants.
fn wanted(session: &Session) -> Vec<&'static str> {
    let views = session.views.all::<Options>();
    let ids = FAMILIES.iter().map(|family| family.id());
    ids.filter(|id| views.iter().any(|view| view.wants(id)))
        .collect()
}

impl ViewOptions for Options {
    fn caption(&self, _: &Session) -> Caption {
        Caption::of("relative error over cost (ns)")
            .naming(Subjects::Selected)
            .at(Directions::Held)
    }

    fn is_of_held(&self) -> bool {
        false
    }

    fn numbers(&mut self) -> Numbers<'_> {
        vec![(&TOLERANCE, &mut self.tolerance)]
    }

    fn texts(&self) -> Vec<&str> {
        self.left_out.iter().map(String::as_str).collect()
    }

    /// The points of the trade-off.
    fn table(&self, session: &Session, answers: &mut Answers) -> Table {
        let request = request(session, Stopwatch::WallClock);
        let report = answers.of_material(session.materials.selected(), request);
        let rows = report
            .iter()
            .flat_map(|report| tradeoff_rows(&self.wanted(report)));
        Table {
            columns: COLUMNS.map(str::to_owned).to_vec(),
            rows: rows.map(|row| row.map(Value::Text).to_vec()).collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::session::Place;

    #[test]
    fn what_several_want_is_measured_once_and_each_shows_its_own() {
        let without = |left_out: &[&str]| Options {
            left_out: left_out.iter().map(|id| (*id).to_owned()).collect(),
            ..Options::default()
        };
        let [first, second] = [
            without(&["tables", "mesh"]),
            without(&["tables", "precision"]),
        ];
        let both = [first.clone(), second].map(|options| Place::View(options.into()));
        let session = Session {
            views: Place::row(both.into()).into(),
            ..Session::default()
        };
        let all = wanted(&session);
        assert!(all.contains(&"mesh") && all.contains(&"precision") && !all.contains(&"tables"));
        let shown = all.into_iter().filter(|id| first.wants(id));
        assert!(shown.clone().count() > 2 && shown.into_iter().all(|id| id != "mesh"));
    }
}
