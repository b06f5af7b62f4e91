//! Lines on a surface of triangles where a number given at its corners has one value.
//!
//! # Source
//! Marching triangles, as the marching cubes of `lorensen1987` but in a surface: between two corners the number is linear,
//! so that each triangle holds one straight piece, which ends where those of its neighbours begin.

use std::collections::HashMap;

use glam::Vec3;

/// Points of a line that are nearer to one another than this, in world units, are one: less than a pixel of a dome that
/// fills a window, and short pieces of a wide line would point anywhere.
const SPACING: f32 = 4e-3;

/// The edge between two corners, the lower index first.
type Edge = [u32; 2];

/// The lines on which `heights`, corner by corner, are `level`; closed ones end where they begin. `at`: the place on an edge,
/// this part of the way from the first corner to the second.
pub(super) fn lines(
    triangles: &[[u32; 3]],
    heights: &[f64],
    level: f64,
    at: impl Fn(Edge, f32) -> Vec3,
) -> Vec<Vec<Vec3>> {
    let height = |corner: u32| heights.get(corner as usize).copied().unwrap_or(f64::NAN);
    let mut links = Links::default();
    for [a, b, c] in triangles {
        let is_above = [*a, *b, *c].map(|corner| height(corner) >= level);
        let [alone, p, q] = match is_above {
            [x, y, z] if x == y && y == z => continue,
            [x, y, z] if y == z && x != y => [a, b, c],
            [x, y, z] if x == z && y != x => [b, c, a],
            _ => [c, a, b],
        };
        links.link(edge(*alone, *p), edge(*alone, *q));
    }
    let place = |edge: Edge| {
        let [from, to] = edge.map(height);
        at(edge, ((level - from) / (to - from)) as f32)
    };
    let lines = links.joined().into_iter();
    lines
        .map(|line| thinned(line.into_iter().map(place)))
        .filter(|line| line.len() > 1)
        .collect()
}

fn edge(a: u32, b: u32) -> Edge {
    [a.min(b), a.max(b)]
}

/// The points without those that all but coincide with the one before; the last one stays.
fn thinned(points: impl Iterator<Item = Vec3>) -> Vec<Vec3> {
    let mut line: Vec<Vec3> = Vec::new();
    let mut skipped = None;
    for point in points.filter(|point| point.is_finite()) {
        let is_near = |last: &Vec3| last.distance(point) < SPACING;
        if line.last().is_some_and(is_near) {
            skipped = Some(point);
        } else {
            line.push(point);
            skipped = None;
        }
    }
    line.extend(skipped);
    line
}

/// Which edges follow one another on a line.
#[derive(Default)]
struct Links(HashMap<Edge, [Option<Edge>; 2]>);

impl Links {
    fn link(&mut self, a: Edge, b: Edge) {
        for (from, to) in [(a, b), (b, a)] {
            let next = self.0.entry(from).or_default();
            if let Some(free) = next.iter_mut().find(|next| next.is_none()) {
                *free = Some(to);
            }
        }
    }

    /// The lines, edge by edge: those with ends first, then those without.
    fn joined(mut self) -> Vec<Vec<Edge>> {
        let mut edges: Vec<Edge> = self.0.keys().copied().collect();
        edges.sort_unstable();
        let mut lines = Vec::new();
        for has_ends in [true, false] {
            for start in &edges {
                let next = self.0.get(start);
                if next.is_some_and(|next| next.contains(&None) == has_ends) {
                    lines.push(self.taken(*start, !has_ends));
                }
            }
        }
        lines
    }

    /// Takes out the line that begins at `start`.
    fn taken(&mut self, start: Edge, is_closed: bool) -> Vec<Edge> {
        let mut line = Vec::new();
        let mut next = Some(start);
        while let Some((edge, following)) = next.and_then(|edge| self.0.remove_entry(&edge)) {
            line.push(edge);
            let is_left = |edge: &Edge| self.0.contains_key(edge);
            next = following.into_iter().flatten().find(is_left);
        }
        if is_closed {
            line.extend(line.first().copied());
        }
        line
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A pyramid of four sides about the origin, its corners 1 from the axis and its top 1 above it.
    fn pyramid() -> (Vec<[u32; 3]>, [Vec3; 5]) {
        let corners = [Vec3::Z, Vec3::X, Vec3::Y, Vec3::NEG_X, Vec3::NEG_Y];
        (vec![[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1]], corners)
    }

    fn of(heights: [f64; 5], level: f64) -> Vec<Vec<Vec3>> {
        let (triangles, corners) = pyramid();
        let at = |[a, b]: Edge, part| corners[a as usize].lerp(corners[b as usize], part);
        lines(&triangles, &heights, level, at)
    }

    #[test]
    fn a_line_about_the_top_is_closed_and_level() {
        let lines = of([1.0, 0.0, 0.0, 0.0, 0.0], 0.25);
        let [line] = &lines[..] else {
            panic!("{lines:?}");
        };
        assert_eq!((line.len(), line.first()), (5, line.last()));
        assert!(line.iter().all(|point| (point.z - 0.25).abs() < 1e-6));
        assert!(of([1.0, 0.0, 0.0, 0.0, 0.0], 1.5).is_empty());
    }

    #[test]
    fn a_line_that_leaves_the_surface_has_ends() {
        // The plane x = 0.5.
        let lines = of([0.0, 1.0, 0.0, -1.0, 0.0], 0.5);
        let [line] = &lines[..] else {
            panic!("{lines:?}");
        };
        assert_eq!(line.len(), 3);
        assert!(line.iter().all(|point| (point.x - 0.5).abs() < 1e-6));
        assert!(line[0].z.abs() < 1e-6 && line[2].z.abs() < 1e-6);
    }

    #[test]
    fn a_line_along_edges_is_drawn_once() {
        // The plane y = 0, in which three corners lie.
        let lines = of([0.0, 0.0, 1.0, 0.0, -1.0], 0.0);
        let [line] = &lines[..] else {
            panic!("{lines:?}");
        };
        let length: f32 = line.windows(2).map(|pair| pair[0].distance(pair[1])).sum();
        assert!((length - 2.0 * 2.0_f32.sqrt()).abs() < 1e-6, "{line:?}");
    }
}
