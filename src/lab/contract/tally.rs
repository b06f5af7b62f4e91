//! Counting comparisons and keeping the worst.

use super::{LawId, LawReport, Status, Witness};

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
        let (ratio, worst) = (ratio(deviation, error), ratio(report.worst, report.error));
        if report.n == 1 || ratio > worst || (ratio == worst && deviation > report.worst) {
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
        assert_eq!(of(LawId::Finite).status, Status::Violated);
        assert_eq!(of(LawId::Weight).status, Status::Violated);
        assert_eq!(of(LawId::Deltas).status, Status::Violated);
        assert_eq!(of(LawId::Support).witness.text, "here");
        assert_eq!(of(LawId::Support).status, Status::Violated);
    }
}
