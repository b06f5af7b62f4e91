//! What is counted at each extreme, and the worst of it.

use std::collections::BTreeMap;

use glam::DVec3;
use serde::Serialize;

use super::ExtremeKind;

/// What was found at one extreme in one precision.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Extreme {
    /// The extreme.
    pub case: ExtremeKind,
    /// The precision: `f32`, `f64` or `reference`.
    pub precision: &'static str,
    /// Number of points: pairs of directions, or samples.
    pub n: u64,
    /// Points with a value, a density, a weight or a direction that is not finite.
    pub non_finite: u64,
    /// Points with a negative value or density.
    pub negative: u64,
    /// Samples where none belong: on a side without a lobe, of another length than 1, or without a density.
    pub misplaced: u64,
    /// The largest relative error against the reference precision at the same rounded inputs; infinite where one of the
    /// two is no number.
    #[serde(serialize_with = "finite")]
    pub max_rel_error: f64,
    /// The largest error over what the stability law allows for it.
    #[serde(serialize_with = "finite")]
    pub max_bound_ratio: f64,
    /// What that ratio may be: 1, or more where a model says so.
    pub allowed_ratio: f64,
    /// The largest weight of a sample.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub max_weight: Option<f64>,
    /// Where the largest ratio is, or the first fault.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub worst: Option<Worst>,
}

/// JSON has no infinity: the largest number stands for it.
#[expect(
    clippy::trivially_copy_pass_by_ref,
    reason = "serde asks with a reference to the field"
)]
fn finite<S: serde::Serializer>(x: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_f64(x.min(f64::MAX))
}

/// A point: a material and a pair of directions.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Worst {
    /// Model and parameters as text; a material's text.
    pub params: String,
    /// The outgoing direction.
    pub wo: DVec3,
    /// The incident direction.
    pub wi: DVec3,
    /// What is off there: `f` or `pdf`, or the fault.
    pub what: String,
}

impl Extreme {
    fn new(case: ExtremeKind, precision: &'static str) -> Self {
        Self {
            case,
            precision,
            n: 0,
            non_finite: 0,
            negative: 0,
            misplaced: 0,
            max_rel_error: 0.0,
            max_bound_ratio: 0.0,
            allowed_ratio: 1.0,
            max_weight: None,
            worst: None,
        }
    }

    /// Results that are not finite, negative or misplaced.
    #[must_use]
    pub fn faults(&self) -> u64 {
        self.non_finite + self.negative + self.misplaced
    }

    /// Whether there is no fault and no error beyond its bound.
    #[must_use]
    pub fn is_stable(&self) -> bool {
        self.faults() == 0 && self.max_bound_ratio <= self.allowed_ratio
    }

    fn absorb(&mut self, other: Self) {
        let is_worse = other.max_bound_ratio > self.max_bound_ratio;
        let is_first_fault = self.faults() == 0 && other.faults() > 0;
        if is_first_fault || (is_worse && self.faults() == 0) || self.worst.is_none() {
            self.worst = other.worst;
        }
        self.n += other.n;
        self.non_finite += other.non_finite;
        self.negative += other.negative;
        self.misplaced += other.misplaced;
        self.max_rel_error = self.max_rel_error.max(other.max_rel_error);
        self.max_bound_ratio = self.max_bound_ratio.max(other.max_bound_ratio);
        self.max_weight = match (self.max_weight, other.max_weight) {
            (Some(a), Some(b)) => Some(a.max(b)),
            (a, b) => a.or(b),
        };
    }
}

/// What a point is found to be.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Finding {
    pub(super) is_not_finite: bool,
    pub(super) is_negative: bool,
    pub(super) is_misplaced: bool,
    pub(crate) relative_error: f64,
    /// The error over its bound; [`Tally::largest_ratio`] or less needs not be exact.
    pub(crate) ratio: f64,
    pub(super) weight: Option<f64>,
    /// `f` or `pdf`, of the ratio.
    pub(crate) what: &'static str,
}

impl Finding {
    /// Whether something is not finite, negative or misplaced.
    pub(super) fn is_faulty(&self) -> bool {
        self.fault().is_some()
    }

    fn fault(&self) -> Option<&'static str> {
        if self.is_not_finite {
            Some("not finite")
        } else if self.is_negative {
            Some("negative")
        } else {
            self.is_misplaced.then_some("misplaced sample")
        }
    }
}

/// The extremes found so far, by case and precision.
#[derive(Clone, Debug, Default)]
pub(super) struct Tally(BTreeMap<(ExtremeKind, &'static str), Extreme>);

impl Tally {
    /// The smallest of the largest ratios of `cases`: a point whose ratio is not above it changes nothing.
    pub(super) fn largest_ratio(&self, cases: &[ExtremeKind], precision: &'static str) -> f64 {
        let ratios = cases.iter().map(|case| {
            let found = self.0.get(&(*case, precision));
            found.map_or(0.0, |extreme| extreme.max_bound_ratio)
        });
        ratios.fold(f64::INFINITY, f64::min)
    }

    /// Counts a point under each of `cases`; `at` says where it is.
    pub(super) fn add(
        &mut self,
        cases: &[ExtremeKind],
        precision: &'static str,
        finding: Finding,
        at: impl Fn() -> (String, DVec3, DVec3),
    ) {
        for case in cases {
            let key = (*case, precision);
            let extreme = self
                .0
                .entry(key)
                .or_insert_with(|| Extreme::new(*case, precision));
            let is_worst = match finding.fault() {
                Some(_) => extreme.faults() == 0,
                None => extreme.faults() == 0 && finding.ratio > extreme.max_bound_ratio,
            };
            if is_worst {
                let (params, wo, wi) = at();
                let what = finding.fault().unwrap_or(finding.what).to_owned();
                extreme.worst = Some(Worst {
                    params,
                    wo,
                    wi,
                    what,
                });
            }
            extreme.n += 1;
            extreme.non_finite += u64::from(finding.is_not_finite);
            extreme.negative += u64::from(finding.is_negative);
            extreme.misplaced += u64::from(finding.is_misplaced);
            extreme.max_rel_error = extreme.max_rel_error.max(finding.relative_error);
            extreme.max_bound_ratio = extreme.max_bound_ratio.max(finding.ratio);
            if let Some(weight) = finding.weight {
                let most = extreme.max_weight.unwrap_or(0.0);
                extreme.max_weight = Some(most.max(weight));
            }
        }
    }

    /// What both found together.
    pub(super) fn with(mut self, other: Self) -> Self {
        for (key, extreme) in other.0 {
            self.0
                .entry(key)
                .or_insert_with(|| Extreme::new(key.0, key.1))
                .absorb(extreme);
        }
        self
    }

    /// What was found, in the order of the cases, judged by the ratio that is allowed.
    pub(super) fn into_extremes(self, allowed_ratio: f64) -> Vec<Extreme> {
        let judged = |extreme| Extreme {
            allowed_ratio,
            ..extreme
        };
        self.0.into_values().map(judged).collect()
    }

    /// What was found, in the order of the cases.
    pub(super) fn extremes(&self) -> impl Iterator<Item = &Extreme> {
        self.0.values()
    }
}
