//! The integral over the hemisphere as a sum: patches of equal solid angle, each with the integrand at its middle.
//!
//! Equal steps of z and of the azimuth cut the sphere into patches of equal solid angle, by Archimedes' hat-box theorem; the
//! shadow of a patch on the plane of the surface has the area of the patch times the cosine at the middle of its z. So sums
//! of 1 and of the cosine are exact however many patches there are, and what is left of the error is that of f and of the
//! density.

use std::f64::consts::TAU;

use glam::DVec3;
use serde::{Deserialize, Serialize};

use super::{Channel, Detail, HeldLobe, Hold, IsWanted, Query, Subject};
use bxdf::math::frame;
use bxdf::{Lobe, Side};

pub use exact::{Exact, ExactRequest, LobeIntegral, Missed};

mod exact;

/// The least and the largest number of patches on one side of the surface, as powers of 2.
pub const COUNT_LOG2: [u8; 2] = [4, 12];

/// What is summed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Integrand {
    /// 1: the solid angle.
    One,
    /// |cos(theta)|: the projected solid angle, which is the area of the unit disc.
    Cosine,
    /// f |cos(theta)| of the free direction: the reflectance.
    #[default]
    FCos,
    /// The density of the sampler, which draws the free direction for the held one in wo's place, whichever is held: the
    /// probability of a sample.
    Density,
}

impl Integrand {
    /// All integrands.
    pub const ALL: [Self; 4] = [Self::One, Self::Cosine, Self::FCos, Self::Density];

    /// The name at the screen.
    #[must_use]
    pub const fn title(self) -> &'static str {
        match self {
            Self::One => "1",
            Self::Cosine => "cos θ",
            Self::FCos => "f cos θ",
            Self::Density => "Density",
        }
    }

    /// The word for it in files.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::One => "one",
            Self::Cosine => "cos",
            Self::FCos => "f_cos",
            Self::Density => "pdf",
        }
    }

    /// The unit; empty for a number without one.
    #[must_use]
    pub const fn unit(self) -> &'static str {
        match self {
            Self::One | Self::Cosine => "",
            Self::FCos | Self::Density => "1/sr",
        }
    }

    /// Whether it is a property of the surface and the direction held; else of the sphere alone.
    #[must_use]
    pub const fn is_of_surface(self) -> bool {
        matches!(self, Self::FCos | Self::Density)
    }

    /// Its values in the directions `free` of one side.
    fn values(self, lobe: &HeldLobe<'_>, free: &[DVec3], is_upper: bool) -> Vec<[f64; 3]> {
        match self {
            Self::One => vec![[1.0; 3]; free.len()],
            Self::Cosine => free.iter().map(|w| [w.z.abs(); 3]).collect(),
            Self::FCos => times_cosine(lobe.values_or_limits(free, is_upper), free),
            Self::Density => {
                let densities = lobe.densities_or_limits(free, is_upper).into_iter();
                densities.map(|density| [density; 3]).collect()
            }
        }
    }
}

fn times_cosine(values: Vec<[f64; 3]>, free: &[DVec3]) -> Vec<[f64; 3]> {
    let all = values.into_iter().zip(free);
    all.map(|(f, w)| f.map(|f| f * w.z.abs())).collect()
}

/// How one side of the sphere is cut: in equal steps of z from n to the horizon, and of the azimuth from s.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Grid {
    /// The steps of z.
    pub rows: usize,
    /// The steps of the azimuth.
    pub columns: usize,
}

impl Grid {
    /// The grid of 2 to the power of `log2` patches. At 45 degrees they are about as high as they are wide.
    #[must_use]
    pub fn of(log2: u8) -> Self {
        let rows_log2 = log2.saturating_sub(2).div_ceil(2);
        Self {
            rows: 1 << rows_log2,
            columns: 1 << log2.saturating_sub(rows_log2),
        }
    }

    /// How many patches there are on one side.
    #[must_use]
    pub fn count(self) -> usize {
        self.rows * self.columns
    }

    /// The patch at `index` of one side: row by row from n, each by rising azimuth.
    #[must_use]
    pub fn patch(self, index: usize, is_upper: bool) -> Patch {
        let (row, column) = (index / self.columns, index % self.columns);
        let height = |row: usize| 1.0 - row as f64 / self.rows as f64;
        let azimuth = |column: usize| TAU * column as f64 / self.columns as f64;
        Patch {
            is_upper,
            height: [height(row + 1), height(row)],
            phi: [azimuth(column), azimuth(column + 1)],
        }
    }

    /// The patches of one side.
    pub fn patches(self, is_upper: bool) -> impl Iterator<Item = Patch> {
        (0..self.count()).map(move |index| self.patch(index, is_upper))
    }

    /// The index of the patch on its side in which the unit vector `w` lies.
    #[must_use]
    pub fn index_of(self, w: DVec3) -> usize {
        let step = |share: f64, n: usize| ((share * n as f64) as usize).min(n.saturating_sub(1));
        let row = step(1.0 - w.z.abs(), self.rows);
        row * self.columns + step(frame::phi(w).rem_euclid(TAU) / TAU, self.columns)
    }
}

/// A patch of the sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Patch {
    /// Whether it is on the side of n.
    pub is_upper: bool,
    /// |z| of its lower and its upper edge.
    pub height: [f64; 2],
    /// The azimuths between which it lies, in radians, 0..2 pi.
    pub phi: [f64; 2],
}

impl Patch {
    /// The direction at shares of its extents, 0..1: from the edge at the horizon's side, by rising azimuth.
    #[must_use]
    pub fn direction(&self, [u, v]: [f64; 2]) -> DVec3 {
        let within = |[a, b]: [f64; 2], share: f64| a + share * (b - a);
        let (height, phi) = (within(self.height, u), within(self.phi, v));
        let (sin, cos) = phi.sin_cos();
        let radius = ((1.0 - height) * (1.0 + height)).max(0.0).sqrt();
        let z = if self.is_upper { height } else { -height };
        DVec3::new(radius * cos, radius * sin, z)
    }

    /// The direction at the middle of its extents, at which the integrand is taken.
    #[must_use]
    pub fn middle(&self) -> DVec3 {
        self.direction([0.5; 2])
    }

    /// The solid angle, in sr.
    #[must_use]
    pub fn solid_angle(&self) -> f64 {
        let ([a, b], [c, d]) = (self.height, self.phi);
        (b - a) * (d - c)
    }

    /// The area of its shadow on the unit disc.
    #[must_use]
    pub fn shadow(&self) -> f64 {
        let [a, b] = self.height;
        self.solid_angle() * f64::midpoint(a, b)
    }
}

/// The query for the values at the middles of patches.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Request {
    /// What is summed.
    pub integrand: Integrand,
    /// The number of patches on one side, as a power of 2.
    pub count_log2: u8,
    /// Whether the side below the surface is summed too.
    pub is_sphere: bool,
}

/// The sides of the sphere that are summed, whether each is the upper one.
fn sides(is_sphere: bool) -> &'static [bool] {
    if is_sphere { &[true, false] } else { &[true] }
}

impl Query for Request {
    type Answer = Sum;

    fn answer(&self, subject: &Subject<'_>, _: Detail, _: IsWanted<'_>) -> Option<Sum> {
        Some(self.sum(&subject.lobe))
    }
}

impl Request {
    /// The sum for `lobe`.
    #[must_use]
    pub fn sum(&self, lobe: &HeldLobe<'_>) -> Sum {
        let grid = Grid::of(self.count_log2);
        let lobes = match self.integrand {
            Integrand::FCos => lobe.lobes(),
            _ => &[],
        };
        let mut sum = Sum {
            grid,
            deltas: self.deltas(lobe),
            lobes: lobes.iter().map(|lobe| (*lobe, [0.0; 3])).collect(),
            ..Sum::default()
        };
        for is_upper in sides(self.is_sphere) {
            let patches: Vec<Patch> = grid.patches(*is_upper).collect();
            let free: Vec<DVec3> = patches.iter().map(Patch::middle).collect();
            let values = self.integrand.values(lobe, &free, *is_upper);
            let parts = patches.into_iter().zip(values);
            sum.parts
                .extend(parts.map(|(patch, value)| Part { patch, value }));
            for (index, (_, total)) in sum.lobes.iter_mut().enumerate() {
                let values = times_cosine(lobe.lobe_values(index, &free), &free);
                let each = grid.patches(*is_upper).zip(values);
                let all = each.map(|(patch, value)| value.map(|x| x * patch.solid_angle()));
                *total = all.fold(*total, plus);
            }
        }
        sum
    }

    /// What the deltas add to the sum: the share of the flux where light is held; where a viewer is, the radiance that it
    /// sees by them under an even sky of radiance 1. Only f cos counts them.
    fn deltas(self, lobe: &HeldLobe<'_>) -> Vec<Point> {
        if self.integrand != Integrand::FCos {
            return Vec::new();
        }
        let arrows = lobe.arrows().into_iter();
        let is_summed = |point: &Point| self.is_sphere || point.direction.z > 0.0;
        let points = arrows.map(|arrow| Point {
            direction: arrow.direction,
            share: match lobe.hold() {
                Hold::Light => arrow.flux,
                Hold::Viewer => arrow.weight,
            },
            side: arrow.side,
        });
        points.filter(is_summed).collect()
    }
}

/// The sum of two triples.
fn plus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    let ([a, b, c], [x, y, z]) = (a, b);
    [a + x, b + y, c + z]
}

/// A patch with the integrand at its middle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Part {
    /// The patch.
    pub patch: Patch,
    /// The value of the integrand, per channel.
    pub value: [f64; 3],
}

impl Part {
    /// What it adds to the sum, per channel: the value times the solid angle.
    #[must_use]
    pub fn share(&self) -> [f64; 3] {
        self.value.map(|x| x * self.patch.solid_angle())
    }
}

/// A Dirac delta, which falls on the disc as a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// The direction, a unit vector.
    pub direction: DVec3,
    /// What it adds to the sum, per channel.
    pub share: [f64; 3],
    /// To which side it goes.
    pub side: Side,
}

/// An integral as a sum; without parts before it is known.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sum {
    /// How each side is cut.
    pub grid: Grid,
    /// The patches, those of the upper side first.
    pub parts: Vec<Part>,
    /// The deltas, which count after them.
    pub deltas: Vec<Point>,
    /// What the patches find of each inner lobe, where f cos is summed.
    pub lobes: Vec<(Lobe, [f64; 3])>,
}

impl Sum {
    /// What each part adds to the sum, per channel, in the order in which they are counted: the patches, then the deltas.
    pub fn shares(&self) -> impl Iterator<Item = [f64; 3]> + '_ {
        let deltas = self.deltas.iter().map(|point| point.share);
        self.parts.iter().map(Part::share).chain(deltas)
    }

    /// The sum of all.
    #[must_use]
    pub fn total(&self) -> [f64; 3] {
        self.shares().fold([0.0; 3], plus)
    }

    /// The luminance of the sum of the first `count` parts.
    #[must_use]
    pub fn luminance_of_first(&self, count: usize) -> f64 {
        Channel::Luminance.of(self.shares().take(count).fold([0.0; 3], plus))
    }
}

#[cfg(test)]
mod tests;
