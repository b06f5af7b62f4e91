//! Adaptive cubature over the sphere that no lobe escapes.
//!
//! # Source
//! The Gauss-Kronrod pair (7, 15) of Kronrod 1965, with the nodes tabulated in Piessens et al. 1983, "QUADPACK"
//! (`piessens1983`), as a product rule on rectangles of (theta, phi); the globally adaptive scheme bisects the
//! rectangle of largest error, across the axis that causes more of it.
//!
//! A narrow lobe is found beforehand: rectangles are halved until the `seeds` (samples of the lobe) no longer crowd
//! into a part of one.

use std::collections::BinaryHeap;
use std::f64::consts::{FRAC_PI_2, TAU};

use glam::DVec3;

use crate::bxdf::math::frame;
use rule::{Axis, Cell, EVALUATIONS, Rectangle, Rule, add};

mod rule;

/// Beyond this many evaluations the integral is returned with the error reached.
const MAX_EVALUATIONS: usize = 4_000_000;

/// Relative error below which refinement cannot improve: rounding of the summands.
const ROUNDING_FLOOR: f64 = 1e-14;

/// The integral over one hemisphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Integral {
    /// The value of each channel.
    pub value: [f64; 3],
    /// The estimated absolute error of the worst channel; the true error is usually far smaller.
    pub error: f64,
}

/// Integrates `f` over solid angle, the hemispheres about +n and -n apart, in this order.
///
/// `f` takes a unit vector. `seeds`: directions where `f` is concentrated, denser where it is higher; without them a
/// feature narrower than about 0.1 rad can be missed. `tolerance`: absolute error wanted in each hemisphere.
#[must_use]
pub fn integrate_sphere(
    f: impl Fn(DVec3) -> [f64; 3],
    seeds: &[DVec3],
    tolerance: f64,
) -> [Integral; 2] {
    [false, true].map(|is_lower| {
        let sign = if is_lower { -1.0 } else { 1.0 };
        let points = seeds
            .iter()
            .filter(|w| w.z * sign > 0.0)
            .map(|w| {
                [
                    w.x.hypot(w.y).atan2(w.z.abs()),
                    frame::phi(*w).rem_euclid(TAU),
                ]
            })
            .collect::<Vec<_>>();
        let rule = Rule::new();
        let integrand = |theta: f64, phi: f64| {
            let (sin_theta, cos_theta) = theta.sin_cos();
            let (sin_phi, cos_phi) = phi.sin_cos();
            f(DVec3::new(
                sin_theta * cos_phi,
                sin_theta * sin_phi,
                sign * cos_theta,
            ))
            .map(|x| x * sin_theta)
        };
        integrate_hemisphere(&rule, &integrand, &points, tolerance)
    })
}

fn integrate_hemisphere(
    rule: &Rule,
    f: &impl Fn(f64, f64) -> [f64; 3],
    seeds: &[[f64; 2]],
    tolerance: f64,
) -> Integral {
    let mut heap: BinaryHeap<Cell> = initial_rectangles(seeds)
        .into_iter()
        .map(|rectangle| rule.cell(f, rectangle))
        .collect();
    let mut evaluations = heap.len() * EVALUATIONS;
    let total = |heap: &BinaryHeap<Cell>| {
        heap.iter().fold(
            Integral {
                value: [0.0; 3],
                error: 0.0,
            },
            |sum, cell| Integral {
                value: add(sum.value, cell.value),
                error: sum.error + cell.error,
            },
        )
    };
    let mut sum = total(&heap);
    loop {
        let floor = ROUNDING_FLOOR * sum.value.into_iter().fold(0.0, |a: f64, b| a.max(b.abs()));
        if sum.error <= tolerance.max(floor) || evaluations > MAX_EVALUATIONS {
            // Summed anew: the running sums have collected rounding.
            return total(&heap);
        }
        let Some(worst) = heap.pop() else {
            return sum;
        };
        sum.error -= worst.error;
        sum.value = add(sum.value, worst.value.map(|x| -x));
        for half in worst.rectangle.halves(worst.split_axis) {
            let cell = rule.cell(f, half);
            sum.error += cell.error;
            sum.value = add(sum.value, cell.value);
            heap.push(cell);
        }
        evaluations += 2 * EVALUATIONS;
    }
}

/// The hemisphere in eight rectangles, each halved while seeds crowd into a part of it.
fn initial_rectangles(seeds: &[[f64; 2]]) -> Vec<Rectangle> {
    let quarter = TAU / 4.0;
    let mut open: Vec<(Rectangle, Vec<[f64; 2]>)> = (0..4)
        .flat_map(|i| {
            let phi = [f64::from(i) * quarter, f64::from(i + 1) * quarter];
            Rectangle {
                theta: [0.0, FRAC_PI_2],
                phi,
            }
            .halves(Axis::Theta)
        })
        .map(|rectangle| {
            (
                rectangle,
                seeds
                    .iter()
                    .copied()
                    .filter(|s| rectangle.contains(*s))
                    .collect(),
            )
        })
        .collect();
    let mut done = Vec::new();
    while let Some((rectangle, inside)) = open.pop() {
        match rectangle.crowded_axis(&inside) {
            None => done.push(rectangle),
            Some(axis) => {
                for half in rectangle.halves(axis) {
                    open.push((
                        half,
                        inside
                            .iter()
                            .copied()
                            .filter(|s| half.contains(*s))
                            .collect(),
                    ));
                }
            }
        }
    }
    done
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn smooth_integrands_are_exact_without_seeds() {
        let [upper, lower] = integrate_sphere(|w| [w.z.abs(), w.x * w.x, 1.0], &[], 1e-12);
        let pi = std::f64::consts::PI;
        for (integral, exact) in [(upper, [pi, TAU / 3.0, TAU]), (lower, [pi, TAU / 3.0, TAU])] {
            for (value, exact) in integral.value.iter().zip(exact) {
                assert!((value - exact).abs() < 1e-12, "{value} {exact}");
            }
            assert!(integral.error < 1e-12);
        }
    }

    #[test]
    fn a_needle_is_found_by_its_seeds() {
        // A normalised von Mises-Fisher lobe of width 1e-4 rad about a direction near the horizon.
        let axis = frame::direction_from_degrees(85.0, 200.0);
        let sharpness = 1e8;
        let f = |w: DVec3| {
            [sharpness / TAU * (-0.5 * sharpness * (w - axis).length_squared()).exp(); 3]
        };
        let (side, up) = (axis.cross(DVec3::Z), axis.cross(axis.cross(DVec3::Z)));
        let seeds: Vec<DVec3> = (0..64)
            .filter_map(|i| {
                let (sin, cos) = (f64::from(i) * 2.4).sin_cos();
                (axis + (side * cos + up * sin) * 2e-5 * f64::from(i).sqrt()).try_normalize()
            })
            .collect();
        let [with, _] = integrate_sphere(f, &seeds, 1e-9);
        assert!((with.value[0] - 1.0).abs() < 1e-8, "{with:?}");
        let [without, _] = integrate_sphere(f, &[], 1e-9);
        assert!(
            without.value[0] < 0.5,
            "the seeds are what finds it: {without:?}"
        );
    }
}
