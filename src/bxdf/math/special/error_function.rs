//! The error function in every precision.
//!
//! f32 and f64 come from the `libm` crate (below one unit in the last place). The reference precision needs its own: a
//! series of positive terms near 0 and a continued fraction in the tail.
//!
//! # Source
//! Abramowitz & Stegun 1964, eqs. 7.1.6 and 7.1.14 (`abramowitz1964`).

use num_traits::FloatConst;
use xprec::Df64;

/// Where the series hands over to the continued fraction. Below it erfc = 1 - erf loses at most a factor
/// 1 / erfc(2) = 214 of the 32 digits; above it the fraction settles in [`FRACTION_TERMS`].
const CROSSOVER: f64 = 2.0;

/// Terms of the series at [`CROSSOVER`]: the ratio of term n to the one before is 8 / (2n + 1), their product 1e-36 at 64.
const SERIES_TERMS: u32 = 64;

/// Terms of the continued fraction at [`CROSSOVER`]: its error falls as exp(-4 sqrt(2n)), 1e-33 at n = 180.
const FRACTION_TERMS: u32 = 200;

/// Beyond it erfc is below the smallest double: exp(-27.3^2) = 1e-324.
const VANISHING: f64 = 27.3;

/// erf(x) in the reference precision, to a relative error of about 1e-31.
#[must_use]
pub fn erf(x: Df64) -> Df64 {
    let magnitude = x.abs();
    let value = if magnitude < Df64::new(CROSSOVER) {
        series(magnitude)
    } else {
        Df64::new(1.0) - tail(magnitude)
    };
    if x < Df64::new(0.0) { -value } else { value }
}

/// erfc(x) = 1 - erf(x) in the reference precision, to a relative error of about 1e-29.
#[must_use]
pub fn erfc(x: Df64) -> Df64 {
    if x < Df64::new(CROSSOVER) {
        Df64::new(1.0) - erf(x)
    } else {
        tail(x)
    }
}

/// erf(x) = 2/sqrt(pi) exp(-x^2) sum of 2^n x^(2n+1) / (1 3 .. (2n+1)), for 0 <= x < [`CROSSOVER`]: no cancellation.
fn series(x: Df64) -> Df64 {
    let x2 = x * x;
    let (mut term, mut sum) = (x, x);
    for n in 1..=SERIES_TERMS {
        term = term * x2 * Df64::new(2.0) / Df64::new(f64::from(2 * n + 1));
        sum += term;
    }
    Df64::FRAC_2_SQRT_PI() * (-x2).exp() * sum
}

/// erfc(x) = exp(-x^2)/sqrt(pi) / (x + (1/2)/(x + 1/(x + (3/2)/(x + ..)))), for x >= [`CROSSOVER`].
fn tail(x: Df64) -> Df64 {
    if x >= Df64::new(VANISHING) {
        return Df64::new(0.0);
    }
    let mut denominator = x;
    for n in (1..=FRACTION_TERMS).rev() {
        denominator = x + Df64::new(0.5 * f64::from(n)) / denominator;
    }
    Df64::FRAC_2_SQRT_PI() * Df64::new(0.5) * (-(x * x)).exp() / denominator
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bxdf::math::Real;

    /// x, erf(x), erfc(x) as the sum of two doubles, from 50-digit arithmetic.
    const TABLE: &[(f64, [f64; 2], [f64; 2])] = &[
        (
            -3.5,
            [-0.999_999_256_901_627_6, -4.964_727_918_721_220_4e-17],
            [1.999_999_256_901_627_6, 4.964_727_918_721_220_4e-17],
        ),
        (
            -0.75,
            [-0.711_155_633_653_515_1, -4.697_440_771_642_89e-17],
            [1.711_155_633_653_515_2, -6.404_789_474_608_675e-17],
        ),
        (
            1e-10,
            [1.128_379_167_095_512_6e-10, 3.250_270_181_699_747e-27],
            [0.999_999_999_887_162, 4.448_743_637_354_84e-17],
        ),
        (
            0.0625,
            [0.070_431_977_722_387_07, 4.502_285_385_811_322e-18],
            [0.929_568_022_277_612_9, -4.502_285_385_811_322e-18],
        ),
        (
            0.5,
            [0.520_499_877_813_046_5, 1.900_077_467_916_287e-17],
            [0.479_500_122_186_953_5, -1.900_077_467_916_287e-17],
        ),
        (
            1.0,
            [0.842_700_792_949_714_9, -2.480_101_178_911_860_2e-17],
            [0.157_299_207_050_285_13, -2.954_563_826_510_312e-18],
        ),
        (
            1.5,
            [0.966_105_146_475_310_8, -3.386_703_144_168_069_6e-17],
            [0.033_894_853_524_689_274, -8.274_380_778_554_473e-19],
        ),
        (
            1.999_023_437_5,
            [0.995_302_042_951_979_1, 3.874_141_896_010_742e-17],
            [0.004_697_957_048_020_856, 2.898_592_493_707_401e-19],
        ),
        (
            2.0,
            [0.995_322_265_018_952_7, 2.207_198_583_297_65e-17],
            [0.004_677_734_981_047_266, -3.879_423_832_664_125_6e-19],
        ),
        (
            2.5,
            [0.999_593_047_982_555, 4.692_515_109_704_223_4e-17],
            [0.000_406_952_017_444_958_9, 2.080_297_158_010_754e-20],
        ),
        (
            4.0,
            [0.999_999_984_582_742_1, 1.448_265_319_200_25e-17],
            [1.541_725_790_028_002e-08, -1.141_787_216_837_102_6e-24],
        ),
        (
            6.5,
            [1.0, -3.842_148_327_120_647_5e-20],
            [3.842_148_327_120_647_5e-20, -2.445_581_682_573_610_4e-37],
        ),
        (
            9.0,
            [1.0, -4.137_031_746_513_81e-37],
            [4.137_031_746_513_81e-37, 1.267_246_930_385_461_2e-53],
        ),
        (
            20.0,
            [1.0, 0.0],
            [5.395_865_611_607_901e-176, -2.498_097_548_434_827_8e-192],
        ),
        (
            25.5,
            [1.0, 0.0],
            [8.801_662_690_727_95e-285, 2.444_002_015_065_658_7e-301],
        ),
    ];

    #[test]
    fn thirty_digits_in_the_reference_precision() {
        for &(x, [erf_hi, erf_lo], [erfc_hi, erfc_lo]) in TABLE {
            let x = Df64::new(x);
            let error = |found: Df64, hi: f64, lo: f64| {
                let exact = Df64::new(hi) + Df64::new(lo);
                ((found - exact) / exact).as_f64().abs()
            };
            let (e, c) = (
                error(erf(x), erf_hi, erf_lo),
                error(erfc(x), erfc_hi, erfc_lo),
            );
            // A few roundings of 1e-32 each; x^2 up to 650 multiplies that of the argument of exp.
            assert!(e < 1e-30, "erf {x:?}: {e:e}");
            assert!(c < 1e-29, "erfc {x:?}: {c:e}");
        }
    }

    #[test]
    fn all_precisions_agree() {
        for &(x, [erf_hi, _], [erfc_hi, _]) in TABLE {
            assert!((Real::erf(x) / erf_hi - 1.0).abs() < 4e-16);
            assert!((Real::erfc(x) / erfc_hi - 1.0).abs() < 4e-16);
            let single = x as f32;
            if f64::from(single) == x && erfc_hi > 1e-37 {
                // One unit in the last place; the tail of libm's erfcf is good to a few.
                assert!((f64::from(Real::erf(single)) / erf_hi - 1.0).abs() < 1.2e-7);
                assert!((f64::from(Real::erfc(single)) / erfc_hi - 1.0).abs() < 4e-7);
            }
        }
    }

    #[test]
    fn the_ends_are_exact() {
        fn ends<R: Real>() {
            let (zero, one, far) = (R::zero(), R::one(), R::of(40.0));
            assert!(zero.erf() == zero && zero.erfc() == one, "{}", R::NAME);
            assert!(far.erf() == one && far.erfc() == zero, "{}", R::NAME);
            assert!(
                (-far).erf() == -one && (-far).erfc() == one + one,
                "{}",
                R::NAME
            );
        }
        ends::<f32>();
        ends::<f64>();
        ends::<Df64>();
    }
}
