//! Half vector and difference as four numbers, without trigonometry.
//!
//! An angle theta of 0..90 degrees is told by x = sqrt(1 - cos(theta)), 0..1 and all but in proportion to it; the half
//! vector's by the square root of that, which has its nodes closer about the normal. An azimuth is told by quarters
//! 0..4: the place on the square |x| + |y| = 1, which the ray meets.

use crate::math::{Real, Vec3};

/// The cosine to which directions at or below the horizon are lifted.
const LOWEST: f64 = 1e-3;

/// Where a pair of directions stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Place<R> {
    /// Quarters of the half vector's azimuth, 0..4.
    pub turn: R,
    /// (1 - cos(theta_h))^(1/4), 0..1.
    pub half: R,
    /// sqrt(1 - cos(theta_d)), 0..1.
    pub difference: R,
    /// Quarters of phi_d, 0..2: both ways between two directions have the same.
    pub azimuth: R,
}

/// Two neighbouring nodes along a coordinate, and how far from the first to the second, 0..1.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cell<R> {
    pub first: usize,
    pub second: usize,
    pub t: R,
}

impl<R: Real> Place<R> {
    /// Of two unit directions above the surface and their half vector.
    #[inline(always)]
    pub(super) fn of(wo: Vec3<R>, wi: Vec3<R>, wh: Vec3<R>) -> Self {
        let one = R::one();
        let sin2_h = wh.x * wh.x + wh.y * wh.y;
        let sin_h = sin2_h.sqrt();
        // Half the difference: as long as the sine of theta_d.
        let d = (wi - wo) * R::of(0.5);
        let sin2_d = d.length_squared();
        let cos_d = wh.dot(wi);
        // Along the meridian of the half vector and across it; at the pole along s and t.
        let (x, y) = if sin_h > R::zero() {
            let (c, s) = (wh.x / sin_h, wh.y / sin_h);
            ((d.x * c + d.y * s) * wh.z - d.z * sin_h, d.y * c - d.x * s)
        } else {
            (d.x, d.y)
        };
        let azimuth = quarters(x, y);
        let two = R::of(2.0);
        Self {
            turn: quarters(wh.x, wh.y),
            half: (sin2_h / (one + wh.z)).sqrt().sqrt().at_most(one),
            difference: (sin2_d / (one + cos_d)).sqrt().at_most(one),
            azimuth: if azimuth >= two {
                azimuth - two
            } else {
                azimuth
            },
        }
    }
}

impl Place<f64> {
    /// Directions wo and wi that stand here, lifted above the horizon where they are not.
    pub(super) fn directions(&self) -> (Vec3<f64>, Vec3<f64>) {
        let [cos_h, cos_d] = [self.half.powi(4), self.difference.powi(2)].map(|x| 1.0 - x);
        let sin = |cos: f64| ((1.0 - cos) * (1.0 + cos)).max(0.0).sqrt();
        let (sin_h, sin_d) = (sin(cos_h), sin(cos_d));
        let [c, s] = unit(self.turn);
        let [x, y] = unit(self.azimuth);
        let half = Vec3::new(sin_h * c, sin_h * s, cos_h);
        let along = Vec3::new(cos_h * c, cos_h * s, -sin_h);
        let across = Vec3::new(-s, c, 0.0);
        let d = (along * x + across * y) * sin_d;
        let lifted = |w: Vec3<f64>| Vec3::new(w.x, w.y, w.z.max(LOWEST)).unit();
        (lifted(half * cos_d - d), lifted(half * cos_d + d))
    }
}

/// Quarters of a turn from x towards y, 0..4; 0 at the origin.
#[inline(always)]
fn quarters<R: Real>(x: R, y: R) -> R {
    let sum = x.abs() + y.abs();
    if sum <= R::zero() {
        return R::zero();
    }
    let along = x / sum;
    if y < R::zero() {
        R::of(3.0) + along
    } else {
        R::one() - along
    }
}

/// The unit vector after so many quarters.
fn unit(quarters: f64) -> [f64; 2] {
    let (x, y) = if quarters <= 2.0 {
        (1.0 - quarters, 1.0 - (1.0 - quarters).abs())
    } else {
        (quarters - 3.0, (quarters - 3.0).abs() - 1.0)
    };
    let length = x.hypot(y);
    [x / length, y / length]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quarters_go_once_around() {
        for index in 0..40 {
            let wanted = f64::from(index) * 0.1;
            let [x, y] = unit(wanted);
            assert!((quarters(x, y) - wanted).abs() < 1e-14, "{wanted}");
            assert!((x.hypot(y) - 1.0).abs() < 1e-14);
        }
        assert_eq!(quarters(0.0, 0.0), 0.0);
        assert_eq!(unit(1.0), [0.0, 1.0]);
    }

    #[test]
    fn places_give_directions_and_directions_places() {
        for turn in [0.0, 0.7, 2.4, 3.9] {
            for half in [0.05, 0.3, 0.55] {
                for difference in [0.02, 0.3] {
                    for azimuth in [0.1, 0.9, 1.7] {
                        let place = Place {
                            turn,
                            half,
                            difference,
                            azimuth,
                        };
                        let (wo, wi) = place.directions();
                        let wh = (wo + wi).unit();
                        let found = Place::of(wo, wi, wh);
                        let gaps = [
                            // Once around is no distance.
                            (found.turn - turn + 6.0) % 4.0 - 2.0,
                            found.half - half,
                            found.difference - difference,
                            found.azimuth - azimuth,
                        ];
                        assert!(
                            gaps.iter().all(|gap| gap.abs() < 1e-9),
                            "{place:?} {found:?}"
                        );
                        // The other way between them stands at the same place.
                        let back = Place::of(wi, wo, wh);
                        assert!((back.azimuth - found.azimuth).abs() < 1e-12);
                    }
                }
            }
        }
    }
}
