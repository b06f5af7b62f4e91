//! The exact value of an integral, how sums come near it, and what lobes patches are too coarse for.

use std::f64::consts::{PI, TAU};

use super::{COUNT_LOG2, Grid, Integrand, Request, Sum, plus};
use crate::analysis::sampling::probability_of_values;
use crate::analysis::{Channel, Detail, HeldLobe, IsWanted, Pace, Query, Subject};
use bxdf::Lobe;
use bxdf::math::frame;

/// Where a sum over a lobe is off by more than this part of its integral, the patches are too coarse for it.
const OFF: f64 = 0.25;

/// A lobe with less than this share is not worth a word.
const FAINT: f64 = 1e-3;

/// Directions that mark a lobe out, along either side of the unit square.
const MARKS_PER_SIDE: u32 = 32;

/// The finest grid that is named, as a power of 2.
const FINEST_LOG2: u8 = 62;

/// The query for the exact value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ExactRequest {
    /// What is integrated.
    pub integrand: Integrand,
    /// Whether over the whole sphere; else over the hemisphere about n.
    pub is_sphere: bool,
}

/// An integral, as adaptive quadrature has it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Exact {
    /// The value per channel, deltas included where they count; `None` before it is known.
    pub value: Option<[f64; 3]>,
    /// The estimated absolute error of the worst channel.
    pub error: f64,
    /// The probability that a sample is of a delta, where the density is integrated.
    pub deltas: f64,
    /// The probability that a draw gives no sample, where the density is integrated.
    pub lost: f64,
    /// Of each inner lobe.
    pub lobes: Vec<LobeIntegral>,
    /// The sums by the number of patches on a side, as a power of 2; none where all are exact.
    pub course: Vec<(u8, [f64; 3])>,
}

/// What is known of a lobe.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LobeIntegral {
    /// The lobe.
    pub lobe: Lobe,
    /// Its integral of f |cos(theta)|, per channel.
    pub value: [f64; 3],
    /// The number of patches on a side that finds it, as a power of 2: half of the lobe is as wide as a step of z and of the
    /// azimuth. `None` where that is beyond all counting.
    pub needed_log2: Option<u8>,
}

/// A lobe that patches are too coarse for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Missed {
    /// The lobe.
    pub lobe: Lobe,
    /// What they find, as luminance.
    pub found: f64,
    /// What there is.
    pub of: f64,
    /// See [`LobeIntegral::needed_log2`].
    pub needed_log2: Option<u8>,
}

impl Query for ExactRequest {
    type Answer = Exact;

    const PACE: Pace = Pace::CoarseFirst;

    fn answer(
        &self,
        subject: &Subject<'_>,
        detail: Detail,
        is_wanted: IsWanted<'_>,
    ) -> Option<Exact> {
        let lobe = &subject.lobe;
        let turn = if self.is_sphere { 2.0 } else { 1.0 };
        let plain = |value: f64| Exact {
            value: Some([value; 3]),
            ..Exact::default()
        };
        let accuracy = match detail {
            Detail::Coarse => (1e-3, 20_000),
            Detail::Full => (1e-6, 400_000),
        };
        let mut exact = match self.integrand {
            Integrand::One => return Some(plain(turn * TAU)),
            Integrand::Cosine => return Some(plain(turn * PI)),
            Integrand::FCos => reflectance(lobe, accuracy),
            Integrand::Density => probability(lobe, accuracy, is_wanted)?,
        };
        let [least, most] = COUNT_LOG2;
        for count_log2 in least..=most {
            if !is_wanted() {
                return None;
            }
            exact
                .course
                .push((count_log2, self.at(count_log2).sum(lobe).total()));
        }
        if self.integrand == Integrand::FCos {
            let deltas = self.at(least).deltas(lobe).into_iter();
            let deltas = deltas.map(|point| point.share).fold([0.0; 3], plus);
            exact.value = exact.value.map(|value| plus(value, deltas));
        }
        Some(exact)
    }
}

impl ExactRequest {
    /// The sum with so many patches on a side.
    fn at(self, count_log2: u8) -> Request {
        Request {
            integrand: self.integrand,
            count_log2,
            is_sphere: self.is_sphere,
        }
    }
}

/// The integral of f |cos(theta)| over the sphere, without deltas. Light from above that does not pass through the surface
/// has no lobe below it.
fn reflectance(lobe: &HeldLobe<'_>, (tolerance, evaluations): (f64, usize)) -> Exact {
    let lobes = lobe.lobes();
    let tolerance = tolerance / lobes.len().max(1) as f64;
    let integrals = lobe.integrals(tolerance, evaluations);
    let mut exact = Exact {
        value: Some([0.0; 3]),
        ..Exact::default()
    };
    for (index, (one, integral)) in lobes.iter().zip(integrals).enumerate() {
        exact.value = exact.value.map(|value| plus(value, integral.value));
        exact.error += integral.error;
        exact.lobes.push(LobeIntegral {
            lobe: *one,
            value: integral.value,
            needed_log2: needed_log2(lobe, index),
        });
    }
    exact
}

/// The probability of a sample that is no delta.
fn probability(
    lobe: &HeldLobe<'_>,
    (tolerance, evaluations): (f64, usize),
    is_wanted: IsWanted<'_>,
) -> Option<Exact> {
    let sampled = lobe.as_sampled();
    let [covered, error] = probability_of_values(&sampled, tolerance, evaluations, is_wanted)?;
    let deltas = sampled.surface().deltas(sampled.held().into());
    let deltas: f64 = deltas.iter().flatten().map(|delta| delta.probability).sum();
    let each = sampled.lobes().iter().enumerate();
    let lobes = each.map(|(index, one)| LobeIntegral {
        lobe: *one,
        value: [f64::NAN; 3],
        needed_log2: needed_log2(&sampled, index),
    });
    Some(Exact {
        value: Some([covered; 3]),
        error,
        deltas,
        lost: (1.0 - covered - deltas).max(0.0),
        lobes: lobes.collect(),
        course: Vec::new(),
    })
}

/// The number of patches, as a power of 2, whose steps of z and of the azimuth hold no more than half of the inner lobe at
/// `index`.
fn needed_log2(lobe: &HeldLobe<'_>, index: usize) -> Option<u8> {
    let n = MARKS_PER_SIDE;
    let centre = |index: u32| (f64::from(index) + 0.5) / f64::from(n);
    let grid = (0..n).flat_map(|i| (0..n).map(move |j| [centre(i), centre(j)]));
    let drawn = lobe.drawn(index, &grid.collect::<Vec<_>>());
    let weights = drawn.weights.iter().map(|rgb| Channel::Luminance.of(*rgb));
    let marks: Vec<_> = drawn.directions.into_iter().zip(weights).collect();
    let middle = marks.iter().map(|(w, weight)| *w * *weight).sum();
    let azimuth = frame::phi(middle);
    let aside = |phi: f64| (phi - azimuth + PI).rem_euclid(TAU) - PI;
    let heights = marks.iter().map(|(w, weight)| (w.z.abs(), *weight));
    let azimuths = marks
        .iter()
        .map(|(w, weight)| (aside(frame::phi(*w)), *weight));
    let [height, width] = [
        middle_half(heights.collect())?,
        middle_half(azimuths.collect())?,
    ];
    let is_enough = |log2: &u8| {
        let grid = Grid::of(*log2);
        grid.rows as f64 * height >= 1.0 && grid.columns as f64 * width >= TAU
    };
    let [least, _] = COUNT_LOG2;
    (least..=FINEST_LOG2).find(is_enough)
}

/// How far the middle half of these places reaches, by their weights; `None` where nothing weighs anything.
fn middle_half(mut places: Vec<(f64, f64)>) -> Option<f64> {
    places.sort_by(|(a, _), (b, _)| a.total_cmp(b));
    let total: f64 = places.iter().map(|(_, weight)| weight).sum();
    let quantile = |share: f64| {
        let mut sum = 0.0;
        let found = places.iter().find(|(_, weight)| {
            sum += weight;
            sum >= share * total
        });
        found.map(|(place, _)| *place)
    };
    if total > 0.0 {
        Some(quantile(0.75)? - quantile(0.25)?)
    } else {
        None
    }
}

impl Exact {
    /// The lobes that the patches of `sum` are too coarse for.
    #[must_use]
    pub fn missed(&self, sum: &Sum) -> Vec<Missed> {
        let count_log2 = sum.grid.count().checked_ilog2().unwrap_or_default();
        let missed = |lobe: &LobeIntegral, found: [f64; 3], of: [f64; 3]| {
            let [found, of] = [found, of].map(|rgb| Channel::Luminance.of(rgb));
            let is_coarse = lobe
                .needed_log2
                .is_none_or(|needed| u32::from(needed) > count_log2);
            let is_off = of > FAINT && (found - of).abs() > OFF * of;
            (is_coarse && is_off).then_some(Missed {
                lobe: lobe.lobe,
                found,
                of,
                needed_log2: lobe.needed_log2,
            })
        };
        if sum.lobes.is_empty() {
            // Of the density there is the whole only: the narrowest lobe is to blame.
            let rank = |lobe: &&LobeIntegral| lobe.needed_log2.unwrap_or(u8::MAX);
            let narrowest = self.lobes.iter().max_by_key(rank);
            let pair = narrowest.zip(self.value);
            let found = pair.and_then(|(lobe, of)| missed(lobe, sum.total(), of));
            return found.into_iter().collect();
        }
        let pairs = self.lobes.iter().zip(&sum.lobes);
        let each = pairs.filter_map(|(lobe, (_, found))| missed(lobe, *found, lobe.value));
        each.collect()
    }
}
