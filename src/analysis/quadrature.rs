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

/// Relative error below which refinement cannot improve: rounding of the summands.
const ROUNDING_FLOOR: f64 = 1e-14;

/// The integral over one hemisphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Integral {
    /// The value of each channel.
    pub value: [f64; 3],
    /// The estimated absolute error of the worst channel. Where the integral has converged the true error is usually
    /// far smaller; where it has not, a feature may have gone unseen and the true error can be larger.
    pub error: f64,
    /// Whether the error reached the tolerance within the evaluations allowed.
    pub has_converged: bool,
}

/// Integrates `f` over solid angle, the hemispheres about +n and -n apart, in this order.
///
/// `f` takes a unit vector. `seeds`: directions where `f` is concentrated, denser where it is higher; without them a
/// feature narrower than about 0.1 rad can be missed. `tolerance`: absolute error wanted in each hemisphere.
/// `max_evaluations`: of `f`, in each hemisphere; beyond it the integral is returned with the error reached.
#[must_use]
pub fn integrate_sphere(
    f: impl Fn(DVec3) -> [f64; 3],
    seeds: &[DVec3],
    tolerance: f64,
    max_evaluations: usize,
) -> [Integral; 2] {
    [false, true].map(|is_lower| {
        let sign = if is_lower { -1.0 } else { 1.0 };
        let points = seeds
            .iter()
            .filter(|w| w.z * sign > 0.0)
            .map(|w| {
                let elevation = w.z.abs().atan2(w.x.hypot(w.y));
                [graded(elevation), frame::phi(*w).rem_euclid(TAU)]
            })
            .collect::<Vec<_>>();
        let rule = Rule::new();
        let integrand = |x: f64, phi: f64| {
            let (elevation, stretch) = elevation_of(x);
            let (cos_theta, sin_theta) = elevation.sin_cos();
            let (sin_phi, cos_phi) = phi.sin_cos();
            f(DVec3::new(
                sin_theta * cos_phi,
                sin_theta * sin_phi,
                sign * cos_theta,
            ))
            .map(|f| f * sin_theta * stretch)
        };
        integrate_hemisphere(&rule, &integrand, &points, tolerance, max_evaluations)
    })
}

/// Exponent of the grading: an elevation of 1e-6 rad lies 1 % of the range from its end. Where the held direction grazes,
/// many models change over a strip beside the horizon as thin as its own elevation, and even steps in theta miss it.
const GRADING: i32 = 3;

/// The coordinate of an elevation, pi/2 at the horizon, 0 at the pole.
fn graded(elevation: f64) -> f64 {
    FRAC_PI_2 * (1.0 - (elevation / FRAC_PI_2).powf(1.0 / f64::from(GRADING)))
}

/// The elevation at a coordinate, and its rate of change.
fn elevation_of(x: f64) -> (f64, f64) {
    let t = (1.0 - x / FRAC_PI_2).max(0.0);
    let power = t.powi(GRADING - 1);
    (FRAC_PI_2 * power * t, f64::from(GRADING) * power)
}

fn integrate_hemisphere(
    rule: &Rule,
    f: &impl Fn(f64, f64) -> [f64; 3],
    seeds: &[[f64; 2]],
    tolerance: f64,
    max_evaluations: usize,
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
                has_converged: false,
            },
            |sum, cell| Integral {
                value: add(sum.value, cell.value),
                error: sum.error + cell.error,
                has_converged: false,
            },
        )
    };
    let mut sum = total(&heap);
    loop {
        let floor = ROUNDING_FLOOR * sum.value.into_iter().fold(0.0, |a: f64, b| a.max(b.abs()));
        let has_converged = sum.error <= tolerance.max(floor);
        if has_converged || evaluations > max_evaluations {
            // Summed anew: the running sums have collected rounding.
            return Integral {
                has_converged,
                ..total(&heap)
            };
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
        let [upper, lower] =
            integrate_sphere(|w| [w.z.abs(), w.x * w.x, 1.0], &[], 1e-12, 1_000_000);
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
        let [with, _] = integrate_sphere(f, &seeds, 1e-9, 1_000_000);
        assert!((with.value[0] - 1.0).abs() < 1e-8, "{with:?}");
        let [without, _] = integrate_sphere(f, &[], 1e-9, 1_000_000);
        assert!(
            without.value[0] < 0.5,
            "the seeds are what finds it: {without:?}"
        );
    }
}
