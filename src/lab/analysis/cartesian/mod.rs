//! The Cartesian plot's data: f over an angle.
//!
//! Over the half and difference angles (`rusinkiewicz1998`) the half vector stands at a fixed azimuth and the difference
//! at phi_d = 90 degrees: both directions are equally high above the surface then, so that no pair lies below it.

use std::f64::consts::{FRAC_PI_2, PI};

use glam::DVec3;

use super::deltas::{self, Stem};
use super::half_difference::{HalfDifference, Spherical, half_difference, pair};
use super::lobe::{HeldLobe, off_horizon, pair_values};
use super::polar::{UNIFORM_STEP_DEG, direction, seed_angles};
use super::refine::{Curve as Places, MIDDLE_AND_BESIDE, first_places, is_on_chord, peaks, refine};
use super::{Detail, IsWanted, Query, RadialScale, Subject};
use bxdf::Side;
use bxdf::math::frame;

/// The angle that f is shown over.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize,
)]
#[serde(rename_all = "snake_case")]
pub enum Abscissa {
    /// The signed angle of the free direction from n in a section, -180..180 degrees.
    #[default]
    Free,
    /// theta_h, of the half vector from n, 0 to [`END_DEG`], at a fixed theta_d.
    Half,
    /// theta_d, of either direction from the half vector, 0 to [`END_DEG`], at a fixed theta_h.
    Difference,
}

impl Abscissa {
    /// All of them, in the order of the screen.
    pub const ALL: [Self; 3] = [Self::Free, Self::Half, Self::Difference];

    /// The words for it on the screen.
    #[must_use]
    pub const fn title(self) -> &'static str {
        match self {
            Self::Free => "Free direction",
            Self::Half => "Half angle",
            Self::Difference => "Difference angle",
        }
    }
}

/// phi_d of the pairs shown over theta_h and theta_d, in degrees.
pub const PHI_D_DEG: f64 = 90.0;

/// Where theta_h and theta_d end, in degrees: towards 90 both directions graze, and f may grow without bound.
pub const END_DEG: f64 = 89.9;

/// The ranges, in radians, of the lines over the free direction's signed angle, and whether each lies above the surface.
pub(super) const SECTION_LINES: [([f64; 2], bool); 3] = [
    ([-PI, -FRAC_PI_2], false),
    ([-FRAC_PI_2, FRAC_PI_2], true),
    ([FRAC_PI_2, PI], false),
];

/// What a Cartesian plot shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Request {
    /// The angle that f is shown over.
    pub abscissa: Abscissa,
    /// The angle held besides: theta_d over theta_h, theta_h over theta_d; degrees, 0 to [`END_DEG`],
    /// beyond which that is taken.
    pub fixed_deg: f64,
    /// The azimuth, in radians, of the section's positive half, or of the half vector.
    pub phi: f64,
    /// Whether values are multiplied by |cos(theta)| of the free direction.
    pub with_cosine: bool,
    /// The scale of the ordinate for which the curve is fine enough.
    pub scale: RadialScale,
    /// Whether the value of the surface to compare with is taken off, where there is one.
    pub is_residual: bool,
}

impl Query for Request {
    type Answer = Curve;

    fn answer(&self, subject: &Subject<'_>, _: Detail, _: IsWanted<'_>) -> Option<Curve> {
        Some(curve(subject, self))
    }
}

/// A point of the curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// The angle, in degrees.
    pub x_deg: f64,
    /// f (times the cosine, less the value compared with, if asked for) in 1/sr, per channel.
    pub value: [f64; 3],
}

/// A curve, in pieces.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Curve {
    /// The pieces, by angle; the curve may jump from one to the next, at the horizon. What is 0 everywhere below the
    /// surface is left out.
    pub lines: Vec<Vec<Point>>,
    /// The largest magnitude of any channel.
    pub peak: f64,
    /// The Dirac deltas over the same angle, less those of the surface compared with: they are no values of the curve.
    pub stems: Vec<Stem>,
}

/// The curve of `subject` that `request` asks for: its chords leave it by at most a thousandth of the plot's height,
/// whichever channel is shown.
#[must_use]
pub fn curve(subject: &Subject<'_>, request: &Request) -> Curve {
    let plot = Plot::of(subject, request);
    let known = plot.known();
    let lines = match request.abscissa {
        Abscissa::Free => section_lines(&plot, &known),
        Abscissa::Half | Abscissa::Difference => {
            vec![plot.line([0.0, END_DEG.to_radians()], true, &known)]
        }
    };
    let values = lines.iter().flatten().flat_map(|point| point.value);
    let peak = values.map(f64::abs).fold(0.0, f64::max);
    let stems = plot.stems();
    Curve { lines, peak, stems }
}

/// What `request` shows of `subject` at `x_deg` degrees: the value that the curve has there.
#[must_use]
pub fn value_at(subject: &Subject<'_>, request: &Request, x_deg: f64) -> [f64; 3] {
    let is_upper = request.abscissa != Abscissa::Free || x_deg.abs() <= 90.0;
    let values = Plot::of(subject, request).values(&[x_deg.to_radians()], is_upper);
    values.first().copied().unwrap_or_default()
}

impl Request {
    /// The pair (wo, wi) that stands at `x_deg` degrees of the plot of `lobe`.
    #[must_use]
    pub fn pair_at(&self, lobe: &HeldLobe<'_>, x_deg: f64) -> (DVec3, DVec3) {
        match self.abscissa {
            Abscissa::Free => lobe.pair(direction(x_deg.to_radians(), self.phi)),
            Abscissa::Half => self.half_pair(x_deg, self.fixed_deg),
            Abscissa::Difference => self.half_pair(self.fixed_deg, x_deg),
        }
    }

    /// The pair with these theta_h and theta_d, in degrees.
    fn half_pair(&self, theta_h: f64, theta_d: f64) -> (DVec3, DVec3) {
        let half = Spherical {
            theta_deg: theta_h.min(END_DEG),
            phi_deg: self.phi.to_degrees(),
        };
        let difference = Spherical {
            theta_deg: theta_d.min(END_DEG),
            phi_deg: PHI_D_DEG,
        };
        pair(half, difference)
    }

    /// Where the half or difference angle of `free` and the held direction stands, in radians.
    fn angle_of(&self, lobe: &HeldLobe<'_>, free: DVec3) -> Option<f64> {
        let HalfDifference { half, difference } = half_difference(free, lobe.held())?;
        let angle = match self.abscissa {
            Abscissa::Difference => difference,
            Abscissa::Free | Abscissa::Half => half,
        };
        Some(angle.theta_deg.to_radians())
    }
}

/// Angles in radians that gather at 0 and at [`END_DEG`], a tenth of the narrowest lobe from there to a tenth of a radian.
fn graded() -> impl Iterator<Item = f64> {
    (0..=32).flat_map(|i| {
        let distance = 1e-5 * 10_f64.powf(f64::from(i) / 8.0);
        [distance, END_DEG.to_radians() - distance]
    })
}

/// A request and what it is asked about.
struct Plot<'a> {
    request: &'a Request,
    lobe: HeldLobe<'a>,
    /// What is taken off.
    against: Option<HeldLobe<'a>>,
}

impl<'a> Plot<'a> {
    fn of(subject: &Subject<'a>, request: &'a Request) -> Self {
        Self {
            request,
            lobe: subject.lobe,
            against: subject.against.filter(|_| request.is_residual),
        }
    }

    /// Angles, in radians, where the surfaces are known to have something.
    fn known(&self) -> Vec<f64> {
        let lobes = [Some(self.lobe), self.against].into_iter().flatten();
        match self.request.abscissa {
            Abscissa::Free => lobes
                .flat_map(|lobe| seed_angles(&lobe, self.request.phi))
                .collect(),
            Abscissa::Half | Abscissa::Difference => {
                let of = |lobe: HeldLobe<'_>| {
                    let seeds = lobe.seeds().directions.into_iter();
                    let angles = seeds.filter_map(|seed| self.request.angle_of(&lobe, seed));
                    angles.collect::<Vec<_>>()
                };
                lobes.flat_map(of).chain(graded()).collect()
            }
        }
    }

    /// The deltas. Over half and difference angles those that mirror stand at theta_h = 0, whatever theta_d, with the share
    /// of their own theta_d: the one of the plot, or the held direction's. What crosses the surface has no half vector there.
    fn stems(&self) -> Vec<Stem> {
        let subject = Subject {
            against: self.against,
            ..Subject::of(self.lobe)
        };
        let (theta_d, x_deg, is_inside) = match self.request.abscissa {
            Abscissa::Free => {
                return deltas::in_section(&deltas::differences(&subject), self.request.phi);
            }
            Abscissa::Half => (self.request.fixed_deg, 0.0, true),
            Abscissa::Difference => {
                let held = frame::theta(self.lobe.held()).to_degrees();
                let held = held.min(180.0 - held);
                (held, held, self.request.fixed_deg == 0.0)
            }
        };
        let (_, wi) = self.request.half_pair(0.0, theta_d);
        let at = |lobe: HeldLobe<'a>| HeldLobe::new(lobe.surface(), lobe.hold(), wi);
        let subject = Subject {
            against: self.against.map(at),
            ..Subject::of(at(self.lobe))
        };
        let found = deltas::differences(&subject).into_iter();
        found
            .filter(|arrow| arrow.side == Side::Reflection)
            .map(|arrow| Stem {
                x_deg,
                flux: arrow.flux,
                side: arrow.side,
                is_inside,
            })
            .collect()
    }

    /// The line over `range`, in radians; `known`: where the surfaces have something.
    fn line(&self, range: [f64; 2], is_upper: bool, known: &[f64]) -> Vec<Point> {
        let [low, high] = range.map(f64::to_degrees);
        let steps = ((high - low) / UNIFORM_STEP_DEG) as u32;
        let line: Places<[f64; 3]> = refine(
            first_places(range, steps, known.iter().copied()),
            &MIDDLE_AND_BESIDE,
            |places| self.values(places, is_upper),
            peaks,
            |peaks, points| is_on_chord(self.request.scale, peaks, points),
        );
        let point = |(place, value): (f64, [f64; 3])| Point {
            x_deg: place.to_degrees(),
            value,
        };
        line.into_iter().map(point).collect()
    }

    /// What is shown at `places`, in radians.
    fn values(&self, places: &[f64], is_upper: bool) -> Vec<[f64; 3]> {
        let place = |angle: &f64| match self.request.abscissa {
            Abscissa::Free => {
                let free = direction(*angle, self.request.phi);
                let pair = self.lobe.pair(off_horizon(free, is_upper));
                (pair, free.z.abs())
            }
            Abscissa::Half | Abscissa::Difference => {
                let pair = self.request.pair_at(&self.lobe, angle.to_degrees());
                (pair, pair.0.z.abs())
            }
        };
        let (pairs, cosines): (Vec<_>, Vec<f64>) = places.iter().map(place).unzip();
        let mut values = pair_values(self.lobe.surface(), &pairs);
        let against = self.against;
        let other = against.map(|against| pair_values(against.surface(), &pairs));
        for (value, other) in values.iter_mut().zip(other.iter().flatten()) {
            value.iter_mut().zip(other).for_each(|(a, b)| *a -= b);
        }
        if self.request.with_cosine {
            for (value, cosine) in values.iter_mut().zip(cosines) {
                *value = value.map(|x| x * cosine);
            }
        }
        values
    }
}

/// The lines over the signed angle of the free direction.
fn section_lines(plot: &Plot<'_>, known: &[f64]) -> Vec<Vec<Point>> {
    let lines = SECTION_LINES.into_iter().filter_map(|(range, is_upper)| {
        let line = plot.line(range, is_upper, known);
        let is_shown = is_upper || line.iter().any(|point| point.value != [0.0; 3]);
        is_shown.then_some(line)
    });
    lines.collect()
}

#[cfg(test)]
mod tests;
