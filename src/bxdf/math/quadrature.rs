//! Fixed quadrature rules.

use std::collections::BTreeMap;
use std::f64::consts::PI;
use std::sync::{Mutex, PoisonError};

use xprec::Df64;

use super::Real;

/// The Gauss-Legendre rule of -1..1 with `nodes` nodes, one for 0, as (node, weight), by node.
///
/// Newton's method, ended in double-double arithmetic: nodes and weights are the doubles nearest to the exact ones (checked
/// against 40 digits for degrees up to 512). Each rule is computed once.
#[must_use]
pub fn gauss_legendre(nodes: usize) -> Vec<(f64, f64)> {
    static RULES: Mutex<BTreeMap<usize, Vec<(f64, f64)>>> = Mutex::new(BTreeMap::new());
    let degree = nodes.max(1);
    let mut rules = RULES.lock().unwrap_or_else(PoisonError::into_inner);
    rules.entry(degree).or_insert_with(|| rule(degree)).clone()
}

/// Newton's steps in double precision: each doubles the two digits or more of the start.
const STEPS: usize = 5;

fn rule(degree: usize) -> Vec<(f64, f64)> {
    let from_above = |index: usize| {
        // Tricomi's start, without its second term: near enough at every degree.
        let mut x = (PI * (index as f64 + 0.75) / (degree as f64 + 0.5)).cos();
        for _ in 0..STEPS {
            let [value, slope] = legendre(degree, x);
            x -= value / slope;
        }
        // Once more with all digits, the slope being that at the zero itself.
        let x = Df64::of(x);
        let [value, slope] = legendre(degree, x);
        let x = x - value / slope;
        let [_, slope] = legendre(degree, x);
        let weight = Df64::of(2.0) / ((Df64::one() - x * x) * slope * slope);
        (x.as_f64(), weight.as_f64())
    };
    // Half of them: the others mirror these, and the middle one is 0.
    let positive: Vec<(f64, f64)> = (0..degree / 2).map(from_above).collect();
    let middle = (degree % 2 == 1).then(|| {
        let [_, slope] = legendre(degree, Df64::zero());
        (0.0, (Df64::of(2.0) / (slope * slope)).as_f64())
    });
    let negative = positive.iter().map(|(x, weight)| (-x, *weight));
    let above = positive.iter().rev().copied();
    negative.chain(middle).chain(above).collect()
}

/// The Legendre polynomial of a degree of 1 or more at `x`, and its derivative; `x` is not 1 or -1.
fn legendre<R: Real>(degree: usize, x: R) -> [R; 2] {
    let (mut before, mut value) = (R::one(), x);
    for n in 2..=degree {
        let n = n as f64;
        let next = (R::of(2.0 * n - 1.0) * x * value - R::of(n - 1.0) * before) / R::of(n);
        (before, value) = (value, next);
    }
    let slope = R::of(degree as f64) * (before - x * value) / ((R::one() - x) * (R::one() + x));
    [value, slope]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rules_are_those_of_the_tables() {
        // Abramowitz & Stegun, table 25.4, and the closed forms of degrees 1 to 3.
        let root = 0.6_f64.sqrt();
        for (degree, expected) in [
            (1, vec![(0.0, 2.0)]),
            (
                2,
                vec![
                    (-(1.0_f64 / 3.0).sqrt(), 1.0),
                    ((1.0_f64 / 3.0).sqrt(), 1.0),
                ],
            ),
            (
                3,
                vec![(-root, 5.0 / 9.0), (0.0, 8.0 / 9.0), (root, 5.0 / 9.0)],
            ),
        ] {
            let found = gauss_legendre(degree);
            assert_eq!(found.len(), expected.len());
            for ((x, weight), (y, other)) in found.into_iter().zip(expected) {
                // One rounding of either side.
                assert!(
                    (x - y).abs() <= 1.2e-16 && (weight - other).abs() <= 2.3e-16,
                    "{degree}"
                );
            }
        }
        let (x, weight) = gauss_legendre(20)[19];
        assert!((x - 0.993_128_599_185_094_9).abs() < 1.2e-16, "{x}");
        assert!(
            (weight - 0.017_614_007_139_152_12).abs() < 4e-18,
            "{weight}"
        );
        assert_eq!(gauss_legendre(0), gauss_legendre(1));
    }

    #[test]
    fn rules_are_exact_for_the_powers_they_promise() {
        for degree in [1, 2, 5, 8, 31, 32, 64, 101, 256] {
            let rule = gauss_legendre(degree);
            assert_eq!(rule.len(), degree);
            assert!(rule.is_sorted_by(|a, b| a.0 < b.0));
            assert!(rule.iter().all(|(x, _)| x.abs() < 1.0));
            for power in (0..2 * degree).step_by((degree / 8).max(1)) {
                let found: f64 = rule
                    .iter()
                    .map(|(x, weight)| weight * x.powi(i32::try_from(power).unwrap()))
                    .sum();
                let exact = if power % 2 == 0 {
                    2.0 / (power as f64 + 1.0)
                } else {
                    0.0
                };
                // Rounded nodes and weights: a unit of round-off for each of the powers at most, over a sum of at most 2.
                let tolerance = 1.2e-16 * (power as f64 + 4.0);
                assert!(
                    (found - exact).abs() < tolerance,
                    "{degree} {power}: {}",
                    found - exact
                );
            }
        }
    }
}
