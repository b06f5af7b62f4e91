//! f32 whose elementary functions are polynomials.

use std::fmt;
use std::num::{FpCategory, ParseFloatError};
use std::ops::{Add, Div, Mul, Neg, Rem, Sub};

use num_traits::{Float, FloatConst, Num, NumCast, One, ToPrimitive, Zero};

use super::Real;
use super::special::polynomial;

/// A number whose elementary functions are those of [`polynomial`], so that loops over them are compiled for wide
/// registers; arithmetic and square roots are the same.
///
/// This is the number in which models are evaluated in `f32`: with the errors of [`polynomial::ERRORS`] every model keeps
/// the stability law that it keeps with the functions of the system's library.
#[derive(Clone, Copy, Default, PartialEq, PartialOrd)]
pub struct Fast<T>(pub T);

impl fmt::Debug for Fast<f32> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

macro_rules! operators {
    ($($operator:ident $method:ident),*) => {$(
        impl $operator for Fast<f32> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self($operator::$method(self.0, other.0))
            }
        }
    )*};
}

operators!(Add add, Sub sub, Mul mul, Div div, Rem rem);

impl Neg for Fast<f32> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Zero for Fast<f32> {
    #[inline(always)]
    fn zero() -> Self {
        Self(0.0)
    }

    #[inline(always)]
    fn is_zero(&self) -> bool {
        self.0 == 0.0
    }
}

impl One for Fast<f32> {
    #[inline(always)]
    fn one() -> Self {
        Self(1.0)
    }
}

impl Num for Fast<f32> {
    type FromStrRadixErr = <f32 as Num>::FromStrRadixErr;

    fn from_str_radix(text: &str, radix: u32) -> Result<Self, Self::FromStrRadixErr> {
        f32::from_str_radix(text, radix).map(Self)
    }
}

impl std::str::FromStr for Fast<f32> {
    type Err = ParseFloatError;

    fn from_str(text: &str) -> Result<Self, ParseFloatError> {
        text.parse().map(Self)
    }
}

impl ToPrimitive for Fast<f32> {
    fn to_i64(&self) -> Option<i64> {
        self.0.to_i64()
    }

    fn to_u64(&self) -> Option<u64> {
        self.0.to_u64()
    }

    #[inline(always)]
    fn to_f64(&self) -> Option<f64> {
        Some(self.0.into())
    }
}

impl NumCast for Fast<f32> {
    fn from<T: ToPrimitive>(n: T) -> Option<Self> {
        n.to_f32().map(Self)
    }
}

/// Methods of f32 that stay as they are, by what they take and give.
macro_rules! as_f32 {
    (constant $($name:ident)*) => {$(
        #[inline(always)]
        fn $name() -> Self {
            Self(<f32 as Float>::$name())
        }
    )*};
    (is $($name:ident)*) => {$(
        #[inline(always)]
        fn $name(self) -> bool {
            Float::$name(self.0)
        }
    )*};
    (unary $($name:ident)*) => {$(
        #[inline(always)]
        fn $name(self) -> Self {
            Self(Float::$name(self.0))
        }
    )*};
    (binary $($name:ident)*) => {$(
        #[inline(always)]
        fn $name(self, other: Self) -> Self {
            Self(Float::$name(self.0, other.0))
        }
    )*};
}

/// Methods that are polynomials.
macro_rules! polynomials {
    ($($name:ident)*) => {$(
        #[inline(always)]
        fn $name(self) -> Self {
            Self(polynomial::$name(self.0))
        }
    )*};
}

impl Float for Fast<f32> {
    as_f32!(constant nan infinity neg_infinity neg_zero min_value min_positive_value max_value epsilon);
    as_f32!(is is_nan is_infinite is_finite is_normal is_sign_positive is_sign_negative);
    as_f32!(unary floor ceil round trunc fract abs signum recip sqrt cbrt exp2 log2 log10 tan asin acos sinh cosh tanh
        asinh acosh atanh);
    as_f32!(binary max min hypot abs_sub);
    polynomials!(exp exp_m1 ln ln_1p);

    fn classify(self) -> FpCategory {
        self.0.classify()
    }

    fn mul_add(self, a: Self, b: Self) -> Self {
        self * a + b
    }

    fn powi(self, n: i32) -> Self {
        Self(self.0.powi(n))
    }

    #[inline(always)]
    fn powf(self, n: Self) -> Self {
        (n * self.ln()).exp()
    }

    fn log(self, base: Self) -> Self {
        self.ln() / base.ln()
    }

    #[inline(always)]
    fn sin(self) -> Self {
        self.sin_cos().0
    }

    #[inline(always)]
    fn cos(self) -> Self {
        self.sin_cos().1
    }

    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = polynomial::sin_cos(self.0);
        (Self(sin), Self(cos))
    }

    #[inline(always)]
    fn atan(self) -> Self {
        self.atan2(Self(1.0))
    }

    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        Self(polynomial::atan2(self.0, x.0))
    }

    fn integer_decode(self) -> (u64, i16, i8) {
        self.0.integer_decode()
    }
}

macro_rules! constants {
    ($($name:ident)*) => {$(
        #[inline(always)]
        fn $name() -> Self {
            Self(std::f32::consts::$name)
        }
    )*};
}

impl FloatConst for Fast<f32> {
    constants!(E FRAC_1_PI FRAC_1_SQRT_2 FRAC_2_PI FRAC_2_SQRT_PI FRAC_PI_2 FRAC_PI_3 FRAC_PI_4 FRAC_PI_6 FRAC_PI_8
        LN_10 LN_2 LOG10_E LOG2_E PI SQRT_2 TAU LOG10_2 LOG2_10);
}

impl Real for Fast<f32> {
    type Stored = f32;
    const NAME: &'static str = f32::NAME;
    const VECTORISES: bool = true;
    const DISPATCHES: bool = true;
    const DISPATCHES_LOBES: bool = false;
    const FUNCTIONS_VECTORISE: bool = true;
    const UNIT_ROUNDOFF: f64 = f32::UNIT_ROUNDOFF;
    const SQUARABLE: f64 = f32::SQUARABLE;
    const RESCALE: f64 = f32::RESCALE;

    #[inline(always)]
    fn of(x: f64) -> Self {
        Self(x as f32)
    }

    #[inline(always)]
    fn load(stored: f32) -> Self {
        Self(stored)
    }

    #[inline(always)]
    fn store(self) -> f32 {
        self.0
    }

    #[inline(always)]
    fn as_f64(self) -> f64 {
        self.0.into()
    }

    #[inline(always)]
    fn erf(self) -> Self {
        Self(polynomial::erf(self.0))
    }

    #[inline(always)]
    fn erfc(self) -> Self {
        Self(polynomial::erfc(self.0))
    }

    #[inline(always)]
    fn ierfc(self) -> Self {
        Self(polynomial::ierfc(self.0))
    }

    #[inline(always)]
    fn sin_cos_turn(self) -> (Self, Self) {
        let (sin, cos) = polynomial::sin_cos_turn(self.0);
        (Self(sin), Self(cos))
    }
}
