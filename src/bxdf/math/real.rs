//! The number type every model is written over.

use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A floating-point type a model can be evaluated in: `f32`, `f64`, or [`Df64`](xprec::Df64) (double-double, 2 x 53 bits), which
/// serves as the *reference*.
///
/// It has what models use and no more. There is no fused multiply-add: it is a slow library call without the target feature.
///
/// The elementary functions of `f32` are polynomials, so that loops over them are compiled for wide registers: with their
/// errors, a few units of round-off, every model keeps the stability law that it keeps with the functions of the system's
/// library. f64 and the reference have their libraries' functions.
pub trait Real:
    Copy
    + Debug
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + Send
    + Sync
    + 'static
{
    /// The name of the precision at the command line: `f32`, `f64` or `reference`.
    const NAME: &'static str;

    /// Unit round-off: the largest relative error of one rounded operation.
    const UNIT_ROUNDOFF: f64;

    /// Whether loops over it are compiled for the widest registers that a machine has.
    const VECTORISES: bool;

    /// Whether those over one lobe are, too: only where lobes are integrated.
    const LOBES_VECTORISE: bool;

    /// Whether those with elementary functions are, too.
    const FUNCTIONS_VECTORISE: bool;

    /// A power of two whose square, and the reciprocal of it, are far from the ends of the range: what lies between it
    /// and its reciprocal can be squared.
    const SQUARABLE: f64;

    /// A power of two that brings what is below [`Self::SQUARABLE`], subnormal numbers too, to where squares keep their
    /// digits; its reciprocal does so from above.
    const RESCALE: f64;

    /// The value of this type nearest to `x`.
    fn of(x: f64) -> Self;

    /// The `f64` nearest to `self`.
    fn as_f64(self) -> f64;

    /// 0.
    #[must_use]
    fn zero() -> Self;

    /// 1.
    #[must_use]
    fn one() -> Self;

    /// pi.
    #[must_use]
    fn pi() -> Self;

    /// 2 pi.
    #[must_use]
    fn tau() -> Self;

    /// pi / 2.
    #[must_use]
    fn frac_pi_2() -> Self;

    /// 1 / pi.
    #[must_use]
    fn frac_1_pi() -> Self;

    /// 2 / sqrt(pi).
    #[must_use]
    fn frac_2_sqrt_pi() -> Self;

    /// 1 / sqrt(2).
    #[must_use]
    fn frac_1_sqrt_2() -> Self;

    /// The natural logarithm of 2.
    #[must_use]
    fn ln_2() -> Self;

    /// The distance from 1 to the next larger number.
    #[must_use]
    fn epsilon() -> Self;

    /// The smallest positive normal number.
    #[must_use]
    fn min_positive_value() -> Self;

    /// The largest finite number.
    #[must_use]
    fn max_value() -> Self;

    /// Whether it is no number.
    #[must_use]
    fn is_nan(self) -> bool;

    /// Whether it is a number and finite.
    #[must_use]
    fn is_finite(self) -> bool;

    /// The magnitude.
    #[must_use]
    fn abs(self) -> Self;

    /// The largest whole number that is not above `self`.
    #[must_use]
    fn floor(self) -> Self;

    /// The square root.
    #[must_use]
    fn sqrt(self) -> Self;

    /// 1 / `self`.
    #[must_use]
    fn recip(self) -> Self;

    /// e to the power `self`.
    #[must_use]
    fn exp(self) -> Self;

    /// e to the power `self`, less 1, which keeps its digits near 0.
    #[must_use]
    fn exp_m1(self) -> Self;

    /// The natural logarithm.
    #[must_use]
    fn ln(self) -> Self;

    /// The natural logarithm of 1 + `self`, which keeps its digits near 0.
    #[must_use]
    fn ln_1p(self) -> Self;

    /// The sine of `self` radians.
    #[must_use]
    fn sin(self) -> Self;

    /// The cosine of `self` radians.
    #[must_use]
    fn cos(self) -> Self;

    /// Sine and cosine of `self` radians.
    fn sin_cos(self) -> (Self, Self);

    /// The larger of two numbers; the other one where one is none.
    #[must_use]
    fn max(self, other: Self) -> Self;

    /// The smaller of two numbers; the other one where one is none.
    #[must_use]
    fn min(self, other: Self) -> Self;

    /// The square root of the sum of both squares, without overflow.
    #[must_use]
    fn hypot(self, other: Self) -> Self;

    /// `self`, above 0, to the power `exponent`.
    #[must_use]
    fn powf(self, exponent: Self) -> Self;

    /// The angle of (`x`, `self`) from the first axis, in radians, -pi..pi.
    #[must_use]
    fn atan2(self, x: Self) -> Self;

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
        Self::of(0.5) * Self::frac_2_sqrt_pi() * (-(self * self)).exp() - self * self.erfc()
    }

    /// Sine and cosine of the angle of `self` turns, 2 pi `self`.
    #[inline(always)]
    fn sin_cos_turn(self) -> (Self, Self) {
        (Self::tau() * self).sin_cos()
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
