//! The reflectance of a smooth interface over the angle of incidence, s and p polarised, and Snell's law.

use super::{Basis, Channel, Detail, IsWanted, Pace, Query, Subject};
use bxdf::math::frame;

mod face;
mod interface;
#[cfg(test)]
mod tests;

pub use face::{Face, Index, Mark, MarkKind, Reflectances};
pub use interface::{Interface, lobe, lobes};

/// Which interface is looked at, and from where.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Request {
    /// The place of its lobe among those of the material that have one; see [`lobe`].
    pub lobe: usize,
    /// The index below the surface over the one above that is taken where there is none.
    pub own: Index,
    /// Whether it is looked at from below; `None`: from the side of the held direction.
    pub is_from_below: Option<bool>,
}

/// An interface over the angle.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Fresnel {
    /// Whether the light is absorbed below: it is looked at from above then, whatever was asked for.
    pub is_absorbing: bool,
    /// Whether it is looked at from below.
    pub is_from_below: bool,
    /// The angle of the held direction from the axis of its side, in degrees.
    pub theta_deg: f64,
    /// The reflectances of each channel; of all at once where they are the same.
    pub curves: Vec<Curve>,
}

/// The reflectances of a channel.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// The channel; `None` for all light alike.
    pub channel: Option<Channel>,
    /// The index below the surface over the one above.
    pub index: Index,
    /// It over the angle of incidence, 0 to 90 degrees, in rising order.
    pub points: Vec<Point>,
    /// The angles at which something happens.
    pub marks: Vec<Mark>,
    /// It at the angle of the held direction.
    pub held: Point,
}

/// What happens to light that arrives at an angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// The angle of incidence in degrees.
    pub theta_deg: f64,
    /// The angle at which it goes on, in degrees; `None` where there is no real one.
    pub refracted_deg: Option<f64>,
    /// What is reflected of it.
    pub reflectances: Reflectances,
}

impl Point {
    fn of(face: &Face, theta_deg: f64) -> Self {
        Self {
            theta_deg,
            refracted_deg: face.refracted_deg(theta_deg),
            reflectances: face.at(theta_deg),
        }
    }
}

impl Curve {
    /// The indices on the side of the incident light and on the other, those above the surface being 1.
    #[must_use]
    pub fn sides(&self, is_from_below: bool) -> [f64; 2] {
        let Index { n, .. } = self.index;
        if is_from_below { [n, 1.0] } else { [1.0, n] }
    }
}

/// Steps over 90 degrees.
const STEPS: u16 = 180;

/// Nearer to an angle at which a curve bends lie places at halves of the distance, so many times.
const HALVINGS: i32 = 24;

impl Query for Request {
    type Answer = Fresnel;

    const BASIS: Basis = Basis::Held;
    const PACE: Pace = Pace::AtOnce;

    fn answer(&self, subject: &Subject<'_>, _: Detail, _: IsWanted<'_>) -> Option<Fresnel> {
        let of_lobe = subject.material.and_then(|material| {
            let component = lobe(material, self.lobe)?;
            Interface::of(component)
        });
        let interface = of_lobe.unwrap_or_else(|| Interface::grey(self.own));
        let held = subject.lobe.held();
        let is_absorbing = interface.is_absorbing();
        let is_from_below = self.is_from_below.unwrap_or(held.z < 0.0) && !is_absorbing;
        let theta_deg = frame::theta(held).to_degrees();
        let theta_deg = theta_deg.min(180.0 - theta_deg);
        let curve = |(channel, index): &(Option<Channel>, Index)| {
            let above = Face::new(*index);
            let face = if is_from_below {
                above.reversed()
            } else {
                above
            };
            let marks = face.marks();
            Curve {
                channel: *channel,
                index: *index,
                points: places(&marks)
                    .into_iter()
                    .map(|at| Point::of(&face, at))
                    .collect(),
                marks,
                held: Point::of(&face, theta_deg),
            }
        };
        Some(Fresnel {
            is_absorbing,
            is_from_below,
            theta_deg,
            curves: interface.channels.iter().map(curve).collect(),
        })
    }
}

/// The angles at which curves are looked at: evenly, and ever closer to where they bend and to the horizon.
fn places(marks: &[Mark]) -> Vec<f64> {
    let step = 90.0 / f64::from(STEPS);
    let evenly = (0..=STEPS).map(|index| step * f64::from(index));
    let bends = marks.iter().map(|mark| mark.theta_deg).chain([90.0]);
    let near = bends.flat_map(|bend| {
        let halves = (0..HALVINGS).map(move |halving| step * 0.5_f64.powi(halving));
        let both = halves.flat_map(move |half| [bend - half, bend + half]);
        both.chain([bend])
    });
    let mut places: Vec<f64> = evenly
        .chain(near)
        .filter(|at| (0.0..=90.0).contains(at))
        .collect();
    places.sort_by(f64::total_cmp);
    places.dedup();
    places
}
