//! Integrals over the cells of a partition, refined until they agree.

use glam::DVec3;

use super::partition::{Hemisphere, Partition, Rectangle};
use bxdf::internals::gauss_legendre;

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

/// Width of a cell, in units of the chart's coordinates, beyond which the rule and its refinement may agree by chance: a
/// lobe or its tail bends within about one unit, and six nodes see that in four.
const WIDE: f64 = 4.0;

impl Rectangle {
    /// Whether it is too wide to be trusted.
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

impl Partition<'_> {
    /// The integrals of `f` over solid angle in every cell, as far as they are its family's, each refined until its error
    /// is estimated at `tolerance`.
    pub(super) fn integrate(
        &self,
        f: impl Fn(DVec3) -> Channels,
        tolerance: f64,
    ) -> Vec<CellIntegral> {
        let rule = gauss_legendre(NODES);
        let mut integrals = Vec::new();
        for hemisphere in &self.hemispheres {
            let integrand = Integrand {
                partition: self,
                hemisphere,
                rule: &rule,
                f: &f,
            };
            let cells = hemisphere.cells.iter();
            integrals.extend(cells.map(|cell| integrand.integral(*cell, tolerance)));
        }
        integrals
    }
}

/// What is integrated over the cells of a hemisphere, and by which rule along each axis.
struct Integrand<'a, F> {
    partition: &'a Partition<'a>,
    hemisphere: &'a Hemisphere,
    rule: &'a [(f64, f64)],
    f: &'a F,
}

impl<F: Fn(DVec3) -> Channels> Integrand<'_, F> {
    fn integral(&self, cell: Rectangle, tolerance: f64) -> CellIntegral {
        self.refined(cell, self.product_rule(cell), (tolerance, MAX_DEPTH))
    }

    fn refined(
        &self,
        cell: Rectangle,
        coarse: Channels,
        (tolerance, depth): (f64, u32),
    ) -> CellIntegral {
        // Rows are clipped to the hemisphere: a cell that reaches beyond it would be halved where nothing is, and its rule
        // would agree with itself.
        let [low, high] = self.hemisphere.chart.widest_x_range_within(cell.y);
        let [x0, x1] = cell.x;
        let clipped = Rectangle {
            x: [x0.max(low), x1.min(high)],
            ..cell
        };
        let quarters = clipped.quarters();
        let values = quarters.map(|quarter| self.product_rule(quarter));
        let fine = values.into_iter().fold([0.0; CHANNELS], add);
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
        let parts = quarters.into_iter().zip(values);
        let parts: Vec<CellIntegral> = parts
            .map(|(quarter, value)| self.refined(quarter, value, (tolerance, depth - 1)))
            .collect();
        CellIntegral::sum(&parts)
    }

    fn product_rule(&self, cell: Rectangle) -> Channels {
        let Hemisphere { chart, family, .. } = self.hemisphere;
        let Partition { specimen, wo, .. } = self.partition;
        let mut sum = [0.0; CHANNELS];
        let [y_middle, y_half] = middle_and_half(cell.y);
        let places = cell.x.map(|x| chart.place(x));
        for (node_y, weight_y) in self.rule {
            let row = chart.row(y_middle + y_half * node_y);
            let [x_middle, x_half] = middle_and_half(row.within(cell.x, places));
            if x_half > 0.0 {
                for (node_x, weight_x) in self.rule {
                    let (wi, density) = row.direction(x_middle + x_half * node_x);
                    let share = family.share(specimen, *wo, wi);
                    let weight = weight_x * weight_y * x_half * y_half * (share * density);
                    sum = add(sum, (self.f)(wi).map(|x| x * weight));
                }
            }
        }
        sum
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
    use crate::analysis::statistics::Random;
    use crate::specimen::Specimen;
    use bxdf::Material;
    use bxdf::math::frame::direction_from_degrees;

    /// The integral of a material's density at 85 degrees.
    fn density_integral(material: &str) -> CellIntegral {
        let material: Material = material.parse().unwrap();
        let specimen = Specimen::of_material(&material);
        let wo = direction_from_degrees(85.0, -75.0);
        let mut random = Random::new(7);
        let pilots: Vec<DVec3> = (0..2048)
            .filter_map(|_| {
                let sample = specimen
                    .double
                    .sample_f(wo.into(), random.unit(), random.pair());
                Some(sample?.wi.into())
            })
            .collect();
        let partition = Partition::new(&specimen, wo, &pilots, &mut random);
        let density = |wi: DVec3| [specimen.double.pdf(wo.into(), wi.into()); CHANNELS];
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
