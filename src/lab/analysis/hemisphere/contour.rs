//! Contour lines of a raster.
//!
//! # Source
//! Marching squares, the plane case of `lorensen1987`, with linear interpolation along the sides of the cells between
//! four pixel centres. Where two opposite corners lie above the level and two below, the mean of the four says whether
//! the centre does, and so which pair belongs together (`wyvill1986`).

use rustc_hash::FxHashMap;

use crate::analysis::Raster;

/// Side of a cell, by its number: those from one pixel to its right neighbour first, then those to the one below.
type Side = usize;

/// The lines on which `values` passes one of `levels`, which rise, as polylines; closed ones end where they begin.
///
/// Coordinates are parts of the raster's width and height, x to the right and y down, a pixel's value standing at its
/// centre. Cells with a corner that is no finite number have no line.
#[must_use]
pub fn lines(values: &Raster<f64>, levels: &[f64]) -> Vec<Vec<[f64; 2]>> {
    let mut links: Vec<Links> = levels.iter().map(|_| Links::new(values)).collect();
    let rows = values.pixels.chunks(values.width.max(1));
    for (y, (upper, lower)) in rows.clone().zip(rows.skip(1)).enumerate() {
        for (x, (upper, lower)) in upper.windows(2).zip(lower.windows(2)).enumerate() {
            let (&[a, b], &[d, c]) = (upper, lower) else {
                continue;
            };
            let corners = [a, b, c, d];
            // Most cells have no line.
            let (low, high) = (a.min(b).min(c).min(d), a.max(b).max(c).max(d));
            let first = levels.partition_point(|level| *level <= low);
            let passed = levels.get(first..).unwrap_or_default();
            let count = passed.partition_point(|level| *level <= high);
            if count > 0 && corners.into_iter().all(f64::is_finite) {
                for (level, links) in passed.iter().zip(links.iter_mut().skip(first)).take(count) {
                    links.cross(corners, *level, x, y);
                }
            }
        }
    }
    links.into_iter().flat_map(Links::joined).collect()
}

/// The points where lines cross the sides of cells, and which are neighbours on a line.
struct Links {
    width: usize,
    height: usize,
    points: FxHashMap<Side, Crossing>,
}

/// Where a line crosses a side.
#[derive(Clone, Copy)]
struct Crossing {
    /// In pixels from the centre of the upper left one.
    point: [f64; 2],
    /// The sides at which the line goes on.
    next: [Option<Side>; 2],
}

impl Links {
    fn new(values: &Raster<f64>) -> Self {
        Self {
            width: values.width,
            height: values.height,
            points: FxHashMap::default(),
        }
    }

    /// Adds the lines through the cell whose upper left corner is the pixel at `x`, `y`; its corners clockwise from there.
    fn cross(&mut self, [a, b, c, d]: [f64; 4], level: f64, x: usize, y: usize) {
        let is_above = [a, b, c, d].map(|v| v >= level);
        // The sides between the corners, clockwise from above.
        let (across, down) = (|x, y| y * self.width + x, self.width * self.height);
        let [top, right, bottom, left] = [
            across(x, y),
            down + across(x + 1, y),
            across(x, y + 1),
            down + across(x, y),
        ];
        let part = |from: f64, to: f64| (level - from) / (to - from);
        let (x, y) = (x as f64, y as f64);
        let points = [
            (top, [x + part(a, b), y]),
            (right, [x + 1.0, y + part(b, c)]),
            (bottom, [x + part(d, c), y + 1.0]),
            (left, [x, y + part(a, d)]),
        ];
        let is_centre_above = (a + b + c + d) * 0.25 >= level;
        let [top, right, bottom, left] = points;
        let mut link = |p, q| self.link(p, q);
        match is_above {
            [true, true, true, true] | [false, false, false, false] => {}
            [true, false, false, false] | [false, true, true, true] => link(left, top),
            [false, true, false, false] | [true, false, true, true] => link(top, right),
            [false, false, true, false] | [true, true, false, true] => link(right, bottom),
            [false, false, false, true] | [true, true, true, false] => link(bottom, left),
            [true, true, false, false] | [false, false, true, true] => link(left, right),
            [true, false, false, true] | [false, true, true, false] => link(top, bottom),
            // A saddle: the corners on the centre's side are joined, the other two are cut off.
            [is_first_above, ..] if is_first_above == is_centre_above => {
                link(top, right);
                link(bottom, left);
            }
            _ => {
                link(left, top);
                link(right, bottom);
            }
        }
    }

    fn link(&mut self, (a, at_a): (Side, [f64; 2]), (b, at_b): (Side, [f64; 2])) {
        for (side, point, other) in [(a, at_a, b), (b, at_b, a)] {
            let next = [None; 2];
            let crossing = self.points.entry(side).or_insert(Crossing { point, next });
            if let Some(free) = crossing.next.iter_mut().find(|next| next.is_none()) {
                *free = Some(other);
            }
        }
    }

    /// The lines, point by point: those with ends first, then those without.
    fn joined(mut self) -> Vec<Vec<[f64; 2]>> {
        let mut lines = Vec::new();
        let mut sides: Vec<Side> = self.points.keys().copied().collect();
        sides.sort_unstable();
        for wants_end in [true, false] {
            for &side in &sides {
                let at = self.points.get(&side);
                let is_start = at.is_some_and(|at| at.next.contains(&None) == wants_end);
                if is_start {
                    lines.push(self.taken(side, !wants_end));
                }
            }
        }
        lines
    }

    /// Takes the line that begins at `start` out of the points.
    fn taken(&mut self, start: Side, is_closed: bool) -> Vec<[f64; 2]> {
        let scale = [1.0 / self.width as f64, 1.0 / self.height as f64];
        let mut line = Vec::new();
        let mut next = Some(start);
        while let Some(at) = next.and_then(|side| self.points.remove(&side)) {
            let [x, y] = at.point;
            line.push([(x + 0.5) * scale[0], (y + 0.5) * scale[1]]);
            let is_left = |side: &Side| self.points.contains_key(side);
            next = at.next.into_iter().flatten().find(is_left);
        }
        if is_closed {
            line.extend(line.first().copied());
        }
        line
    }
}

/// The most levels that [`levels`] gives.
const MAX_LEVELS: f64 = 10.0;

/// Round numbers between `min` and `max`, at most ten or so: 1, 2 or 5 times a power of ten apart, or, where
/// `is_logarithmic`, one, two or five to the decade, or some decades apart. None where there is nothing between.
#[must_use]
pub fn levels(min: f64, max: f64, is_logarithmic: bool) -> Vec<f64> {
    let is_range = min.is_finite() && max.is_finite() && min < max;
    if !is_range || (is_logarithmic && min <= 0.0) {
        return Vec::new();
    }
    let between = |level: &f64| *level > min && *level < max;
    if !is_logarithmic {
        let step = round_step((max - min) / MAX_LEVELS);
        let (first, last) = ((min / step).floor() as i64, (max / step).ceil() as i64);
        return (first..=last)
            .map(|n| n as f64 * step)
            .filter(between)
            .collect();
    }
    let decades = (max / min).log10();
    let (first, last) = (min.log10().floor() as i32, max.log10().ceil() as i32);
    let every = (decades / MAX_LEVELS).ceil() as i32;
    let factors: &[f64] = if decades > 6.0 {
        &[1.0]
    } else if decades > 3.0 {
        &[1.0, 3.0]
    } else {
        &[1.0, 2.0, 5.0]
    };
    (first..=last)
        .filter(|power| power.rem_euclid(every.max(1)) == 0)
        .flat_map(|power| {
            factors
                .iter()
                .map(move |factor| factor * power_of_ten(power))
        })
        .filter(between)
        .collect()
}

/// The smallest of 1, 2 and 5 times a power of ten that is at least `least`.
fn round_step(least: f64) -> f64 {
    let power = least.log10().floor() as i32;
    let candidates = [1.0, 2.0, 5.0].map(|factor| factor * power_of_ten(power));
    let found = candidates.into_iter().find(|step| *step >= least);
    found.unwrap_or_else(|| power_of_ten(power + 1))
}

/// 10 to the `power`, to the last bit: a negative power by division.
fn power_of_ten(power: i32) -> f64 {
    if power < 0 {
        1.0 / 10.0_f64.powi(-power)
    } else {
        10.0_f64.powi(power)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The raster of `f` over -1..1 in x and y, y up.
    fn raster(size: usize, f: impl Fn(f64, f64) -> f64 + Sync) -> Raster<f64> {
        let place = |index: usize| 2.0 * (index as f64 + 0.5) / size as f64 - 1.0;
        let row = |y| (0..size).map(|x| f(place(x), -place(y))).collect();
        Raster::rows_while(size, size, &|| true, row).unwrap()
    }

    #[test]
    fn a_circle_is_one_closed_line() {
        let lines = lines(&raster(64, |x, y| x * x + y * y), &[0.25]);
        assert_eq!(lines.len(), 1);
        let line = &lines[0];
        assert_eq!(line.first(), line.last());
        let mut length = 0.0;
        for pair in line.windows(2) {
            let [x, y] = pair[0].map(|t| 2.0 * t - 1.0);
            // A chord of a parabola over a pixel of 1/32 is off by 1/32^2/4 in value, over a slope of 1.
            assert!((x.hypot(y) - 0.5).abs() < 3e-4, "{x} {y}");
            length += 2.0 * (pair[1][0] - pair[0][0]).hypot(pair[1][1] - pair[0][1]);
        }
        assert!((length - std::f64::consts::PI).abs() < 2e-3, "{length}");
    }

    #[test]
    fn an_open_line_ends_at_the_rim_and_gaps_have_none() {
        let slope = |x: f64, y: f64| if x.abs() < 0.2 { f64::NAN } else { y };
        let lines = lines(&raster(20, slope), &[0.01]);
        assert_eq!(lines.len(), 2);
        for line in &lines {
            // 8 columns to either side of the gap, the cells between them 7.
            assert_eq!(line.len(), 8);
            assert!(line.iter().all(|[_, y]| (y - 0.495).abs() < 1e-12));
        }
    }

    #[test]
    fn a_saddle_is_cut_on_the_side_of_its_centre() {
        let saddle = |level| lines(&raster(2, |x, y| 4.0 * x * y), &[level]);
        // Corners 1 and -1; the centre, 0, is above -0.5 with the high corners, which lie upper right and lower left.
        let joined = saddle(-0.5);
        assert_eq!(joined.len(), 2);
        let cuts_corner = |line: &Vec<[f64; 2]>, corner: [f64; 2]| {
            line.iter()
                .all(|[x, y]| (x - corner[0]).abs() + (y - corner[1]).abs() < 0.3)
        };
        for corner in [[0.25, 0.25], [0.75, 0.75]] {
            assert!(joined.iter().any(|line| cuts_corner(line, corner)));
        }
        let cut = saddle(0.5);
        for corner in [[0.75, 0.25], [0.25, 0.75]] {
            assert!(cut.iter().any(|line| cuts_corner(line, corner)));
        }
    }

    #[test]
    fn levels_are_round() {
        assert_eq!(levels(0.0, 1.0, false).len(), 9);
        assert_eq!(levels(-3.0, 7.0, false)[..3], [-2.0, -1.0, 0.0]);
        assert_eq!(
            levels(0.011, 3.0, true),
            [0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0]
        );
        assert_eq!(levels(1e-3, 2e5, true)[..2], [1e-2, 0.1]);
        assert!(levels(1e-30, 1.0, true).len() <= 10);
        assert!(levels(0.0, 1.0, true).is_empty() && levels(2.0, 2.0, false).is_empty());
    }
}
