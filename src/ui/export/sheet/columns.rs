//! Two columns to a page.

use std::collections::VecDeque;

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
    /// Whether what follows may stand before it, where it is too high for what is left of a column.
    floats: bool,
    /// Whether a step begins with it.
    begins: bool,
}

impl Item {
    /// An item that goes on with what stands above it.
    pub(super) fn of(painted: Painted) -> Self {
        Self {
            painted,
            above: GAP,
            is_bound: false,
            floats: false,
            begins: false,
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
        Self {
            begins: true,
            ..Self::apart(painted).bound()
        }
    }

    /// A figure.
    pub(super) fn figure(painted: Painted) -> Self {
        Self {
            floats: true,
            ..Self::of(painted)
        }
    }

    fn height(&self) -> f32 {
        self.painted.size.y
    }
}

/// Where an item stands: its column, counted through all pages, and its height there.
type Place = (usize, f32);

/// Where items stand.
pub(super) struct Columns {
    /// The items with their places, in the order of the columns.
    items: Vec<(Place, Item)>,
}

/// By how much the room between items is smaller, the first where none needs fewer pages.
const SQUEEZES: [f32; 3] = [1.0, 0.7, 0.4];

/// How often the height of the last page is halved in search of the least one that holds what is on it.
const HALVINGS: usize = 12;

impl Columns {
    /// Fills columns, below the head those of the first page; those of the last page are about equally high.
    pub(super) fn filled(head: &Painted, items: Vec<Item>) -> Self {
        let bottom = PAPER.size_mm.y * PAPER.points_per_mm - MARGIN;
        let top = |column: usize| match column {
            0..COLUMNS => MARGIN + head.size.y,
            _ => MARGIN,
        };
        let page_of = |places: &[(Place, usize)]| {
            let last = places.iter().map(|((column, _), _)| column / COLUMNS).max();
            last.unwrap_or(0)
        };
        // A page more is worth less than the room between items.
        let squeezed = SQUEEZES.map(|squeeze| (squeeze, flow(&items, squeeze, top, |_| bottom)));
        let fewest = squeezed
            .into_iter()
            .min_by_key(|(_, places)| page_of(places));
        let (squeeze, mut places) = fewest.unwrap_or_default();
        let page = page_of(&places);
        let (mut low, mut high) = (top(page * COLUMNS), bottom);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            let lower = |column: usize| {
                if column / COLUMNS < page {
                    bottom
                } else {
                    middle
                }
            };
            let found = flow(&items, squeeze, top, lower);
            let fits = |((column, y), index): &(Place, usize)| {
                let height = items.get(*index).map_or(0.0, Item::height);
                y + height <= lower(*column) || *column / COLUMNS < page
            };
            if page_of(&found) == page && found.iter().all(fits) {
                (high, places) = (middle, found);
            } else {
                low = middle;
            }
        }
        let mut items: Vec<Option<Item>> = items.into_iter().map(Some).collect();
        let placed = places.into_iter().filter_map(|(place, index)| {
            let item = items.get_mut(index)?.take()?;
            Some((place, item))
        });
        Self {
            items: placed.collect(),
        }
    }

    /// How many pages there are.
    pub(super) fn pages(&self) -> usize {
        self.items
            .last()
            .map_or(1, |((column, _), _)| column / COLUMNS + 1)
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
                .filter(move |((column, _), _)| column / COLUMNS == number);
            let items = here.map(move |((column, y), item)| {
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

/// Where the items go, with their indices and `squeeze` times their room above, in columns from `top` to `bottom`. A figure for which a column has no room is the first in the
/// next one, and the text of its step goes on before it.
fn flow(
    items: &[Item],
    squeeze: f32,
    top: impl Fn(usize) -> f32,
    bottom: impl Fn(usize) -> f32,
) -> Vec<(Place, usize)> {
    let mut placed = Vec::new();
    let mut waiting: VecDeque<usize> = VecDeque::new();
    let (mut column, mut y, mut after_bound) = (0, top(0), false);
    let mut next = 0;
    loop {
        let at_top = y == top(column);
        let is_ahead = |index: &usize| {
            // What waits stands before the next step, and first in a column.
            let begins = items.get(*index).is_none_or(|item| item.begins);
            waiting.is_empty() || !(at_top || begins)
        };
        let from_text = Some(next).filter(is_ahead);
        let Some(index) = from_text.or_else(|| waiting.front().copied()) else {
            return placed;
        };
        let Some(item) = items.get(index) else {
            return placed;
        };
        let gap = match (at_top, after_bound) {
            (true, _) => 0.0,
            (false, true) => squeeze * GAP,
            (false, false) => squeeze * item.above,
        };
        let bound = match items.get(index + 1) {
            Some(next) if item.is_bound && !next.floats => squeeze * GAP + next.height(),
            _ => 0.0,
        };
        let is_full = !at_top && y + gap + item.height() + bound > bottom(column);
        if is_full && item.floats && from_text.is_some() {
            waiting.push_back(index);
            next += 1;
            continue;
        }
        if is_full {
            column += 1;
            y = top(column);
            continue;
        }
        placed.push(((column, y + gap), index));
        y += gap + item.height();
        after_bound = item.is_bound;
        if from_text.is_some() {
            next += 1;
        } else {
            waiting.pop_front();
        }
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
        let at: Vec<usize> = columns
            .items
            .iter()
            .map(|((column, _), _)| *column)
            .collect();
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

    fn places(columns: &Columns) -> Vec<(usize, f32)> {
        let all = columns.items.iter();
        all.map(|((column, _), item)| (*column, item.height()))
            .collect()
    }

    #[test]
    fn columns_of_the_last_page_are_about_equally_high() {
        let head = piece(0.0);
        let items = (0..4).map(|_| Item::of(piece(100.0))).collect();
        let columns = Columns::filled(&head, items);
        let [a, b] = [0, 1].map(|wanted| {
            let of = columns.items.iter();
            of.filter(|((column, _), _)| *column == wanted).count()
        });
        assert_eq!([a, b], [2, 2]);
    }

    #[test]
    fn the_text_of_a_step_goes_on_before_a_figure_that_has_no_room() {
        let high = PAPER.size_mm.y * PAPER.points_per_mm - 2.0 * MARGIN;
        let items = vec![
            Item::heading(piece(20.0)),
            Item::of(piece(high - 200.0)),
            Item::figure(piece(300.0)),
            Item::of(piece(50.0)),
            // Of the next step nothing comes before it.
            Item::heading(piece(21.0)),
            Item::of(piece(high - 400.0)),
        ];
        let columns = Columns::filled(&piece(0.0), items);
        let expected = [
            (0, 20.0),
            (0, high - 200.0),
            (0, 50.0),
            (1, 300.0),
            (1, 21.0),
            (1, high - 400.0),
        ];
        assert_eq!(places(&columns), expected);
    }

    #[test]
    fn no_page_is_begun_for_what_has_room_where_gaps_are_smaller() {
        let high = PAPER.size_mm.y * PAPER.points_per_mm - 2.0 * MARGIN;
        let part = (high - 5.0 * APART - 4.0) / 6.0;
        // Two columns of six parts with all the room between them, which leave nothing for one more line.
        let parts = (0..12).map(|_| Item::apart(piece(part)));
        let items = parts.chain([Item::apart(piece(10.0))]).collect();
        assert_eq!(Columns::filled(&piece(0.0), items).pages(), 1);
    }
}
