//! Coordinates in which a lobe is a smooth bump, however narrow, wherever it points.

use std::f64::consts::{FRAC_PI_2, PI};

use glam::DVec3;

use super::subject::Subject;
use crate::bxdf::math::frame;
use crate::bxdf::{Category, Side};

/// Coordinates in which the directions of one hemisphere are cut and integrated.
pub(super) struct Chart {
    shape: Shape,
    /// The given direction, mirrored to above the surface.
    wo: DVec3,
    /// The sign of z in the hemisphere.
    sign: f64,
}

enum Shape {
    /// x = theta from the hemisphere's pole, y = azimuth.
    Polar,
    /// x, y = asinh(slope / scale) of the half vector of `wo` and wi, or of wi mirrored about the normal.
    Half { scale: [f64; 2], is_back: bool },
}

impl Chart {
    /// The chart of the hemisphere with this sign of z in which the lobe at `wo` is smooth; `inside`: samples in it.
    pub(super) fn new(subject: &Subject, wo: DVec3, sign: f64, inside: &[DVec3]) -> Self {
        let above = |w: DVec3| DVec3::new(w.x, w.y, w.z.abs());
        let is_back = subject.has_category(Category::RetroReflective);
        let is_near = wo.z * sign > 0.0;
        let is_lobed = subject.has_side(Side::Reflection)
            && (is_back || subject.has_category(Category::GlossySpecular));
        let shape = if is_near && is_lobed && !inside.is_empty() {
            let mut all: Vec<[f64; 2]> = inside
                .iter()
                .map(|wi| slopes(above(wo), above(*wi), is_back).map(f64::abs))
                .collect();
            let scale = [true, false].map(|is_x| median(&mut all, is_x).max(f64::EPSILON));
            Shape::Half { scale, is_back }
        } else {
            Shape::Polar
        };
        Chart {
            shape,
            wo: above(wo),
            sign,
        }
    }

    /// The range of x wide enough for every y; the rows are clipped to [`Self::x_range`].
    pub(super) fn widest_x_range(&self) -> [f64; 2] {
        match self.shape {
            Shape::Polar => [0.0, FRAC_PI_2],
            Shape::Half {
                scale: [scale, _], ..
            } => [-1.0, 1.0].map(|s: f64| ((self.wo.x + s) / self.wo.z / scale).asinh()),
        }
    }

    pub(super) fn coordinates(&self, wi: DVec3) -> [f64; 2] {
        let wi = DVec3::new(wi.x, wi.y, wi.z * self.sign);
        match self.shape {
            Shape::Polar => [frame::theta(wi), frame::phi(wi)],
            Shape::Half {
                scale: [sx, sy],
                is_back,
            } => {
                let [x, y] = slopes(self.wo, wi, is_back);
                [(x / sx).asinh(), (y / sy).asinh()]
            }
        }
    }

    /// The direction at these coordinates, and the solid angle per unit of their area.
    pub(super) fn direction(&self, [x, y]: [f64; 2]) -> (DVec3, f64) {
        let (wi, density) = match self.shape {
            Shape::Polar => {
                let ((sin, cos), (sin_phi, cos_phi)) = (x.sin_cos(), y.sin_cos());
                (DVec3::new(sin * cos_phi, sin * sin_phi, cos), sin)
            }
            Shape::Half {
                scale: [sx, sy],
                is_back,
            } => {
                let (slope_x, slope_y) = (sx * x.sinh(), sy * y.sinh());
                let hz = 1.0 / (1.0 + slope_x * slope_x + slope_y * slope_y).sqrt();
                let wh = DVec3::new(slope_x * hz, slope_y * hz, hz);
                let cos_d = self.wo.dot(wh);
                let mut wi = wh * (2.0 * cos_d) - self.wo;
                if is_back {
                    wi = DVec3::new(-wi.x, -wi.y, wi.z);
                }
                // dwi = 4 cos_d dwh, dwh = hz^3 per unit of slope area.
                let stretch = sx * x.cosh() * sy * y.cosh();
                (wi, 4.0 * cos_d * hz * hz * hz * stretch)
            }
        };
        (DVec3::new(wi.x, wi.y, wi.z * self.sign), density)
    }

    /// The range of y.
    pub(super) fn y_range(&self) -> [f64; 2] {
        match self.shape {
            Shape::Polar => [-PI, PI],
            Shape::Half {
                scale: [_, scale], ..
            } => {
                let (centre, radius) = (self.wo.y / self.wo.z, 1.0 / self.wo.z);
                [centre - radius, centre + radius].map(|y| (y / scale).asinh())
            }
        }
    }

    /// The range of x at `y`. In slopes the hemisphere is the disc of radius 1/cos about tan(theta) of `wo`: the half
    /// vectors' slopes are a stereographic projection of wi.
    pub(super) fn x_range(&self, y: f64) -> [f64; 2] {
        match self.shape {
            Shape::Polar => [0.0, FRAC_PI_2],
            Shape::Half {
                scale: [sx, sy], ..
            } => {
                let radius = 1.0 / self.wo.z;
                let dy = sy * y.sinh() - self.wo.y * radius;
                let reach = ((radius - dy) * (radius + dy)).max(0.0).sqrt();
                let centre = self.wo.x * radius;
                [centre - reach, centre + reach].map(|x| (x / sx).asinh())
            }
        }
    }
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

/// The median of the x or y of `points`, which are left in two halves about it. 0 without points.
pub(super) fn median(points: &mut [[f64; 2]], is_x: bool) -> f64 {
    let key = |[x, y]: &[f64; 2]| if is_x { *x } else { *y };
    if points.is_empty() {
        return 0.0;
    }
    let (_, middle, _) =
        points.select_nth_unstable_by(points.len() / 2, |a, b| key(a).total_cmp(&key(b)));
    key(middle)
}
