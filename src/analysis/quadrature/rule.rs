//! The product rule on one rectangle, and the rectangle itself.

use std::cmp::Ordering;

/// The nodes of the 15-point Kronrod rule on (-1, 1) from the outermost to the centre; the others are their negatives.
const NODES: [f64; 8] = [
    0.991_455_371_120_812_6,
    0.949_107_912_342_758_5,
    0.864_864_423_359_769_1,
    0.741_531_185_599_394_4,
    0.586_087_235_467_691_1,
    0.405_845_151_377_397_2,
    0.207_784_955_007_898_47,
    0.0,
];

/// The Kronrod weights of [`NODES`].
const KRONROD: [f64; 8] = [
    0.022_935_322_010_529_224,
    0.063_092_092_629_978_56,
    0.104_790_010_322_250_18,
    0.140_653_259_715_525_92,
    0.169_004_726_639_267_9,
    0.190_350_578_064_785_4,
    0.204_432_940_075_298_9,
    0.209_482_141_084_727_82,
];

/// The weights of the 7-point Gauss rule on the same nodes; 0 where it has none.
const GAUSS: [f64; 8] = [
    0.0,
    0.129_484_966_168_869_7,
    0.0,
    0.279_705_391_489_276_64,
    0.0,
    0.381_830_050_505_118_9,
    0.0,
    0.417_959_183_673_469_4,
];

/// Evaluations of the product rule on one rectangle.
pub(super) const EVALUATIONS: usize = 15 * 15;

/// A rectangle is halved while it holds at least this many seeds, crowded into less than [`CROWDED`] of its width.
const SEEDS_TO_SPLIT: usize = 4;

/// See [`SEEDS_TO_SPLIT`].
const CROWDED: f64 = 0.4;

/// A rectangle is halved, too, while the middle half of its seeds crowds into less than this part of its width: the
/// seeds of a wide lobe must not hide a narrow one. Half of an even spread is .5 wide.
const HALF_CROWDED: f64 = 0.1;

/// Rectangles narrower than this are not halved for their seeds, in radians: below it, rounding of the angles shows.
const NARROWEST: f64 = 1e-12;

/// The sum of two triples.
pub(super) fn add(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    let ([a0, a1, a2], [b0, b1, b2]) = (a, b);
    [a0 + b0, a1 + b1, a2 + b2]
}

/// The axes of a rectangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Axis {
    Theta,
    Phi,
}

/// A rectangle of (theta, phi), in radians.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rectangle {
    pub(super) theta: [f64; 2],
    pub(super) phi: [f64; 2],
}

impl Rectangle {
    pub(super) fn halves(self, axis: Axis) -> [Self; 2] {
        let middle = |[a, b]: [f64; 2]| f64::midpoint(a, b);
        match axis {
            Axis::Theta => {
                let m = middle(self.theta);
                [
                    Self {
                        theta: [self.theta[0], m],
                        ..self
                    },
                    Self {
                        theta: [m, self.theta[1]],
                        ..self
                    },
                ]
            }
            Axis::Phi => {
                let m = middle(self.phi);
                [
                    Self {
                        phi: [self.phi[0], m],
                        ..self
                    },
                    Self {
                        phi: [m, self.phi[1]],
                        ..self
                    },
                ]
            }
        }
    }

    /// The axis along which `seeds` crowd into a part of the rectangle, if they do.
    pub(super) fn crowded_axis(&self, seeds: &[[f64; 2]]) -> Option<Axis> {
        if seeds.len() < SEEDS_TO_SPLIT {
            return None;
        }
        let relative_spread = |range: [f64; 2], coordinate: fn(&[f64; 2]) -> f64| {
            let width = range[1] - range[0];
            if width <= NARROWEST {
                return 1.0;
            }
            let mut coordinates: Vec<f64> = seeds.iter().map(coordinate).collect();
            let [all, half] = spreads(&mut coordinates).map(|spread| spread / width);
            // Either may fall below its threshold; both on the scale of the first.
            all.min(half * (CROWDED / HALF_CROWDED))
        };
        let theta = relative_spread(self.theta, |s| s[0]);
        let phi = relative_spread(self.phi, |s| s[1]);
        let (axis, spread) = if theta < phi {
            (Axis::Theta, theta)
        } else {
            (Axis::Phi, phi)
        };
        (spread < CROWDED).then_some(axis)
    }

    pub(super) fn contains(&self, [theta, phi]: [f64; 2]) -> bool {
        let within = |range: [f64; 2], x: f64| range[0] <= x && x <= range[1];
        within(self.theta, theta) && within(self.phi, phi)
    }
}

/// From where to where all of `coordinates` lie, and the middle half of them.
fn spreads(coordinates: &mut [f64]) -> [f64; 2] {
    let n = coordinates.len();
    let mut rank = |index: usize| {
        let index = index.min(n.saturating_sub(1));
        *coordinates.select_nth_unstable_by(index, f64::total_cmp).1
    };
    let [lowest, lower, upper, highest] = [0, n / 4, n - n / 4 - 1, n - 1].map(&mut rank);
    [highest - lowest, upper - lower]
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
    kronrod: f64,
    gauss: f64,
}

/// The 15 nodes along an axis.
pub(super) struct Rule {
    nodes: Vec<Node>,
}

impl Rule {
    pub(super) fn new() -> Self {
        let table = NODES.into_iter().zip(KRONROD).zip(GAUSS);
        let half = table.map(|((x, kronrod), gauss)| Node { x, kronrod, gauss });
        let mirrored = half
            .clone()
            .filter(|node| node.x > 0.0)
            .map(|node| Node { x: -node.x, ..node });
        Self {
            nodes: mirrored.chain(half).collect(),
        }
    }

    /// Both rules and their two mixtures on `rectangle`: the mixtures tell which axis causes the error.
    pub(super) fn cell(&self, f: &impl Fn(f64, f64) -> [f64; 3], rectangle: Rectangle) -> Cell {
        let place = |[a, b]: [f64; 2], x: f64| f64::midpoint(a, b) + 0.5 * (b - a) * x;
        let area = 0.25
            * (rectangle.theta[1] - rectangle.theta[0])
            * (rectangle.phi[1] - rectangle.phi[0]);
        let (mut value, mut coarse_theta, mut coarse_phi, mut coarse) =
            ([0.0; 3], [0.0; 3], [0.0; 3], [0.0; 3]);
        for t in &self.nodes {
            let theta = place(rectangle.theta, t.x);
            let (mut kronrod, mut gauss) = ([0.0; 3], [0.0; 3]);
            for p in &self.nodes {
                let sample = f(theta, place(rectangle.phi, p.x));
                kronrod = add(kronrod, sample.map(|s| s * p.kronrod));
                gauss = add(gauss, sample.map(|s| s * p.gauss));
            }
            value = add(value, kronrod.map(|s| s * t.kronrod));
            coarse_theta = add(coarse_theta, kronrod.map(|s| s * t.gauss));
            coarse_phi = add(coarse_phi, gauss.map(|s| s * t.kronrod));
            coarse = add(coarse, gauss.map(|s| s * t.gauss));
        }
        let difference = |other: [f64; 3]| {
            value
                .iter()
                .zip(other)
                .map(|(a, b)| (a - b).abs())
                .fold(0.0, f64::max)
                * area
        };
        let (by_theta, by_phi) = (difference(coarse_theta), difference(coarse_phi));
        Cell {
            rectangle,
            value: value.map(|x| x * area),
            error: difference(coarse).max(by_theta).max(by_phi),
            split_axis: if by_theta >= by_phi {
                Axis::Theta
            } else {
                Axis::Phi
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rules_are_exact_for_their_degrees() {
        let rule = Rule::new();
        for degree in (0..=22).step_by(2) {
            let exact = 2.0 / f64::from(degree + 1);
            let kronrod: f64 = rule
                .nodes
                .iter()
                .map(|n| n.kronrod * n.x.powi(degree))
                .sum();
            assert!(
                (kronrod - exact).abs() < 1e-15,
                "Kronrod, degree {degree}: {kronrod}"
            );
            if degree <= 12 {
                let gauss: f64 = rule.nodes.iter().map(|n| n.gauss * n.x.powi(degree)).sum();
                assert!(
                    (gauss - exact).abs() < 1e-15,
                    "Gauss, degree {degree}: {gauss}"
                );
            }
        }
    }
}
