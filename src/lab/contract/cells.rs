//! Partitions of the sphere that follow its lobes: cells of about equal probability, and integrals over each.
//!
//! A narrow lobe is a smooth bump in the slopes of its half vector, wherever it points; a solid-angle grid would miss it.
//! Each hemisphere therefore has a chart in which the lobe is smooth, cut at the medians of pilot samples.

use glam::DVec3;

use super::chart::{Chart, median};
use super::families::Family;
use crate::analysis::statistics::Random;
use crate::bxdf::math::quadrature::gauss_legendre;
use crate::lab::subject::Subject;

/// A cell is cut while each half keeps at least this many pilot samples.
const PILOTS_PER_CELL: usize = 32;

/// Gauss-Legendre nodes along each axis of a cell.
const NODES: usize = 6;

/// Quarterings of a cell at most: 2^-10 of its width, far below any feature that is left after the cuts.
const MAX_DEPTH: u32 = 10;

/// The errors of adaptive integrals are estimates: where a kink crosses a cell they fall short, by up to 2.7 as seen (a
/// blade of `ward`, 89.9 degrees). A law allows this many times the estimate.
pub(super) const ESTIMATE: f64 = 3.0;

/// The number of integrands: `pdf`, and f |cos| of three channels both ways.
pub(super) const CHANNELS: usize = 7;

/// The integrals of all channels over a cell.
pub(super) type Channels = [f64; CHANNELS];

#[derive(Clone, Copy)]
struct Rectangle {
    x: [f64; 2],
    y: [f64; 2],
}

/// Width of a cell, in units of the chart's coordinates, beyond which the rule and its refinement may agree by chance: a
/// lobe or its tail bends within about one unit, and six nodes see that in four.
const WIDE: f64 = 4.0;

impl Rectangle {
    fn is_wide(self) -> bool {
        [self.x, self.y]
            .into_iter()
            .any(|[low, high]| high - low > WIDE)
    }

    fn quarters(self) -> [Self; 4] {
        let ([x0, x1], [y0, y1]) = (self.x, self.y);
        let (x, y) = (f64::midpoint(x0, x1), f64::midpoint(y0, y1));
        [
            Self {
                x: [x0, x],
                y: [y0, y],
            },
            Self {
                x: [x, x1],
                y: [y0, y],
            },
            Self {
                x: [x0, x],
                y: [y, y1],
            },
            Self {
                x: [x, x1],
                y: [y, y1],
            },
        ]
    }
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

struct Hemisphere {
    family: Family,
    /// The sign of z.
    sign: f64,
    chart: Chart,
    root: Node,
    cells: Vec<Rectangle>,
    /// The number of the first cell.
    first: usize,
}

/// The sphere cut into cells for each family of lobes, upper hemisphere first.
pub(super) struct Partition<'a> {
    subject: &'a Subject,
    wo: DVec3,
    hemispheres: Vec<Hemisphere>,
    rule: Vec<(f64, f64)>,
}

/// The integrals over a cell and the estimated error of the worst.
#[derive(Clone, Copy, Debug)]
pub(super) struct CellIntegral {
    pub(super) value: Channels,
    pub(super) error: f64,
}

impl CellIntegral {
    const EMPTY: Self = Self {
        value: [0.0; CHANNELS],
        error: 0.0,
    };

    /// The integrals over all these cells, and the sum of their errors.
    pub(super) fn sum(parts: &[Self]) -> Self {
        parts.iter().fold(Self::EMPTY, |sum, part| sum.plus(*part))
    }

    fn plus(self, other: Self) -> Self {
        Self {
            value: add(self.value, other.value),
            error: self.error + other.error,
        }
    }
}

impl<'a> Partition<'a> {
    /// The partition that follows the samples `pilots` of `subject` at `wo`.
    pub(super) fn new(
        subject: &'a Subject,
        wo: DVec3,
        pilots: &[DVec3],
        random: &mut Random,
    ) -> Self {
        let own: Vec<(Family, DVec3)> = pilots
            .iter()
            .map(|w| (Family::drawn(subject, wo, *w, random), *w))
            .collect();
        let mut hemispheres = Vec::new();
        let mut first = 0;
        for &family in Family::of(subject) {
            for sign in [1.0, -1.0] {
                let inside: Vec<DVec3> = own
                    .iter()
                    .filter(|(owner, w)| *owner == family && w.z * sign > 0.0)
                    .map(|(_, w)| *w)
                    .collect();
                let chart = Chart::new(subject, wo, sign, family.is_back(subject), &inside);
                let hemisphere = Hemisphere::new(family, sign, chart, &inside, first);
                first += hemisphere.cells.len();
                hemispheres.push(hemisphere);
            }
        }
        Self {
            subject,
            wo,
            hemispheres,
            rule: gauss_legendre(NODES),
        }
    }

    /// The number of the cell that contains `wi`, for a family drawn with the shares they have of it.
    pub(super) fn cell_of(&self, wi: DVec3, random: &mut Random) -> Option<usize> {
        let family = Family::drawn(self.subject, self.wo, wi, random);
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

    /// The integrals of `f` over solid angle in every cell, as far as they are its family's, each refined until its error
    /// is estimated at `tolerance`.
    pub(super) fn integrate(
        &self,
        f: impl Fn(DVec3) -> Channels,
        tolerance: f64,
    ) -> Vec<CellIntegral> {
        let mut integrals = Vec::new();
        for hemisphere in &self.hemispheres {
            let integrand = |at: [f64; 2]| {
                let (wi, density) = hemisphere.chart.direction(at);
                let share = hemisphere.family.share(self.subject, self.wo, wi);
                f(wi).map(|x| x * (share * density))
            };
            for &cell in &hemisphere.cells {
                let coarse = self.product_rule(&hemisphere.chart, cell, &integrand);
                integrals.push(self.refined(
                    &hemisphere.chart,
                    cell,
                    coarse,
                    &integrand,
                    (tolerance, MAX_DEPTH),
                ));
            }
        }
        integrals
    }

    fn refined(
        &self,
        chart: &Chart,
        cell: Rectangle,
        coarse: Channels,
        f: &impl Fn([f64; 2]) -> Channels,
        (tolerance, depth): (f64, u32),
    ) -> CellIntegral {
        // Rows are clipped to the hemisphere: a cell that reaches beyond it would be halved where nothing is, and its rule
        // would agree with itself.
        let [low, high] = chart.widest_x_range_within(cell.y);
        let [x0, x1] = cell.x;
        let clipped = Rectangle {
            x: [x0.max(low), x1.min(high)],
            ..cell
        };
        let quarters = clipped
            .quarters()
            .map(|quarter| (quarter, self.product_rule(chart, quarter, f)));
        let fine = quarters
            .iter()
            .fold([0.0; CHANNELS], |sum, (_, value)| add(sum, *value));
        let difference = fine
            .iter()
            .zip(coarse)
            .map(|(a, b)| (a - b).abs())
            .fold(0.0, f64::max);
        // A NaN would make the comparison false for ever: it ends the refinement and shows in the sum.
        let is_settled =
            (difference <= tolerance && !clipped.is_wide()) || fine.iter().any(|x| !x.is_finite());
        if is_settled || depth == 0 {
            return CellIntegral {
                value: fine,
                error: difference,
            };
        }
        let parts = quarters
            .map(|(quarter, value)| self.refined(chart, quarter, value, f, (tolerance, depth - 1)));
        CellIntegral::sum(&parts)
    }

    fn product_rule(
        &self,
        chart: &Chart,
        cell: Rectangle,
        f: &impl Fn([f64; 2]) -> Channels,
    ) -> Channels {
        let mut sum = [0.0; CHANNELS];
        let [y_middle, y_half] = middle_and_half(cell.y);
        for &(node_y, weight_y) in &self.rule {
            let y = y_middle + y_half * node_y;
            let [low, high] = chart.x_range(y);
            let [x0, x1] = cell.x;
            let x = [x0.max(low), x1.min(high)];
            let [x_middle, x_half] = middle_and_half(x);
            if x_half > 0.0 {
                for &(node_x, weight_x) in &self.rule {
                    let weight = weight_x * weight_y * x_half * y_half;
                    sum = add(sum, f([x_middle + x_half * node_x, y]).map(|v| v * weight));
                }
            }
        }
        sum
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

fn add(mut a: Channels, b: Channels) -> Channels {
    a.iter_mut().zip(b).for_each(|(a, b)| *a += b);
    a
}

fn middle_and_half([a, b]: [f64; 2]) -> [f64; 2] {
    [f64::midpoint(a, b), 0.5 * (b - a)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bxdf::Material;
    use crate::bxdf::math::frame::direction_from_degrees;

    /// The integral of a material's density at 85 degrees.
    fn density_integral(material: &str) -> CellIntegral {
        let material: Material = material.parse().unwrap();
        let subject = Subject::of_material(&material);
        let wo = direction_from_degrees(85.0, -75.0);
        let mut random = Random::new(7);
        let pilots: Vec<DVec3> = (0..2048)
            .filter_map(|_| {
                let sample = subject
                    .double
                    .sample_f(wo.into(), random.unit(), random.pair());
                Some(sample?.wi.into())
            })
            .collect();
        let partition = Partition::new(&subject, wo, &pilots, &mut random);
        let density = |wi: DVec3| [subject.double.pdf(wo.into(), wi.into()); CHANNELS];
        CellIntegral::sum(&partition.integrate(density, 1e-6))
    }

    #[test]
    fn the_outermost_cells_are_refined_where_the_hemisphere_cuts_them() {
        // The horizon is 4.4 widths away: 3e-10 of the half vectors are lost.
        let total = density_integral("cook_torrance:f0=1,m=.01");
        assert!((total.value[0] - 1.0).abs() <= total.error, "{total:?}");
    }

    #[test]
    fn a_needle_within_a_wide_lobe_is_seen() {
        for diffuse in ["1", ".1", ".03"] {
            let total = density_integral(&format!("ward:alpha=.0001,diffuse={diffuse}"));
            assert!(
                (total.value[0] - 1.0).abs() <= total.error,
                "{diffuse}: {total:?}"
            );
            let total = density_integral(&format!("ward:alpha=.0001,specular={diffuse},diffuse=1"));
            assert!(
                (total.value[0] - 1.0).abs() <= total.error,
                "{diffuse}: {total:?}"
            );
        }
    }
}
