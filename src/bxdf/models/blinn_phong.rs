//! The cosine power lobe of the half vector.
//!
//! # Source
//! Blinn 1977, "Models of Light Reflection for Computer Synthesized Pictures" (`blinn1977`), normalised so that the
//! glossy lobe reflects `specular` at normal incidence (Giesen 2009, `giesen2009`):
//! f = diffuse/pi + specular (n + 2)(n + 4) / (8 pi (2^(-n/2) + n)) (n.wh)^n.
//!
//! # Departures
//! Blinn's factors D, G and F over the cosines are left out, as is usual under this name: `cook_torrance` has them.
//!
//! # Validity
//! The glossy lobe darkens towards grazing incidence (the half vectors of a solid angle of `wi` become rarer), where real
//! surfaces brighten. Sums of diffuse and specular above 1 create energy (declared below).

use crate::common::*;
use crate::glossy::{
    DIFFUSE, LOBES, Mixture, OverDiffuse, SPECULAR, cosine_power, exceeds_one, exponent, reflected,
    shares,
};
use crate::microfacet::Pair;
use crate::optics::Spectrum;
use crate::param::ParamSet;

/// The list entry.
pub(super) static SPEC: ModelSpec = ModelSpec {
    id: "blinn_phong",
    title: "Blinn-Phong",
    source: "Blinn 1977; normalisation Giesen 2009",
    summary: "The highlight as a power of the half vector's cosine: it stretches towards the horizon as real ones do, and \
              fades there as they do not",
    lobes: LOBES,
    parameters: &[
        DIFFUSE,
        SPECULAR,
        exponent(
            "exponent",
            64.0,
            "Power of the half vector's cosine; about four times Phong's exponent for a lobe as wide",
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

struct BlinnPhong<R> {
    /// The value of the diffuse lobe.
    diffuse: Spectrum<R>,
    /// The value of the glossy lobe at its peak.
    peak: Spectrum<R>,
    exponent: R,
    shares: [R; 2],
}

fn build<R: Real>(params: &ParamSet) -> Box<dyn Scatterer<R>> {
    let diffuse = Spectrum::of(params.rgb("diffuse"));
    let specular = Spectrum::of(params.rgb("specular"));
    let n = R::of(params.number("exponent"));
    let two_to_minus_half_n = (-(n * R::ln_2() * R::of(0.5))).exp();
    let normalisation =
        (n + R::of(2.0)) * (n + R::of(4.0)) / (R::of(8.0) * R::pi() * (two_to_minus_half_n + n));
    Box::new(Mixture(BlinnPhong {
        diffuse: diffuse * R::frac_1_pi(),
        peak: specular * normalisation,
        exponent: n,
        shares: shares(specular, diffuse),
    }))
}

impl<R: Real> OverDiffuse<R> for BlinnPhong<R> {
    #[inline(always)]
    fn glossy(&self, pair: &Pair<R>) -> Spectrum<R> {
        self.peak * cosine_power::of_normal(pair.wh, self.exponent)
    }

    #[inline(always)]
    fn glossy_pdf(&self, pair: &Pair<R>) -> R {
        let Pair { wh, cos_d, .. } = *pair;
        let power = cosine_power::of_normal(wh, self.exponent);
        // (n + 1) / (2 pi) cos^n per solid angle of wh, 4 (wo.wh) of wi for one of wh.
        let of_wh = (self.exponent + R::one()) * R::of(0.5) * R::frac_1_pi() * power;
        (of_wh / (R::of(4.0) * cos_d)).saturated()
    }

    #[inline(always)]
    fn sample_glossy(&self, wo: Vec3<R>, u: [R; 2]) -> Option<Vec3<R>> {
        let azimuth = cosine_power::azimuth(u[1]);
        let wh = cosine_power::sample_about_z(self.exponent, u[0], azimuth);
        Some(reflected(wo, wh))
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

#[cfg(test)]
mod tests {
    use crate::Material;
    use crate::math::Vec3;
    use crate::math::frame::direction_from_degrees;
    use std::f64::consts::{FRAC_PI_2, PI, TAU};

    #[test]
    fn the_glossy_lobe_reflects_all_at_normal_incidence() {
        for exponent in [1.0, 2.0, 7.5, 64.0] {
            let model: Material = format!("blinn_phong:exponent={exponent}").parse().unwrap();
            let model = model.build::<f64>();
            let up = Vec3::new(0.0, 0.0, 1.0);
            let steps = 4000;
            let width = FRAC_PI_2 / f64::from(steps);
            let rho: f64 = (0..steps)
                .map(|i| {
                    let (sin, cos) = ((f64::from(i) + 0.5) * width).sin_cos();
                    model.f(up, Vec3::new(sin, 0.0, cos)).0[0] * cos * sin * TAU * width
                })
                .sum();
            // Midpoint rule, error of order width^2.
            assert!((rho - 1.0).abs() < 1e-5, "{exponent}: {rho}");
        }
    }

    #[test]
    fn the_value_is_the_published_power_of_the_half_angle() {
        let model: Material = "blinn_phong:diffuse=.1,specular=.5,exponent=20"
            .parse()
            .unwrap();
        let wi = direction_from_degrees(70.0, 0.0).into();
        let f = model
            .build::<f64>()
            .f(direction_from_degrees(-40.0, 0.0).into(), wi)
            .0[0];
        let peak = 22.0 * 24.0 / (8.0 * PI * (2_f64.powi(-10) + 20.0));
        let expected = 0.1 / PI + 0.5 * peak * 15_f64.to_radians().cos().powi(20);
        assert!((f / expected - 1.0).abs() < 1e-14, "{f} {expected}");
    }
}
