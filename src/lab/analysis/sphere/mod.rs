//! The lit sphere's data: linear radiance of a sphere seen from far away.
//!
//! The viewer stands along +z of the picture, x to the right, y up. At each point n is the sphere's normal, s runs along
//! its circle of latitude, t towards its upper pole. The material is opaque to the sphere's shape: light reaches every
//! point from all around, also from below its surface, and nothing casts a shadow on anything.

mod dome;
mod pair;
pub(super) mod scene;

use glam::DVec3;
use serde::{Deserialize, Serialize};

use super::{Basis, Detail, IsWanted, Pace, Query, Raster, Subject};
use bxdf::batch::Columns;
use bxdf::math::frame::direction_from_degrees;

use dome::Dome;
pub use pair::{Normal, glint, normal_of, pair_at, viewer_of};
use scene::{Frame, Scene};

/// What the sphere is lit by.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Light {
    /// Light of one direction, with the irradiance pi on a surface that faces it: there a white diffuse surface has the
    /// radiance 1. Dirac deltas show nothing of it, as no point mirrors exactly that direction to the viewer.
    #[default]
    Directional,
    /// Radiance 1 from everywhere, below the surface as well: the picture shows `rho_hd` for the viewer's direction.
    Dome,
    /// A sky, bright above and dark below, with a soft sun of 9 degrees radius; its radiance is n^2 times as high below a
    /// surface with the index n, as inside a body that it has entered.
    Sky,
}

impl Light {
    /// All lights.
    pub const ALL: [Self; 3] = [Self::Directional, Self::Dome, Self::Sky];

    /// The name at the screen.
    #[must_use]
    pub const fn title(self) -> &'static str {
        match self {
            Self::Directional => "Directional light",
            Self::Dome => "Uniform dome",
            Self::Sky => "Sky and sun",
        }
    }

    /// Whether it has a direction.
    #[must_use]
    pub const fn has_direction(self) -> bool {
        !matches!(self, Self::Dome)
    }
}

/// A square picture: linear R, G, B, and the share of the pixel that the sphere covers, 0..1.
pub type Picture = Raster<[f32; 4]>;

/// What a picture shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Request {
    /// What lights the sphere.
    pub light: Light,
    /// Where the directional light or the sun stands, in degrees: the angle from the viewer's axis, and the angle about
    /// it from the right, counter-clockwise.
    pub direction: [f64; 2],
    /// Pixels along either side.
    pub size: usize,
}

impl Request {
    /// The unit vector to the light or sun, in the frame of the picture.
    #[must_use]
    pub fn to_light(&self) -> DVec3 {
        let [theta_deg, phi_deg] = self.direction;
        direction_from_degrees(theta_deg, phi_deg)
    }
}

/// The part of the picture's half width that the sphere takes.
pub const RADIUS: f64 = 0.96;

/// The disc that a sphere takes in a square picture.
#[derive(Clone, Copy, Debug)]
pub(super) struct Disc {
    /// Pixels along either side.
    pub side: usize,
}

impl Disc {
    /// The normal seen in a pixel, and the share of the pixel that is covered; `None` where none is.
    pub(super) fn pixel(self, column: usize, row: usize) -> Option<(DVec3, f64)> {
        let place = |index: usize| (2.0 * (index as f64 + 0.5) / self.side as f64 - 1.0) / RADIUS;
        let pixel_width = 2.0 / (RADIUS * self.side as f64);
        let (x, y) = (place(column), -place(row));
        let radius = x.hypot(y);
        let coverage = (0.5 + (1.0 - radius) / pixel_width).clamp(0.0, 1.0);
        if coverage == 0.0 {
            return None;
        }
        // A pixel on the edge shows what is just inside.
        let inward = (1.0 - 0.5 * pixel_width).min(radius) / radius.max(f64::MIN_POSITIVE);
        let (x, y) = (x * inward, y * inward);
        let normal = DVec3::new(x, y, (1.0 - x * x - y * y).max(0.0).sqrt());
        Some((normal, coverage))
    }
}

/// The coarse picture has a third of the pixels along either side.
const COARSER: usize = 3;

/// Directions of the sun and of each lobe that a point of the sphere under the sky looks at.
const SKY_SAMPLES: [usize; 2] = [16, 40];
const COARSE_SKY_SAMPLES: [usize; 2] = [6, 12];

impl Query for Request {
    type Answer = Picture;

    const BASIS: Basis = Basis::Surface;

    const PACE: Pace = Pace::CoarseFirst;

    fn answer(
        &self,
        subject: &Subject<'_>,
        detail: Detail,
        is_wanted: IsWanted<'_>,
    ) -> Option<Picture> {
        let bxdf = subject.lobe.surface();
        let (side, samples) = match detail {
            Detail::Coarse => (self.size.div_ceil(COARSER), COARSE_SKY_SAMPLES),
            Detail::Full => (self.size, SKY_SAMPLES),
        };
        let picture = |radiance: &(dyn Fn(&[DVec3]) -> Vec<[f64; 3]> + Sync)| {
            picture(side, is_wanted, radiance)
        };
        match self.light {
            Light::Directional => {
                let light = self.to_light();
                picture(&|normals| directional(subject, light, normals))
            }
            Light::Dome => {
                let dome = Dome::new(bxdf, detail, is_wanted)?;
                let radiance = |n: &DVec3| dome.radiance(Frame::at(*n).local(DVec3::Z).into());
                picture(&|normals| normals.iter().map(radiance).collect())
            }
            Light::Sky => {
                let scene = Scene::new(bxdf, subject.relative_index(), self.to_light(), samples);
                picture(&|normals| normals.iter().map(|n| scene.radiance(*n)).collect())
            }
        }
    }
}

/// The picture of a sphere whose points have this radiance, asked for row by row.
fn picture(
    side: usize,
    is_wanted: IsWanted<'_>,
    radiance: &(dyn Fn(&[DVec3]) -> Vec<[f64; 3]> + Sync),
) -> Option<Picture> {
    let disc = Disc { side };
    Raster::rows_while(side, side, is_wanted, |row| {
        let pixels: Vec<_> = (0..side).map(|column| disc.pixel(column, row)).collect();
        let normals: Vec<DVec3> = pixels.iter().flatten().map(|(n, _)| *n).collect();
        let mut values = radiance(&normals).into_iter();
        let shown = |pixel: Option<(DVec3, f64)>| {
            let (_, coverage) = pixel?;
            let [r, g, b] = values.next()?;
            Some([r, g, b, coverage].map(|x| x as f32))
        };
        let row = pixels.into_iter().map(shown);
        row.map(Option::unwrap_or_default).collect()
    })
}

/// The irradiance of the directional light on a surface that faces it.
const IRRADIANCE: f64 = std::f64::consts::PI;

/// The radiance where the normals are `normals`, under a directional light towards `light`.
fn directional(subject: &Subject<'_>, light: DVec3, normals: &[DVec3]) -> Vec<[f64; 3]> {
    let pairs = normals.iter().map(|n| {
        let frame = Frame::at(*n);
        let (wo, wi) = (frame.local(DVec3::Z), frame.local(light));
        (DVec3::from(wo), DVec3::from(wi))
    });
    let (wo, wi): (Vec<DVec3>, Vec<DVec3>) = pairs.unzip();
    let wi = Columns::directions(wi);
    let f = subject.lobe.surface().values(&Columns::directions(wo), &wi);
    let [_, _, cosines] = wi.slices();
    let values = f.rows().zip(cosines);
    values
        .map(|(f, cos)| f.map(|f| f * cos.abs() * IRRADIANCE))
        .collect()
}

#[cfg(test)]
mod tests;
