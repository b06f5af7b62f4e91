//! Dirac deltas where a plot shows them: never as values, always as their share of the flux at their place.

use glam::DVec3;

use super::lobe::{Arrow, HeldLobe};
use super::section::signed_angle;
use super::{Channel, Detail, IsWanted, Pace, Query, Subject};
use bxdf::Side;

/// A delta whose direction is within this of a section, as a length, lies in it: a third of a degree is no wider than a
/// line is drawn.
const IN_SECTION: f64 = 0.02;

/// Directions nearer to one another than this are one: deltas of two surfaces, computed by two formulas.
const SAME_DIRECTION: f64 = 1e-9;

/// The deltas of the lobe.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Arrows;

impl Query for Arrows {
    type Answer = Vec<Arrow>;

    // What is drawn of the values must not be ahead of it.
    const PACE: Pace = Pace::AtOnce;

    fn answer(&self, subject: &Subject<'_>, _: Detail, _: IsWanted<'_>) -> Option<Vec<Arrow>> {
        Some(subject.lobe.arrows())
    }
}

/// A delta in a plot over an angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stem {
    /// Where it stands, in degrees.
    pub x_deg: f64,
    /// The share of the flux that it carries, per channel, or what is shown in its place; less that of the surface compared with, where there is one.
    pub flux: [f64; 3],
    /// To which side it goes.
    pub side: Side,
    /// Whether it lies in what the plot shows; else it is elsewhere, with this angle.
    pub is_inside: bool,
}

impl Stem {
    /// The luminance of [`Self::flux`].
    #[must_use]
    pub fn share(&self) -> f64 {
        Channel::Luminance.of(self.flux)
    }
}

/// Whether the unit vector `w` lies in the section at azimuth `phi`, in radians.
#[must_use]
pub fn is_in_section(w: DVec3, phi: f64) -> bool {
    let (sin, cos) = phi.sin_cos();
    (w.y * cos - w.x * sin).abs() < IN_SECTION
}

/// `arrows` over the signed angle from n in the section at azimuth `phi`, in radians.
#[must_use]
pub fn in_section(arrows: &[Arrow], phi: f64) -> Vec<Stem> {
    in_section_as(arrows, phi, |arrow| arrow.flux)
}

/// [`in_section`], with the probability of being chosen in place of the share of the flux.
#[must_use]
pub fn chosen_in_section(arrows: &[Arrow], phi: f64) -> Vec<Stem> {
    in_section_as(arrows, phi, |arrow| [arrow.probability; 3])
}

fn in_section_as(arrows: &[Arrow], phi: f64, flux: impl Fn(&Arrow) -> [f64; 3]) -> Vec<Stem> {
    let stem = |arrow: &Arrow| Stem {
        x_deg: signed_angle(arrow.direction, phi).to_degrees(),
        flux: flux(arrow),
        side: arrow.side,
        is_inside: is_in_section(arrow.direction, phi),
    };
    arrows.iter().map(stem).collect()
}

/// The deltas of `subject`, each with that of the surface compared with, if there is one in the same direction.
#[must_use]
pub fn pairs(subject: &Subject<'_>) -> Vec<[Option<Arrow>; 2]> {
    let own = subject.lobe.arrows();
    let other = subject.against.map_or_else(Vec::new, |lobe| lobe.arrows());
    let is_same = |a: &Arrow, b: &Arrow| a.direction.distance(b.direction) < SAME_DIRECTION;
    let alone = other.iter().filter(|b| !own.iter().any(|a| is_same(a, b)));
    let alone = alone.map(|b| [None, Some(*b)]);
    let with = own.iter().map(|a| {
        let found = other.iter().find(|b| is_same(a, b));
        [Some(*a), found.copied()]
    });
    with.chain(alone).collect()
}

/// The deltas of `subject`, their flux less that of the surface compared with; those that are alike in both are none.
#[must_use]
pub fn differences(subject: &Subject<'_>) -> Vec<Arrow> {
    let difference = |[own, other]: [Option<Arrow>; 2]| {
        let mut arrow = own.or(other)?;
        let flux = |arrow: Option<Arrow>| arrow.map_or([0.0; 3], |arrow| arrow.flux);
        let ([a, b, c], [x, y, z]) = (flux(own), flux(other));
        arrow.flux = [a - x, b - y, c - z];
        (arrow.flux != [0.0; 3]).then_some(arrow)
    };
    pairs(subject).into_iter().filter_map(difference).collect()
}

/// The share of the flux arriving along the unit vector `w` that `lobe`'s surface mirrors, per channel: the delta of all
/// pairs whose half vector is n. `None` where it mirrors nothing.
#[must_use]
pub fn mirrored(lobe: &HeldLobe<'_>, w: DVec3) -> Option<[f64; 3]> {
    let arrows = HeldLobe::new(lobe.surface(), lobe.hold(), w).arrows();
    let mut reflected = arrows.into_iter();
    let reflected = reflected.find(|arrow| arrow.side == Side::Reflection)?;
    Some(reflected.flux)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::Hold;
    use bxdf::math::frame::direction_from_degrees;
    use bxdf::{Material, Scatterer};

    fn surface(text: &str) -> Box<dyn Scatterer<f64>> {
        text.parse::<Material>().unwrap().build()
    }

    fn lobe(surface: &dyn Scatterer<f64>) -> HeldLobe<'_> {
        HeldLobe::new(surface, Hold::Light, direction_from_degrees(50.0, 180.0))
    }

    #[test]
    fn glass_has_a_stem_to_either_side() {
        let glass = surface("fresnel_specular:eta=1.5");
        let arrows = lobe(&*glass).arrows();
        let stems = in_section(&arrows, 0.0);
        let [up, down] = &stems[..] else {
            panic!("{stems:?}");
        };
        assert!((up.x_deg - 50.0).abs() < 1e-9 && up.side == Side::Reflection);
        // By Snell's law.
        let sine = 50.0_f64.to_radians().sin() / 1.5;
        let refracted = 180.0 - sine.atan2((1.0 - sine * sine).sqrt()).to_degrees();
        assert!((down.x_deg - refracted).abs() < 1e-9, "{down:?}");
        assert!((up.share() + down.share() - 1.0).abs() < 1e-12);
        assert!(up.is_inside && down.is_inside);
        // In another section it stands at its angle from n, and is not inside.
        let aside = in_section(&arrows, 1.0);
        assert!(aside.iter().all(|stem| !stem.is_inside));
        assert!((aside[0].x_deg.abs() - 50.0).abs() < 1e-9);
    }

    #[test]
    fn what_carries_nothing_is_no_delta() {
        let black = surface("specular_reflection:reflectance=0");
        assert!(lobe(&*black).arrows().is_empty());
        // Light from inside glass beyond the critical angle is all mirrored.
        let glass = surface("fresnel_specular:eta=1.5");
        let inside = HeldLobe::new(&*glass, Hold::Light, direction_from_degrees(120.0, 0.0));
        let arrows = inside.arrows();
        assert_eq!(arrows.len(), 1);
        assert!((arrows[0].flux[0] - 1.0).abs() < 1e-12);
    }

    #[test]
    fn differences_are_those_of_shares() {
        let (bright, dark) = (
            surface("specular_reflection:reflectance=0.9"),
            surface("specular_reflection:reflectance=0.4"),
        );
        let diffuse = surface("lambertian_reflection");
        let against = |own: &dyn Scatterer<f64>, other: &dyn Scatterer<f64>| {
            let subject = Subject {
                against: Some(lobe(other)),
                ..Subject::of(lobe(own))
            };
            let found = differences(&subject);
            found.iter().map(|arrow| arrow.flux[1]).collect::<Vec<_>>()
        };
        assert!((against(&*bright, &*dark)[0] - 0.5).abs() < 1e-12);
        assert!((against(&*diffuse, &*dark)[0] + 0.4).abs() < 1e-12);
        assert!(against(&*dark, &*dark).is_empty());
    }

    #[test]
    fn all_pairs_about_the_normal_are_mirrored_by_their_own_angle() {
        let glass = surface("fresnel_specular:eta=1.5");
        let share = |theta| {
            let w = direction_from_degrees(theta, 20.0);
            mirrored(&lobe(&*glass), w).map(|flux| flux[1])
        };
        assert!((share(0.0).unwrap() - 0.04).abs() < 1e-12);
        assert!(share(85.0).unwrap() > 0.4);
        assert_eq!(mirrored(&lobe(&*surface("oren_nayar")), DVec3::Z), None);
    }
}
