//! The number type every model is written over.

use std::fmt::Debug;

use num_traits::{Float, FloatConst};
use xprec::Df64;

use super::special::{error_function, turn};

/// A floating-point type a model can be evaluated in: `f32`, `f64`, or [`Df64`] (double-double, 2 x 53 bits), which
/// serves as the *reference*.
///
/// Models use only what [`Float`] and [`FloatConst`] offer, less `mul_add` (a slow library call without the target
/// feature), and less `cbrt` and `integer_decode`, which xprec does not implement.
pub trait Real: Float + FloatConst + Debug + Send + Sync + 'static {
    /// How batches hold such numbers: `f32` for [`Fast`](super::Fast) ones, else the type itself.
    type Stored: Copy + Debug + Send + Sync + 'static;

    /// The name of the precision at the command line: `f32`, `f64` or `reference`.
    const NAME: &'static str;

    /// Unit round-off: the largest relative error of one rounded operation.
    const UNIT_ROUNDOFF: f64;

    /// Whether loops over it can be compiled for wide registers.
    const VECTORISES: bool;

    /// Whether they are, for the widest that a machine has.
    const DISPATCHES: bool;

    /// Whether those over one lobe are, too: only where lobes are integrated.
    const DISPATCHES_LOBES: bool;

    /// Whether loops with elementary functions can, too.
    const FUNCTIONS_VECTORISE: bool;

    /// A power of two whose square, and the reciprocal of it, are far from the ends of the range: what lies between it
    /// and its reciprocal can be squared.
    const SQUARABLE: f64;

    /// A power of two that brings what is below [`Self::SQUARABLE`], subnormal numbers too, to where squares keep their
    /// digits; its reciprocal does so from above.
    const RESCALE: f64;

    /// The value of this type nearest to `x`.
    fn of(x: f64) -> Self;

    /// The number that is `stored`.
    fn load(stored: Self::Stored) -> Self;

    /// The number as it is stored.
    fn store(self) -> Self::Stored;

    /// The `f64` nearest to `self`.
    fn as_f64(self) -> f64;

    /// The error function 2/sqrt(pi) times the integral of exp(-t^2) from 0 to `self`.
    #[must_use]
    fn erf(self) -> Self;

    /// 1 - erf(`self`), which keeps its digits where `self` is large.
    #[must_use]
    fn erfc(self) -> Self;

    /// The integral of erfc from `self`, 0 or more, on: good to the rounding of its sum with `self`.
    #[must_use]
    #[inline(always)]
    fn ierfc(self) -> Self {
        Self::of(0.5) * Self::FRAC_2_SQRT_PI() * (-(self * self)).exp() - self * self.erfc()
    }

    /// Sine and cosine of the angle of `self` turns, 2 pi `self`.
    #[inline(always)]
    fn sin_cos_turn(self) -> (Self, Self) {
        Float::sin_cos(Self::TAU() * self)
    }

    /// `self` squared.
    #[must_use]
    #[inline(always)]
    fn sqr(self) -> Self {
        self * self
    }

    /// The square root of `self`, 0 for the tiny negative numbers that rounding leaves where a true zero was meant.
    #[must_use]
    #[inline(always)]
    fn sqrt_clamped(self) -> Self {
        if self > Self::zero() {
            self.sqrt()
        } else {
            Self::zero()
        }
    }

    /// The larger of two numbers, `least` where `self` is none: one instruction, which `max` is not.
    #[must_use]
    #[inline(always)]
    fn at_least(self, least: Self) -> Self {
        if self > least { self } else { least }
    }

    /// The smaller of two numbers, `most` where `self` is none.
    #[must_use]
    #[inline(always)]
    fn at_most(self, most: Self) -> Self {
        if self < most { self } else { most }
    }

    /// Two powers of two of product 1: the first brings a number of this magnitude to where its square neither over- nor
    /// underflows. Both are 1 for all but extreme numbers.
    #[must_use]
    #[inline(always)]
    fn rescaling(self) -> (Self, Self) {
        let (one, up) = (Self::one(), Self::of(Self::RESCALE));
        let (down, smallest) = (Self::of(1.0 / Self::RESCALE), Self::of(Self::SQUARABLE));
        if self < smallest {
            (up, down)
        } else if self > Self::of(1.0 / Self::SQUARABLE) {
            (down, up)
        } else {
            (one, one)
        }
    }

    /// [`Self::rescaling`] of a number that is not extremely large.
    #[must_use]
    #[inline(always)]
    fn raising(self) -> (Self, Self) {
        if self < Self::of(Self::SQUARABLE) {
            (Self::of(Self::RESCALE), Self::of(1.0 / Self::RESCALE))
        } else {
            (Self::one(), Self::one())
        }
    }

    /// `self` where it is a number up to the largest finite one, the largest finite one otherwise.
    ///
    /// For values whose true size overflows the type. A double-double overflow yields NaN rather than infinity,
    /// therefore NaN saturates too.
    #[must_use]
    #[inline(always)]
    fn saturated(self) -> Self {
        self.at_most(Self::max_value())
    }
}

/// 2 to the power `exponent`, within the normal numbers.
const fn power_of_two(exponent: i64) -> f64 {
    f64::from_bits(((1023 + exponent) as u64) << 52)
}

impl Real for f32 {
    type Stored = Self;
    const NAME: &'static str = "f32";
    const VECTORISES: bool = true;
    // Plain `f32` is what the library's functions are measured with: those are no loops.
    const DISPATCHES: bool = false;
    const DISPATCHES_LOBES: bool = false;
    const FUNCTIONS_VECTORISE: bool = false;
    const UNIT_ROUNDOFF: f64 = f32::EPSILON as f64 / 2.0;
    const SQUARABLE: f64 = power_of_two(-60);
    const RESCALE: f64 = power_of_two(90);

    #[inline(always)]
    fn of(x: f64) -> Self {
        x as Self
    }

    #[inline(always)]
    fn load(stored: Self) -> Self {
        stored
    }

    #[inline(always)]
    fn store(self) -> Self {
        self
    }

    #[inline(always)]
    fn as_f64(self) -> f64 {
        f64::from(self)
    }

    #[inline]
    fn erf(self) -> Self {
        libm::erff(self)
    }

    #[inline]
    fn erfc(self) -> Self {
        libm::erfcf(self)
    }
}

impl Real for f64 {
    type Stored = Self;
    const NAME: &'static str = "f64";
    const VECTORISES: bool = true;
    const DISPATCHES: bool = true;
    const DISPATCHES_LOBES: bool = true;
    const FUNCTIONS_VECTORISE: bool = false;
    const UNIT_ROUNDOFF: f64 = f64::EPSILON / 2.0;
    const SQUARABLE: f64 = power_of_two(-400);
    const RESCALE: f64 = power_of_two(600);

    #[inline(always)]
    fn of(x: f64) -> Self {
        x
    }

    #[inline(always)]
    fn load(stored: Self) -> Self {
        stored
    }

    #[inline(always)]
    fn store(self) -> Self {
        self
    }

    #[inline(always)]
    fn as_f64(self) -> f64 {
        self
    }

    #[inline]
    fn erf(self) -> Self {
        libm::erf(self)
    }

    #[inline(always)]
    fn sin_cos_turn(self) -> (Self, Self) {
        turn::sin_cos_turn(self)
    }

    #[inline]
    fn erfc(self) -> Self {
        libm::erfc(self)
    }
}

impl Real for Df64 {
    type Stored = Self;
    const NAME: &'static str = "reference";
    const VECTORISES: bool = false;
    const DISPATCHES: bool = false;
    const DISPATCHES_LOBES: bool = false;
    const FUNCTIONS_VECTORISE: bool = false;
    const UNIT_ROUNDOFF: f64 = f64::EPSILON * f64::EPSILON / 4.0;
    const SQUARABLE: f64 = f64::SQUARABLE;
    const RESCALE: f64 = f64::RESCALE;

    #[inline(always)]
    fn of(x: f64) -> Self {
        Self::new(x)
    }

    #[inline(always)]
    fn load(stored: Self) -> Self {
        stored
    }

    #[inline(always)]
    fn store(self) -> Self {
        self
    }

    #[inline(always)]
    fn as_f64(self) -> f64 {
        self.hi() + self.lo()
    }

    #[inline]
    fn erf(self) -> Self {
        error_function::erf(self)
    }

    #[inline]
    fn erfc(self) -> Self {
        error_function::erfc(self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn elementary<R: Real>() {
        assert_eq!(R::of(0.0).sqrt().as_f64(), 0.0);
        assert_eq!(R::of(-1e-30).sqrt_clamped().as_f64(), 0.0);
        assert_eq!(R::of(2.25).sqrt_clamped().as_f64(), 1.5);
        let overflowed = R::max_value() * R::of(4.0);
        assert!(overflowed.saturated().is_finite(), "{}", R::NAME);
        assert_eq!(R::of(1.5).saturated().as_f64(), 1.5);
    }

    #[test]
    fn every_precision_has_the_same_elementary_behaviour() {
        elementary::<f32>();
        elementary::<f64>();
        elementary::<Df64>();
    }

    #[test]
    fn the_reference_carries_thirty_digits() {
        let third = Df64::of(1.0) / Df64::of(3.0);
        let error = (third * Df64::of(3.0) - Df64::of(1.0)).as_f64().abs();
        // Two roundings of at most 2^-104 each.
        assert!(error < 1e-31, "{error}");
        let sqrt_two = Df64::of(2.0).sqrt();
        assert!((sqrt_two.sqr() - Df64::of(2.0)).as_f64().abs() < 1e-31);
    }
}
