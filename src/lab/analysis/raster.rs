//! Values on a grid of pixels.

use rayon::prelude::*;

use super::IsWanted;

/// A rectangle of values, row by row from the upper left.
#[derive(Clone, Debug, PartialEq)]
pub struct Raster<T> {
    /// Pixels in a row.
    pub width: usize,
    /// How many rows there are.
    pub height: usize,
    /// The values: `width` times `height`.
    pub pixels: Vec<T>,
}

impl<T> Default for Raster<T> {
    fn default() -> Self {
        Self {
            width: 0,
            height: 0,
            pixels: Vec::new(),
        }
    }
}

impl<T: Send> Raster<T> {
    /// The raster whose rows `row` gives, each of `width` values, computed side by side. `None` where it was not wanted to
    /// the end, which is asked before each row.
    #[must_use]
    pub fn rows_while(
        width: usize,
        height: usize,
        is_wanted: IsWanted<'_>,
        row: impl Fn(usize) -> Vec<T> + Sync,
    ) -> Option<Self> {
        let rows = (0..height).into_par_iter().map(|index| {
            let values = is_wanted().then(|| row(index))?;
            debug_assert_eq!(values.len(), width, "row {index} has another width");
            Some(values)
        });
        let rows: Vec<Vec<T>> = rows.collect::<Option<_>>()?;
        Some(Self {
            width,
            height,
            pixels: rows.into_iter().flatten().collect(),
        })
    }
}

impl<T> Raster<T> {
    /// The value in column `x` from the left and row `y` from above; `None` beyond the raster.
    #[must_use]
    pub fn at(&self, x: usize, y: usize) -> Option<&T> {
        let is_inside = x < self.width && y < self.height;
        is_inside.then(|| self.pixels.get(y * self.width + x))?
    }

    /// The rows, from above.
    pub fn rows(&self) -> impl Iterator<Item = &[T]> {
        self.pixels.chunks(self.width.max(1))
    }

    /// The raster of what `f` makes of each value.
    #[must_use]
    pub fn map<U>(&self, f: impl FnMut(&T) -> U) -> Raster<U> {
        Raster {
            width: self.width,
            height: self.height,
            pixels: self.pixels.iter().map(f).collect(),
        }
    }

    /// The raster of what `f` makes of the values of two; `None` where their sizes differ.
    #[must_use]
    pub fn zip_with<U, V>(
        &self,
        other: &Raster<U>,
        mut f: impl FnMut(&T, &U) -> V,
    ) -> Option<Raster<V>> {
        let is_alike = (self.width, self.height) == (other.width, other.height);
        let pairs = self.pixels.iter().zip(&other.pixels);
        is_alike.then(|| Raster {
            width: self.width,
            height: self.height,
            pixels: pairs.map(|(a, b)| f(a, b)).collect(),
        })
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicUsize, Ordering};

    use super::*;

    fn numbered(width: usize, height: usize) -> Raster<usize> {
        let row = |y| (0..width).map(|x| 10 * y + x).collect();
        Raster::rows_while(width, height, &|| true, row).unwrap()
    }

    #[test]
    fn rows_stand_in_their_order() {
        let raster = numbered(3, 2);
        assert_eq!(raster.pixels, [0, 1, 2, 10, 11, 12]);
        assert_eq!(raster.at(2, 1), Some(&12));
        assert_eq!((raster.at(3, 0), raster.at(0, 2)), (None, None));
        assert!(raster.rows().eq([&[0, 1, 2], &[10, 11, 12]]));
        assert_eq!(Raster::<f64>::default().rows().count(), 0);
        assert_eq!(numbered(0, 0), Raster::default());
    }

    #[test]
    fn what_is_no_longer_wanted_is_given_up() {
        let asked = AtomicUsize::new(0);
        let is_wanted = || asked.fetch_add(1, Ordering::Relaxed) < 3;
        assert_eq!(Raster::rows_while(2, 100, &is_wanted, |y| vec![y; 2]), None);
        assert!(asked.load(Ordering::Relaxed) < 100);
    }

    #[test]
    fn values_are_joined_where_they_stand() {
        let sum = numbered(3, 2).zip_with(&numbered(3, 2).map(|x| 2 * x), |a, b| a + b);
        assert_eq!(sum.unwrap().pixels, [0, 3, 6, 30, 33, 36]);
        assert_eq!(numbered(3, 2).zip_with(&numbered(2, 3), |a, _| *a), None);
    }
}
