//! A family of choices, what it reports to while it is measured, and how far that is.

use super::front;
use super::report::{CostUnit, FamilyReport, Point, Report, Slopes};
use super::study::{Stop, Study};
use crate::analysis::{IsWanted, Steps, finish, pause};
use crate::timing::{Stopwatch, Timing};

/// What measures a family, step by step.
pub type Measuring<'a> = Steps<'a, Result<(), Stop>>;

/// A family of choices.
pub trait Family: Sync {
    /// The word for it at the command line and in reports.
    fn id(&self) -> &'static str;

    /// The name at the screen.
    fn title(&self) -> &'static str;

    /// What its costs are of.
    fn cost_unit(&self) -> CostUnit;

    /// Whether its choices are ways to evaluate the material as it is given, held against that: advice for the material as a
    /// whole is chosen among them.
    fn is_of_material(&self) -> bool {
        false
    }

    /// Whether the errors of its choices are found in a moment: nothing has to be baked or drawn at random for them.
    fn has_quick_errors(&self) -> bool {
        false
    }

    /// How long it takes to measure, in any unit common to all: for the progress.
    fn share(&self) -> f64;

    /// Measures every choice for the material of `study` and hands the points to `bench`.
    ///
    /// # Errors
    /// [`Stop`], where the family does not apply, or is not wanted any more.
    fn measure<'a>(&'a self, study: &'a Study<'_>, bench: &'a mut Bench<'_>) -> Measuring<'a>;
}

/// What families report to while they measure.
pub struct Bench<'a> {
    stopwatch: Stopwatch,
    is_wanted: IsWanted<'a>,
    /// Told of the report so far, after each point, and of the share of the work done, 0..1.
    listener: &'a mut dyn FnMut(&Report, f64),
    report: Report,
    /// The shares of the work done and to be done.
    done: f64,
    current: f64,
    total: f64,
    fraction: f64,
}

impl Bench<'_> {
    /// The time that `work` takes; see [`Stopwatch::time`].
    pub(super) fn time(&self, size: f64, work: &mut dyn FnMut()) -> Timing {
        self.stopwatch.time(size, work)
    }

    /// Ends a step.
    ///
    /// # Errors
    /// [`Stop::Unwanted`], where nobody wants more.
    pub(super) async fn wanted(&self) -> Result<(), Stop> {
        pause().await;
        if (self.is_wanted)() {
            Ok(())
        } else {
            Err(Stop::Unwanted)
        }
    }

    /// This share of the family's work, 0..1, is done; ends a step.
    ///
    /// # Errors
    /// As [`Self::wanted`].
    pub(super) async fn at(&mut self, fraction: f64) -> Result<(), Stop> {
        self.fraction = fraction;
        self.wanted().await
    }

    /// What the family's choices are held against.
    pub(super) fn reference(&mut self, text: String) {
        if let Some(family) = self.report.families.last_mut() {
            family.reference = text;
        }
    }

    /// A choice has been measured.
    pub(super) fn point(&mut self, point: Point) {
        if let Some(family) = self.report.families.last_mut() {
            family.points.push(point);
            front::mark(&mut family.points);
        }
        self.tell();
    }

    fn tell(&mut self) {
        let progress = (self.done + self.current * self.fraction) / self.total;
        (self.listener)(&self.report, progress);
    }

    async fn run(&mut self, family: &dyn Family, study: &Study<'_>) -> Result<(), Stop> {
        self.report.families.push(FamilyReport {
            id: family.id(),
            title: family.title(),
            reference: String::new(),
            not_applicable: None,
            cost_unit: family.cost_unit(),
            is_of_material: family.is_of_material(),
            points: Vec::new(),
            slopes: Slopes::new(),
        });
        (self.current, self.fraction) = (family.share(), 0.0);
        let outcome = family.measure(study, self).await;
        self.done += self.current;
        (self.current, self.fraction) = (0.0, 0.0);
        if let Some(report) = self.report.families.last_mut() {
            report.slopes = front::slopes(&report.points);
            if let Err(Stop::NotApplicable(reason)) = &outcome {
                report.not_applicable = Some(reason.clone());
            }
        }
        self.tell();
        match outcome {
            Err(Stop::Unwanted) => Err(Stop::Unwanted),
            _ => Ok(()),
        }
    }
}

/// Measures the choices of `families` for the material of `study`. `listener` is told of the report so far and of the
/// share of the work done, 0..1, after each point. `None` as soon as `is_wanted` says no.
#[must_use]
pub fn measure(
    study: &Study<'_>,
    families: &[&dyn Family],
    stopwatch: Stopwatch,
    is_wanted: IsWanted<'_>,
    listener: &mut dyn FnMut(&Report, f64),
) -> Option<Report> {
    let measuring = in_steps(study, families, stopwatch, is_wanted, listener);
    finish(Box::pin(measuring))
}

/// [`measure`], step by step.
pub(super) async fn in_steps(
    study: &Study<'_>,
    families: &[&dyn Family],
    stopwatch: Stopwatch,
    is_wanted: IsWanted<'_>,
    listener: &mut dyn FnMut(&Report, f64),
) -> Option<Report> {
    let mut bench = Bench {
        stopwatch,
        is_wanted,
        listener,
        report: Report {
            material: study.material.clone(),
            held: study.held,
            families: Vec::new(),
        },
        done: 0.0,
        current: 0.0,
        total: families.iter().map(|family| family.share()).sum(),
        fraction: 0.0,
    };
    for family in families {
        bench.run(*family, study).await.ok()?;
    }
    Some(bench.report)
}
