//! Elementary functions of f32 as straight-line polynomials: a loop over them is compiled for wide registers, which a
//! loop over the system's library is not.
//!
//! Each reduces its argument to a small range, exactly or in two steps, and evaluates a minimax polynomial there. The
//! coefficients are our own fits, by iteratively reweighted least squares in Chebyshev nodes; the error of each fit, at
//! most a tenth of a rounding, is given beside it. The largest error of each function against the reference precision,
//! rounding included, is in [`ERRORS`], which a test measures. NaN is not passed on: models never give one.

/// The largest relative error of each function, in units of the round-off 2^-24, over the range beside it.
#[cfg(test)]
pub const ERRORS: [(&str, f64, [f64; 2]); 11] = [
    ("sin_turn", 2.5, [0.0, 1.0]),
    ("cos_turn", 2.5, [0.0, 1.0]),
    ("exp", 1.5, [-87.0, 88.0]),
    ("exp_m1", 2.5, [-20.0, 88.0]),
    ("ln", 1.5, [1e-38, 1e38]),
    ("ln_1p", 2.5, [-1.0, 1e6]),
    ("atan", 2.5, [0.0, 1e6]),
    ("erf", 3.5, [0.0, 4.0]),
    ("erfc", 8.0, [-4.0, 2.0]),
    // The rounding of the square of the argument is multiplied by it.
    ("erfc_tail", 80.0, [2.0, 9.0]),
    // Of the sum of x and ierfc(x).
    ("ierfc", 5.0, [0.0, 30.0]),
];

/// The sum of `coefficients`\[i\] x^i.
#[inline(always)]
fn polynomial<const N: usize>(x: f32, coefficients: [f32; N]) -> f32 {
    let mut sum = 0.0;
    for c in coefficients.into_iter().rev() {
        sum = sum * x + c;
    }
    sum
}

/// 1.5 2^23: added to a number up to 2^22, it leaves the nearest integer in the last bits.
const TO_INTEGER: f32 = 12_582_912.0;

/// The integer nearest to `x`, as a number and as an integer; |x| up to 2^22.
#[inline(always)]
fn nearest(x: f32) -> (f32, i32) {
    let shifted = x + TO_INTEGER;
    let integer = shifted.to_bits().wrapping_sub(TO_INTEGER.to_bits());
    (shifted - TO_INTEGER, integer.cast_signed())
}

/// 2^n for n in -126..=127.
#[inline(always)]
fn power_of_two(n: i32) -> f32 {
    f32::from_bits((n + 127).cast_unsigned() << 23)
}

/// Sine and cosine of 2 pi `turns`, for |turns| up to 2^20. No multiple of pi is subtracted: the reduction is exact.
#[must_use]
#[inline(always)]
pub fn sin_cos_turn(turns: f32) -> (f32, f32) {
    let quarters = 4.0 * turns;
    let (whole, quadrant) = nearest(quarters);
    sin_cos_in_quadrant((quarters - whole) * std::f32::consts::FRAC_PI_2, quadrant)
}

/// Sine and cosine of `angle` in radians, up to 8192: pi/2 is subtracted in three parts.
#[must_use]
#[inline(always)]
pub fn sin_cos(angle: f32) -> (f32, f32) {
    /// pi/2 = the sum, the first two with trailing zeros that make their multiples exact.
    const PARTS: [f32; 3] = [1.570_312_5, 4.837_513e-4, 7.549_79e-8];
    let (whole, quadrant) = nearest(angle * std::f32::consts::FRAC_2_PI);
    let [high, middle, low] = PARTS;
    let rest = ((angle - whole * high) - whole * middle) - whole * low;
    sin_cos_in_quadrant(rest, quadrant)
}

/// Sine and cosine of `r` + `quadrant` pi/2, |r| <= pi/4. Errors of the fits: 4e-9 and 1e-10.
#[inline(always)]
fn sin_cos_in_quadrant(r: f32, quadrant: i32) -> (f32, f32) {
    let r2 = r * r;
    let sin = r + r * r2 * polynomial(r2, [-0.166_666_55, 0.008_332_178, -0.000_195_172_98]);
    let even = polynomial(r2, [0.041_666_646, -0.001_388_736_8, 2.443_845e-5]);
    let cos = (1.0 - 0.5 * r2) + r2 * r2 * even;
    let is_odd = quadrant & 1 != 0;
    let (s, c) = if is_odd { (cos, sin) } else { (sin, cos) };
    (
        if quadrant & 2 == 0 { s } else { -s },
        if (quadrant + 1) & 2 == 0 { c } else { -c },
    )
}

/// `x`, but at least `low` and at most `high`: two instructions, which `clamp` is not.
#[inline(always)]
fn clamped(x: f32, low: f32, high: f32) -> f32 {
    let raised = if x > low { x } else { low };
    if raised < high { raised } else { high }
}

/// `x` as n ln 2 + r with |r| <= ln(2) / 2: r, (e^r - 1 - r) and n. Error of the fit: 3e-9.
#[inline(always)]
fn reduced_exponential(x: f32) -> (f32, f32, i32) {
    /// ln 2 in two parts, the first with trailing zeros.
    const LN_2: [f32; 2] = [0.693_359_4, -2.121_944_4e-4];
    /// (e^r - 1 - r) / r^2.
    const FIT: [f32; 5] = [
        0.5,
        0.166_665_18,
        0.041_666_206,
        0.008_368_954,
        0.001_395_06,
    ];
    let (whole, n) = nearest(x * std::f32::consts::LOG2_E);
    let [high, low] = LN_2;
    let r = (x - whole * high) - whole * low;
    (r, r * r * polynomial(r, FIT), n)
}

/// e^x; 0 below -104, infinite above 88.8.
#[must_use]
#[inline(always)]
pub fn exp(x: f32) -> f32 {
    let within = clamped(x, -105.0, 90.0);
    let (r, rest, n) = reduced_exponential(within);
    // In two steps: 2^n itself may be subnormal or too large where e^x is not.
    let half = n >> 1;
    (1.0 + (r + rest)) * power_of_two(half) * power_of_two(n - half)
}

/// e^x - 1, which keeps its digits near 0; infinite above 88.8.
#[must_use]
#[inline(always)]
pub fn exp_m1(x: f32) -> f32 {
    let within = clamped(x, -20.0, 89.0);
    let (r, rest, n) = reduced_exponential(within);
    // Twice the half: 2^128 is too large where e^x is not.
    let half = power_of_two(n - 1);
    ((r + rest) * half + (half - 0.5)) * 2.0
}

/// The logarithm of 2 in two parts, the first with trailing zeros.
const LN_2: [f32; 2] = [0.693_359_4, -2.121_944_4e-4];

/// `x` as 2^n (1 + f), 1 + f in sqrt(1/2)..sqrt(2), for a normal `x` above 0.
#[inline(always)]
fn exponent_and_fraction(x: f32) -> (i32, f32) {
    let above_root = x
        .to_bits()
        .wrapping_sub(std::f32::consts::FRAC_1_SQRT_2.to_bits());
    let n = above_root.cast_signed() >> 23;
    let mantissa = x.to_bits().wrapping_sub((n << 23).cast_unsigned());
    (n, f32::from_bits(mantissa) - 1.0)
}

/// ln(1 + f) + n ln 2, for f in sqrt(1/2) - 1 .. sqrt(2) - 1. Error of the fit: 8e-10.
#[inline(always)]
fn logarithm(n: i32, f: f32) -> f32 {
    /// (ln(1 + f) - f + f^2 / 2) / f^3.
    const FIT: [f32; 9] = [
        0.333_333_13,
        -0.250_000_1,
        0.200_021_34,
        -0.166_680_07,
        0.142_192_23,
        -0.124_051_385,
        0.118_903_39,
        -0.116_796_404,
        0.067_465_5,
    ];
    let [high, low] = LN_2;
    let (n, f2) = (n as f32, f * f);
    let rest = f * f2 * polynomial(f, FIT) + n * low;
    n * high + (f + (rest - 0.5 * f2))
}

/// The natural logarithm; minus infinity at 0, NaN below.
#[must_use]
#[inline(always)]
pub fn ln(x: f32) -> f32 {
    /// Makes subnormal numbers normal.
    const SCALE: f32 = 8_388_608.0;
    let is_subnormal = x < f32::MIN_POSITIVE;
    let (n, f) = exponent_and_fraction(if is_subnormal { x * SCALE } else { x });
    let n = if is_subnormal { n - 23 } else { n };
    at_the_ends(x, logarithm(n, f))
}

/// ln(1 + x), which keeps its digits near 0; minus infinity at -1, NaN below.
#[must_use]
#[inline(always)]
pub fn ln_1p(x: f32) -> f32 {
    let sum = 1.0 + x;
    // What the sum has lost of x or of 1.
    let lost = if x < 1.0 {
        x - (sum - 1.0)
    } else {
        1.0 - (sum - x)
    };
    let (n, f) = exponent_and_fraction(sum);
    let (f, correction) = if n == 0 { (x, 0.0) } else { (f, lost / sum) };
    at_the_ends(sum, logarithm(n, f) + correction)
}

/// `value`, the logarithm of `x`, but where `x` is 0, negative or infinite.
#[inline(always)]
fn at_the_ends(x: f32, value: f32) -> f32 {
    if x > f32::MAX {
        x
    } else if x > 0.0 {
        value
    } else if x == 0.0 {
        f32::NEG_INFINITY
    } else {
        f32::NAN
    }
}

/// The angle of the point (x, y), -pi..pi; 0 at the origin. Error of the fit: 2e-9.
#[must_use]
#[inline(always)]
pub fn atan2(y: f32, x: f32) -> f32 {
    /// (atan(q) / q - 1) / q^2 in q^2.
    const FIT: [f32; 9] = [
        -0.333_333_02,
        0.199_986_38,
        -0.142_652_45,
        0.109_575_72,
        -0.084_194_46,
        0.058_234_32,
        -0.031_455_466,
        0.011_064_315,
        -0.001_827_184_7,
    ];
    let (up, across) = (y.abs(), x.abs());
    let is_steep = up > across;
    let (low, high) = if is_steep { (across, up) } else { (up, across) };
    let q = if high > 0.0 { low / high } else { 0.0 };
    let q2 = q * q;
    let flat = q + q * q2 * polynomial(q2, FIT);
    let acute = if is_steep {
        std::f32::consts::FRAC_PI_2 - flat
    } else {
        flat
    };
    let angle = if x < 0.0 {
        std::f32::consts::PI - acute
    } else {
        acute
    };
    angle.copysign(y)
}

/// The error function. Error of the fit: 1e-9.
#[must_use]
#[inline(always)]
pub fn erf(x: f32) -> f32 {
    let magnitude = x.abs();
    let far = 1.0 - erfc_beyond_half(magnitude);
    if magnitude < 1.0 {
        erf_near(x)
    } else {
        far.copysign(x)
    }
}

/// 1 - erf(x), which keeps its digits where x is large.
#[must_use]
#[inline(always)]
pub fn erfc(x: f32) -> f32 {
    let magnitude = x.abs();
    let far = erfc_beyond_half(magnitude);
    if magnitude < 0.5 {
        1.0 - erf_near(x)
    } else if x < 0.0 {
        2.0 - far
    } else {
        far
    }
}

/// erf for |x| up to 1.
#[inline(always)]
fn erf_near(x: f32) -> f32 {
    const FIT: [f32; 7] = [
        std::f32::consts::FRAC_2_SQRT_PI,
        -0.376_126_26,
        0.112_836,
        -0.026_854_444,
        0.005_189_535,
        -0.000_802_084_1,
        7.889_119e-5,
    ];
    x * polynomial(x * x, FIT)
}

/// erfc for x from .5: exp(-x^2) times t P(t) with t = 2 / (2 + x). Error of the fit: 3e-9.
#[inline(always)]
fn erfc_beyond_half(x: f32) -> f32 {
    const FIT: [f32; 10] = [
        0.282_086_5,
        0.282_318_44,
        0.244_255_23,
        0.192_881_78,
        0.018_938_862,
        0.151_478_3,
        -0.271_194,
        0.062_692_16,
        0.066_832_036,
        -0.030_317_007,
    ];
    let t = 2.0 / (2.0 + x);
    exp(-(x * x)) * (t * polynomial(t, FIT))
}

/// The integral of [`erfc`] from `x` on, for `x` from 0: exp(-x^2) / sqrt(pi) - x erfc(x), good to the rounding of its
/// sum with x. Error of the fit: 6e-8 of that sum.
#[must_use]
#[inline(always)]
pub fn ierfc(x: f32) -> f32 {
    /// In powers of x - [`MIDDLE`].
    const FIT: [f32; 14] = [
        0.068_201_7,
        -0.203_092_34,
        0.250_982_94,
        -0.150_581_15,
        0.025_945_237,
        0.020_732_315,
        -0.011_436_581,
        -0.000_908_719_43,
        0.002_241_534_4,
        -0.000_395_696_46,
        -0.000_222_637_54,
        0.000_116_951_44,
        -2.074_303_3e-5,
        1.293_675_3e-6,
    ];
    const MIDDLE: f32 = 0.9;
    /// From here on it is less than the rounding of x.
    const END: f32 = 3.25;
    let within = if x < END { x } else { END };
    polynomial(within - MIDDLE, FIT)
}

#[cfg(test)]
mod tests;
