//! The trade-off, asked as a query.

use glam::DVec3;

use super::FAMILIES;
use super::bench::{self, Family};
use super::report::Report;
use super::study::Study;
use crate::analysis::{Basis, Detail, IsWanted, Pace, Query, Steps, Subject, Tell, finish};
use crate::timing::Stopwatch;

/// What is measured of a material, and how.
#[derive(Clone, Debug, PartialEq)]
pub struct Request {
    /// The direction of view of the estimates, from the surface: a unit vector.
    pub held: DVec3,
    /// The ids of the families.
    pub families: Vec<&'static str>,
    /// What measures times.
    pub stopwatch: Stopwatch,
}

impl Query for Request {
    type Answer = Report;

    const BASIS: Basis = Basis::Material;

    const PACE: Pace = Pace::Long;

    fn answer(&self, of: &Subject<'_>, detail: Detail, is_wanted: IsWanted<'_>) -> Option<Report> {
        finish(self.in_steps(*of, detail, is_wanted, &|_, _| {}))
    }

    /// Tells the report so far after each point.
    fn in_steps<'a>(
        &'a self,
        of: Subject<'a>,
        _: Detail,
        is_wanted: IsWanted<'a>,
        tell: Tell<'a, Report>,
    ) -> Steps<'a, Option<Report>> {
        Box::pin(async move {
            let study = Study::new(of.material?, Some(self.held));
            let is_asked = |family: &&dyn Family| self.families.contains(&family.id());
            let families: Vec<&dyn Family> = FAMILIES.into_iter().filter(is_asked).collect();
            let mut tell = |report: &Report, share: f64| tell(report.clone(), share);
            bench::in_steps(&study, &families, self.stopwatch, is_wanted, &mut tell).await
        })
    }
}

/// How far choices are off, which no clock is needed for.
#[derive(Clone, Debug, PartialEq)]
pub struct Accuracy {
    /// The direction of view of the estimates, from the surface: a unit vector.
    pub held: DVec3,
    /// The ids of the families.
    pub families: Vec<&'static str>,
}

impl Query for Accuracy {
    /// The costs in it are none.
    type Answer = Report;

    const BASIS: Basis = Basis::Material;

    const PACE: Pace = Pace::Short;

    fn answer(&self, of: &Subject<'_>, detail: Detail, is_wanted: IsWanted<'_>) -> Option<Report> {
        let request = Request {
            held: self.held,
            families: self.families.clone(),
            stopwatch: Stopwatch::NoClock,
        };
        request.answer(of, detail, is_wanted)
    }
}
