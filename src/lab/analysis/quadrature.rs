//! Adaptive cubature over the unit square, and the choice among several maps of it.
//!
//! A lobe may be a needle over the sphere; over the square that its own sampling maps to directions
//! ([`Lobes::sample_lobe`](bxdf::Lobes::sample_lobe)) f |cos(theta)| / pdf is bounded and smooth, however narrow and
//! wherever the lobe, and nothing need be searched for. Where it breaks along a curve (the edge of what the horizon
//! hides), another map may have the curve as a side of its own, see [`best_of`](best_of()).
//!
//! # Source
//! The nested Clenshaw-Curtis rules of 8 and 16 intervals (`clenshaw1960`) as a product rule: they reach the rectangle's
//! sides, where layers too thin for interior nodes stand (the edge of what the horizon hides). The globally adaptive
//! scheme bisects the rectangle of largest error, across the axis that causes more of it.

use std::collections::BinaryHeap;
use std::f64::consts::FRAC_PI_2;

use rule::{Cell, EVALUATIONS, Rectangle, Rule, add};

pub use best_of::best_of;

mod best_of;
mod rule;

/// Relative error below which refinement cannot improve: rounding of the summands.
const ROUNDING_FLOOR: f64 = 1e-14;

/// Where a cell's integral changes when it is halved, at least this part of the change is the error of either half,
/// whatever its rules say: at a kink or a jump both may agree by chance, and along a straight one in every cell at once.
/// A kink's error falls to a quarter where the cell is halved.
const CAUTION: f64 = 0.25;

/// Cells whose values are asked for at once: enough for a batch, and few enough that its memory stays in the cache.
const AT_ONCE: usize = 2;

/// The largest number below 1: maps of the square take numbers in [0, 1).
const LAST: f64 = 1.0 - 0.5 * f64::EPSILON;

/// An integral over the square.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Integral {
    /// The value of each channel.
    pub value: [f64; 3],
    /// The estimated absolute error of the worst channel; usually the true error is far smaller.
    pub error: f64,
    /// How many values were asked for.
    pub evaluations: usize,
}

impl Integral {
    const NOTHING: Self = Self {
        value: [0.0; 3],
        error: 0.0,
        evaluations: 0,
    };

    /// The largest difference of a channel.
    fn distance(&self, other: &Self) -> f64 {
        largest(add(self.value, other.value.map(|x| -x)))
    }
}

/// The values of an integrand at many points of the unit square at once.
pub type Integrand<'a> = &'a dyn Fn(&[[f64; 2]]) -> Vec<[f64; 3]>;

/// Integrates `f` over the unit square.
///
/// `tolerance`: absolute error wanted. `max_evaluations`: values of `f`; beyond it the integral is returned with the error
/// reached. Square-root singularities at the square's sides, which maps to the hemisphere have at pole and horizon, cost
/// nothing: u is taken as sin^2.
#[must_use]
pub fn integrate_square(f: Integrand<'_>, tolerance: f64, max_evaluations: usize) -> Integral {
    let mut cubature = Cubature::new(f, true);
    while !cubature.is_within(tolerance) && cubature.evaluations < max_evaluations {
        cubature.halve_worst();
    }
    cubature.total()
}

/// An integral that is being refined.
struct Cubature<'a> {
    rule: Rule,
    f: Integrand<'a>,
    /// Whether the square's sides have square-root singularities.
    is_graded: bool,
    cells: BinaryHeap<Cell>,
    sum: Integral,
    evaluations: usize,
}

impl<'a> Cubature<'a> {
    /// Sixteen cells to begin with: on fewer, both rules may overlook the same bend and agree.
    fn new(f: Integrand<'a>, is_graded: bool) -> Self {
        let mut cubature = Self {
            rule: Rule::new(),
            f,
            is_graded,
            cells: BinaryHeap::new(),
            sum: Integral::NOTHING,
            evaluations: 0,
        };
        let whole = Rectangle {
            x: [0.0, 1.0],
            y: [0.0, 1.0],
        };
        let parts = whole.quarters().map(Rectangle::quarters);
        cubature.cells = cubature.integrated(parts.as_flattened()).into();
        cubature.sum = cubature.total();
        cubature
    }

    /// Whether the error is at most `tolerance`, or no more than rounding makes it.
    fn is_within(&self, tolerance: f64) -> bool {
        let floor = ROUNDING_FLOOR * largest(self.sum.value);
        self.sum.error <= tolerance.max(floor)
    }

    /// Bisects the cell of largest error.
    fn halve_worst(&mut self) {
        let Some(worst) = self.cells.pop() else {
            return;
        };
        let halves = self.integrated(&worst.rectangle.halves(worst.split_axis));
        let before = worst.value.map(|x| -x);
        let after = halves.iter().map(|half| half.value);
        let change = largest(after.fold(before, add));
        self.sum.error -= worst.error;
        self.sum.value = add(self.sum.value, before);
        for mut cell in halves {
            cell.error = cell.error.max(change * CAUTION);
            self.sum.error += cell.error;
            self.sum.value = add(self.sum.value, cell.value);
            self.cells.push(cell);
        }
    }

    /// The integrals over `rectangles`, a few at a time.
    fn integrated(&mut self, rectangles: &[Rectangle]) -> Vec<Cell> {
        let some = rectangles.chunks(AT_ONCE);
        some.flat_map(|some| self.integrated_at_once(some))
            .collect()
    }

    fn integrated_at_once(&mut self, rectangles: &[Rectangle]) -> Vec<Cell> {
        let count = rectangles.len() * EVALUATIONS;
        let (mut points, mut slopes) = (Vec::with_capacity(count), Vec::with_capacity(count));
        let place = |x| {
            if self.is_graded { graded(x) } else { [x, 1.0] }
        };
        for part in rectangles {
            let columns: Vec<[f64; 2]> = self.rule.places(part.y).map(place).collect();
            for [u, du] in self.rule.places(part.x).map(place) {
                points.extend(columns.iter().map(|[v, _]| [u, *v]));
                slopes.extend(columns.iter().map(|[_, dv]| du * dv));
            }
        }
        self.evaluations += count;
        let mut values = (self.f)(&points);
        for (value, slope) in values.iter_mut().zip(slopes) {
            *value = value.map(|x| x * slope);
        }
        let cells = rectangles.iter().zip(values.chunks(EVALUATIONS));
        cells
            .map(|(part, values)| self.rule.cell(*part, values))
            .collect()
    }

    /// The sum over all cells, anew: the running sum collects rounding.
    fn total(&self) -> Integral {
        let sum = self
            .cells
            .iter()
            .fold([0.0; 3], |sum, cell| add(sum, cell.value));
        Integral {
            value: sum,
            error: self.cells.iter().map(|cell| cell.error).sum(),
            evaluations: self.evaluations,
        }
    }
}

fn largest(channels: [f64; 3]) -> f64 {
    channels.into_iter().fold(0.0, |a: f64, b| a.max(b.abs()))
}

/// sin^2 of a quarter turn of x^2 (3 - 2 x), and its rate of change: a map of the unit interval to itself that makes
/// square roots at its ends smooth.
#[must_use]
pub fn graded(x: f64) -> [f64; 2] {
    let step = x * x * (3.0 - 2.0 * x);
    let (sin, cos) = (FRAC_PI_2 * step).sin_cos();
    let slope = 6.0 * x * (1.0 - x);
    [(sin * sin).min(LAST), 2.0 * FRAC_PI_2 * sin * cos * slope]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn each(f: impl Fn([f64; 2]) -> [f64; 3]) -> impl Fn(&[[f64; 2]]) -> Vec<[f64; 3]> {
        move |points| points.iter().map(|point| f(*point)).collect()
    }

    #[test]
    fn smooth_integrands_and_roots_at_the_sides_are_exact() {
        let found = integrate_square(
            &each(|[u, v]| [u * v, u.sqrt() * (1.0 - v).sqrt(), (3.0 * u).exp()]),
            1e-12,
            100_000,
        );
        let exact = [0.25, 4.0 / 9.0, (3.0_f64.exp() - 1.0) / 3.0];
        for (value, exact) in found.value.iter().zip(exact) {
            assert!((value - exact).abs() < 1e-12, "{value} {exact}");
        }
        assert!(found.error < 1e-12);
    }

    #[test]
    fn a_kink_is_refined_and_the_error_is_an_error() {
        // The integral of max(0, u + v - 1/3) over the square: 1 - 1/3 + (1/3)^3 / 6.
        let exact = 2.0 / 3.0 + 1.0 / 162.0;
        let f = each(|[u, v]| [(u + v - 1.0 / 3.0).max(0.0); 3]);
        let found = integrate_square(&f, 1e-8, 1_000_000);
        assert!(found.error <= 1e-8 && (found.value[0] - exact).abs() <= 1e-8);
        let hasty = integrate_square(&f, 1e-12, 10_000);
        assert!(hasty.error > 1e-12 && (hasty.value[0] - exact).abs() <= hasty.error);
    }
}
