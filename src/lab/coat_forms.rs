//! What stands over the diffuse part under a coat: three forms that are met with, held against reciprocity and energy.
//!
//! A smooth coat over a white ground: the coat reflects F at the light's cosine, and the ground's 1/pi is multiplied by a factor for
//! the light that crosses the coat. Which Fresnel term that is of is a choice; each has its price.

use std::f64::consts::{FRAC_PI_2, TAU};

use glam::DVec3;

use bxdf::internals::{fresnel, gauss_legendre};
use bxdf::math::frame::direction_from_degrees;

/// A factor on the diffuse part under a coat.
pub struct CoatForm {
    /// The word for it.
    pub id: &'static str,
    /// The name at the screen.
    pub title: &'static str,
    /// The factor, in TeX.
    pub formula: &'static str,
    /// What it is good for and what it costs, one sentence without a full stop.
    pub why: &'static str,
    /// The factor for the light `wi` and the viewer `wo`, both above the surface, by the reflectance at a cosine.
    factor: fn(&dyn Fn(f64) -> f64, DVec3, DVec3) -> f64,
}

/// The forms, the one that the models use first.
pub static COAT_FORMS: [CoatForm; 3] = [
    CoatForm {
        id: "both",
        title: "(1 - F(n.i)) (1 - F(n.o))",
        formula: r"(1 - F(\normal{n}\cdot\light{\omega_i}))\,(1 - F(\normal{n}\cdot\viewer{\omega_o}))",
        why: "Light crosses the coat twice; what is held back on its way out is lost, unless its bounces are summed",
        factor: |f, wi, wo| (1.0 - f(wi.z)) * (1.0 - f(wo.z)),
    },
    CoatForm {
        id: "half",
        title: "1 - F(h.i)",
        formula: r"1 - F(\half{h}\cdot\light{\omega_i})",
        why: "The rest of what a facet at h mirrors; but grazing light, which the coat has mirrored already, is let to the ground",
        factor: |f, wi, wo| {
            let cos = 0.5 * (wi + wo).length();
            1.0 - f(cos.min(1.0))
        },
    },
    CoatForm {
        id: "light",
        title: "1 - F(n.i)",
        formula: r"1 - F(\normal{n}\cdot\light{\omega_i})",
        why: "All that the coat does not mirror leaves again, evenly; but light and viewer are not treated alike",
        factor: |f, wi, _| 1.0 - f(wi.z),
    },
];

/// Points of a quadrature along the polar angle and along half the azimuth.
const POINTS: [usize; 2] = [48, 24];

/// Angles at which reciprocity is tried, in degrees.
const TRIED: usize = 45;

/// By how much a form may exceed 1 or differ and still count as keeping a law: the quadrature's own error.
const TOLERANCE: f64 = 1e-5;

/// What a form does to the laws.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Verdict {
    /// The largest difference of the factors of a pair and of the same pair with light and viewer exchanged.
    pub difference: f64,
    /// The largest share of the light that leaves, over a white ground.
    pub most: f64,
    /// The angle of incidence where that is, in degrees.
    pub at_deg: f64,
}

impl Verdict {
    /// Whether both ways between two directions are alike.
    #[must_use]
    pub fn is_reciprocal(&self) -> bool {
        self.difference <= TOLERANCE
    }

    /// Whether no more light leaves than arrives.
    #[must_use]
    pub fn keeps_energy(&self) -> bool {
        self.most <= 1.0 + TOLERANCE
    }
}

impl CoatForm {
    /// The factor for the light at `theta_i` degrees and the viewer at `theta_o` degrees in the plane of incidence, on two sides of n,
    /// under a coat of relative index `eta`.
    #[must_use]
    pub fn factor(&self, eta: f64, theta_i: f64, theta_o: f64) -> f64 {
        let wi = direction_from_degrees(theta_i, 0.0);
        let wo = direction_from_degrees(theta_o, 180.0);
        (self.factor)(&reflectance(eta), wi, wo)
    }

    /// The share of the light from `theta_deg` that leaves a coat of relative index `eta` over a white ground.
    #[must_use]
    pub fn total(&self, eta: f64, theta_deg: f64) -> f64 {
        let f = reflectance(eta);
        let wi = direction_from_degrees(theta_deg, 0.0);
        let [polar, azimuth] = POINTS.map(gauss_legendre);
        let mut ground = 0.0;
        for (x, weight) in polar {
            let theta = 0.5 * FRAC_PI_2 * (1.0 + x);
            let (sin, cos) = theta.sin_cos();
            for (y, share) in &azimuth {
                // Half the azimuths: the other half is the same.
                let (sin_phi, cos_phi) = (0.25 * TAU * (1.0 + y)).sin_cos();
                let wo = DVec3::new(sin * cos_phi, sin * sin_phi, cos);
                ground += weight * share * sin * cos * (self.factor)(&f, wi, wo);
            }
        }
        // dtheta is pi/4 dx, dphi pi/2 dy, twice for both halves; 1/pi of the ground.
        f(wi.z) + ground * 0.25 * std::f64::consts::PI
    }

    /// The shares of [`Self::total`] at `count` angles from n to the horizon, with the angles in degrees.
    pub fn curve(&self, eta: f64, count: usize) -> impl Iterator<Item = (f64, f64)> + '_ {
        (0..count).map(move |index| {
            let theta = 90.0 * (index as f64 + 0.5) / count as f64;
            (theta, self.total(eta, theta))
        })
    }

    /// What the form does to both laws under a coat of relative index `eta`.
    #[must_use]
    pub fn verdict(&self, eta: f64) -> Verdict {
        let angles = (0..TRIED).map(|index| 2.0 * index as f64);
        let pairs = angles
            .clone()
            .flat_map(|a| angles.clone().map(move |b| (a, b)));
        let differences =
            pairs.map(|(a, b)| (self.factor(eta, a, b) - self.factor(eta, b, a)).abs());
        let totals = self.curve(eta, TRIED);
        let (at_deg, most) = totals
            .max_by(|one, other| one.1.total_cmp(&other.1))
            .unwrap_or_default();
        Verdict {
            difference: differences.fold(0.0, f64::max),
            most,
            at_deg,
        }
    }
}

/// The reflectance of a smooth coat at a cosine.
fn reflectance(eta: f64) -> impl Fn(f64) -> f64 {
    move |cos| fresnel::dielectric(cos, eta).reflectance
}

#[cfg(test)]
mod tests {
    use super::*;

    fn form(id: &str) -> &'static CoatForm {
        COAT_FORMS.iter().find(|form| form.id == id).unwrap()
    }

    #[test]
    fn two_forms_are_reciprocal_and_two_keep_energy() {
        for eta in [1.2, 1.5, 2.4] {
            let laws = ["both", "half", "light"].map(|id| {
                let verdict = form(id).verdict(eta);
                (verdict.is_reciprocal(), verdict.keeps_energy())
            });
            assert_eq!(laws, [(true, true), (true, false), (false, true)], "{eta}");
        }
    }

    #[test]
    fn the_light_alone_differs_both_ways() {
        let light = form("light");
        let [there, back] = [light.factor(1.5, 60.0, 0.0), light.factor(1.5, 0.0, 60.0)];
        assert!(
            (there - 0.911).abs() < 5e-4 && (back - 0.960).abs() < 5e-4,
            "{there} {back}"
        );
    }

    #[test]
    fn what_leaves_is_what_the_closed_forms_say() {
        // 1 - F leaves again as it came in; of the product the diffuse mean of 1 - F is left.
        let crossing = bxdf::internals::diffuse_transmittance(1.5_f64);
        for theta in [0.0, 40.0, 75.0, 88.0] {
            let f = reflectance(1.5)(direction_from_degrees(theta, 0.0).z);
            let light = form("light").total(1.5, theta);
            assert!((light - 1.0).abs() < 1e-9, "{theta}: {light}");
            let both = form("both").total(1.5, theta);
            let expected = f + (1.0 - f) * crossing;
            assert!((both - expected).abs() < 1e-5, "{theta}: {both} {expected}");
        }
    }
}
