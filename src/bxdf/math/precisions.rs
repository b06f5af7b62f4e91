//! The precisions: f32, f64, and double-double as the reference.

use num_traits::{Float, FloatConst, One, Zero};
use xprec::Df64;

use super::Real;
use super::special::{error_function, polynomial, turn};

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
