//! Tables over the wavelength, as the files of `assets` hold them.

use bxdf::error::{Error, Result};

/// Rows by wavelength in nm, in rising order, of as many columns each.
#[derive(Clone, Debug)]
pub(super) struct Table {
    rows: Vec<Vec<f64>>,
}

impl Table {
    /// Reads CSV: comment lines that start with `#`, a header line, rows of numbers.
    ///
    /// # Errors
    /// [`Error::Parse`] with the line.
    pub(super) fn parse(name: &str, text: &str) -> Result<Self> {
        let mut reader = csv::ReaderBuilder::new()
            .comment(Some(b'#'))
            .from_reader(text.as_bytes());
        let rows = reader.deserialize();
        let rows: std::result::Result<Vec<Vec<f64>>, csv::Error> = rows.collect();
        let rows = rows.map_err(|error| Error::parse(name, error.to_string()))?;
        let wavelengths = rows.iter().filter_map(|row| row.first());
        if rows.len() < 2 || !wavelengths.is_sorted_by(|a, b| a < b) {
            return Err(Error::parse(
                name,
                "two rows at least, by rising wavelength, are needed",
            ));
        }
        Ok(Self { rows })
    }

    /// The wavelengths of the first and the last row, in nm.
    pub(super) fn range_nm(&self) -> [f64; 2] {
        let end = |row: Option<&Vec<f64>>| row.and_then(|row| row.first()).copied();
        [self.rows.first(), self.rows.last()].map(|row| end(row).unwrap_or(f64::NAN))
    }

    /// The `N` columns after the wavelength at `nm`, by linear interpolation; those of the nearer end outside the range.
    pub(super) fn at<const N: usize>(&self, nm: f64) -> [f64; N] {
        let wavelength = |row: &Vec<f64>| row.first().copied().unwrap_or(f64::NAN);
        let next = self.rows.partition_point(|row| wavelength(row) < nm);
        let next = next.clamp(1, self.rows.len() - 1);
        let (Some(before), Some(after)) = (self.rows.get(next - 1), self.rows.get(next)) else {
            return [f64::NAN; N];
        };
        let [start, end] = [before, after].map(wavelength);
        let t = ((nm - start) / (end - start)).clamp(0.0, 1.0);
        std::array::from_fn(|column| {
            let [a, b] =
                [before, after].map(|row| row.get(column + 1).copied().unwrap_or(f64::NAN));
            a + t * (b - a)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn between_rows_values_lie_between_and_beyond_they_stay() {
        let table = Table::parse("a table", "# of a test\nnm,n,k\n400,1,0\n500,2,4\n").unwrap();
        assert_eq!(table.range_nm(), [400.0, 500.0]);
        assert_eq!(table.at::<2>(425.0), [1.25, 1.0]);
        assert_eq!(
            [table.at::<2>(400.0), table.at::<2>(500.0)],
            [[1.0, 0.0], [2.0, 4.0]]
        );
        assert_eq!([table.at::<1>(0.0), table.at::<1>(900.0)], [[1.0], [2.0]]);
    }

    #[test]
    fn what_is_no_table_is_refused_with_its_line() {
        for (text, expected) in [
            ("nm,n\n400,1\n", "two rows"),
            ("nm,n\n500,1\n400,1\n", "rising"),
            ("nm,n\n400,1\n500,x\n", "line: 3"),
            ("nm,n\n400,1\n500\n", "line: 3"),
        ] {
            let error = Table::parse("t", text).unwrap_err().to_string();
            assert!(error.contains(expected), "{error}");
        }
    }
}
