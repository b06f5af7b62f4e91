//! The error function in every precision.
//!
//! f64 comes from the `libm` crate (below one unit in the last place), f32 from polynomials. The reference precision needs its own: Taylor's
//! series about anchors, which a series of positive terms and a continued fraction place once, and that fraction in the tail.
//! What is a rounding of f64 beside the result is summed in f64.
//!
//! # Source
//! Abramowitz & Stegun 1964, eqs. 7.1.6, 7.1.14 and 7.1.19 (`abramowitz1964`).

use std::sync::LazyLock;

use num_traits::FloatConst;
use xprec::Df64;

/// Below it anchors hold erf, from it on erfc: there 1 - erf would lose more than a factor 1 / erfc(1) = 6.4.
const CROSSOVER: f64 = 1.0;

/// From here on the continued fraction has few terms, and needs no anchors.
const FAR: f64 = 6.0;

/// Anchors per unit; a power of two, so that they are exact.
const DENSITY: f64 = 32.0;

/// Terms of Taylor's series: an anchor is 1/64 away at most and below [`FAR`], so that term n is about
/// (2 * 6 / 64)^n / n!, 1e-31 at 19; the sum divides it by n + 1.
const TAYLOR_TERMS: u32 = 19;

/// Terms of them after which the others are below 1e-15 of the sum.
const EXACT_TERMS: u32 = 10;

/// Terms of the series at [`CROSSOVER`]: the ratio of term n to the one before is 2 / (2n + 1), their product 1e-38 at 28.
const SERIES_TERMS: u32 = 28;

/// Beyond it erfc is below the smallest double: exp(-27.3^2) = 1e-324.
const VANISHING: f64 = 27.3;

/// erf(x) in the reference precision, to a relative error of about 1e-31.
#[must_use]
pub fn erf(x: Df64) -> Df64 {
    let value = match of_magnitude(x.abs()) {
        Found::Erf(erf) => erf,
        Found::Erfc(erfc) => Df64::new(1.0) - erfc,
    };
    if x < Df64::new(0.0) { -value } else { value }
}

/// erfc(x) = 1 - erf(x) in the reference precision, to a relative error of about 1e-31 times the exponent x^2.
#[must_use]
pub fn erfc(x: Df64) -> Df64 {
    let (one, is_negative) = (Df64::new(1.0), x < Df64::new(0.0));
    match of_magnitude(x.abs()) {
        Found::Erf(erf) if is_negative => one + erf,
        Found::Erf(erf) => one - erf,
        Found::Erfc(erfc) if is_negative => one + (one - erfc),
        Found::Erfc(erfc) => erfc,
    }
}

/// Whichever of the two keeps its digits.
enum Found {
    Erf(Df64),
    Erfc(Df64),
}

/// erf(x) or erfc(x) for x >= 0; what is no number stays none.
fn of_magnitude(x: Df64) -> Found {
    if x >= Df64::new(FAR) {
        return Found::Erfc(tail(x));
    }
    let place = (x.hi() * DENSITY).round();
    let Some(anchor) = ANCHORS.get(place as usize).filter(|_| !x.hi().is_nan()) else {
        return Found::Erf(x);
    };
    let step = x - Df64::new(anchor.x);
    let rise = anchor.slope * step * anchor.mean_slope(step);
    match anchor.value {
        Found::Erf(erf) => Found::Erf(erf + rise),
        Found::Erfc(erfc) => Found::Erfc(erfc - rise),
    }
}

/// A place where the functions are known.
struct Anchor {
    x: f64,
    value: Found,
    /// erf'(x) = 2/sqrt(pi) exp(-x^2).
    slope: Df64,
}

static ANCHORS: LazyLock<Vec<Anchor>> = LazyLock::new(|| {
    let last = (FAR * DENSITY) as u32;
    let places = (0..=last).map(|place| f64::from(place) / DENSITY);
    places.map(Anchor::new).collect()
});

impl Anchor {
    fn new(x: f64) -> Self {
        let exact = Df64::new(x);
        Self {
            x,
            value: if x < CROSSOVER {
                Found::Erf(series(exact))
            } else {
                Found::Erfc(tail(exact))
            },
            slope: Df64::FRAC_2_SQRT_PI() * (-exact * exact).exp(),
        }
    }

    /// The mean of erf' from x to x + `step` over erf'(x): the sum of t_n / (n + 1) with t_n = (-step)^n H_n(x) / n! and the
    /// recurrence of Hermite's polynomials, H_(n+1) = 2 x H_n - 2 n H_(n-1).
    fn mean_slope(&self, step: Df64) -> Df64 {
        let (linear, square) = (step * (-2.0 * self.x), step * step * -2.0);
        let (mut before, mut term) = (Df64::new(0.0), Df64::new(1.0));
        let mut sum = term;
        for n in (1..=EXACT_TERMS).map(f64::from) {
            (before, term) = (term, (linear * term + square * before) / n);
            sum += term / (n + 1.0);
        }
        let (linear, square) = (linear.hi(), square.hi());
        let (mut before, mut term, mut rest) = (before.hi(), term.hi(), 0.0);
        for n in (EXACT_TERMS + 1..=TAYLOR_TERMS).map(f64::from) {
            (before, term) = (term, (linear * term + square * before) / n);
            rest += term / (n + 1.0);
        }
        sum + rest
    }
}

/// erf(x) = 2/sqrt(pi) exp(-x^2) sum of 2^n x^(2n+1) / (1 3 .. (2n+1)), for 0 <= x <= [`CROSSOVER`]: no cancellation.
fn series(x: Df64) -> Df64 {
    let x2 = x * x;
    let (mut term, mut sum) = (x, x);
    for n in 1..=SERIES_TERMS {
        term = term * x2 * 2.0 / f64::from(2 * n + 1);
        sum += term;
    }
    Df64::FRAC_2_SQRT_PI() * (-x2).exp() * sum
}

/// erfc(x) = exp(-x^2)/sqrt(pi) / (x + (1/2)/(x + 1/(x + (3/2)/(x + ..)))), for x >= [`CROSSOVER`].
fn tail(x: Df64) -> Df64 {
    if x >= Df64::new(VANISHING) {
        return Df64::new(0.0);
    }
    // Its error falls as exp(-2 x sqrt(2n)) at last, and faster while n is below x^2. So many terms leave 2e-33, and so many
    // less than 1e-16, found by trial from 1 to 27: what lies below those counts as f64 has it.
    let per_x = x.hi().recip();
    let all = (722.0 * per_x + 55.0) * per_x + 12.0;
    let exact = (190.0 * per_x + 28.0) * per_x + 7.0;
    let (all, exact) = (all as u32, exact as u32);
    let half = |n: u32| 0.5 * f64::from(n);
    let below = (exact + 1..=all).rev();
    let below = below.fold(x.hi(), |sum, n| x.hi() + half(n) / sum);
    let sum = (1..=exact).rev();
    let sum = sum.fold(Df64::new(below), |sum, n| x + Df64::new(half(n)) / sum);
    Df64::FRAC_2_SQRT_PI() * 0.5 * (-(x * x)).exp() / sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Real;

    /// x, at anchors and between them, erf(x), erfc(x) as the sum of two doubles, from 50-digit arithmetic.
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
            0.062_5,
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
            -1.984_375,
            [-0.994_989_066_050_073_5, 3.640_682_172_002_906_6e-17],
            [1.994_989_066_050_073_5, -3.640_682_172_002_906_6e-17],
        ),
        (
            0.3,
            [0.328_626_759_459_127_4, 2.290_825_444_698_277_7e-17],
            [0.671_373_240_540_872_6, 3.260_289_678_427_505_3e-17],
        ),
        (
            0.984_375,
            [0.836_112_870_050_396_5, 1.115_974_962_582_807e-17],
            [0.163_887_129_949_603_53, -1.115_974_962_582_807e-17],
        ),
        (
            1.015,
            [0.848_834_476_670_026_3, -2.084_576_620_207_312e-17],
            [0.151_165_523_329_973_7, -6.909_809_413_555_793e-18],
        ),
        (
            1.7,
            [0.983_790_458_590_774_5, 4.165_380_782_531_01e-17],
            [0.016_209_541_409_225_44, -2.044_440_186_672_801e-20],
        ),
        (
            2.2,
            [0.998_137_153_702_018_2, -5.487_205_731_279_638_4e-17],
            [0.001_862_846_297_981_889_8, 1.142_738_502_985_864e-20],
        ),
        (
            3.3,
            [0.999_996_942_290_203_5, 3.418_688_300_158_856e-17],
            [3.057_709_796_438_165_4e-06, -2.097_339_313_701_187e-22],
        ),
        (
            5.984_375,
            [1.0, -2.601_740_916_063_35e-17],
            [2.601_740_916_063_35e-17, 1.009_834_900_818_151_8e-33],
        ),
        (
            6.01,
            [1.0, -1.905_345_579_029_651e-17],
            [1.905_345_579_029_651e-17, 5.943_622_585_304_594e-34],
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
            // A few roundings of 1e-32 each.
            assert!(e < 2e-31, "erf {x:?}: {e:e}");
            assert!(c < 5e-31, "erfc {x:?}: {c:e}");
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
