//! The energy that single scattering loses, and a lobe that gives it back.
//!
//! # Source
//! Kulla & Conty 2017 for the lobe (`kulla2017`), which is that of Kelemen & Szirmay-Kalos 2001 (`kelemen2001`); Hill
//! 2018 for its colour (`hill2018`); Turquin 2019 for the other use of the same table (`turquin2019`).

use std::sync::{Arc, Mutex, PoisonError};

use super::Masking;
use super::lost_energy::Lobe;
use crate::math::{Real, Vec3};

/// Terms of the Chebyshev series through which the integrals are interpolated: 1.2e-6 at the worst width.
const TERMS: u32 = 40;

/// Cells of the table that is read, linear between: 4e-6 at the worst width.
const CELLS: u32 = 2048;

/// What is taken off the series: its own error. Where nothing is lost its rounding must not pass for a loss, and a loss
/// a little too small creates no energy.
const SERIES_ERROR: f64 = 2e-6;

/// Tables kept for the next material of the same widths: those of a few materials in every precision.
const KEPT: usize = 16;

/// 1 - E(mu) of an isotropic lobe, its mean, and the density proportional to (1 - E(mu)) mu.
#[derive(Debug)]
pub struct EnergyTable {
    /// Tabulated over x = sqrt(mu (1 + k) / (mu + k)), 0 to 1; k is this.
    scale: f64,
    one_minus_e: Vec<f64>,
    /// The density of x.
    density: Vec<f64>,
    /// Its integral from 0.
    cumulative: Vec<f64>,
    one_minus_mean: f64,
}

type Key = (bool, u64, Masking);

impl EnergyTable {
    /// The table of Beckmann or GGX of width `alpha`. Built in a few milliseconds, or taken from the last few built.
    #[must_use]
    pub fn of(is_beckmann: bool, alpha: f64, masking: Masking) -> Arc<Self> {
        static CACHE: Mutex<Vec<(Key, Arc<EnergyTable>)>> = Mutex::new(Vec::new());
        let key = (is_beckmann, alpha.to_bits(), masking);
        // A thread that panicked with the lock held has left whole entries: each is one push or one remove.
        let lock = || CACHE.lock().unwrap_or_else(PoisonError::into_inner);
        let found = lock()
            .iter()
            .find(|(k, _)| *k == key)
            .map(|(_, t)| Arc::clone(t));
        found.unwrap_or_else(|| {
            let table = Arc::new(Self::new(&Lobe {
                is_beckmann,
                alpha,
                masking,
            }));
            let mut cache = lock();
            if cache.len() >= KEPT {
                cache.remove(0);
            }
            cache.push((key, Arc::clone(&table)));
            table
        })
    }

    fn new(lobe: &Lobe) -> Self {
        // Fine enough at mu = alpha, where 1 - E bends, and at mu = 1, where x crowds if the scale is too small.
        let scale = (6.0 * lobe.alpha).max(0.05);
        let series = Series::new(lobe);
        let step = 1.0 / f64::from(CELLS);
        let (mut one_minus_e, mut density) = (Vec::new(), Vec::new());
        for cell in 0..=CELLS {
            let x = f64::from(cell) * step;
            let rest = 1.0 + scale - x * x;
            let mu = scale * x * x / rest;
            let loss = series.at(mu);
            one_minus_e.push(loss);
            // 2 (1 - E) mu dmu/dx.
            density.push(2.0 * loss * mu * 2.0 * x * scale * (1.0 + scale) / (rest * rest));
        }
        let mut sum = 0.0;
        let mut cumulative = vec![0.0];
        cumulative.extend(density.iter().zip(density.iter().skip(1)).map(|(a, b)| {
            sum += 0.5 * (a + b) * step;
            sum
        }));
        let share = if sum > 0.0 { 1.0 / sum } else { 0.0 };
        density
            .iter_mut()
            .chain(&mut cumulative)
            .for_each(|x| *x *= share);
        Self {
            scale,
            one_minus_e,
            density,
            cumulative,
            one_minus_mean: sum,
        }
    }

    /// 1 - E(mu), 0..1.
    #[inline]
    pub fn one_minus_e<R: Real>(&self, mu: R) -> R {
        interpolated(&self.one_minus_e, self.place(mu))
    }

    /// 1 - Ebar, the cosine-weighted mean 2 int (1 - E(mu)) mu dmu; 0 where the lobe loses nothing.
    #[must_use]
    pub fn one_minus_mean(&self) -> f64 {
        self.one_minus_mean
    }

    /// The density per solid angle with which [`Self::sample`] returns a direction of cosine `mu`: proportional to
    /// (1 - E(mu)) mu.
    pub fn pdf<R: Real>(&self, mu: R) -> R {
        let x = self.x(mu).at_least(R::min_positive_value());
        let k = R::of(self.scale);
        let mu_k = mu + k;
        let dx_dmu = k * (R::one() + k) / (mu_k * mu_k) / (R::of(2.0) * x);
        interpolated(&self.density, self.place(mu)) * dx_dmu * R::frac_1_pi() * R::of(0.5)
    }

    /// A direction above the surface with density [`Self::pdf`].
    pub fn sample<R: Real>(&self, u: [R; 2]) -> Vec3<R> {
        let next = self.cumulative.partition_point(|c| *c <= u[0].as_f64());
        let cell = next.saturating_sub(1).min(CELLS as usize - 1);
        let at = |values: &[f64], i: usize| R::of(values.get(i).copied().unwrap_or(0.0));
        let (q0, q1) = (at(&self.density, cell), at(&self.density, cell + 1));
        let cells = R::of(f64::from(CELLS));
        // The integral of a linear density from the start of the cell: q0 t + (q1 - q0) t^2 / 2 = mass.
        let mass = (u[0] - at(&self.cumulative, cell)).max(R::zero()) * cells;
        let root = (q0 * q0 + R::of(2.0) * (q1 - q0) * mass).sqrt_clamped();
        let t = (R::of(2.0) * mass / (q0 + root).at_least(R::min_positive_value())).min(R::one());
        let x = (R::of(cell as f64) + t) / cells;
        let (one, k) = (R::one(), R::of(self.scale));
        let mu = (k * x * x / (one + k - x * x)).min(one);
        let sin = ((one - mu) * (one + mu)).sqrt_clamped();
        let (sin_phi, cos_phi) = u[1].sin_cos_turn();
        Vec3::new(sin * cos_phi, sin * sin_phi, mu)
    }

    #[inline(always)]
    fn x<R: Real>(&self, mu: R) -> R {
        let k = R::of(self.scale);
        (mu * (R::one() + k) / (mu + k)).sqrt().min(R::one())
    }

    /// Where mu stands in the tables. Towards the pole x crowds below 1, and the place is counted from there: 1 - x is
    /// k (1 - mu) / ((mu + k)(1 + x)), which keeps the digits that x has lost.
    #[inline(always)]
    fn place<R: Real>(&self, mu: R) -> Place<R> {
        let (one, k, cells) = (R::one(), R::of(self.scale), R::of(f64::from(CELLS)));
        let x = self.x(mu);
        if x < R::of(0.5) {
            return Place::new(x * cells);
        }
        let from_end = (k * (one - mu) / ((mu + k) * (one + x))).at_least(R::zero());
        let Place { cell, share } = Place::new(from_end * cells);
        Place {
            cell: (CELLS as usize - 1).saturating_sub(cell),
            share: one - share,
        }
    }
}

/// A place in a table: a cell, and the share of it that is passed.
struct Place<R> {
    cell: usize,
    share: R,
}

impl<R: Real> Place<R> {
    #[inline(always)]
    fn new(place: R) -> Self {
        let cell = (place.as_f64() as usize).min(CELLS as usize - 1);
        // Within the cell, whichever way its number was rounded.
        let share = (place - R::of(cell as f64))
            .at_least(R::zero())
            .at_most(R::one());
        Self { cell, share }
    }
}

/// The values of a table, linear between.
#[inline(always)]
fn interpolated<R: Real>(values: &[f64], Place { cell, share }: Place<R>) -> R {
    let at = |i: usize| R::of(values.get(i).copied().unwrap_or(0.0));
    at(cell) * (R::one() - share) + at(cell + 1) * share
}

/// (1 - E)((mu + k) / k)^2 as a Chebyshev series in sqrt(mu (1 + k) / (mu + k)): of like size for every mu, as 1 - E
/// falls with (alpha / mu)^2.
struct Series {
    scale: f64,
    coefficients: Vec<f64>,
}

impl Series {
    fn new(lobe: &Lobe) -> Self {
        let scale = 6.0 * lobe.alpha;
        let n = f64::from(TERMS);
        let angle = |j: u32| std::f64::consts::PI * (f64::from(j) + 0.5) / n;
        let values: Vec<f64> = (0..TERMS)
            .map(|j| {
                let x = 0.5 * (1.0 + angle(j).cos());
                let mu = scale * x * x / (1.0 + scale - x * x);
                let weight = 1.0 + mu / scale;
                lobe.one_minus_e(mu.min(1.0)) * weight * weight
            })
            .collect();
        let coefficients = (0..TERMS)
            .map(|i| {
                let terms = (0..TERMS).zip(&values);
                let sum: f64 = terms
                    .map(|(j, v)| v * (f64::from(i) * angle(j)).cos())
                    .sum();
                sum * if i == 0 { 1.0 / n } else { 2.0 / n }
            })
            .collect();
        Self {
            scale,
            coefficients,
        }
    }

    /// 1 - E(mu), not below 0, by Clenshaw's recurrence.
    fn at(&self, mu: f64) -> f64 {
        let x = 2.0 * (mu * (1.0 + self.scale) / (mu + self.scale)).sqrt() - 1.0;
        let (mut b1, mut b2) = (0.0, 0.0);
        for c in self.coefficients.iter().skip(1).rev() {
            (b1, b2) = (c + 2.0 * x * b1 - b2, b1);
        }
        let value = self.coefficients.first().copied().unwrap_or(0.0) + x * b1 - b2;
        let weight = 1.0 + mu / self.scale;
        (value - SERIES_ERROR).max(0.0) / (weight * weight)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Albedos by an independent quadrature, printed to 8 digits: alpha, masking, at mu .05, .5 and 1.
    const FURNACE: [(f64, Masking, [f64; 3]); 6] = [
        (
            0.1,
            Masking::Separable,
            [0.885_970_36, 0.969_115_12, 0.988_304_06],
        ),
        (
            0.5,
            Masking::Separable,
            [0.792_276_45, 0.686_007_25, 0.687_848_52],
        ),
        (
            1.0,
            Masking::Separable,
            [0.584_481_56, 0.409_137_09, 0.306_852_82],
        ),
        (
            0.1,
            Masking::Correlated,
            [0.911_762_51, 0.969_204_98, 0.988_304_06],
        ),
        (
            0.5,
            Masking::Correlated,
            [0.912_547_80, 0.698_250_70, 0.687_848_52],
        ),
        (
            1.0,
            Masking::Correlated,
            [0.847_773_88, 0.450_693_86, 0.306_852_82],
        ),
    ];

    #[test]
    fn white_furnace_values() {
        for (alpha, masking, expected) in FURNACE {
            let lobe = Lobe {
                is_beckmann: false,
                alpha,
                masking,
            };
            let table = EnergyTable::of(false, alpha, masking);
            for (mu, expected) in [0.05, 0.5, 1.0].into_iter().zip(expected) {
                let error = (1.0 - lobe.one_minus_e(mu) - expected).abs();
                // Half a unit of the last printed digit.
                assert!(error < 5.1e-9, "{alpha} {masking:?} {mu}: {error:e}");
                let error = (1.0 - table.one_minus_e(mu) - expected).abs();
                assert!(error < 6e-6, "table {alpha} {masking:?} {mu}: {error:e}");
            }
        }
        let lobe = Lobe {
            is_beckmann: false,
            alpha: 1.0,
            masking: Masking::Separable,
        };
        assert!((lobe.one_minus_e(1.0) - std::f64::consts::LN_2).abs() < 1e-12);
    }

    #[test]
    fn the_table_is_the_integral_at_every_width() {
        let mut worst: f64 = 0.0;
        for is_beckmann in [false, true] {
            for masking in [Masking::Correlated, Masking::Separable] {
                for alpha in [1e-4, 1e-3, 0.02, 0.1, 0.3, 1.0] {
                    let lobe = Lobe {
                        is_beckmann,
                        alpha,
                        masking,
                    };
                    let table = EnergyTable::of(is_beckmann, alpha, masking);
                    for mu in [
                        1e-3 * alpha,
                        0.1 * alpha,
                        0.5 * alpha,
                        alpha,
                        0.05,
                        0.3,
                        0.9,
                    ] {
                        let error = table.one_minus_e(mu) - lobe.one_minus_e(mu);
                        worst = worst.max(error.abs());
                    }
                }
            }
        }
        assert!(worst < 1e-5, "{worst:e}");
    }

    #[test]
    fn samples_have_the_density() {
        let table = EnergyTable::of(false, 0.5, Masking::Separable);
        let mut sum = 0.0;
        let n = 4000;
        for i in 0..n {
            // The mean of cos/pdf over samples of a hemisphere is pi; midpoint rule in u, the table's kinks of 1 / CELLS.
            let w: Vec3<f64> = table.sample([(f64::from(i) + 0.5) / f64::from(n), 0.3]);
            assert!((w.length_squared() - 1.0).abs() < 1e-14);
            sum += w.z / table.pdf(w.z);
        }
        let mean = sum / f64::from(n);
        assert!((mean / std::f64::consts::PI - 1.0).abs() < 1e-5, "{mean}");
    }

    #[test]
    fn the_density_keeps_its_digits_towards_the_pole() {
        // Found by its place from the other end, it would be off by 4e-6 in f32.
        let table = EnergyTable::of(false, 0.0033, Masking::Correlated);
        for step in 1..2000 {
            let mu = 0.01 + 0.99 * step as f32 / 2000.0;
            let exact = table.pdf(f64::from(mu));
            let error = (f64::from(table.pdf(mu)) / exact - 1.0).abs();
            assert!(error < 1.5e-6, "{mu}: {error:e}");
        }
    }
}
