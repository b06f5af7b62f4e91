//! The room of small sums: each a picture with a slim bar beside it and numbers below it.

use egui::{Rect, Ui};

use super::scene::Scene;
use crate::widgets::draw;
use crate::widgets::pictures::{self, Cell};

/// The width of the bar beside a small picture, in points.
pub(super) const BAR: f32 = 12.0;

/// Between it and the picture, in points.
pub(super) const BAR_GAP: f32 = 8.0;

/// The part of a small sum that the numbers below it take at most.
const TEXT_SHARE: f32 = 0.45;

/// Below narrower pictures the numbers stand in short lines, by their width in points.
const NARROW: f32 = 270.0;

/// Places for small sums, each a picture of so many halves with a slim bar beside it and numbers below it.
pub(super) fn cells(ui: &Ui, room: Rect, n: usize, halves: usize) -> Vec<Cell> {
    let (line, aspect) = (line_height(ui), Scene::aspect(halves));
    let scene = |width: f32| (width - BAR - BAR_GAP).max(1.0) / aspect;
    let numbers = |width: f32| most_lines(width) as f32 * line;
    // How many lines there are, and so the shape of a place, depends on its width: of the shapes for each number of columns
    // the one that leaves the largest pictures.
    let grids = (1..=n.max(1)).map(|columns| {
        let width = room.width() / columns as f32;
        pictures::cells(ui, room, n, width / (scene(width) + numbers(width)))
    });
    let size = |cells: &Vec<Cell>| {
        let picture = cells.first().map_or(Rect::ZERO, |cell| cell.picture);
        scene(picture.width()).min(picture.height() - lines(ui, picture) as f32 * line)
    };
    let largest = grids.max_by(|a, b| size(a).total_cmp(&size(b)));
    largest.unwrap_or_default()
}

/// The height of a line of numbers below a small sum, in points.
pub(super) fn line_height(ui: &Ui) -> f32 {
    draw::small_font(ui).size + 4.0
}

/// How many lines of numbers there are below a small sum in `place`: the picture comes first.
pub(super) fn lines(ui: &Ui, place: Rect) -> usize {
    let room = TEXT_SHARE * place.height() / line_height(ui);
    (room as usize).min(most_lines(place.width()))
}

/// The most lines of numbers below a small sum of this width.
fn most_lines(width: f32) -> usize {
    if is_narrow(width) { 3 } else { 2 }
}

/// Whether the numbers below a small sum of this width are short ones.
pub(super) fn is_narrow(width: f32) -> bool {
    width < NARROW
}
