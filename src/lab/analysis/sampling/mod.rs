//! What `sample_f` does for the held direction, which stands in wo's place whichever is held: its samples, how they are
//! distributed and what they weigh, and what they are worth against samples that do not know the lobe.

mod draws;
mod estimator;
mod histogram;
mod points;
pub mod warp;

use super::polar::{self, section};
use super::scale::RadialScale;
use super::{Detail, HeldLobe, IsWanted, Pace, Query, Subject};
use bxdf::optics::spectrum::luminance;

pub use draws::{CHUNK, Draw, Draws, FIRST_SEED};
pub use estimator::Estimator;
pub use histogram::{Cell, Histogram, WeightBin, WeightHistogram, probability_of_values};
pub use points::Point;
pub use warp::{Warp, WarpRequest};

use points::{Samples, drawn};

/// What of a study is wanted: the rest is left empty.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// All of it.
    All,
    /// The samples alone.
    Points,
    /// The samples and how they are distributed.
    Histogram,
    /// The samples and what they weigh.
    Weights,
    /// The density against f |cos(theta)|.
    Densities,
    /// The estimates.
    Estimators,
}

/// What a study takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Request {
    /// What of it is wanted.
    pub part: Part,
    /// How many samples are drawn.
    pub count: usize,
    /// The seed of the random numbers: the same seed gives the same samples.
    pub seed: u64,
    /// The azimuth of the section in which densities are compared, in radians.
    pub phi: f64,
}

/// What a section shows of the sampler in one direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Density {
    /// The signed angle from n, -180..180, positive towards the section's azimuth.
    pub angle_deg: f64,
    /// The density of the sampler, in 1/sr.
    pub pdf: f64,
    /// The luminance of f |cos(theta)| over its integral over the sphere, in 1/sr: the density of a sampler whose
    /// weights have all one luminance.
    pub f_cos: f64,
}

/// What the samples of a held direction are like.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Study {
    /// The samples, lost ones left out.
    pub points: Vec<Point>,
    /// How many of the draws gave no sample.
    pub lost: usize,
    /// How they are distributed, against the density.
    pub histogram: Histogram,
    /// What they weigh.
    pub weights: WeightHistogram,
    /// The density against f |cos(theta)| in a section, by angle; empty where f is 0 all over the section.
    pub densities: Vec<Density>,
    /// Three estimates of one integral: by `sample_f`, by cosine-weighted directions, by uniform ones.
    pub estimators: [Estimator; 3],
}

/// The coarse study has a sixteenth of the samples.
const COARSER: usize = 16;

impl Query for Request {
    type Answer = Study;

    const PACE: Pace = Pace::CoarseFirst;

    fn answer(
        &self,
        subject: &Subject<'_>,
        detail: Detail,
        is_wanted: IsWanted<'_>,
    ) -> Option<Study> {
        let lobe = subject.lobe.as_sampled();
        let count = match detail {
            Detail::Coarse => self.count.div_ceil(COARSER),
            Detail::Full => self.count,
        };
        let Samples { points, lost } = drawn(&lobe, count, self.seed, is_wanted)?;
        let wants = |part: Part| self.part == Part::All || self.part == part;
        let mut study = Study::default();
        if wants(Part::Histogram) {
            study.histogram = Histogram::new(&lobe, &points, lost, self.seed, is_wanted)?;
        }
        if wants(Part::Densities) {
            study.densities = densities(&lobe, self.phi);
        }
        if wants(Part::Weights) {
            study.weights = WeightHistogram::new(&points, lost);
        }
        if wants(Part::Estimators) {
            study.estimators = estimator::all(&lobe, &points, count, self.seed);
        }
        (study.lost, study.points) = (lost, points);
        is_wanted().then_some(study)
    }
}

/// The three estimates of a study of so many draws, alone.
#[must_use]
pub fn estimators(lobe: &HeldLobe<'_>, count: usize, seed: u64) -> [Estimator; 3] {
    let drawn = drawn(lobe, count, seed, &|| true);
    drawn.map_or_else(Default::default, |drawn| {
        estimator::all(lobe, &drawn.points, count, seed)
    })
}

/// The luminance of the integral of f |cos(theta)| over the sphere, without deltas.
fn integral(lobe: &HeldLobe<'_>) -> f64 {
    let integrals = lobe.integrals(INTEGRAL_TOLERANCE, INTEGRAL_EVALUATIONS);
    let luminances = integrals
        .into_iter()
        .map(|integral| luminance(integral.value));
    luminances.sum()
}

/// Absolute error of an integral that curves are divided by, and how many values it may take.
const INTEGRAL_TOLERANCE: f64 = 1e-4;
const INTEGRAL_EVALUATIONS: usize = 100_000;

/// The density and f |cos(theta)| in the section at azimuth `phi`, at the angles at which the polar curve is fine enough.
fn densities(lobe: &HeldLobe<'_>, phi: f64) -> Vec<Density> {
    let request = polar::Request {
        phi,
        with_cosine: true,
        scale: RadialScale::Linear,
    };
    let polar::Section { upper, lower, .. } = section(lobe, &request);
    let integral = integral(lobe);
    let arc = |points: Vec<polar::Point>, is_upper: bool| {
        let directions = points
            .iter()
            .map(|point| polar::direction(point.angle, phi));
        let densities = lobe.densities_or_limits(&directions.collect::<Vec<_>>(), is_upper);
        let all = points.into_iter().zip(densities);
        all.map(|(point, pdf)| Density {
            angle_deg: point.angle.to_degrees(),
            pdf,
            f_cos: if integral > 0.0 {
                luminance(point.value) / integral
            } else {
                0.0
            },
        })
        .collect::<Vec<_>>()
    };
    // The arc below runs from -90 over 180 to 90 degrees.
    let (negative, positive): (Vec<_>, Vec<_>) = arc(lower, false)
        .into_iter()
        .partition(|density| density.angle_deg < 0.0);
    let negative = negative.into_iter().rev();
    let positive = positive.into_iter().rev();
    negative.chain(arc(upper, true)).chain(positive).collect()
}

#[cfg(test)]
mod tests;
