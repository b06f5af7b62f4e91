//! Numbers for estimates: random, stratified, of low discrepancy.

use sobol_burley::sample;

use crate::analysis::statistics::Random;
use bxdf::batch::Columns;

/// How the numbers of the samples are spread.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sequence {
    /// Independent random numbers.
    Plain,
    /// One in each cell of a grid over u, and one in each stratum of uc; made anew for each number of samples.
    Stratified,
    /// The Sobol sequence with Owen scrambling (`burley2020`).
    Sobol,
}

/// The numbers of some samples, each in [0, 1): uc, which chooses among lobes or sides, and the two of u, which choose
/// directions.
pub type Numbers = Columns<f64, 3>;

impl Sequence {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Plain, Self::Stratified, Self::Sobol];

    /// Its name in choices.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Plain => "plain",
            Self::Stratified => "stratified",
            Self::Sobol => "Sobol",
        }
    }

    /// log2 of the most samples it has.
    #[must_use]
    pub const fn longest(self) -> u32 {
        match self {
            Self::Plain | Self::Stratified => 20,
            // As far as the library goes.
            Self::Sobol => 16,
        }
    }

    /// Whether the first numbers of a long sequence are those of a short one.
    #[must_use]
    pub const fn has_prefixes(self) -> bool {
        !matches!(self, Self::Stratified)
    }

    /// The numbers of 2^`log_n` samples. The same `seed` gives the same numbers, another one independent ones.
    #[must_use]
    pub fn numbers(self, log_n: u32, seed: u32) -> Numbers {
        let n = 1_u32 << log_n;
        match self {
            Self::Plain => {
                let mut random = Random::new(u64::from(seed));
                Numbers::from_rows((0..n).map(|_| [(); 3].map(|()| random.unit())))
            }
            Self::Sobol => {
                let number = |index, axis| f64::from(sample(index, axis, seed));
                Numbers::from_rows((0..n).map(|index| [0, 1, 2].map(|axis| number(index, axis))))
            }
            Self::Stratified => {
                let mut random = Random::new(u64::from(seed) << 32 | u64::from(log_n));
                let columns = 1_u32 << (log_n / 2);
                let rows = n / columns;
                let mut numbers = Numbers::from_rows((0..n).map(|index| {
                    let [column, row] = [index % columns, index / columns].map(f64::from);
                    let stratum = f64::from(index) / f64::from(n);
                    let uc = stratum + random.unit() / f64::from(n);
                    let u = (column + random.unit()) / f64::from(columns);
                    let v = (row + random.unit()) / f64::from(rows);
                    [uc, u, v].map(|x| x.min(BELOW_ONE))
                }));
                let [uc, _, _] = numbers.slices_mut();
                shuffle(uc, &mut random);
                numbers
            }
        }
    }
}

/// The largest number below 1.
const BELOW_ONE: f64 = 1.0 - 0.5 * f64::EPSILON;

/// Puts `values` in a random order (Fisher and Yates).
fn shuffle(values: &mut [f64], random: &mut Random) {
    for last in (1..values.len()).rev() {
        let other = (random.unit() * (last + 1) as f64) as usize;
        values.swap(last, other.min(last));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_cell_and_each_stratum_has_one() {
        let numbers = Sequence::Stratified.numbers(5, 3);
        let mut uc = numbers.slices()[0].to_vec();
        let mut cells: Vec<_> = numbers
            .rows()
            .map(|[_, u, v]| ((4.0 * u) as u32, (8.0 * v) as u32))
            .collect();
        cells.sort_unstable();
        cells.dedup();
        assert_eq!(cells.len(), 32);
        assert!(uc.windows(2).any(|pair| pair[0] > pair[1]), "shuffled");
        uc.sort_by(f64::total_cmp);
        assert!((0..32).all(|index| (32.0 * uc[index]) as usize == index));
    }

    #[test]
    fn prefixes_and_seeds() {
        for sequence in Sequence::ALL {
            let (short, long) = (sequence.numbers(6, 1), sequence.numbers(8, 1));
            let is_prefix = short.rows().eq(long.rows().take(64));
            assert_eq!(is_prefix, sequence.has_prefixes(), "{sequence:?}");
            assert!(sequence.numbers(6, 1).rows().eq(short.rows()));
            assert!(sequence.numbers(6, 2).rows().ne(short.rows()));
            let mean = long.rows().map(|[_, _, v]| v).sum::<f64>() / 256.0;
            // Three standard deviations of the plain one: .289 / 16 each.
            assert!((mean - 0.5).abs() < 0.055, "{sequence:?}: {mean}");
        }
    }
}
