//! The cosine power lobe about the mirror direction.
//!
//! # Source
//! Phong 1975 (`phong1975`), in the form that obeys physics of Lafortune & Willems 1994, "Using the Modified Phong
//! Reflectance Model for Physically Based Rendering" (`lafortune1994`): f = diffuse/pi + specular (n + 2)/(2 pi) cos^n,
//! the angle being that between `wi` and the mirror direction of `wo`.
//!
//! # Departures
//! None in value. cos^n comes from the distance of the two directions where they are near (see `glossy::cosine_power`).
//!
//! # Validity
//! The glossy lobe reflects `specular` at normal incidence and about cos(theta) of that at the angle theta (half of it at
//! 60 degrees, next to nothing at grazing incidence, where real surfaces brighten); what falls below the horizon is lost.
//! The authors require diffuse + specular <= 1; larger sums create energy (declared below).

use crate::common::*;
use crate::glossy::{
    DIFFUSE, LOBES, Mixture, OverDiffuse, SPECULAR, cosine_power, exceeds_one, exponent, shares,
};
use crate::microfacet::Pair;
use crate::optics::Spectrum;
use crate::param::ParamSet;

/// The list entry.
pub(super) static SPEC: ModelSpec = ModelSpec {
    id: "phong",
    title: "Phong",
    source: "Phong 1975; Lafortune & Willems 1994, the modified, normalised model",
    summary: "A highlight as a power of a cosine about the mirror direction: round at every angle, where real highlights \
              stretch towards the horizon",
    lobes: LOBES,
    parameters: &[
        DIFFUSE,
        SPECULAR,
        exponent(
            "exponent",
            32.0,
            "Power of the cosine: the larger, the narrower the lobe",
        ),
    ],
    properties: Properties {
        declarations: &[Declaration {
            law: Law::Energy,
            parameters: "diffuse=1,specular=1",
            theta_deg: 0.0,
            note: "rho_dh is diffuse + specular at normal incidence: the two are free, as published, and may exceed 1",
            when: exceeds_one,
        }],
        ..Properties::PLAIN
    },
    validate: ModelSpec::any,
    builders: builders!(build),
    // A power of a cosine without a Fresnel factor: no model here has a cheaper highlight.
    stand_ins: &[],
};

struct Phong<R> {
    /// The value of the diffuse lobe.
    diffuse: Spectrum<R>,
    specular: Spectrum<R>,
    exponent: R,
    shares: [R; 2],
}

fn build<R: Real>(params: &ParamSet) -> Box<dyn Scatterer<R>> {
    let diffuse = Spectrum::of(params.rgb("diffuse"));
    let specular = Spectrum::of(params.rgb("specular"));
    Box::new(Mixture(Phong {
        diffuse: diffuse * R::frac_1_pi(),
        specular,
        exponent: R::of(params.number("exponent")),
        shares: shares(specular, diffuse),
    }))
}

impl<R: Real> Phong<R> {
    /// cos^n / (2 pi), the angle being that of wi with the mirror direction of wo.
    #[inline(always)]
    fn power(&self, pair: &Pair<R>) -> R {
        let mirror = pair.wo.mirrored_about_normal();
        cosine_power::between(pair.wi, mirror, self.exponent) * R::of(0.5) * R::frac_1_pi()
    }
}

impl<R: Real> OverDiffuse<R> for Phong<R> {
    #[inline(always)]
    fn glossy(&self, pair: &Pair<R>) -> Spectrum<R> {
        self.specular * ((self.exponent + R::of(2.0)) * self.power(pair))
    }

    #[inline(always)]
    fn glossy_pdf(&self, pair: &Pair<R>) -> R {
        (self.exponent + R::one()) * self.power(pair)
    }

    #[inline(always)]
    fn sample_glossy(&self, wo: Vec3<R>, u: [R; 2]) -> Option<Vec3<R>> {
        let azimuth = cosine_power::azimuth(u[1]);
        let w = cosine_power::sample_about_z(self.exponent, u[0], azimuth);
        Some(tilted(w, wo.mirrored_about_normal()))
    }

    #[inline(always)]
    fn diffuse(&self, _pair: &Pair<R>) -> Spectrum<R> {
        self.diffuse
    }

    #[inline(always)]
    fn shares(&self, _wo: Vec3<R>) -> [R; 2] {
        self.shares
    }
}

/// `w` turned by the rotation that takes +z to the unit vector `axis` above the surface by the shortest way.
#[inline(always)]
fn tilted<R: Real>(w: Vec3<R>, axis: Vec3<R>) -> Vec3<R> {
    let across = axis.x * w.x + axis.y * w.y;
    let along = w.z - across / (R::one() + axis.z);
    Vec3::new(
        w.x + axis.x * along,
        w.y + axis.y * along,
        axis.z * w.z - across,
    )
}

#[cfg(test)]
mod tests {
    use super::tilted;
    use crate::Material;
    use crate::math::Vec3;
    use crate::math::frame::direction_from_degrees;
    use std::f64::consts::PI;

    #[test]
    fn the_lobe_is_the_published_power_about_the_mirror_direction() {
        let phong: Material = "phong:diffuse=.2,specular=.6,exponent=50".parse().unwrap();
        let phong = phong.build::<f64>();
        let wo = direction_from_degrees(-40.0, 0.0).into();
        for off in [0.0_f64, 5.0, 12.0] {
            let f = phong
                .f(wo, direction_from_degrees(40.0 + off, 0.0).into())
                .0[0];
            let expected = 0.2 / PI + 0.6 * 52.0 / (2.0 * PI) * off.to_radians().cos().powi(50);
            assert!((f / expected - 1.0).abs() < 1e-14, "{off}: {f}");
        }
    }

    #[test]
    fn lobes_sum_to_the_value() {
        let phong: Material = "phong:diffuse=.3,exponent=5".parse().unwrap();
        let phong = phong.build::<f64>();
        let wo = direction_from_degrees(130.0, 10.0).into();
        let wi = direction_from_degrees(140.0, 200.0).into();
        let [glossy, diffuse] = [0, 1].map(|index| phong.lobe_f(index, wo, wi));
        assert_eq!(phong.f(wo, wi), glossy + diffuse);
        assert!(glossy.0[0] > 0.0 && diffuse.0[0] == 0.3 * std::f64::consts::FRAC_1_PI);
    }

    #[test]
    fn tilting_is_a_rotation_that_takes_z_to_the_axis() {
        let axis: Vec3<f64> = direction_from_degrees(89.0, 200.0).into();
        let up = Vec3::new(0.0, 0.0, 1.0);
        assert_eq!(tilted(up, axis), axis);
        let (a, b) = (Vec3::new(0.6, 0.0, 0.8), Vec3::new(0.0, -0.8, 0.6));
        let (a_tilted, b_tilted) = (tilted(a, axis), tilted(b, axis));
        assert!((a_tilted.length_squared() - 1.0).abs() < 1e-15);
        assert!((a_tilted.dot(b_tilted) - a.dot(b)).abs() < 1e-15);
        assert!((a_tilted.dot(axis) - a.z).abs() < 1e-15);
    }
}
