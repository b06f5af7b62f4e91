//! How a lobe's map bends the unit square: the images of the lines of a regular grid.

use glam::DVec3;
use rayon::prelude::*;

use crate::analysis::{Detail, HeldLobe, IsWanted, Query, Subject};
use bxdf::Lobe;
use bxdf::math::frame::angle_between;

/// The images of a grid of the unit square under the map of one lobe.
#[derive(Clone, Debug)]
pub struct Warp {
    /// The lobe.
    pub lobe: Lobe,
    /// The lines, cut where directions are lost or jump.
    pub lines: Vec<Vec<DVec3>>,
}

/// The query how each lobe's map bends the square, for the held direction in wo's place.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct WarpRequest {
    /// Cells along either side of the square.
    pub cells: usize,
}

impl Query for WarpRequest {
    type Answer = Vec<Warp>;

    fn answer(
        &self,
        subject: &Subject<'_>,
        _: Detail,
        is_wanted: IsWanted<'_>,
    ) -> Option<Vec<Warp>> {
        let held = subject.lobe;
        let warp = |(index, lobe): (usize, &Lobe)| {
            is_wanted().then(|| Warp {
                lobe: *lobe,
                lines: lines(&held, index, self.cells),
            })
        };
        held.lobes().iter().enumerate().map(warp).collect()
    }
}

/// Pieces into which a line is cut to begin with.
const PIECES: usize = 64;

/// Pieces longer than this, in radians, are halved.
const LONGEST: f64 = 0.03;

/// How often a piece may be halved: what then is still long is a jump.
const MAX_HALVINGS: usize = 10;

/// The largest number below 1: maps of the square take numbers in [0, 1).
const LAST: f64 = 1.0 - 0.5 * f64::EPSILON;

/// The images of the lines of a grid of `cells` by `cells` over the unit square, under the map of the lobe at `index` for
/// the held direction in wo's place ([`Lobes::sample_lobe`](bxdf::Lobes::sample_lobe)): first those of equal
/// u\[0\], then those of equal u\[1\], cut where directions are lost or jump.
#[must_use]
pub fn lines(lobe: &HeldLobe<'_>, index: usize, cells: usize) -> Vec<Vec<DVec3>> {
    let lobe = lobe.as_sampled();
    let image = |line: usize| {
        let (is_first, number) = (line <= cells, line % (cells + 1));
        let fixed = (number as f64 / cells.max(1) as f64).min(LAST);
        image(&lobe, index, &|t: f64| {
            let t = t.min(LAST);
            if is_first { [fixed, t] } else { [t, fixed] }
        })
    };
    let lines = (0..2 * (cells + 1)).into_par_iter().map(image);
    lines.collect::<Vec<_>>().into_iter().flatten().collect()
}

/// The image of the line `at` of the square, in pieces.
fn image(
    lobe: &HeldLobe<'_>,
    index: usize,
    at: &(dyn Fn(f64) -> [f64; 2] + Sync),
) -> Vec<Vec<DVec3>> {
    let directions = |places: &[f64]| {
        let u: Vec<[f64; 2]> = places.iter().map(|t| at(*t)).collect();
        lobe.drawn(index, &u).directions
    };
    let places: Vec<f64> = (0..=PIECES).map(|i| i as f64 / PIECES as f64).collect();
    let first = directions(&places);
    let mut points: Vec<(f64, DVec3)> = places.into_iter().zip(first).collect();
    let is_long = |a: DVec3, b: DVec3| {
        (a == DVec3::ZERO) != (b == DVec3::ZERO) || angle_between(a, b) > LONGEST
    };
    for _ in 0..MAX_HALVINGS {
        let long = points.windows(2).filter_map(|pair| match pair {
            [(t, a), (next, b)] if is_long(*a, *b) => Some(f64::midpoint(*t, *next)),
            _ => None,
        });
        let middles: Vec<f64> = long.collect();
        if middles.is_empty() {
            break;
        }
        let added = directions(&middles);
        points.extend(middles.into_iter().zip(added));
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
    }
    let mut pieces: Vec<Vec<DVec3>> = Vec::new();
    let mut last = DVec3::ZERO;
    for (_, direction) in points {
        if direction == DVec3::ZERO {
            last = direction;
            continue;
        }
        match pieces.last_mut() {
            Some(piece) if last != DVec3::ZERO && !is_long(last, direction) => {
                piece.push(direction);
            }
            _ => pieces.push(vec![direction]),
        }
        last = direction;
    }
    pieces.retain(|piece| piece.len() > 1);
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::Hold;
    use bxdf::Material;
    use bxdf::math::frame::{direction_from_degrees, theta};

    fn lines_of(material: &str, theta_deg: f64, cells: usize) -> Vec<Vec<DVec3>> {
        let model = material.parse::<Material>().unwrap().build();
        let held = direction_from_degrees(theta_deg, 0.0);
        lines(&HeldLobe::new(&*model, Hold::Light, held), 0, cells)
    }

    #[test]
    fn the_square_of_a_diffuse_lobe_becomes_circles_and_meridians() {
        let lines = lines_of("lambertian_reflection", 30.0, 4);
        // sin^2 theta of 0, a quarter, a half, three quarters, and the rim; five meridians, the first twice.
        assert_eq!(lines.len(), 10);
        for (line, square) in lines.iter().zip([0.0, 0.25, 0.5, 0.75, 1.0]) {
            for w in line {
                assert!(
                    (theta(*w).sin().powi(2) - square).abs() < 1e-12,
                    "{w} {square}"
                );
            }
        }
        for line in &lines[5..] {
            assert!(line.windows(2).all(|pair| theta(pair[0]) < theta(pair[1])));
        }
    }

    #[test]
    fn lines_end_where_directions_are_lost() {
        // At grazing incidence part of a rough lobe's half vectors mirror below the horizon.
        let lines = lines_of("rough_conductor:alpha=0.8", 80.0, 8);
        for line in &lines {
            assert!(
                line.iter()
                    .all(|w| w.z > 0.0 && (w.length() - 1.0).abs() < 1e-9)
            );
            for pair in line.windows(2) {
                assert!(angle_between(pair[0], pair[1]) <= LONGEST);
            }
        }
        let lowest = lines.iter().flatten().map(|w| w.z).fold(1.0, f64::min);
        assert!(lowest < 1e-2, "{lowest}");
    }

    #[test]
    fn each_lobe_has_a_grid_of_its_own() {
        let material: Material = "plastic".parse().unwrap();
        let model = material.build();
        let subject = Subject::of(HeldLobe::new(&*model, Hold::Light, DVec3::Z));
        let request = WarpRequest { cells: 4 };
        let warps = request.answer(&subject, Detail::Full, &|| true).unwrap();
        assert_eq!(warps.len(), subject.lobe.lobes().len());
        assert!(warps.iter().all(|warp| !warp.lines.is_empty()));
        assert!(request.answer(&subject, Detail::Full, &|| false).is_none());
    }
}
