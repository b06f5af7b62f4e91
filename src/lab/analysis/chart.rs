//! Coordinates of the directions to one side of a surface: polar ones about a direction, ending at the horizon.
//!
//! In them the horizon is a side of the unit square, and nothing drawn is lost beyond it. About the normal, what breaks at
//! the elevation of the held direction or at right angles to its azimuth breaks along lines of the coordinates; about the
//! held direction, what breaks with the angle between the two (total reflection within a microfacet) does.

use std::f64::consts::{FRAC_PI_2, PI};

use glam::DVec3;

use super::quadrature::graded;
use bxdf::Side;

/// Below this sine of its polar angle a direction is the normal: both charts are the same.
const UPRIGHT: f64 = 1e-9;

/// A map of the unit square to directions: the polar angle by the first number, the azimuth by the second.
pub(super) struct Chart {
    /// The direction of azimuth 0, the one of a quarter turn, and the pole.
    axes: [DVec3; 3],
    /// The components along the normal of the pole and of the direction of azimuth 0; the third axis has none.
    heights: [f64; 2],
    /// The polar angles at 0, at one half (where the azimuths that are above the horizon become fewer, or the held
    /// direction stands) and at 1.
    angles: [f64; 3],
}

impl Chart {
    /// The charts of the hemisphere to the `side` of the surface on which, or across from which, the unit vector `held`
    /// stands: about the normal, and about `held` itself or its opposite.
    pub(super) fn of_side(held: DVec3, side: Side) -> Vec<Self> {
        let near = match side {
            Side::Reflection => held,
            Side::Transmission => -held,
        };
        let normal = DVec3::new(0.0, 0.0, 1.0_f64.copysign(near.z));
        let (sin, cos) = (near.x.hypot(near.y), near.z.abs());
        let theta = sin.atan2(cos);
        let across = if sin > UPRIGHT {
            DVec3::new(near.x / sin, near.y / sin, 0.0)
        } else {
            DVec3::X
        };
        let about_normal = Self {
            axes: [across, normal.cross(across), normal],
            heights: [1.0, 0.0],
            angles: [0.0, theta, FRAC_PI_2],
        };
        if sin <= UPRIGHT {
            return vec![about_normal];
        }
        let up = normal * sin - across * cos;
        let about_held = Self {
            axes: [up, near.cross(up), near],
            heights: [cos, sin],
            angles: [0.0, FRAC_PI_2 - theta, FRAC_PI_2 + theta],
        };
        vec![about_normal, about_held]
    }

    /// The directions of `points`, and the weight of each: how much solid angle there is around it, times |cos(theta)|.
    pub(super) fn places(&self, points: &[[f64; 2]]) -> (Vec<DVec3>, Vec<f64>) {
        let rows = points.chunk_by(|[x, _], [next, _]| x == next);
        let mut places = (
            Vec::with_capacity(points.len()),
            Vec::with_capacity(points.len()),
        );
        for row in rows {
            let Some([x, _]) = row.first() else { continue };
            let meridians = self.meridians(*x);
            places.extend(row.iter().map(|[_, y]| meridians.place(self, *y)));
        }
        places
    }

    /// What all places of one polar angle have in common.
    fn meridians(&self, x: f64) -> Meridians {
        let [start, middle, end] = self.angles;
        let (low, high, t) = if x < 0.5 {
            (start, middle, 2.0 * x)
        } else {
            (middle, end, 2.0 * x - 1.0)
        };
        let [g, slope] = graded(t);
        let (sin, cos) = (low + (high - low) * g).sin_cos();
        let [pole, zero] = self.heights;
        let lowest = (-(cos * pole) / (sin * zero)).min(1.0);
        let reach = if lowest > -1.0 {
            (1.0 - lowest * lowest).sqrt().atan2(lowest)
        } else {
            PI
        };
        Meridians {
            sin,
            cos,
            reach,
            weight: sin * 2.0 * (high - low) * slope * 2.0 * reach,
        }
    }
}

struct Meridians {
    sin: f64,
    cos: f64,
    /// The azimuths above the horizon: to so far on either side of 0.
    reach: f64,
    weight: f64,
}

impl Meridians {
    fn place(&self, chart: &Chart, y: f64) -> (DVec3, f64) {
        let (sin, cos) = (self.reach * (2.0 * y - 1.0)).sin_cos();
        let [first, second, pole] = chart.axes;
        let direction = pole * self.cos + (first * cos + second * sin) * self.sin;
        let [pole, zero] = chart.heights;
        let height = pole * self.cos + zero * cos * self.sin;
        (direction, self.weight * height.max(0.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::quadrature::best_of;
    use bxdf::math::frame::direction_from_degrees;

    #[test]
    fn charts_cover_the_hemisphere() {
        // The integrals of cos, of cos^3 and of cos x^2 over a hemisphere.
        let exact = [PI, FRAC_PI_2, PI / 4.0];
        for theta in [0.0, 1e-7, 30.0, 60.0, 89.9, 90.0, 135.0] {
            let held = direction_from_degrees(theta, 20.0);
            for side in [Side::Reflection, Side::Transmission] {
                for chart in Chart::of_side(held, side) {
                    let moments = |points: &[[f64; 2]]| -> Vec<[f64; 3]> {
                        let moments = |(direction, weight): (DVec3, f64)| {
                            let is_there =
                                (direction.z * held.z >= -1e-15) == (side == Side::Reflection);
                            assert!(is_there || weight < 1e-12 || theta == 90.0);
                            assert!((direction.length() - 1.0).abs() < 1e-14);
                            let [x, _, z] = direction.to_array();
                            [weight, weight * z * z, weight * x * x]
                        };
                        let (directions, weights) = chart.places(points);
                        directions.into_iter().zip(weights).map(moments).collect()
                    };
                    let found = best_of(&moments, &[], 1e-9, 1_000_000);
                    let gaps = found.value.iter().zip(exact).map(|(a, b)| (a - b).abs());
                    let gap = gaps.fold(0.0, f64::max);
                    assert!(gap < 1e-8, "{theta} {side:?}: {found:?}");
                }
            }
        }
    }
}
