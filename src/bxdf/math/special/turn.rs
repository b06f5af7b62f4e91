//! Sine and cosine of a turn in f64 as straight-line polynomials, so that loops that draw directions vectorise.
//!
//! The reduction to an eighth of a turn is exact; there the Taylor series (`abramowitz1964`, 4.3.65 and 4.3.66) are
//! cut where the next term is below a tenth of a rounding.

use std::f64::consts::FRAC_PI_2;

/// 1.5 2^52: added to a number up to 2^51, it leaves the nearest integer in the last bits.
const TO_INTEGER: f64 = 6_755_399_441_055_744.0;

/// Factors of the powers of r^2 in sin(r)/r - 1, from the first power on: (-1)^n / (2 n + 1)!.
const SINE: [f64; 8] = [
    -1.0 / 6.0,
    1.0 / 120.0,
    -1.0 / 5_040.0,
    1.0 / 362_880.0,
    -1.0 / 39_916_800.0,
    1.0 / 6_227_020_800.0,
    -1.0 / 1_307_674_368_000.0,
    1.0 / 355_687_428_096_000.0,
];

/// Factors of the powers of r^2 in cos(r) - 1 + r^2/2, from the second power on: (-1)^n / (2 n)!.
const COSINE: [f64; 8] = [
    1.0 / 24.0,
    -1.0 / 720.0,
    1.0 / 40_320.0,
    -1.0 / 3_628_800.0,
    1.0 / 479_001_600.0,
    -1.0 / 87_178_291_200.0,
    1.0 / 20_922_789_888_000.0,
    -1.0 / 6_402_373_705_728_000.0,
];

/// Sine and cosine of 2 pi `turns`, for |turns| up to 2^49.
#[must_use]
#[inline(always)]
pub fn sin_cos_turn(turns: f64) -> (f64, f64) {
    let quarters = 4.0 * turns;
    let shifted = quarters + TO_INTEGER;
    let quadrant = shifted.to_bits();
    let r = (quarters - (shifted - TO_INTEGER)) * FRAC_PI_2;
    let r2 = r * r;
    let sin = r + r * r2 * series(r2, SINE);
    let cos = (1.0 - 0.5 * r2) + r2 * r2 * series(r2, COSINE);
    let (s, c) = if quadrant & 1 != 0 {
        (cos, sin)
    } else {
        (sin, cos)
    };
    (
        if quadrant & 2 == 0 { s } else { -s },
        if quadrant.wrapping_add(1) & 2 == 0 {
            c
        } else {
            -c
        },
    )
}

/// The sum of `factors`\[i\] x^i.
#[inline(always)]
fn series<const N: usize>(x: f64, factors: [f64; N]) -> f64 {
    let mut sum = 0.0;
    for factor in factors.into_iter().rev() {
        sum = sum * x + factor;
    }
    sum
}

#[cfg(test)]
mod tests {
    use xprec::Df64;

    use super::*;
    use crate::math::Real;

    /// The largest relative error measured is 1.9 roundings; a bound with room for other numbers.
    const LARGEST_ERROR: f64 = 2.5 * f64::UNIT_ROUNDOFF;

    #[test]
    fn turns_are_those_of_the_reference() {
        let mut worst = 0.0_f64;
        for i in 1..40_000 {
            let turns = f64::from(i) / 40_000.0 * 1.25 - 0.125;
            let angle = Df64::tau() * Df64::of(turns);
            let (sin, cos) = sin_cos_turn(turns);
            for (found, exact) in [(sin, Real::sin(angle)), (cos, Real::cos(angle))] {
                // The reference is no exact 0 at a multiple of half a turn.
                if found != 0.0 {
                    let error = (Df64::of(found) / exact - Df64::of(1.0)).as_f64().abs();
                    worst = worst.max(error);
                }
            }
        }
        println!("{} roundings", worst / f64::UNIT_ROUNDOFF);
        assert!(
            worst <= LARGEST_ERROR && worst > 0.5 * LARGEST_ERROR,
            "{worst:e}"
        );
    }

    #[test]
    fn quarters_are_exact() {
        assert_eq!(sin_cos_turn(0.0), (0.0, 1.0));
        assert_eq!(sin_cos_turn(0.25), (1.0, 0.0));
        assert_eq!(sin_cos_turn(0.5).1, -1.0);
        assert_eq!(sin_cos_turn(-0.75), (1.0, 0.0));
    }
}
