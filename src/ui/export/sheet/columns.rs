//! Two columns to a page.

use egui::{Pos2, pos2, vec2};

use crate::export::painted::Painted;
use crate::export::pdf::{Paper, Placed};

/// A sheet of A4, on which a column is as wide as a figure for one.
pub(super) const PAPER: Paper = Paper {
    size_mm: vec2(210.0, 297.0),
    points_per_mm: COLUMN / 88.0,
};

/// The width of a column, in points: that of a figure for one.
pub(super) const COLUMN: f32 = 400.0;

/// How many columns there are, and the room between them, in points.
const COLUMNS: usize = 2;
const GUTTER: f32 = 30.0;

/// The width of all columns, in points.
pub(super) const WIDTH: f32 = COLUMNS as f32 * COLUMN + (COLUMNS as f32 - 1.0) * GUTTER;

/// From the upper and from the lower edge to what is printed, in points.
const MARGIN: f32 = 60.0;

/// From the lower edge to the foot, in points.
const FOOT: f32 = 40.0;

/// Between two items, in points.
const GAP: f32 = 6.0;

/// Above what begins something new, in points.
const APART: f32 = 18.0;

/// What stands in a column in one piece.
pub(super) struct Item {
    painted: Painted,
    /// The room above it, where it is not the first in its column, in points.
    above: f32,
    /// Whether what follows begins in the same column.
    is_bound: bool,
}

impl Item {
    /// An item that goes on with what stands above it.
    pub(super) fn of(painted: Painted) -> Self {
        Self {
            painted,
            above: GAP,
            is_bound: false,
        }
    }

    /// One with which something new begins.
    pub(super) fn apart(painted: Painted) -> Self {
        Self {
            above: APART,
            ..Self::of(painted)
        }
    }

    /// The same item, which stays with what follows.
    pub(super) fn bound(self) -> Self {
        Self {
            is_bound: true,
            ..self
        }
    }

    /// A heading.
    pub(super) fn heading(painted: Painted) -> Self {
        Self::apart(painted).bound()
    }

    fn height(&self) -> f32 {
        self.painted.size.y
    }
}

/// Where items stand.
pub(super) struct Columns {
    /// The items, each with its column, counted through all pages, and its height there.
    items: Vec<(usize, f32, Item)>,
}

impl Columns {
    /// Fills columns, below the head those of the first page.
    pub(super) fn filled(head: &Painted, items: Vec<Item>) -> Self {
        let bottom = PAPER.size_mm.y * PAPER.points_per_mm - MARGIN;
        let top = |column: usize| match column {
            0..COLUMNS => MARGIN + head.size.y,
            _ => MARGIN,
        };
        let mut placed: Vec<(usize, f32, Item)> = Vec::new();
        let (mut column, mut y, mut after_bound) = (0, top(0), false);
        let mut rest = items.into_iter().peekable();
        while let Some(item) = rest.next() {
            let is_first = y == top(column);
            let gap = match (is_first, after_bound) {
                (true, _) => 0.0,
                (false, true) => GAP,
                (false, false) => item.above,
            };
            let bound = match rest.peek() {
                Some(next) if item.is_bound => GAP + next.height(),
                _ => 0.0,
            };
            if !is_first && y + gap + item.height() + bound > bottom {
                column += 1;
                y = top(column);
            } else {
                y += gap;
            }
            let height = item.height();
            let is_bound = item.is_bound;
            placed.push((column, y, item));
            y += height;
            after_bound = is_bound;
        }
        Self { items: placed }
    }

    /// How many pages there are.
    pub(super) fn pages(&self) -> usize {
        self.items
            .last()
            .map_or(1, |(column, ..)| column / COLUMNS + 1)
    }

    /// What stands on each page: the head on the first one, a foot on each.
    pub(super) fn placed<'a>(
        &'a self,
        head: &'a Painted,
        feet: &'a [Painted],
    ) -> Vec<Vec<Placed<'a>>> {
        let paper = PAPER.size_mm * PAPER.points_per_mm;
        let left = 0.5 * (paper.x - WIDTH);
        let page = |(number, foot): (usize, &'a Painted)| {
            let here = self
                .items
                .iter()
                .filter(move |(column, ..)| column / COLUMNS == number);
            let items = here.map(move |(column, y, item)| {
                let x = left + (column % COLUMNS) as f32 * (COLUMN + GUTTER);
                (pos2(x, *y), &item.painted)
            });
            let head = (number == 0).then_some((pos2(left, MARGIN), head));
            let foot: (Pos2, &Painted) = (pos2(left, paper.y - FOOT), foot);
            head.into_iter().chain(items).chain([foot]).collect()
        };
        feet.iter().enumerate().map(page).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn piece(height: f32) -> Painted {
        Painted::of_shapes(vec2(COLUMN, height), Vec::new())
    }

    #[test]
    fn a_heading_stays_with_what_follows_and_pages_are_filled_in_order() {
        let high = PAPER.size_mm.y * PAPER.points_per_mm - 2.0 * MARGIN;
        let head = piece(100.0);
        let items = vec![
            Item::of(piece(high - 200.0)),
            // There is room for the heading, but not for its text.
            Item::heading(piece(30.0)),
            Item::of(piece(80.0)),
            Item::of(piece(high - 100.0)),
            // What is higher than a column has one for itself.
            Item::of(piece(high + 50.0)),
        ];
        let columns = Columns::filled(&head, items);
        let at: Vec<usize> = columns.items.iter().map(|(column, ..)| *column).collect();
        assert_eq!(at, [0, 1, 1, 2, 3]);
        assert_eq!(columns.pages(), 2);
        let feet = [piece(10.0), piece(10.0)];
        let placed = columns.placed(&head, &feet);
        let counts: Vec<usize> = placed.iter().map(Vec::len).collect();
        assert_eq!(counts, [5, 3]);
        let (first, _) = placed[0][1];
        assert_eq!(first.y, MARGIN + 100.0, "below the head");
        let (second, _) = placed[0][2];
        assert!(second.x > first.x + COLUMN && second.y == first.y);
        let (third, _) = placed[1][0];
        assert_eq!(third.y, MARGIN);
    }
}
