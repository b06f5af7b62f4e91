//! How samples are distributed, and what they weigh.

use std::f64::consts::TAU;

use glam::DVec3;
use rayon::prelude::*;

use super::draws::FIRST_SEED;
use super::points::{Point, Samples, drawn};
use crate::analysis::quadrature::integrate_square;
use crate::analysis::statistics::{ChiSquare, chi_square};
use crate::analysis::{HeldLobe, IsWanted};
use bxdf::math::frame;
use bxdf::optics::spectrum::luminance;

/// A cell of the sphere, and the samples in it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell {
    /// The polar angles between which it lies, in radians, 0..pi; a cell does not cross the horizon.
    pub theta: [f64; 2],
    /// The azimuths between which it lies, in radians; the second is larger, and may be above pi.
    pub phi: [f64; 2],
    /// Its solid angle, in sr.
    pub solid_angle: f64,
    /// How many samples fell into it.
    pub observed: usize,
    /// How many the density says: its integral over the cell, times the number of draws.
    pub expected: f64,
}

/// The samples by cells of the sphere, and the test whether they follow the density.
///
/// The cells hold about as many samples each: other samples than those that are counted have cut the sphere at their
/// medians, so that there are cells wherever the lobe is, however narrow.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Histogram {
    /// The cells, which cover the sphere.
    pub cells: Vec<Cell>,
    /// How many samples of deltas were drawn, and how many should have been.
    pub deltas: [f64; 2],
    /// How many draws gave no sample, and how many should have been so.
    pub lost: [f64; 2],
    /// Pearson's statistic over the cells, the deltas and the lost draws; what is expected less than ten times is pooled.
    pub chi_square: f64,
    /// Its degrees of freedom; 0 where there is nothing to test.
    pub degrees: usize,
    /// The chance that samples that follow the density give as large a statistic or a larger one; 1 where there is
    /// nothing to test.
    pub p_value: f64,
    /// The largest estimated error of what is expected in a cell, over its standard deviation: where it is not far below
    /// 1, the test is of the integral, not of the samples.
    pub expectation_error: f64,
}

/// Samples that cut the sphere, for each cell.
const PILOTS_PER_CELL: usize = 32;

/// Cells at most.
const MAX_CELLS: usize = 128;

/// The error wanted in an expected count, in its standard deviations.
const COUNT_TOLERANCE: f64 = 0.05;

/// Values of the density that a cell may take: some of the blades of an anisotropic lobe need them.
const MAX_EVALUATIONS: usize = 100_000;

impl Histogram {
    /// That of the samples `points`, and `lost` draws without one; `None` where it was not wanted to the end.
    pub(super) fn new(
        lobe: &HeldLobe<'_>,
        points: &[Point],
        lost: usize,
        seed: u64,
        is_wanted: IsWanted<'_>,
    ) -> Option<Self> {
        let count = points.len() + lost;
        let n = (count / PILOTS_PER_CELL).clamp(1, MAX_CELLS);
        let pilots = drawn(lobe, n * PILOTS_PER_CELL, !seed, is_wanted)?;
        let patches = patches(lobe, &pilots);
        let tolerance = COUNT_TOLERANCE / (count.max(1) as f64 * n as f64).sqrt();
        let integrals = integrals(lobe, &patches, (tolerance, MAX_EVALUATIONS), is_wanted)?;
        let observed = observed(&patches, points);
        let counted = patches.iter().zip(integrals.iter().zip(observed));
        let cells = counted.map(|(patch, ([share, _], observed))| Cell {
            expected: share * count as f64,
            observed,
            ..patch.cell()
        });
        let cells: Vec<Cell> = cells.collect();
        let probabilities = lobe
            .surface()
            .deltas(lobe.held().into())
            .into_iter()
            .flatten();
        let probability: f64 = probabilities.map(|delta| delta.probability).sum();
        let drawn_deltas = points.iter().filter(|point| point.is_delta).count();
        let deltas = [drawn_deltas as f64, probability * count as f64];
        let covered: f64 = integrals.iter().map(|[share, _]| share).sum();
        let lost = [
            lost as f64,
            (1.0 - covered - probability).max(0.0) * count as f64,
        ];
        let mut bins: Vec<(f64, f64)> = cells
            .iter()
            .map(|cell| (cell.observed as f64, cell.expected))
            .collect();
        bins.extend([deltas, lost].map(|[observed, expected]| (observed, expected)));
        let nothing = ChiSquare {
            statistic: 0.0,
            degrees: 0,
            p_value: 1.0,
        };
        let test = chi_square(&bins).unwrap_or(nothing);
        let errors = integrals
            .iter()
            .filter(|[share, _]| *share > 0.0)
            .map(|[share, error]| error * (count as f64 / share).sqrt());
        Some(Self {
            cells,
            deltas,
            lost,
            chi_square: test.statistic,
            degrees: test.degrees,
            p_value: test.p_value,
            expectation_error: errors.fold(0.0, f64::max),
        })
    }
}

/// A rectangle of one side of the sphere: its coordinates are 1 - |cos(theta)|, which keeps its digits at the pole, and
/// the azimuth; equal areas are equal solid angles.
#[derive(Clone, Copy, Debug)]
struct Patch {
    is_upper: bool,
    depth: [f64; 2],
    phi: [f64; 2],
}

/// The coordinates of a direction, the azimuth counted from `first_phi`.
fn coordinates(w: DVec3, first_phi: f64) -> [f64; 2] {
    let depth = (w.x * w.x + w.y * w.y) / (1.0 + w.z.abs());
    [
        depth,
        first_phi + (frame::phi(w) - first_phi).rem_euclid(TAU),
    ]
}

impl Patch {
    /// The direction at parts of its extents.
    fn direction(&self, [u, v]: [f64; 2]) -> DVec3 {
        let within = |[a, b]: [f64; 2], part: f64| a + part * (b - a);
        let (depth, phi) = (within(self.depth, u), within(self.phi, v));
        let (sin, cos) = phi.sin_cos();
        let radius = (depth * (2.0 - depth)).sqrt();
        let z = if self.is_upper {
            1.0 - depth
        } else {
            depth - 1.0
        };
        DVec3::new(radius * cos, radius * sin, z)
    }

    fn solid_angle(&self) -> f64 {
        let ([a, b], [c, d]) = (self.depth, self.phi);
        (b - a) * (d - c)
    }

    /// The integral of the sampler's density, and its error.
    fn density(&self, lobe: &HeldLobe<'_>, (tolerance, max_evaluations): (f64, usize)) -> [f64; 2] {
        let solid_angle = self.solid_angle();
        let values = |u: &[[f64; 2]]| {
            let directions: Vec<DVec3> = u.iter().map(|u| self.direction(*u)).collect();
            let densities = lobe.densities_or_limits(&directions, self.is_upper);
            densities
                .into_iter()
                .map(|pdf| [pdf * solid_angle, 0.0, 0.0])
                .collect()
        };
        let integral = integrate_square(&values, tolerance, max_evaluations);
        let [share, ..] = integral.value;
        [share, integral.error]
    }

    /// It as a cell without samples.
    fn cell(&self) -> Cell {
        let theta = self.depth.map(|depth| {
            let theta = 2.0 * depth.sqrt().atan2((2.0 - depth).sqrt());
            if self.is_upper {
                theta
            } else {
                std::f64::consts::PI - theta
            }
        });
        let [a, b] = theta;
        Cell {
            theta: [a.min(b), a.max(b)],
            phi: self.phi,
            solid_angle: self.solid_angle(),
            observed: 0,
            expected: 0.0,
        }
    }

    fn contains(&self, [depth, phi]: [f64; 2]) -> bool {
        let ([a, b], [c, d]) = (self.depth, self.phi);
        // Open at the upper ends, but for those of the whole side, which nothing lies beyond.
        (a..b).contains(&depth) && (c..d).contains(&phi)
    }

    /// The parts of it in which there are few of the points `pilots`, its own.
    fn parts(self, pilots: &mut [[f64; 2]], is_depth: bool, parts: &mut Vec<Self>) {
        let key = |[depth, phi]: &[f64; 2]| if is_depth { *depth } else { *phi };
        let extent = if is_depth { self.depth } else { self.phi };
        pilots.sort_by(|a, b| key(a).total_cmp(&key(b)));
        let (low, high) = pilots.split_at_mut(pilots.len() / 2);
        let ends = low.last().zip(high.first());
        let middle = ends.map(|(a, b)| f64::midpoint(key(a), key(b)));
        let is_large = low.len() + high.len() >= 2 * PILOTS_PER_CELL;
        let cut = middle.filter(|at| is_large && extent[0] < *at && *at < extent[1]);
        let Some(at) = cut else {
            parts.push(self);
            return;
        };
        let [first, last] = extent;
        let with = |extent: [f64; 2]| {
            if is_depth {
                Self {
                    depth: extent,
                    ..self
                }
            } else {
                Self {
                    phi: extent,
                    ..self
                }
            }
        };
        with([first, at]).parts(low, !is_depth, parts);
        with([at, last]).parts(high, !is_depth, parts);
    }
}

/// Patches that cover the sphere, cut at the medians of `pilots`.
fn patches(lobe: &HeldLobe<'_>, pilots: &Samples) -> Vec<Patch> {
    // Azimuths begin where most lobes have a plane of symmetry, far from where most are.
    let first_phi = frame::phi(lobe.held());
    let mut patches = Vec::new();
    for is_upper in [true, false] {
        let whole = Patch {
            is_upper,
            depth: [0.0, 1.0],
            phi: [first_phi, first_phi + TAU],
        };
        let on_side = pilots
            .points
            .iter()
            .filter(|point| !point.is_delta && (point.direction.z > 0.0) == is_upper);
        let mut points: Vec<[f64; 2]> = on_side
            .map(|point| coordinates(point.direction, first_phi))
            .collect();
        whole.parts(&mut points, true, &mut patches);
    }
    patches
}

/// The integral of the density over each patch with its error, where they are wanted to the end; `accuracy`: the error
/// wanted in each, and how many values each may take.
fn integrals(
    lobe: &HeldLobe<'_>,
    patches: &[Patch],
    accuracy: (f64, usize),
    is_wanted: IsWanted<'_>,
) -> Option<Vec<[f64; 2]>> {
    let integral = |patch: &Patch| is_wanted().then(|| patch.density(lobe, accuracy));
    patches.par_iter().map(integral).collect()
}

/// Cells in which the density is integrated where no samples are counted.
const CELLS_OF_DENSITY: usize = 32;

/// The probability that a sample is no delta and not lost, and its estimated error: the integral of the density over the
/// sphere. `tolerance`: absolute error wanted; `max_evaluations`: how many densities it may take. `None` where it was not
/// wanted to the end.
pub fn probability_of_values(
    lobe: &HeldLobe<'_>,
    tolerance: f64,
    max_evaluations: usize,
    is_wanted: IsWanted<'_>,
) -> Option<[f64; 2]> {
    let count = CELLS_OF_DENSITY * PILOTS_PER_CELL;
    let pilots = drawn(lobe, count, u64::from(FIRST_SEED), is_wanted)?;
    let patches = patches(lobe, &pilots);
    let n = patches.len().max(1);
    let accuracy = (tolerance / n as f64, max_evaluations / n);
    let integrals = integrals(lobe, &patches, accuracy, is_wanted)?;
    let add = |[a, b]: [f64; 2], [x, y]: &[f64; 2]| [a + x, b + y];
    Some(integrals.iter().fold([0.0; 2], add))
}

/// How many of `points`, without deltas, lie in each patch.
fn observed(patches: &[Patch], points: &[Point]) -> Vec<usize> {
    let first_phi = patches
        .iter()
        .map(|patch| patch.phi[0])
        .fold(f64::INFINITY, f64::min);
    let mut counts = vec![0; patches.len()];
    for point in points.iter().filter(|point| !point.is_delta) {
        let is_upper = point.direction.z > 0.0;
        let [depth, phi] = coordinates(point.direction, first_phi);
        // The horizon itself and the last azimuth belong to what is just before them.
        let place = [
            depth.min(1.0 - f64::EPSILON),
            phi.min((first_phi + TAU).next_down()),
        ];
        let is_there = |patch: &Patch| patch.is_upper == is_upper && patch.contains(place);
        let found = patches.iter().position(is_there);
        if let Some(count) = found.and_then(|index| counts.get_mut(index)) {
            *count += 1;
        }
    }
    counts
}

/// A bin of weights.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WeightBin {
    /// The decimal logarithms of the weights between which it lies; the second belongs to the next bin.
    pub log10: [f64; 2],
    /// How many samples fell into it.
    pub count: usize,
}

/// The luminances of the samples' weights, deltas included.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WeightHistogram {
    /// The weights above 0, by their logarithm, from the smallest to the largest.
    pub bins: Vec<WeightBin>,
    /// The mean over all draws, lost ones counting as 0.
    pub mean: f64,
    /// The largest.
    pub largest: f64,
    /// The share of the draws that gave no sample, or one of weight 0.
    pub zeros: f64,
    /// How many draws gave no sample.
    pub lost: usize,
}

/// Bins at most, and the width of the narrowest: weights that differ by less than 2 % count as alike.
const MAX_BINS: f64 = 48.0;
const NARROWEST_BIN: f64 = 0.01;

impl WeightHistogram {
    /// That of the samples `points`, and `lost` draws without one.
    pub(super) fn new(points: &[Point], lost: usize) -> Self {
        let weights: Vec<f64> = points.iter().map(|point| luminance(point.weight)).collect();
        let count = (weights.len() + lost).max(1) as f64;
        let logarithms: Vec<f64> = weights
            .iter()
            .filter(|w| **w > 0.0)
            .map(|w| w.log10())
            .collect();
        let first = logarithms.iter().copied().fold(f64::INFINITY, f64::min);
        let last = logarithms.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let width = ((last - first) / MAX_BINS).max(NARROWEST_BIN);
        // Half a bin aside, so that weights that are all alike but for rounding share one.
        let start = first - 0.5 * width;
        let bins = if logarithms.is_empty() {
            0
        } else {
            ((last - start) / width) as usize + 1
        };
        let bin = |index: usize| WeightBin {
            log10: [index, index + 1].map(|i| start + i as f64 * width),
            count: 0,
        };
        let mut bins: Vec<WeightBin> = (0..bins).map(bin).collect();
        for logarithm in &logarithms {
            if let Some(bin) = bins.get_mut(((logarithm - start) / width) as usize) {
                bin.count += 1;
            }
        }
        Self {
            bins,
            mean: weights.iter().sum::<f64>() / count,
            largest: weights.iter().copied().fold(0.0, f64::max),
            zeros: (weights.len() + lost - logarithms.len()) as f64 / count,
            lost,
        }
    }
}
