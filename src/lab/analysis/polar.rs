//! The polar plot's data: the section of a lobe through a plane that contains the normal.

use std::f64::consts::{FRAC_PI_2, PI};

use glam::DVec3;

use super::deltas::{self, Stem};
use super::lobe::HeldLobe;
use super::refine::{CHORD_TOLERANCE, first_places, refine};
use super::scale::RadialScale;
use super::{Detail, IsWanted, Query, Subject};

pub use super::section::{direction, signed_angle};

/// What a section shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Request {
    /// The azimuth of the section's positive half, in radians.
    pub phi: f64,
    /// Whether values are multiplied by |cos(theta)| of the free direction.
    pub with_cosine: bool,
    /// The radial scale for which the curve is fine enough.
    pub scale: RadialScale,
}

impl Request {
    /// The value shown where f is this at the unit vector `w`.
    fn shown(&self, f: [f64; 3], w: DVec3) -> [f64; 3] {
        let cosine = if self.with_cosine { w.z.abs() } else { 1.0 };
        f.map(|f| f * cosine)
    }
}

impl Query for Request {
    type Answer = Section;

    fn answer(&self, subject: &Subject<'_>, _: Detail, _: IsWanted<'_>) -> Option<Section> {
        Some(section(&subject.lobe, self))
    }
}

/// A point of the curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// The signed angle from n in radians, -pi..pi, positive towards the section's azimuth.
    pub angle: f64,
    /// f (times the cosine, if asked for) in 1/sr, per channel.
    pub value: [f64; 3],
}

/// A section: two arcs, above and below the horizon, each from the negative to the positive half; an arc that is 0
/// everywhere is empty.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Section {
    /// The arc above the surface, angles -pi/2..pi/2.
    pub upper: Vec<Point>,
    /// The arc below, angles from -pi/2 over -pi and pi to pi/2.
    pub lower: Vec<Point>,
    /// The largest value of any channel.
    pub peak: f64,
    /// The Dirac deltas, over the same angle: they are no values of the arcs.
    pub stems: Vec<Stem>,
}

/// Spacing of the uniform grid under the adaptive one.
pub(super) const UNIFORM_STEP_DEG: f64 = 1.5;

/// The section of `lobe` that `request` asks for.
///
/// The points are a uniform grid and the angles of the lobe's own samples, halved while the midpoint leaves the chord:
/// the largest value is within a thousandth of the lobe's largest in the section, however narrow the lobe.
#[must_use]
pub fn section(lobe: &HeldLobe<'_>, request: &Request) -> Section {
    let angles = seed_angles(lobe, request.phi);
    let upper = arc(lobe, request, &angles, true);
    let lower = arc(lobe, request, &angles, false);
    let peak = upper
        .iter()
        .chain(&lower)
        .map(|point| largest(point.value))
        .fold(0.0, f64::max);
    let stems = deltas::in_section(&lobe.arrows(), request.phi);
    Section {
        upper,
        lower,
        peak,
        stems,
    }
}

/// Where the lobe is known to be: the signed angles of its own samples in the section at azimuth `phi`, of the held
/// direction, and of its mirror image.
pub(super) fn seed_angles(lobe: &HeldLobe<'_>, phi: f64) -> Vec<f64> {
    let held = signed_angle(lobe.held(), phi);
    let seeds = lobe.seeds().directions.into_iter();
    let seeds = seeds.map(|seed| signed_angle(seed, phi));
    [held, -held].into_iter().chain(seeds).collect()
}

/// One arc, above or below: its places are -pi/2..pi/2, counted from n or -n. `angles`: where the lobe is known to be.
fn arc(lobe: &HeldLobe<'_>, request: &Request, angles: &[f64], is_upper: bool) -> Vec<Point> {
    let angle_of = |place: f64| if is_upper { place } else { lower_angle(place) };
    let steps = (180.0 / UNIFORM_STEP_DEG) as u32;
    let known = angles.iter().map(|angle| angle_of(*angle));
    let places = first_places([-FRAC_PI_2, FRAC_PI_2], steps, known);
    let at = |places: &[f64]| {
        let directions = places
            .iter()
            .map(|place| direction(angle_of(*place), request.phi));
        let directions: Vec<_> = directions.collect();
        let values = lobe.values_or_limits(&directions, is_upper);
        let shown = values.into_iter().zip(directions);
        shown.map(|(f, w)| request.shown(f, w)).collect::<Vec<_>>()
    };
    let peak_of = |curve: &[(f64, [f64; 3])]| {
        let values = curve.iter().map(|(_, value)| largest(*value));
        Some(values.fold(0.0, f64::max)).filter(|peak| *peak > 0.0)
    };
    let is_good = |peak: &f64, points: [&(f64, [f64; 3]); 3]| {
        let [[ax, ay], [mx, my], [bx, by]] = points.map(|(place, value)| {
            let radius = request.scale.radius(largest(*value), *peak);
            [radius * place.sin(), radius * place.cos()]
        });
        (mx - f64::midpoint(ax, bx)).hypot(my - f64::midpoint(ay, by)) <= CHORD_TOLERANCE
    };
    let curve = refine(places, &[0.5], at, peak_of, is_good);
    if peak_of(&curve).is_none() {
        return Vec::new();
    }
    curve
        .into_iter()
        .map(|(place, value)| Point {
            angle: angle_of(place),
            value,
        })
        .collect()
}

/// The signed angle from n of a place on the lower arc, which is counted from -n; and the other way round.
fn lower_angle(place: f64) -> f64 {
    if place > 0.0 { PI - place } else { -PI - place }
}

fn largest(value: [f64; 3]) -> f64 {
    value.into_iter().fold(0.0, f64::max)
}

/// The value of `lobe` at signed angle `angle` of the section, or its limit at the horizon: what the curve shows and a
/// read-out says.
#[must_use]
pub fn value_at(lobe: &HeldLobe<'_>, request: &Request, angle: f64) -> [f64; 3] {
    value_on_side(lobe, request, angle, angle.abs() <= FRAC_PI_2)
}

fn value_on_side(lobe: &HeldLobe<'_>, request: &Request, angle: f64, is_upper: bool) -> [f64; 3] {
    let w = direction(angle, request.phi);
    request.shown(lobe.value_or_limit(w, is_upper), w)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::Hold;
    use bxdf::math::frame::direction_from_degrees;
    use bxdf::{Material, Scatterer};

    fn request(phi_deg: f64) -> Request {
        Request {
            phi: phi_deg.to_radians(),
            with_cosine: false,
            scale: RadialScale::Linear,
        }
    }

    /// The largest value in the plane, by golden-section search about the best of a very fine local grid.
    fn true_peak(lobe: &HeldLobe<'_>, request: &Request, near: f64, width: f64) -> f64 {
        let value = |angle: f64| largest(value_at(lobe, request, angle));
        let steps = 4000;
        let grid =
            (0..=steps).map(|i| near + width * (2.0 * f64::from(i) / f64::from(steps) - 1.0));
        let best = grid.max_by(|a, b| value(*a).total_cmp(&value(*b))).unwrap();
        let (mut low, mut high) = (
            best - 2.0 * width / f64::from(steps),
            best + 2.0 * width / f64::from(steps),
        );
        for _ in 0..60 {
            let (a, b) = (low + 0.382 * (high - low), low + 0.618 * (high - low));
            if value(a) > value(b) {
                high = b;
            } else {
                low = a;
            }
        }
        value(f64::midpoint(low, high)).max(value(best))
    }

    fn section_peak_ratio(material: &str, theta_deg: f64, phi_deg: f64) -> (f64, usize) {
        let material: Material = material.parse().unwrap();
        let model: Box<dyn Scatterer<f64>> = material.build();
        let lobe = HeldLobe::new(
            &*model,
            Hold::Light,
            direction_from_degrees(theta_deg, phi_deg),
        );
        let request = request(phi_deg);
        let section = section(&lobe, &request);
        // Where the lobe is by its construction, not where the curve has found it.
        let theta = theta_deg.to_radians();
        let near = if material.components()[0].model().id == "retro_reflector" {
            theta
        } else {
            -theta
        };
        let alpha = material.components()[0].params().number("alpha_x");
        let width = (10.0 * alpha).clamp(0.01, 1.0).min(FRAC_PI_2 - near.abs());
        (
            section.peak / true_peak(&lobe, &request, near, width),
            section.upper.len(),
        )
    }

    #[test]
    fn the_plotted_maximum_is_the_true_one_within_a_percent() {
        for (alpha, theta) in [
            ("0.3", 30.0),
            ("0.001", 60.0),
            ("0.0001", 85.0),
            ("0.0001", 0.0),
            ("0.02", 89.0),
        ] {
            for model in ["rough_conductor", "retro_reflector"] {
                let (ratio, points) =
                    section_peak_ratio(&format!("{model}:alpha={alpha}"), theta, 40.0);
                // The section may hold a higher value elsewhere (f grows towards the horizon), never a lower one.
                assert!(ratio >= 0.99, "{model} {alpha} {theta}: {ratio}");
                assert!(
                    ratio <= 1.000_001 || alpha == "0.3",
                    "{model} {alpha} {theta}: {ratio}"
                );
                assert!(points < 2000, "{model} {alpha} {theta}: {points} points");
            }
        }
    }

    #[test]
    fn the_mirror_direction_stands_where_it_should() {
        let material: Material = "rough_conductor:alpha=0.001".parse().unwrap();
        let model: Box<dyn Scatterer<f64>> = material.build();
        let lobe = HeldLobe::new(&*model, Hold::Light, direction_from_degrees(60.0, 0.0));
        let section = section(&lobe, &request(0.0));
        let top = section
            .upper
            .iter()
            .max_by(|a, b| a.value[0].total_cmp(&b.value[0]))
            .unwrap();
        assert!(
            (top.angle.to_degrees() + 60.0).abs() < 0.05,
            "{}",
            top.angle.to_degrees()
        );
        assert!(section.lower.is_empty());
    }

    #[test]
    fn arcs_end_at_the_horizon_and_stay_on_their_side() {
        let material: Material = "lambertian_transmission".parse().unwrap();
        let model: Box<dyn Scatterer<f64>> = material.build();
        let lobe = HeldLobe::new(&*model, Hold::Light, direction_from_degrees(30.0, 0.0));
        let section = section(&lobe, &request(0.0));
        assert!(section.upper.is_empty());
        let (first, last) = (
            section.lower.first().unwrap(),
            section.lower.last().unwrap(),
        );
        assert!((first.angle + FRAC_PI_2).abs() < 1e-12 && (last.angle - FRAC_PI_2).abs() < 1e-12);
        assert!(
            section
                .lower
                .iter()
                .all(|p| p.angle.abs() >= FRAC_PI_2 - 1e-12 && p.value[0] > 0.25)
        );
    }
}
