//! The arrays that batches read and write: columns of one length in one piece of memory.

use std::cell::Cell;

use glam::DVec3;

use crate::math::Real;

/// Bytes by which each column starts further within its page than the one before: thirteen lines of a cache, so that 64
/// columns start on 64 different lines of a page before one starts where the first does.
const STAGGER: usize = 832;

/// Bytes of a page. A cache finds its lines by their place within one: columns that all start at the same place evict one
/// another where there are more of them than the cache has ways (twelve at most in a first-level cache today; samples have
/// seventeen columns).
const PAGE: usize = 4096;

thread_local! {
    /// How many columns this thread has staggered, for those of one allocation not to stand where those of another do.
    static STAGGERED: Cell<usize> = const { Cell::new(0) };
}

/// `N` columns of one length.
///
/// Where they are longer than a page, each starts elsewhere within its page, whatever the others of this and of other
/// `Columns` are: so the arrays of a batch do not evict one another from the cache. (Lambert's f of 2^20 pairs took 1.1 ns
/// a pair with all arrays aligned, and .92 so; 1.0 and .57 on two threads.)
#[derive(Clone, Debug)]
pub struct Columns<R, const N: usize> {
    memory: Vec<R>,
    /// Where the first one starts.
    first: usize,
    /// From the start of one to that of the next.
    stride: usize,
    length: usize,
}

impl<R: Copy, const N: usize> Columns<R, N> {
    /// Columns of `length` numbers, all of them `value`.
    #[must_use]
    pub fn filled(value: R, length: usize) -> Self {
        let size = size_of::<R>().max(1);
        let (first, stride) = if length * size < PAGE {
            (0, length)
        } else {
            let step = |columns: usize| columns.wrapping_mul(STAGGER) % PAGE / size;
            let before = STAGGERED.get();
            STAGGERED.set(before.wrapping_add(N));
            (
                step(before),
                (length * size).next_multiple_of(PAGE) / size + STAGGER / size,
            )
        };
        Self {
            memory: vec![value; first + N * stride],
            first,
            stride,
            length,
        }
    }

    /// Columns of `length` numbers, those of each column being all the same: a direction that is held.
    #[must_use]
    pub fn repeated(row: [R; N], length: usize) -> Self {
        let Some(value) = row.first() else {
            return Self::from_rows([]);
        };
        let mut columns = Self::filled(*value, length);
        for (column, value) in columns.slices_mut().into_iter().zip(row) {
            column.fill(value);
        }
        columns
    }

    /// The columns of a table that is given row by row.
    #[must_use]
    pub fn from_rows<I>(rows: I) -> Self
    where
        I: IntoIterator<Item = [R; N], IntoIter: ExactSizeIterator>,
    {
        let mut rows = rows.into_iter().peekable();
        let length = rows.len();
        let Some(value) = rows.peek().and_then(|row| row.first().copied()) else {
            return Self {
                memory: Vec::new(),
                first: 0,
                stride: 0,
                length: 0,
            };
        };
        let mut columns = Self::filled(value, length);
        let mut slices = columns.slices_mut();
        for (index, row) in rows.enumerate() {
            for (slice, value) in slices.iter_mut().zip(row) {
                if let Some(place) = slice.get_mut(index) {
                    *place = value;
                }
            }
        }
        columns
    }

    /// How many numbers each column holds.
    #[must_use]
    pub fn len(&self) -> usize {
        self.length
    }

    /// Whether they hold none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.length == 0
    }

    /// The columns.
    #[must_use]
    pub fn slices(&self) -> [&[R]; N] {
        std::array::from_fn(|index| {
            let start = self.first + index * self.stride;
            let slice = self.memory.get(start..start + self.length);
            slice.unwrap_or_default()
        })
    }

    /// The columns, to be written.
    #[must_use]
    pub fn slices_mut(&mut self) -> [&mut [R]; N] {
        let mut rest = self.memory.get_mut(self.first..).unwrap_or_default();
        std::array::from_fn(|_| {
            let (column, others) = std::mem::take(&mut rest)
                .split_at_mut_checked(self.stride)
                .unwrap_or_default();
            rest = others;
            column.get_mut(..self.length).unwrap_or_default()
        })
    }

    /// The rows, in order.
    #[must_use]
    pub fn rows(&self) -> impl ExactSizeIterator<Item = [R; N]> + '_ {
        let columns = self.slices();
        // Every column is as long as the first one, whose numbers stand in where there are none.
        let own = columns.first().copied().unwrap_or_default();
        own.iter().enumerate().map(move |(index, first)| {
            columns.map(|column| column.get(index).copied().unwrap_or(*first))
        })
    }
}

impl<R: Real> Columns<R, 3> {
    /// These directions, rounded to `R`.
    #[must_use]
    pub fn directions(all: impl IntoIterator<Item = DVec3, IntoIter: ExactSizeIterator>) -> Self {
        Self::from_rows(all.into_iter().map(|w| w.to_array().map(R::of)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_and_columns_are_one_table() {
        let rows = [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]];
        let mut columns = Columns::from_rows(rows);
        assert_eq!(columns.slices(), [[1.0, 4.0], [2.0, 5.0], [3.0, 6.0]]);
        assert!(columns.rows().eq(rows));
        let [_, y, _] = columns.slices_mut();
        y[1] = 7.0;
        assert!(columns.rows().eq([rows[0], [4.0, 7.0, 6.0]]));
        assert!(columns.len() == 2 && !columns.is_empty());
        let held = Columns::repeated([0.0, 0.6, 0.8], 1000);
        assert!(held.rows().len() == 1000 && held.rows().all(|row| row == [0.0, 0.6, 0.8]));
        assert!(Columns::<f32, 4>::from_rows([]).is_empty());
        assert_eq!(Columns::filled(1.5, 3).slices(), [[1.5; 3]; 2]);
    }

    /// Of the seventeen columns of samples, in whatever allocations they stand, no two start on the same line of a page.
    #[test]
    fn long_columns_start_on_lines_of_their_own() {
        for length in [1 << 10, 5000, 1 << 20] {
            let given = Columns::<f32, 3>::filled(0.0, length);
            let numbers = Columns::<f32, 3>::filled(0.0, length);
            let other_numbers = Columns::<f32, 3>::filled(0.0, length);
            let drawn = Columns::<f32, 8>::filled(0.0, length);
            // Allocations of this size start at one place in their pages; relative to it, lines are told apart.
            let lines = |memory: &[f32], slices: &[&[f32]]| -> Vec<usize> {
                let start = memory.as_ptr().addr();
                let place = |slice: &&[f32]| (slice.as_ptr().addr() - start) % PAGE / 64;
                slices.iter().map(place).collect()
            };
            let mut all = [
                lines(&given.memory, &given.slices()),
                lines(&numbers.memory, &numbers.slices()),
                lines(&other_numbers.memory, &other_numbers.slices()),
                lines(&drawn.memory, &drawn.slices()),
            ]
            .concat();
            assert_eq!(all.len(), 17);
            all.sort_unstable();
            all.dedup();
            assert_eq!(all.len(), 17, "{length}: {all:?}");
        }
    }
}
