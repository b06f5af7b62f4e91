//! Counting comparisons and keeping the worst.

use super::law::{LawId, LawReport, Status};
use crate::specimen::Witness;

/// The worst comparison of every law so far.
#[derive(Clone, Debug)]
pub struct Tallies(Vec<LawReport>);

impl Default for Tallies {
    fn default() -> Self {
        let empty = |law| LawReport {
            law,
            status: Status::Ok,
            worst: 0.0,
            error: 0.0,
            n: 0,
            witness: Witness::default(),
            reason: String::new(),
        };
        Self(LawId::ALL.map(empty).to_vec())
    }
}

impl Tallies {
    /// Counts one comparison of `law`: it holds where `deviation` <= `error`, both not negative; a deviation that is not
    /// finite breaks it, whatever the error. `witness` says where, should it be the worst.
    pub fn record<W: Into<Witness>>(
        &mut self,
        law: LawId,
        deviation: f64,
        error: f64,
        witness: impl FnOnce() -> W,
    ) {
        let Some(report) = self.0.iter_mut().find(|report| report.law == law) else {
            return;
        };
        report.n += 1;
        let deviation = if deviation.is_nan() {
            f64::INFINITY
        } else {
            deviation
        };
        let rank = |deviation, error| rank(law, deviation, error);
        let (this, worst) = (rank(deviation, error), rank(report.worst, report.error));
        if report.n == 1 || this > worst || (this == worst && deviation > report.worst) {
            report.worst = deviation;
            report.error = error;
            report.witness = witness().into();
        }
        if deviation.is_infinite() || error.is_nan() || deviation > error {
            report.status = Status::Violated;
        }
    }

    /// Counts a comparison that is a plain yes or no.
    pub fn require<W: Into<Witness>>(
        &mut self,
        law: LawId,
        holds: bool,
        witness: impl FnOnce() -> W,
    ) {
        self.record(law, if holds { 0.0 } else { 1.0 }, 0.0, witness);
    }

    /// The reports, in the order of [`LawId::ALL`].
    pub fn into_reports(self) -> impl Iterator<Item = LawReport> {
        self.0.into_iter()
    }
}

/// How bad a comparison is: by what factor its deviation uses up the error. Where a law of physics is broken, by how much is
/// what counts.
fn rank(law: LawId, deviation: f64, error: f64) -> f64 {
    let ratio = ratio(deviation, error);
    if law.is_physical() && ratio > 1.0 {
        1.0 + deviation
    } else {
        ratio
    }
}

/// By what factor `deviation` uses up `error`.
fn ratio(deviation: f64, error: f64) -> f64 {
    if deviation == 0.0 {
        0.0
    } else if deviation.is_infinite() || error.is_nan() {
        f64::INFINITY
    } else {
        deviation / error
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_worst_is_kept_and_a_nan_breaks_the_law() {
        let mut tallies = Tallies::default();
        for (deviation, error) in [(0.0, 0.0), (1.0, 2.0), (3.0, 4.0), (2.0, 8.0)] {
            tallies.record(LawId::Energy, deviation, error, || {
                format!("{deviation}/{error}")
            });
        }
        // Of what breaks a law of physics, the largest amount is kept, of others the largest factor.
        tallies.record(LawId::Isotropy, 0.1, 1e-3, String::new);
        tallies.record(LawId::Isotropy, 0.2, 1e-2, String::new);
        let mut created = Tallies::default();
        created.record(LawId::Energy, 0.1, 1e-3, String::new);
        created.record(LawId::Energy, 0.2, 1e-2, String::new);
        created.record(LawId::Energy, 0.1, 1e-4, String::new);
        let mut created = created.into_reports();
        let energy = created.find(|report| report.law == LawId::Energy);
        assert_eq!(energy.map(|report| report.worst), Some(0.2));
        tallies.record(LawId::Finite, f64::NAN, 1.0, String::new);
        tallies.record(LawId::Weight, f64::INFINITY, f64::INFINITY, String::new);
        tallies.record(LawId::Deltas, 0.0, f64::NAN, String::new);
        tallies.require(LawId::Support, true, String::new);
        tallies.require(LawId::Support, false, || "here".to_owned());
        let reports: Vec<LawReport> = tallies.into_reports().collect();
        let of = |law| {
            reports
                .iter()
                .find(|report| report.law == law)
                .unwrap()
                .clone()
        };
        assert_eq!(
            (of(LawId::Energy).witness.text.as_str(), of(LawId::Energy).n),
            ("3/4", 4)
        );
        assert_eq!(of(LawId::Energy).status, Status::Ok);
        assert_eq!(of(LawId::Isotropy).worst, 0.1);
        assert_eq!(of(LawId::Finite).status, Status::Violated);
        assert_eq!(of(LawId::Weight).status, Status::Violated);
        assert_eq!(of(LawId::Deltas).status, Status::Violated);
        assert_eq!(of(LawId::Support).witness.text, "here");
        assert_eq!(of(LawId::Support).status, Status::Violated);
    }
}
