//! Random numbers and goodness of fit.

use glam::DVec3;
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::{Rng as _, SeedableRng as _};
use statrs::distribution::{ChiSquared, ContinuousCDF as _};

use bxdf::math::Real;

/// Expected counts below this are pooled: the chi-square distribution is an approximation for large counts.
pub const SMALLEST_EXPECTATION: f64 = 10.0;

/// A generator of its own for each purpose, the same in every run.
pub struct Random(Pcg64Mcg);

impl Random {
    /// The generator number `seed`.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self(Pcg64Mcg::seed_from_u64(seed))
    }

    /// The generator as it is after `count` numbers.
    #[must_use]
    pub fn after(mut self, count: u128) -> Self {
        self.0.advance(count);
        self
    }

    /// Uniform in [0, 1), 53 bits.
    pub fn unit(&mut self) -> f64 {
        self.number()
    }

    /// Uniform in [0, 1), with as many bits as `R` holds, at most 53: rounding never makes it 1.
    ///
    /// The numbers of a seed are the same in every precision, but for the bits that do not fit.
    pub fn number<R: Real>(&mut self) -> R {
        unit_of(self.0.next_u64())
    }

    /// Two of [`Self::unit`].
    pub fn pair(&mut self) -> [f64; 2] {
        [self.unit(), self.unit()]
    }

    /// A direction uniform over the sphere.
    pub fn direction(&mut self) -> DVec3 {
        let [u, v] = self.pair();
        let z = 1.0 - 2.0 * u;
        let (sin, cos) = (std::f64::consts::TAU * v).sin_cos();
        let radius = ((1.0 - z) * (1.0 + z)).sqrt();
        DVec3::new(radius * cos, radius * sin, z)
    }
}

/// The most bits of one random number.
const RANDOM_BITS: u32 = f64::MANTISSA_DIGITS;

/// The number in [0, 1) whose first binary digits are those of `bits`.
fn unit_of<R: Real>(bits: u64) -> R {
    let kept = (-R::UNIT_ROUNDOFF.log2() as u32).min(RANDOM_BITS);
    let integer = bits >> (u64::BITS - kept);
    R::of(integer as f64 / (1_u64 << kept) as f64)
}

/// The outcome of a chi-square test.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChiSquare {
    /// Pearson's statistic: the sum of (observed - expected)^2 / expected over the bins.
    pub statistic: f64,
    /// The degrees of freedom: the number of bins left after pooling, less 1.
    pub degrees: usize,
    /// The chance that samples of the expected distribution give as large a statistic or a larger one.
    pub p_value: f64,
}

/// Pearson's chi-square test of `(observed, expected)` counts whose sums agree.
///
/// Bins expected to hold fewer than [`SMALLEST_EXPECTATION`] are pooled. `None` where one bin or none is left.
#[must_use]
pub fn chi_square(bins: &[(f64, f64)]) -> Option<ChiSquare> {
    let (mut pool, mut kept) = ((0.0, 0.0), Vec::new());
    for &(observed, expected) in bins {
        if expected >= SMALLEST_EXPECTATION {
            kept.push((observed, expected));
        } else {
            pool.0 += observed;
            pool.1 += expected.max(0.0);
        }
    }
    // At most 10 expected, more than 60 seen: a Poisson tail of 1e-25.
    let is_impossible = pool.1 < SMALLEST_EXPECTATION && pool.0 > 6.0 * SMALLEST_EXPECTATION;
    if pool.1 >= SMALLEST_EXPECTATION || is_impossible {
        kept.push(pool);
    }
    let statistic: f64 = kept.iter().map(|(o, e)| (o - e) * (o - e) / e).sum();
    let degrees = kept.len().saturating_sub(1);
    if is_impossible {
        return Some(ChiSquare {
            statistic,
            degrees,
            p_value: 0.0,
        });
    }
    let p_value = (degrees > 0).then(|| ChiSquared::new(degrees as f64).ok())?;
    Some(ChiSquare {
        statistic,
        degrees,
        p_value: p_value?.sf(statistic),
    })
}

#[cfg(test)]
mod tests {
    use xprec::Df64;

    use super::*;

    #[test]
    fn the_tail_of_chi_square() {
        // Two bins of 100: (10^2 + 10^2) / 100 = 2 at one degree of freedom has the tail erfc(1) = .15729920705.
        let found = chi_square(&[(110.0, 100.0), (90.0, 100.0)]).unwrap();
        assert!((found.p_value - 0.157_299_207_05).abs() < 1e-9, "{found:?}");
        assert_eq!((found.statistic, found.degrees), (2.0, 1));
        assert!(chi_square(&[(100.0, 100.0), (0.0, 0.0)]).is_none());
    }

    #[test]
    fn samples_where_none_can_be_are_no_chance() {
        let found = chi_square(&[(30.0, 100.0), (70.0, 0.0)]).unwrap();
        assert_eq!(found.p_value, 0.0);
    }

    #[test]
    fn random_directions_are_unit_and_repeat() {
        let mut random = Random::new(7);
        let first = random.direction();
        assert!((first.length() - 1.0).abs() < 1e-15);
        assert_eq!(Random::new(7).direction(), first);
        assert!((0..1000).all(|_| (0.0..1.0).contains(&random.unit())));
    }

    #[test]
    fn random_numbers_stay_below_one_in_every_precision() {
        assert_eq!(unit_of::<f32>(u64::MAX), 1.0 - f32::EPSILON / 2.0);
        assert_eq!(unit_of::<f64>(u64::MAX), 1.0 - f64::EPSILON / 2.0);
        assert!(unit_of::<Df64>(u64::MAX) < Df64::of(1.0));
    }

    #[test]
    fn precisions_share_their_random_numbers() {
        let (mut a, mut b) = (Random::new(7), Random::new(7));
        for _ in 0..100 {
            let (single, double) = (a.number::<f32>(), b.number::<f64>());
            // The bits cut off.
            assert!((0.0..2_f64.powi(-24)).contains(&(double - f64::from(single))));
        }
    }

    #[test]
    fn numbers_that_are_passed_over_are_those_that_would_be_drawn() {
        let mut random = Random::new(3);
        let numbers: Vec<f64> = (0..100).map(|_| random.unit()).collect();
        for (count, number) in (0..).zip(numbers) {
            assert_eq!(Random::new(3).after(count).unit(), number);
        }
    }
}
