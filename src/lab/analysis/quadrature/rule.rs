//! The product rule on one rectangle, and the rectangle itself.

use std::cmp::Ordering;
use std::f64::consts::PI;

/// Intervals of the fine rule; the coarse one has half as many.
const INTERVALS: usize = 16;

/// Evaluations of the product rule on one rectangle.
pub(super) const EVALUATIONS: usize = (INTERVALS + 1) * (INTERVALS + 1);

/// The sum of two triples.
pub(super) fn add(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    let ([a0, a1, a2], [b0, b1, b2]) = (a, b);
    [a0 + b0, a1 + b1, a2 + b2]
}

/// The axes of a rectangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Axis {
    X,
    Y,
}

/// A rectangle in the square.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rectangle {
    pub(super) x: [f64; 2],
    pub(super) y: [f64; 2],
}

impl Rectangle {
    pub(super) fn halves(self, axis: Axis) -> [Self; 2] {
        let parts = |[a, b]: [f64; 2]| {
            let middle = f64::midpoint(a, b);
            [[a, middle], [middle, b]]
        };
        match axis {
            Axis::X => parts(self.x).map(|x| Self { x, ..self }),
            Axis::Y => parts(self.y).map(|y| Self { y, ..self }),
        }
    }

    pub(super) fn quarters(self) -> [Self; 4] {
        let [[a, b], [c, d]] = self.halves(Axis::X).map(|half| half.halves(Axis::Y));
        [a, b, c, d]
    }
}

/// A rectangle with the integral over it.
pub(super) struct Cell {
    pub(super) rectangle: Rectangle,
    pub(super) value: [f64; 3],
    pub(super) error: f64,
    pub(super) split_axis: Axis,
}

impl PartialEq for Cell {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Cell {}

impl PartialOrd for Cell {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Cell {
    fn cmp(&self, other: &Self) -> Ordering {
        self.error.total_cmp(&other.error)
    }
}

/// One node of the product rule's axis: its place and both weights.
#[derive(Clone, Copy)]
struct Node {
    x: f64,
    fine: f64,
    /// 0 where the coarse rule has no node.
    coarse: f64,
}

/// The nodes along an axis.
pub(super) struct Rule {
    nodes: Vec<Node>,
}

impl Rule {
    pub(super) fn new() -> Self {
        let node = |j: usize| Node {
            x: (PI * j as f64 / INTERVALS as f64).cos(),
            fine: weight(j, INTERVALS),
            coarse: if j.is_multiple_of(2) {
                weight(j / 2, INTERVALS / 2)
            } else {
                0.0
            },
        };
        Self {
            nodes: (0..=INTERVALS).map(node).collect(),
        }
    }

    /// The nodes along the side `[a, b]` of a rectangle.
    pub(super) fn places(&self, [a, b]: [f64; 2]) -> impl Iterator<Item = f64> {
        let nodes = self.nodes.iter();
        nodes.map(move |node| f64::midpoint(a, b) + 0.5 * (b - a) * node.x)
    }

    /// Both rules and their two mixtures on `rectangle`, from the integrand's [`EVALUATIONS`] values at the
    /// [`Self::places`] of its sides, y running faster: the mixtures tell which axis causes the error.
    pub(super) fn cell(&self, rectangle: Rectangle, values: &[[f64; 3]]) -> Cell {
        let area = 0.25 * (rectangle.x[1] - rectangle.x[0]) * (rectangle.y[1] - rectangle.y[0]);
        let (mut value, mut coarse_x, mut coarse_y, mut coarse) =
            ([0.0; 3], [0.0; 3], [0.0; 3], [0.0; 3]);
        for (row, values) in self.nodes.iter().zip(values.chunks(self.nodes.len())) {
            let (mut fine_row, mut coarse_row) = ([0.0; 3], [0.0; 3]);
            for (node, sample) in self.nodes.iter().zip(values) {
                fine_row = add(fine_row, sample.map(|s| s * node.fine));
                coarse_row = add(coarse_row, sample.map(|s| s * node.coarse));
            }
            value = add(value, fine_row.map(|s| s * row.fine));
            coarse_x = add(coarse_x, fine_row.map(|s| s * row.coarse));
            coarse_y = add(coarse_y, coarse_row.map(|s| s * row.fine));
            coarse = add(coarse, coarse_row.map(|s| s * row.coarse));
        }
        let difference = |other: [f64; 3]| {
            value
                .iter()
                .zip(other)
                .map(|(a, b)| (a - b).abs())
                .fold(0.0, f64::max)
                * area
        };
        let (by_x, by_y) = (difference(coarse_x), difference(coarse_y));
        Cell {
            rectangle,
            value: value.map(|x| x * area),
            error: difference(coarse).max(by_x).max(by_y),
            split_axis: if by_x >= by_y { Axis::X } else { Axis::Y },
        }
    }
}

/// The weight of node `j` of the Clenshaw-Curtis rule of `n` intervals (even) on (-1, 1).
fn weight(j: usize, n: usize) -> f64 {
    let (angle, n_real) = (PI * j as f64 / n as f64, n as f64);
    let sum: f64 = (1..=n / 2)
        .map(|k| {
            let halved = if 2 * k == n { 1.0 } else { 2.0 };
            let k = k as f64;
            halved * (2.0 * k * angle).cos() / (4.0 * k * k - 1.0)
        })
        .sum();
    let ends = if j == 0 || j == n { 1.0 } else { 2.0 };
    ends / n_real * (1.0 - sum)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rules_are_exact_for_their_degrees() {
        let rule = Rule::new();
        for degree in (0..=INTERVALS).step_by(2) {
            let exact = 2.0 / (degree + 1) as f64;
            let power = |x: f64| x.powf(degree as f64);
            let fine: f64 = rule.nodes.iter().map(|n| n.fine * power(n.x.abs())).sum();
            assert!(
                (fine - exact).abs() < 1e-15,
                "fine, degree {degree}: {fine}"
            );
            if degree <= INTERVALS / 2 {
                let coarse: f64 = rule.nodes.iter().map(|n| n.coarse * power(n.x.abs())).sum();
                assert!(
                    (coarse - exact).abs() < 1e-15,
                    "coarse, degree {degree}: {coarse}"
                );
            }
        }
    }
}
