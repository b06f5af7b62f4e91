//! The slopes that a viewer sees of a surface whose slopes follow a Gaussian: the inverse of their distribution.
//!
//! # Source
//! Heitz 2014 for the distribution (`heitz2014`), Jakob 2014 for the first guess of its inverse (`jakob2014`), and Giles 2011
//! for that of erf (`giles2011`).

use crate::math::Real;

/// Visible slopes in units of alpha lie within +-10: beyond it lies a share of exp(-100) = 4e-44, less than the smallest
/// step of a random number in any precision.
const LARGEST_SLOPE: f64 = 10.0;

/// Steps of the inversion at most: bisection alone brings 20 down to 2e-11 in 40.
const MAX_STEPS: usize = 40;

/// The slope x, of a Gaussian exp(-x^2), that a viewer at polar angle theta sees with probability `u` or below.
///
/// Its cumulative weight is C(x) = cos erfc(-x) + sin exp(-x^2) / sqrt(pi) up to x = cot(theta), where a facet turns
/// away. C(x) = u C(cot) is solved by Halley's method inside a bracket that shrinks at every step: C is flat in the tail
/// and at the upper end, where a bare step leaves the range. The first guess is made in erf(x), in which C is
/// nearly straight.
#[inline(always)]
pub(super) fn visible_slope<R: Real>(cos: R, sin: R, u: R) -> R {
    let largest = R::of(LARGEST_SLOPE);
    let end = if largest * sin > cos {
        cos / sin
    } else {
        largest
    };
    // u = 0 stands for all numbers down to the next: half the smallest step, rather than a slope of minus infinity.
    let u = u.at_least(R::of(0.5 * R::UNIT_ROUNDOFF));
    let guess = first_guess(cos, sin, end, u);
    let mut bracket = Bracket {
        cos,
        sin,
        // C(cot), as cot sin is cos.
        target: u * (cos + cos + sin * end.ierfc()),
        low: -largest,
        high: end,
        x: guess.at_least(-largest).at_most(end),
    };
    if R::FUNCTIONS_VECTORISE {
        // As many as leave less than the rounding, written out: a loop that ends early has no wide form.
        return bracket.step().step().x;
    }
    // The digits triple: a step of sqrt(round-off) is the last that matters.
    let last_step = R::of(R::UNIT_ROUNDOFF.sqrt());
    for _ in 0..MAX_STEPS {
        let next = bracket.step();
        let step = (next.x - bracket.x).abs();
        bracket = next;
        if step <= last_step {
            break;
        }
    }
    bracket.x
}

/// The slope across the plane of sight, of which all are visible: erf(x) = 2 `u` - 1, by the fit of Giles 2011 for single
/// precision.
#[inline(always)]
pub(super) fn central_slope<R: Real>(u: R) -> R {
    const NEAR: [f64; 9] = [
        1.501_409_41,
        0.246_640_727,
        -0.004_177_681_64,
        -0.001_253_725_03,
        0.000_218_580_87,
        -4.391_506_54e-6,
        -3.523_387_7e-6,
        3.432_739_39e-7,
        2.810_226_36e-8,
    ];
    const FAR: [f64; 9] = [
        2.832_976_82,
        1.001_674_06,
        0.009_438_870_47,
        -0.007_622_461_3,
        0.005_739_507_73,
        -0.003_673_428_44,
        0.001_349_343_22,
        0.000_100_950_558,
        -0.000_200_214_257,
    ];
    let (one, four) = (R::one(), R::of(4.0));
    let u = u.at_least(R::of(0.5 * R::UNIT_ROUNDOFF));
    let w = -(four * u * (one - u)).ln();
    let sum = |x: R, fit: [f64; 9]| {
        let mut sum = R::zero();
        for c in fit.into_iter().rev() {
            sum = sum * x + R::of(c);
        }
        sum
    };
    let near = sum(w - R::of(2.5), NEAR);
    let far = sum(w.sqrt_clamped() - R::of(3.0), FAR);
    (u + u - one) * if w < R::of(5.0) { near } else { far }
}

/// Where the slope is sought whose cumulative weight is `target`: between `low` and `high`, at `x` next.
#[derive(Clone, Copy)]
struct Bracket<R> {
    cos: R,
    sin: R,
    target: R,
    low: R,
    high: R,
    x: R,
}

impl<R: Real> Bracket<R> {
    /// The bracket after one step of Halley's method, or a bisection where that would leave it.
    #[inline(always)]
    fn step(self) -> Self {
        let Self { cos, sin, x, .. } = self;
        let bell = R::frac_2_sqrt_pi() * (-(x * x)).exp();
        let excess = cos * (-x).erfc() + sin * bell * R::of(0.5) - self.target;
        let is_below = excess < R::zero();
        let low = if is_below { x } else { self.low };
        let high = if is_below { self.high } else { x };
        // C' = bell seen, C'' / C' = -2 x - sin / seen; all by one division.
        let seen = cos - x * sin;
        let twice = seen + seen;
        let next = x - twice * excess / (twice * (bell * seen + excess * x) + excess * sin);
        let middle = (low + high) * R::of(0.5);
        let is_inside = next >= low && next <= high;
        Self {
            low,
            high,
            x: if is_inside { next } else { middle },
            ..self
        }
    }
}

/// A visible slope to about 1 %, of those up to `end`: Jakob's fit of erf(x), and Winitzki's elementary inverse of erf.
#[inline(always)]
fn first_guess<R: Real>(cos: R, sin: R, end: R, u: R) -> R {
    /// The coefficients of Jakob 2014, in the polar angle.
    const FIT: [f64; 3] = [-0.876, 0.4265, -0.0594];
    /// Winitzki's constant.
    const A: f64 = 0.147;
    let (one, half) = (R::one(), R::of(0.5));
    let theta = sin.atan2(cos);
    let [c1, c2, c3] = FIT.map(R::of);
    let exponent = one + theta * (c1 + theta * (c2 + theta * c3));
    let erf_end = end.erf();
    let y = erf_end - (one + erf_end) * ((one - u).ln() * exponent).exp();
    // Kept off +-1, where the inverse is infinite.
    let most = one - R::of(4.0 * R::UNIT_ROUNDOFF.max(1e-13));
    let y = y.at_least(-most).at_most(most);
    let log = ((one - y) * (one + y)).ln();
    let b = R::of(std::f64::consts::FRAC_2_PI / A) + half * log;
    let square = (b * b - log / R::of(A)).sqrt() - b;
    let magnitude = square.sqrt_clamped();
    if y < R::zero() { -magnitude } else { magnitude }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slopes_invert_their_distribution_at_every_angle() {
        fn round_trip<R: Real>(tolerance: f64) {
            for cos in [1.0, 0.999, 0.5, 1e-3, 1e-20] {
                let sin = f64::sqrt((1.0 - cos) * (1.0 + cos));
                let (cos, sin) = (R::of(cos), R::of(sin));
                let weight = |x: R| {
                    cos * (-x).erfc() + sin * (-(x * x)).exp() * R::frac_2_sqrt_pi() * R::of(0.5)
                };
                let end = if sin > R::zero() {
                    cos / sin
                } else {
                    R::of(LARGEST_SLOPE)
                };
                let end = end.min(R::of(LARGEST_SLOPE));
                for u in [1e-6, 1e-3, 0.1, 0.5, 0.9, 0.999, 1.0 - 1e-6] {
                    let u = R::of(u);
                    let x = visible_slope(cos, sin, u);
                    let back = weight(x) / weight(end);
                    assert!(
                        (back - u).as_f64().abs() < tolerance,
                        "{} {cos:?} {u:?}: {back:?}",
                        R::NAME
                    );
                }
                for u in [R::zero(), R::one() - R::of(R::UNIT_ROUNDOFF)] {
                    // The fit is for single precision, and used there alone.
                    let is_fitted = R::FUNCTIONS_VECTORISE;
                    assert!(!is_fitted || central_slope(u).abs() <= R::of(LARGEST_SLOPE));
                    assert!(visible_slope(cos, sin, u).abs() <= R::of(LARGEST_SLOPE));
                }
            }
        }
        for u in [
            1e-7_f32,
            1e-6,
            1e-3,
            0.1,
            0.499,
            0.5,
            0.9,
            0.999,
            1.0 - 1e-6,
        ] {
            let back = 0.5 * Real::erfc(-f64::from(central_slope(u)));
            assert!((back - f64::from(u)).abs() < 3e-7, "{u}: {back}");
        }
        // A dozen roundings; in the reference precision the last step of 1e-16 leaves its square.
        round_trip::<f32>(1e-6);
        round_trip::<f32>(1e-6);
        round_trip::<f64>(2e-15);
        round_trip::<xprec::Df64>(1e-29);
    }
}
