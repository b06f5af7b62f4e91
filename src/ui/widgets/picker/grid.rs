//! Where the entries of the grid stand, and how arrows go through them.

use std::ops::Range;

use crate::theme;

/// The columns that a picker has whose grid may be so wide.
pub(super) fn columns(width: f32) -> usize {
    let columns =
        (width - theme::SCROLL_ROOM + theme::CELL_GAP) / (theme::CELL.x + theme::CELL_GAP);
    (columns.max(1.0) as usize).min(theme::GRID_COLUMNS)
}

/// The width of a grid of so many columns, with the scroll bar.
pub(super) fn width(columns: usize) -> f32 {
    columns as f32 * (theme::CELL.x + theme::CELL_GAP) - theme::CELL_GAP + theme::SCROLL_ROOM
}

/// The rows of a grid of so many `columns`: groups of these `sizes` stand below one another, each in rows of its own.
pub(super) fn rows(sizes: impl IntoIterator<Item = usize>, columns: usize) -> Vec<Range<usize>> {
    let columns = columns.max(1);
    let (mut rows, mut first) = (Vec::new(), 0);
    for size in sizes {
        let end = first + size;
        while first < end {
            let next = end.min(first + columns);
            rows.push(first..next);
            first = next;
        }
    }
    rows
}

/// Where the arrows lead from `at`: so many places onwards in the order of reading, and so many rows down, in the same
/// column where the row reaches so far. Before anything is chosen, any arrow leads to the first place. `None` where there
/// is no place.
pub(super) fn moved(
    rows: &[Range<usize>],
    at: Option<usize>,
    [places, down]: [isize; 2],
) -> Option<usize> {
    let last = rows.last()?.end.checked_sub(1)?;
    let Some(at) = at else {
        return (places != 0 || down != 0).then_some(0);
    };
    let at = at.min(last);
    let at = at.saturating_add_signed(places).min(last);
    let row = rows.iter().position(|row| row.contains(&at))?;
    let column = at - rows.get(row)?.start;
    let row = row.saturating_add_signed(down).min(rows.len() - 1);
    let row = rows.get(row)?;
    Some((row.start + column).min(row.end - 1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_group_begins_a_row() {
        assert_eq!(rows([5, 1, 2], 3), [0..3, 3..5, 5..6, 6..8]);
        assert!(rows([0, 0], 3).is_empty());
        assert_eq!(rows([2], 0), [0..1, 1..2]);
    }

    #[test]
    fn arrows_go_along_rows_and_columns() {
        let rows = rows([5, 1, 2], 3);
        for (from, by, to) in [
            (0, [1, 0], 1),
            (2, [1, 0], 3),
            (3, [-1, 0], 2),
            (0, [-1, 0], 0),
            (7, [1, 0], 7),
            (1, [0, 1], 4),
            // The next rows are shorter.
            (2, [0, 1], 4),
            (4, [0, 1], 5),
            (5, [0, 1], 6),
            (7, [0, -1], 5),
            (1, [0, 9], 7),
            (1, [0, -9], 1),
        ] {
            assert_eq!(moved(&rows, Some(from), by), Some(to), "{from} {by:?}");
        }
        assert_eq!(moved(&rows, None, [0, 1]), Some(0));
        assert_eq!(moved(&rows, None, [0, 0]), None);
        assert_eq!(moved(&[], Some(0), [1, 0]), None);
    }
}
