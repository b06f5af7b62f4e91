//! Coordinates in which a lobe is a smooth bump, however narrow, wherever it points.

use std::f64::consts::{FRAC_PI_2, PI};

use glam::DVec3;

use super::order::{median, narrow_scale};
use crate::specimen::Specimen;
use bxdf::math::frame;
use bxdf::{Category, Side};

/// Coordinates in which the directions of one hemisphere are cut and integrated.
pub(super) struct Chart {
    shape: Shape,
    /// The given direction, mirrored to above the surface.
    wo: DVec3,
    /// The sign of z in the hemisphere.
    sign: f64,
}

enum Shape {
    /// x = asinh(elevation / scale), y = azimuth. The scale is wo's own elevation: a diffuse lobe seen near the horizon
    /// bends where wi is as low, and a grid of even steps in theta would miss that strip.
    Polar { scale: f64 },
    /// x, y = asinh(slope / scale) of the half vector of `wo` and wi, or of wi mirrored about the normal.
    Half { scale: [f64; 2], is_back: bool },
    /// x, y = asinh((q - centre) / scale) of the stereographic image q = (wi.x, wi.y) / (1 + wi.z), in which the
    /// hemisphere is the unit disc: a refracted lobe is a bump about its centre, and the horizon is smooth.
    Bump { centre: [f64; 2], scale: [f64; 2] },
    /// x, y = asinh(slope / scale) of the normal that refracts `wo` into wi, `e` being the index across: a blade that
    /// bends over the sphere is straight in it. Not every normal does refract; the edge of those that do is ragged.
    Refracted { scale: [f64; 2], e: f64 },
}

/// Slopes within this many times the scale are integrated over: the tail of GGX seen from the horizon, 1 / slope, is
/// then far below the samples' resolution.
const REACH: f64 = 1e7;

/// Scale below which a refracted lobe is too thin to be told from its bend.
const THIN: f64 = 0.03;

impl Chart {
    /// The chart of the hemisphere with this sign of z in which the lobe at `wo`, which may point back, is smooth;
    /// `inside`: samples in it.
    pub(super) fn new(
        specimen: &Specimen,
        wo: DVec3,
        sign: f64,
        is_back: bool,
        inside: &[DVec3],
    ) -> Self {
        let above = |w: DVec3| DVec3::new(w.x, w.y, w.z.abs());
        let is_near = wo.z * sign > 0.0;
        let is_lobed = specimen.has_side(Side::Reflection)
            && (is_back || specimen.has_category(Category::GlossySpecular));
        let shape = if is_near && is_lobed && !inside.is_empty() {
            let mut all: Vec<[f64; 2]> = inside
                .iter()
                .map(|wi| slopes(above(wo), above(*wi), is_back).map(f64::abs))
                .collect();
            let scale = [true, false].map(|is_x| narrow_scale(&mut all, is_x).max(f64::EPSILON));
            Shape::Half { scale, is_back }
        } else if !is_near && !inside.is_empty() && specimen.has_transmitted_lobe() {
            transmitted(specimen, wo, inside)
        } else {
            Shape::Polar {
                scale: elevation(above(wo)).max(f64::EPSILON),
            }
        };
        Chart {
            shape,
            wo: above(wo),
            sign,
        }
    }

    /// The range of x wide enough for every y; the rows are clipped by [`Row::within`].
    pub(super) fn widest_x_range(&self) -> [f64; 2] {
        match self.shape {
            Shape::Polar { scale } => [0.0, (FRAC_PI_2 / scale).asinh()],
            Shape::Half {
                scale: [scale, _], ..
            } => [-1.0, 1.0].map(|s: f64| ((self.wo.x + s) / self.wo.z / scale).asinh()),
            Shape::Bump {
                centre: [cx, _],
                scale: [sx, _],
            } => [-1.0, 1.0].map(|edge: f64| ((edge - cx) / sx).asinh()),
            Shape::Refracted { .. } => [-REACH.asinh(), REACH.asinh()],
        }
    }

    /// The largest [`Row::x_range`] of all y in this range: that at the y nearest to the middle of the disc.
    pub(super) fn widest_x_range_within(&self, [y0, y1]: [f64; 2]) -> [f64; 2] {
        match self.shape {
            Shape::Polar { .. } | Shape::Refracted { .. } => self.widest_x_range(),
            Shape::Half {
                scale: [_, scale], ..
            } => {
                let middle = (self.wo.y / self.wo.z / scale).asinh();
                self.row(middle.max(y0).min(y1)).x_range()
            }
            Shape::Bump {
                centre: [_, cy],
                scale: [_, sy],
            } => {
                let middle = (-cy / sy).asinh();
                self.row(middle.max(y0).min(y1)).x_range()
            }
        }
    }

    pub(super) fn coordinates(&self, wi: DVec3) -> [f64; 2] {
        let wi = DVec3::new(wi.x, wi.y, wi.z * self.sign);
        match self.shape {
            Shape::Polar { scale } => [(elevation(wi) / scale).asinh(), frame::phi(wi)],
            Shape::Half {
                scale: [sx, sy],
                is_back,
            } => {
                let [x, y] = slopes(self.wo, wi, is_back);
                [(x / sx).asinh(), (y / sy).asinh()]
            }
            Shape::Bump {
                centre: [cx, cy],
                scale: [sx, sy],
            } => {
                let [qx, qy] = stereographic(wi);
                [((qx - cx) / sx).asinh(), ((qy - cy) / sy).asinh()]
            }
            Shape::Refracted { scale: [sx, sy], e } => {
                let [x, y] = refracting_slopes(self.wo, wi, e);
                [(x / sx).asinh(), (y / sy).asinh()]
            }
        }
    }

    /// The range of y.
    pub(super) fn y_range(&self) -> [f64; 2] {
        match self.shape {
            Shape::Polar { .. } => [-PI, PI],
            Shape::Refracted { .. } => [-REACH.asinh(), REACH.asinh()],
            Shape::Half {
                scale: [_, scale], ..
            } => {
                let (centre, radius) = (self.wo.y / self.wo.z, 1.0 / self.wo.z);
                [centre - radius, centre + radius].map(|y| (y / scale).asinh())
            }
            Shape::Bump {
                centre: [_, cy],
                scale: [_, sy],
            } => [-1.0, 1.0].map(|edge: f64| ((edge - cy) / sy).asinh()),
        }
    }

    /// Where along x this coordinate is: a slope, or a place in the disc.
    pub(super) fn place(&self, x: f64) -> f64 {
        match self.shape {
            Shape::Polar { scale } => scaled(scale, x).0,
            Shape::Half { scale: [sx, _], .. } | Shape::Refracted { scale: [sx, _], .. } => {
                scaled(sx, x).0
            }
            Shape::Bump {
                centre: [cx, _],
                scale: [sx, _],
            } => cx + scaled(sx, x).0,
        }
    }

    /// The inverse of [`Self::place`].
    fn coordinate(&self, place: f64) -> f64 {
        match self.shape {
            Shape::Polar { scale } => (place / scale).asinh(),
            Shape::Half { scale: [sx, _], .. } | Shape::Refracted { scale: [sx, _], .. } => {
                (place / sx).asinh()
            }
            Shape::Bump {
                centre: [cx, _],
                scale: [sx, _],
            } => ((place - cx) / sx).asinh(),
        }
    }

    /// The directions at `y`.
    pub(super) fn row(&self, y: f64) -> Row<'_> {
        let across = match self.shape {
            Shape::Polar { .. } => y.sin_cos(),
            Shape::Half {
                scale: [_, scale], ..
            }
            | Shape::Bump {
                scale: [_, scale], ..
            }
            | Shape::Refracted {
                scale: [_, scale], ..
            } => scaled(scale, y),
        };
        Row {
            chart: self,
            across,
        }
    }
}

/// `scale` sinh(x), and its derivative.
fn scaled(scale: f64, x: f64) -> (f64, f64) {
    let sinh = x.sinh();
    (scale * sinh, scale * (1.0 + sinh * sinh).sqrt())
}

/// The directions of a chart at one y.
pub(super) struct Row<'a> {
    chart: &'a Chart,
    /// Sine and cosine of the azimuth; or what [`scaled`] makes of y.
    across: (f64, f64),
}

impl Row<'_> {
    /// The places along x, as of [`Chart::place`], between which the hemisphere lies. In slopes it is the disc of radius 1/cos
    /// about tan(theta) of `wo`: the half vectors' slopes are a stereographic projection of wi.
    fn edges(&self) -> Option<[f64; 2]> {
        let Chart { shape, wo, .. } = self.chart;
        let (across, _) = self.across;
        match *shape {
            Shape::Polar { .. } | Shape::Refracted { .. } => None,
            Shape::Half { .. } => {
                let radius = 1.0 / wo.z;
                let dy = across - wo.y * radius;
                let reach = ((radius - dy) * (radius + dy)).max(0.0).sqrt();
                let centre = wo.x * radius;
                Some([centre - reach, centre + reach])
            }
            Shape::Bump {
                centre: [_, cy], ..
            } => {
                let qy = cy + across;
                let reach = ((1.0 - qy) * (1.0 + qy)).max(0.0).sqrt();
                Some([-reach, reach])
            }
        }
    }

    /// The range of x.
    fn x_range(&self) -> [f64; 2] {
        let edges = self.edges();
        edges.map_or(self.chart.widest_x_range(), |edges| {
            edges.map(|edge| self.chart.coordinate(edge))
        })
    }

    /// The part of the range `x`, whose ends are at these `places`, in which the hemisphere lies.
    pub(super) fn within(&self, [x0, x1]: [f64; 2], [first, last]: [f64; 2]) -> [f64; 2] {
        let Some([low, high]) = self.edges() else {
            let [low, high] = self.chart.widest_x_range();
            return [x0.max(low), x1.min(high)];
        };
        // Most rows need not be clipped, and no logarithm.
        let from = if first >= low {
            x0
        } else {
            self.chart.coordinate(low)
        };
        let to = if last <= high {
            x1
        } else {
            self.chart.coordinate(high)
        };
        [from, to]
    }

    /// The direction at `x`, and the solid angle per unit of the coordinates' area.
    pub(super) fn direction(&self, x: f64) -> (DVec3, f64) {
        let (wo, sign) = (self.chart.wo, self.chart.sign);
        let (across, stretch_y) = self.across;
        let (wi, density) = match self.chart.shape {
            Shape::Polar { scale } => {
                let (elevation, stretch) = scaled(scale, x);
                let (z, radius) = elevation.sin_cos();
                let (sin_phi, cos_phi) = self.across;
                let wi = DVec3::new(radius * cos_phi, radius * sin_phi, z);
                (wi, radius * stretch)
            }
            Shape::Half {
                scale: [sx, _],
                is_back,
            } => {
                let (along, stretch_x) = scaled(sx, x);
                let hz = 1.0 / (1.0 + along * along + across * across).sqrt();
                let wh = DVec3::new(along * hz, across * hz, hz);
                let cos_d = wo.dot(wh);
                let mut wi = wh * (2.0 * cos_d) - wo;
                if is_back {
                    wi = DVec3::new(-wi.x, -wi.y, wi.z);
                }
                // dwi = 4 cos_d dwh, dwh = hz^3 per unit of slope area.
                (wi, 4.0 * cos_d * hz * hz * hz * (stretch_x * stretch_y))
            }
            Shape::Bump {
                centre: [cx, cy],
                scale: [sx, _],
            } => {
                let (along, stretch_x) = scaled(sx, x);
                let (qx, qy) = (cx + along, cy + across);
                let r2 = qx * qx + qy * qy;
                let wi = DVec3::new(2.0 * qx, 2.0 * qy, 1.0 - r2) / (1.0 + r2);
                // dwi = 4 dq / (1 + q^2)^2.
                let per_area = 4.0 / ((1.0 + r2) * (1.0 + r2));
                (wi, per_area * (stretch_x * stretch_y))
            }
            Shape::Refracted { scale: [sx, _], e } => {
                let (along, stretch_x) = scaled(sx, x);
                let (wi, density) = refracted(wo, [along, across], e);
                (wi, density * (stretch_x * stretch_y))
            }
        };
        (DVec3::new(wi.x, wi.y, wi.z * sign), density)
    }
}

/// The angle of `w`, above the surface, from the horizon.
fn elevation(w: DVec3) -> f64 {
    w.z.atan2(w.x.hypot(w.y))
}

/// The image of `w`, above the surface, on the plane of the equator seen from the nadir.
fn stereographic(w: DVec3) -> [f64; 2] {
    [w.x / (1.0 + w.z), w.y / (1.0 + w.z)]
}

/// The slopes of the normal that refracts `wo`, above the surface, into (wi.x, wi.y, -wi.z).
fn refracting_slopes(wo: DVec3, wi: DVec3, e: f64) -> [f64; 2] {
    let g = wo + e * DVec3::new(wi.x, wi.y, -wi.z);
    [g.x / g.z, g.y / g.z]
}

/// Where the normal of these slopes refracts `wo`, mirrored to above the surface, and the solid angle per area of
/// slopes: 0 for a normal that does not refract it to the other side.
fn refracted(wo: DVec3, [x, y]: [f64; 2], e: f64) -> (DVec3, f64) {
    let hz = 1.0 / (1.0 + x * x + y * y).sqrt();
    let wh = DVec3::new(x * hz, y * hz, hz);
    let cos_o = wo.dot(wh);
    let tangent = wo - wh * cos_o;
    let cos2_i = 1.0 - tangent.length_squared() / (e * e);
    let cos_i = cos2_i.max(0.0).sqrt();
    let wi = -tangent / e - wh * cos_i;
    if cos_o <= 0.0 || cos2_i <= 0.0 || wi.z >= 0.0 {
        return (wo, 0.0);
    }
    // dwi = |g|^2 / (e^2 |wi.h|) dwh, |g| = |wo.h - e |wi.h||, and dwh = hz^3 per area of slopes.
    let g = cos_o - e * cos_i;
    let density = g * g / (e * e * cos_i) * hz * hz * hz;
    (DVec3::new(wi.x, wi.y, -wi.z) / wi.length(), density)
}

/// The chart of a refracted lobe with these samples.
fn transmitted(specimen: &Specimen, wo: DVec3, inside: &[DVec3]) -> Shape {
    let e = specimen.index_at(-wo) / specimen.index_at(wo);
    let above = |w: &DVec3| DVec3::new(w.x, w.y, w.z.abs());
    let mut slopes: Vec<[f64; 2]> = inside
        .iter()
        .map(|wi| refracting_slopes(above(&wo), above(wi), e).map(f64::abs))
        .collect();
    let scale = [true, false].map(|is_x| median(&mut slopes, is_x).max(f64::EPSILON));
    if e != 1.0 && scale.into_iter().any(|s| s < THIN) {
        Shape::Refracted { scale, e }
    } else {
        bump(inside)
    }
}

/// The chart about the median of the samples `inside` one hemisphere, as wide as they lie.
fn bump(inside: &[DVec3]) -> Shape {
    let mut images: Vec<[f64; 2]> = inside
        .iter()
        .map(|w| stereographic(DVec3::new(w.x, w.y, w.z.abs())))
        .collect();
    let centre = [true, false].map(|is_x| median(&mut images, is_x));
    let [cx, cy] = centre;
    let mut distances: Vec<[f64; 2]> = images
        .iter()
        .map(|[x, y]| [(x - cx).abs(), (y - cy).abs()])
        .collect();
    let scale = [true, false].map(|is_x| median(&mut distances, is_x).max(f64::EPSILON));
    Shape::Bump { centre, scale }
}

/// The slopes of the half vector of `wo` and `wi`, both above the surface.
fn slopes(wo: DVec3, wi: DVec3, is_back: bool) -> [f64; 2] {
    let sum = if is_back {
        wo + DVec3::new(-wi.x, -wi.y, wi.z)
    } else {
        wo + wi
    };
    [sum.x / sum.z, sum.y / sum.z]
}
