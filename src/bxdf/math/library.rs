//! f32 with the elementary functions of the system's library.

use std::ops::{Add, Div, Mul, Neg, Sub};

use super::Real;

/// An f32 whose elementary functions are those of the system's library, in place of polynomials: with it the labs measure
/// what the polynomials change. Arithmetic is the same.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Libm(pub f32);

macro_rules! operators {
    ($($operator:ident $method:ident),*) => {$(
        impl $operator for Libm {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self($operator::$method(self.0, other.0))
            }
        }
    )*};
}

operators!(Add add, Sub sub, Mul mul, Div div);

impl Neg for Libm {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

/// Methods of `$of`, by what they take and give.
macro_rules! of {
    ($of:ty: constant $($name:ident)*) => {$(
        #[inline(always)]
        fn $name() -> Self {
            Self(<$of>::$name())
        }
    )*};
    ($of:ty: is $($name:ident)*) => {$(
        #[inline(always)]
        fn $name(self) -> bool {
            <$of>::$name(self.0)
        }
    )*};
    ($of:ty: unary $($name:ident)*) => {$(
        #[inline(always)]
        fn $name(self) -> Self {
            Self(<$of>::$name(self.0))
        }
    )*};
    ($of:ty: binary $($name:ident)*) => {$(
        #[inline(always)]
        fn $name(self, other: Self) -> Self {
            Self(<$of>::$name(self.0, other.0))
        }
    )*};
}

impl Real for Libm {
    const NAME: &'static str = f32::NAME;
    const VECTORISES: bool = false;
    const LOBES_VECTORISE: bool = false;
    const FUNCTIONS_VECTORISE: bool = false;
    const UNIT_ROUNDOFF: f64 = f32::UNIT_ROUNDOFF;
    const SQUARABLE: f64 = f32::SQUARABLE;
    const RESCALE: f64 = f32::RESCALE;

    of!(f32: constant zero one pi tau frac_pi_2 frac_1_pi frac_2_sqrt_pi frac_1_sqrt_2 ln_2 epsilon min_positive_value max_value);
    of!(f32: is is_nan is_finite);
    // The inherent functions of f32 go before those of `Real`.
    of!(f32: unary abs floor sqrt recip exp exp_m1 ln ln_1p sin cos);
    of!(f32: binary max min hypot powf atan2);

    #[inline(always)]
    fn of(x: f64) -> Self {
        Self(x as f32)
    }

    #[inline(always)]
    fn as_f64(self) -> f64 {
        self.0.into()
    }

    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.0.sin_cos();
        (Self(sin), Self(cos))
    }

    #[inline]
    fn erf(self) -> Self {
        Self(libm::erff(self.0))
    }

    #[inline]
    fn erfc(self) -> Self {
        Self(libm::erfcf(self.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn its_functions_are_the_library_s_and_f32_s_are_not() {
        let (mut differ, mut same) = (0, 0);
        for i in 1..1000_u16 {
            let x = f32::from(i) * 0.01;
            assert_eq!(Libm(x).exp().0, x.exp());
            assert_eq!(Libm(x).atan2(Libm(1.0)).0, x.atan2(1.0));
            if Real::exp(x) == x.exp() {
                same += 1;
            } else {
                differ += 1;
            }
        }
        assert!(differ > 50 && same > 50, "{differ} {same}");
    }
}
