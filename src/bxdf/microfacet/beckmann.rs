//! The anisotropic Beckmann distribution, slopes of a Gaussian, with Smith masking by the exact error function.
//!
//! # Source
//! Beckmann & Spizzichino 1963 (`beckmann1963`), Walter et al. 2007, eqs. 25 to 29 (`walter2007`), Heitz 2014 for Lambda
//! and the distribution of visible slopes (`heitz2014`); Jakob 2014 for the first guess of its inverse (`jakob2014`), and Giles
//! 2011 for that of erf (`giles2011`).
//!
//! # Departures
//! None in value: masking uses erf itself, not the popular rational fit (`beckmann_rational`), so that sampling and density
//! agree. With A = cot(theta) / alpha and s = sqrt(alpha_x^2 x^2 + alpha_y^2 y^2), so that A = z / s,
//! z (1 + 2 Lambda) = z + s (exp(-A^2) / sqrt(pi) - A erfc(A)): a sum of positive terms, the second of which is at most
//! the rounding of the first where its own difference cancels; and no tangent.

use super::{Masked, Normals};
use crate::bxdf::math::{Real, Vec3};

/// Below this cos^2 the exponent of D is beyond 1 / 1e-3 - 1 = 999 for every width to 1: exp underflows to 0 in every
/// precision, and the division by cos^4 must not get the chance to make that 0 / 0.
const SMALLEST_COS_SQUARED: f64 = 1e-3;

/// Where A stops to matter: erf(30) = 1 and exp(-900) = 0 in every precision. Caps A = z / 0 at normal incidence.
const LARGEST_A: f64 = 30.0;

/// Visible slopes in units of alpha lie within +-10: beyond it lies a share of exp(-100) = 4e-44, less than the smallest
/// step of a random number in any precision.
const LARGEST_SLOPE: f64 = 10.0;

/// Steps of the inversion at most: bisection alone brings 20 down to 2e-11 in 40.
const MAX_STEPS: usize = 40;

/// Beckmann with widths `alpha_x`, `alpha_y` along s and t, both above 0.
#[derive(Clone, Copy, Debug)]
pub struct Beckmann<R> {
    alpha_x: R,
    alpha_y: R,
    /// Their reciprocals.
    per_alpha: [R; 2],
    /// 1 / (pi alpha_x alpha_y), D at the pole.
    peak: R,
}

impl<R: Real> Beckmann<R> {
    /// The distribution with these widths, used as given.
    pub fn new(alpha_x: R, alpha_y: R) -> Self {
        let one = R::one();
        Self {
            alpha_x,
            alpha_y,
            per_alpha: [one / alpha_x, one / alpha_y],
            peak: one / (R::PI() * (alpha_x * alpha_y)),
        }
    }

    /// |z| (1 + 2 Lambda(w)): what `Ggx::stretched_length` is for GGX.
    #[inline(always)]
    pub fn masking_length(&self, w: Vec3<R>) -> R {
        let (z, s, a) = self.z_s_a(w);
        z + s * a.ierfc()
    }

    /// |z| and s: A is their quotient.
    #[inline(always)]
    pub(super) fn cosine_and_spread(&self, w: Vec3<R>) -> (R, R) {
        let (x, y) = (self.alpha_x * w.x, self.alpha_y * w.y);
        (w.z.abs(), (x * x + y * y).sqrt())
    }

    #[inline(always)]
    fn z_s_a(&self, w: Vec3<R>) -> (R, R, R) {
        let (z, s) = self.cosine_and_spread(w);
        let largest = R::of(LARGEST_A);
        let a = if largest * s > z { z / s } else { largest };
        (z, s, a)
    }
}

impl<R: Real> Normals<R> for Beckmann<R> {
    /// The density of microfacet normals at the unit normal `wh`, in 1/sr; the same on both sides. It may underflow to 0.
    #[inline(always)]
    fn d(&self, wh: Vec3<R>) -> R {
        let z2 = wh.z * wh.z;
        let safe_z2 = z2.max(R::of(SMALLEST_COS_SQUARED));
        let [per_x, per_y] = self.per_alpha;
        let (x, y) = (wh.x * per_x, wh.y * per_y);
        let per_z2 = R::one() / safe_z2;
        let bell = (-(x * x + y * y) * per_z2).exp();
        let density = self.peak * bell * (per_z2 * per_z2);
        if z2 < safe_z2 { R::zero() } else { density }
    }

    #[inline(always)]
    fn masked(&self, w: Vec3<R>) -> Masked<R> {
        Masked {
            mu: w.z.abs(),
            t: self.masking_length(w),
        }
    }

    /// 2 |z| Lambda(w): [`Self::masking_length`] less |z|, without their difference.
    #[inline(always)]
    fn masking_excess(&self, w: Vec3<R>) -> R {
        let (z, s, a) = self.z_s_a(w);
        let excess = s * (-(a * a)).exp() * R::FRAC_2_SQRT_PI() * R::of(0.5) - z * a.erfc();
        excess.max(R::zero())
    }

    /// A visible normal of `wo` (on the upper side): visible slopes of the surface stretched to unit width, turned to
    /// the azimuth of `wo` and stretched back.
    #[inline(always)]
    fn sample_visible_normal(&self, wo: Vec3<R>, u: [R; 2]) -> Option<Vec3<R>> {
        let (v, _) =
            Vec3::new(self.alpha_x * wo.x, self.alpha_y * wo.y, wo.z).unit_and_length_of_short()?;
        let sin = (v.x * v.x + v.y * v.y).sqrt();
        let (cos_phi, sin_phi) = if sin > R::zero() {
            (v.x / sin, v.y / sin)
        } else {
            (R::one(), R::zero())
        };
        let along = visible_slope(v.z, sin, u[0]);
        let across = if R::FUNCTIONS_VECTORISE {
            central_slope(u[1])
        } else {
            visible_slope(R::one(), R::zero(), u[1])
        };
        let x = cos_phi * along - sin_phi * across;
        let y = sin_phi * along + cos_phi * across;
        let (wh, _) =
            Vec3::new(-self.alpha_x * x, -self.alpha_y * y, R::one()).unit_and_length_of_short()?;
        Some(wh)
    }
}

/// The slope x, of a Gaussian exp(-x^2), that a viewer at polar angle theta sees with probability `u` or below.
///
/// Its cumulative weight is C(x) = cos erfc(-x) + sin exp(-x^2) / sqrt(pi) up to x = cot(theta), where a facet turns
/// away. C(x) = u C(cot) is solved by Halley's method inside a bracket that shrinks at every step: C is flat in the tail
/// and at the upper end, where a bare step leaves the range. The first guess is made in erf(x), in which C is
/// nearly straight.
#[inline(always)]
fn visible_slope<R: Real>(cos: R, sin: R, u: R) -> R {
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
fn central_slope<R: Real>(u: R) -> R {
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
        let bell = R::FRAC_2_SQRT_PI() * (-(x * x)).exp();
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
    use crate::bxdf::math::Fast;

    #[test]
    fn the_peak_is_the_published_one_and_the_horizon_is_empty() {
        let normal = Vec3::new(0.0, 0.0, 1.0);
        let peak = Beckmann::new(0.1, 0.4).d(normal);
        assert!((peak * std::f64::consts::PI * 0.04 - 1.0).abs() < 1e-15);
        for z in [0.0, 1e-30, 1e-3, 0.03] {
            assert_eq!(Beckmann::new(1.0_f32, 1.0).d(Vec3::new(1.0, 0.0, z)), 0.0);
        }
    }

    #[test]
    fn lambda_is_the_published_one() {
        // Lambda = exp(-A^2)/(2 A sqrt(pi)) - erfc(A)/2, at A = 1: .025126..; and its excess form at every A.
        let beckmann = Beckmann::new(0.5, 0.5);
        for cos in [1e-3, 0.1, 0.447_213_6, 0.7, 0.99, 1.0] {
            let sin = f64::sqrt((1.0 - cos) * (1.0 + cos));
            let w = Vec3::new(sin, 0.0, cos);
            let a = cos / (0.5 * sin);
            let lambda =
                (-a * a).exp() / (2.0 * a * std::f64::consts::PI.sqrt()) - 0.5 * Real::erfc(a);
            let length = beckmann.masking_length(w);
            assert!((length / (cos * (1.0 + 2.0 * lambda)) - 1.0).abs() < 1e-14);
            assert!((beckmann.masking_excess(w) - 2.0 * cos * lambda).abs() < 1e-16);
        }
    }

    #[test]
    fn slopes_invert_their_distribution_at_every_angle() {
        fn round_trip<R: Real>(tolerance: f64) {
            for cos in [1.0, 0.999, 0.5, 1e-3, 1e-20] {
                let sin = f64::sqrt((1.0 - cos) * (1.0 + cos));
                let (cos, sin) = (R::of(cos), R::of(sin));
                let weight = |x: R| {
                    cos * (-x).erfc() + sin * (-(x * x)).exp() * R::FRAC_2_SQRT_PI() * R::of(0.5)
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
            let back = 0.5 * Real::erfc(-f64::from(central_slope(Fast(u)).0));
            assert!((back - f64::from(u)).abs() < 3e-7, "{u}: {back}");
        }
        // A dozen roundings; in the reference precision the last step of 1e-16 leaves its square.
        round_trip::<Fast<f32>>(1e-6);
        round_trip::<f32>(1e-6);
        round_trip::<f64>(2e-15);
        round_trip::<xprec::Df64>(1e-29);
    }
}
