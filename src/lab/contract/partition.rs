//! Partitions of the sphere that follow its lobes: cells of about equal probability.
//!
//! A narrow lobe is a smooth bump in the slopes of its half vector, wherever it points; a solid-angle grid would miss it.
//! Each hemisphere therefore has a chart in which the lobe is smooth, cut at the medians of pilot samples.

use glam::DVec3;

use super::chart::Chart;
use super::needle_partition::Family;
use super::order::median;
use crate::analysis::statistics::Random;
use crate::specimen::Specimen;

/// A cell is cut while each half keeps at least this many pilot samples.
const PILOTS_PER_CELL: usize = 32;

/// A cell: ranges of a chart's coordinates.
#[derive(Clone, Copy)]
pub(super) struct Rectangle {
    pub(super) x: [f64; 2],
    pub(super) y: [f64; 2],
}

/// How a hemisphere is cut into cells.
enum Node {
    /// A cell, by its number.
    Cell(usize),
    /// Two parts, divided where x (or y) is `at`.
    Cut {
        is_x: bool,
        at: f64,
        low: Box<Self>,
        high: Box<Self>,
    },
}

pub(super) struct Hemisphere {
    pub(super) family: Family,
    /// The sign of z.
    sign: f64,
    pub(super) chart: Chart,
    root: Node,
    pub(super) cells: Vec<Rectangle>,
    /// The number of the first cell.
    first: usize,
}

/// The sphere cut into cells for each family of lobes, upper hemisphere first.
pub(super) struct Partition<'a> {
    pub(super) specimen: &'a Specimen,
    pub(super) wo: DVec3,
    pub(super) hemispheres: Vec<Hemisphere>,
}

impl<'a> Partition<'a> {
    /// The partition that follows the samples `pilots` of `specimen` at `wo`.
    pub(super) fn new(
        specimen: &'a Specimen,
        wo: DVec3,
        pilots: &[DVec3],
        random: &mut Random,
    ) -> Self {
        let own: Vec<(Family, DVec3)> = pilots
            .iter()
            .map(|w| (Family::drawn(specimen, wo, *w, random), *w))
            .collect();
        let mut hemispheres = Vec::new();
        let mut first = 0;
        for &family in Family::of(specimen) {
            for sign in [1.0, -1.0] {
                let inside: Vec<DVec3> = own
                    .iter()
                    .filter(|(owner, w)| *owner == family && w.z * sign > 0.0)
                    .map(|(_, w)| *w)
                    .collect();
                let chart = Chart::new(specimen, wo, sign, family.is_back(specimen), &inside);
                let hemisphere = Hemisphere::new(family, sign, chart, &inside, first);
                first += hemisphere.cells.len();
                hemispheres.push(hemisphere);
            }
        }
        Self {
            specimen,
            wo,
            hemispheres,
        }
    }

    /// The number of the cell that contains `wi`, for a family drawn with the shares they have of it.
    pub(super) fn cell_of(&self, wi: DVec3, random: &mut Random) -> Option<usize> {
        let family = Family::drawn(self.specimen, self.wo, wi, random);
        let sign = if wi.z > 0.0 { 1.0 } else { -1.0 };
        let is_it =
            |hemisphere: &&Hemisphere| (hemisphere.family, hemisphere.sign) == (family, sign);
        let hemisphere = self.hemispheres.iter().find(is_it)?;
        let [x, y] = hemisphere.chart.coordinates(wi);
        let mut node = &hemisphere.root;
        loop {
            match node {
                Node::Cell(index) => return Some(hemisphere.first + index),
                Node::Cut {
                    is_x,
                    at,
                    low,
                    high,
                } => {
                    let coordinate = if *is_x { x } else { y };
                    node = if coordinate < *at { low } else { high };
                }
            }
        }
    }
}

impl Hemisphere {
    fn new(family: Family, sign: f64, chart: Chart, inside: &[DVec3], first: usize) -> Self {
        let [x, y] = [chart.widest_x_range(), chart.y_range()];
        let mut points: Vec<[f64; 2]> = inside.iter().map(|w| chart.coordinates(*w)).collect();
        let mut cells = Vec::new();
        let root = cut(&mut points, Rectangle { x, y }, true, &mut cells);
        Self {
            family,
            sign,
            chart,
            root,
            cells,
            first,
        }
    }
}

/// Cuts `cell` at the median of `points`, alternating between x and y.
fn cut(points: &mut [[f64; 2]], cell: Rectangle, is_x: bool, cells: &mut Vec<Rectangle>) -> Node {
    if points.len() < 2 * PILOTS_PER_CELL {
        cells.push(cell);
        return Node::Cell(cells.len() - 1);
    }
    let at = median(points, is_x);
    let ([x0, x1], [y0, y1]) = (cell.x, cell.y);
    let (low, high) = if is_x {
        (
            Rectangle {
                x: [x0, at],
                ..cell
            },
            Rectangle {
                x: [at, x1],
                ..cell
            },
        )
    } else {
        (
            Rectangle {
                y: [y0, at],
                ..cell
            },
            Rectangle {
                y: [at, y1],
                ..cell
            },
        )
    };
    let (points_low, points_high) = points.split_at_mut(points.len() / 2);
    Node::Cut {
        is_x,
        at,
        low: Box::new(cut(points_low, low, !is_x, cells)),
        high: Box::new(cut(points_high, high, !is_x, cells)),
    }
}
