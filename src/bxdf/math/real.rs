//! The number type every model is written over.

use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

use num_traits::{Float, FloatConst, One, Zero};
use xprec::Df64;

use super::special::{error_function, polynomial, turn};

/// A floating-point type a model can be evaluated in: `f32`, `f64`, or [`Df64`] (double-double, 2 x 53 bits), which
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

/// 2 to the power `exponent`, within the normal numbers.
const fn power_of_two(exponent: i64) -> f64 {
    f64::from_bits(((1023 + exponent) as u64) << 52)
}

/// Methods that a type has from num_traits as they are, by what they take and give.
macro_rules! as_float {
    (constant $($name:ident)*) => {$(
        #[inline(always)]
        fn $name() -> Self {
            <Self as Float>::$name()
        }
    )*};
    (is $($name:ident)*) => {$(
        #[inline(always)]
        fn $name(self) -> bool {
            <Self as Float>::$name(self)
        }
    )*};
    (unary $($name:ident)*) => {$(
        #[inline(always)]
        fn $name(self) -> Self {
            <Self as Float>::$name(self)
        }
    )*};
    (binary $($name:ident)*) => {$(
        #[inline(always)]
        fn $name(self, other: Self) -> Self {
            <Self as Float>::$name(self, other)
        }
    )*};
    (pair $($name:ident)*) => {$(
        #[inline(always)]
        fn $name(self) -> (Self, Self) {
            <Self as Float>::$name(self)
        }
    )*};
}

/// What every number of num_traits has alike: constants, comparisons, and what is one instruction.
macro_rules! arithmetic {
    () => {
        as_float!(constant epsilon min_positive_value max_value);
        as_float!(is is_nan is_finite);
        as_float!(unary abs floor sqrt recip);
        as_float!(binary max min hypot);
        arithmetic!(pi = PI, tau = TAU, frac_pi_2 = FRAC_PI_2, frac_1_pi = FRAC_1_PI, frac_2_sqrt_pi = FRAC_2_SQRT_PI,
            frac_1_sqrt_2 = FRAC_1_SQRT_2, ln_2 = LN_2);

        #[inline(always)]
        fn zero() -> Self {
            <Self as Zero>::zero()
        }

        #[inline(always)]
        fn one() -> Self {
            <Self as One>::one()
        }
    };
    ($($name:ident = $constant:ident),*) => {$(
        #[inline(always)]
        fn $name() -> Self {
            <Self as FloatConst>::$constant()
        }
    )*};
}

/// Methods that are polynomials.
macro_rules! polynomials {
    (unary $($name:ident)*) => {$(
        #[inline(always)]
        fn $name(self) -> Self {
            polynomial::$name(self)
        }
    )*};
    (binary $($name:ident)*) => {$(
        #[inline(always)]
        fn $name(self, other: Self) -> Self {
            polynomial::$name(self, other)
        }
    )*};
    (pair $($name:ident)*) => {$(
        #[inline(always)]
        fn $name(self) -> (Self, Self) {
            polynomial::$name(self)
        }
    )*};
}

impl Real for f32 {
    const NAME: &'static str = "f32";
    const VECTORISES: bool = true;
    const LOBES_VECTORISE: bool = false;
    const FUNCTIONS_VECTORISE: bool = true;
    const UNIT_ROUNDOFF: f64 = f32::EPSILON as f64 / 2.0;
    const SQUARABLE: f64 = power_of_two(-60);
    const RESCALE: f64 = power_of_two(90);

    arithmetic!();
    polynomials!(unary exp exp_m1 ln ln_1p erf erfc ierfc);
    polynomials!(binary atan2);
    polynomials!(pair sin_cos sin_cos_turn);

    #[inline(always)]
    fn of(x: f64) -> Self {
        x as Self
    }

    #[inline(always)]
    fn as_f64(self) -> f64 {
        f64::from(self)
    }

    #[inline(always)]
    fn sin(self) -> Self {
        polynomial::sin_cos(self).0
    }

    #[inline(always)]
    fn cos(self) -> Self {
        polynomial::sin_cos(self).1
    }

    #[inline(always)]
    fn powf(self, exponent: Self) -> Self {
        polynomial::exp(exponent * polynomial::ln(self))
    }
}

impl Real for f64 {
    const NAME: &'static str = "f64";
    const VECTORISES: bool = true;
    const LOBES_VECTORISE: bool = true;
    const FUNCTIONS_VECTORISE: bool = false;
    const UNIT_ROUNDOFF: f64 = f64::EPSILON / 2.0;
    const SQUARABLE: f64 = power_of_two(-400);
    const RESCALE: f64 = power_of_two(600);

    arithmetic!();
    as_float!(unary exp exp_m1 ln ln_1p sin cos);
    as_float!(binary powf atan2);
    as_float!(pair sin_cos);

    #[inline(always)]
    fn of(x: f64) -> Self {
        x
    }

    #[inline(always)]
    fn as_f64(self) -> f64 {
        self
    }

    #[inline]
    fn erf(self) -> Self {
        libm::erf(self)
    }

    #[inline]
    fn erfc(self) -> Self {
        libm::erfc(self)
    }

    #[inline(always)]
    fn sin_cos_turn(self) -> (Self, Self) {
        turn::sin_cos_turn(self)
    }
}

impl Real for Df64 {
    const NAME: &'static str = "reference";
    const VECTORISES: bool = false;
    const LOBES_VECTORISE: bool = false;
    const FUNCTIONS_VECTORISE: bool = false;
    const UNIT_ROUNDOFF: f64 = f64::EPSILON * f64::EPSILON / 4.0;
    const SQUARABLE: f64 = f64::SQUARABLE;
    const RESCALE: f64 = f64::RESCALE;

    arithmetic!();
    as_float!(unary exp exp_m1 ln ln_1p sin cos);
    as_float!(binary powf atan2);
    as_float!(pair sin_cos);

    #[inline(always)]
    fn of(x: f64) -> Self {
        Self::new(x)
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
