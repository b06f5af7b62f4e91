//! An anisotropic Phong lobe with Fresnel's behaviour over a diffuse lobe that gives way to it.
//!
//! # Source
//! Ashikhmin & Shirley 2000, "An Anisotropic Phong BRDF Model" (`ashikhmin2000`): with wh the half vector and
//! e = (nx hx^2 + ny hy^2) / (hx^2 + hy^2),
//! glossy = sqrt((nx + 1)(ny + 1)) / (8 pi) (n.wh)^e F(wo.wh) / ((wo.wh) max(mu_o, mu_i)), F Schlick's from `specular`;
//! diffuse = 28/(23 pi) `diffuse` (1 - `specular`) (1 - (1 - mu_o/2)^5) (1 - (1 - mu_i/2)^5).
//!
//! # Departures
//! None in value. (n.wh)^e / max(mu_o, mu_i) is written with the power e - 1, since 2 (wo.wh) (n.wh) = mu_o + mu_i: the
//! quotient of two numbers that both underflow at grazing directions is gone. The paper leaves the choice between the two
//! lobes open: it follows what each reflects of `wo`, Schlick's factor for the glossy one.
//!
//! # Validity
//! The diffuse lobe gets no more than the glossy one lets through: energy is kept at every angle and exponent. Wide glossy
//! lobes lose much below the horizon: at exponents 1 and specular 1 a quarter is reflected at normal incidence, half at
//! grazing; so do narrow ones (half) where the light comes within their width of the horizon.

use super::blinn_phong;
use crate::common::*;
use crate::glossy::cosine_power::{azimuth, ln_cos_over_sin2, sample_about_z};
use crate::glossy::{LOBES, Mixture, OverDiffuse, exponent, reflected, shares};
use crate::microfacet::Pair;
use crate::optics::{Spectrum, fresnel};
use crate::param::ParamSet;

/// The list entry.
pub(super) static SPEC: ModelSpec = ModelSpec {
    id: "ashikhmin_shirley",
    title: "Ashikhmin-Shirley",
    source: "Ashikhmin & Shirley 2000, An Anisotropic Phong BRDF Model",
    summary: "Polished plastic or wood: the diffuse colour gives way to a white reflection towards the horizon; two \
              exponents make the highlight a blade",
    lobes: LOBES,
    parameters: &[
        ParamSpec::rgb(
            "diffuse",
            [0.5; 3],
            "Share that the diffuse lobe reflects of the light the glossy one lets through, per channel",
        ),
        ParamSpec::rgb(
            "specular",
            [0.05; 3],
            "Reflectance of the glossy lobe at normal incidence, per channel; it tends to 1 at grazing angles",
        ),
        exponent(
            "exponent_x",
            100.0,
            "Power of the half vector's cosine along s: the larger, the narrower",
        ),
        exponent(
            "exponent_y",
            100.0,
            "Power of the half vector's cosine along t: the larger, the narrower",
        ),
    ],
    properties: Properties {
        is_isotropic: |params| params.number("exponent_x") == params.number("exponent_y"),
        ..Properties::PLAIN
    },
    validate: ModelSpec::any,
    builders: builders!(build),
    stand_ins: &[
        StandIn {
            name: "One exponent for two",
            lost: "The highlight no longer turns with the surface: a blade becomes a round highlight with a peak as high",
            replace: |params| {
                let (x, y) = (params.number("exponent_x"), params.number("exponent_y"));
                // sqrt((x + 1)(y + 1)) is the height of the peak.
                let both = Value::Number(if x == y {
                    x
                } else {
                    (x * y + x + y + 1.0).sqrt() - 1.0
                });
                params.replaced(&[("exponent_x", both), ("exponent_y", both)])
            },
        },
        StandIn {
            name: "Blinn-Phong for both lobes",
            lost: "The highlight does not grow towards the horizon, nor does the diffuse colour give way to it there; where \
                   the exponents differ, it is round",
            replace: |params| {
                let (x, y) = (params.number("exponent_x"), params.number("exponent_y"));
                let specular = params.rgb("specular");
                let [r, g, b] = params.rgb("diffuse");
                let [r_left, g_left, b_left] = specular.map(|specular| 1.0 - specular);
                blinn_phong::SPEC.text_at(&[
                    ("diffuse", Value::Rgb([r * r_left, g * g_left, b * b_left])),
                    ("specular", Value::Rgb(specular)),
                    ("exponent", Value::Number((x * y).sqrt())),
                ])
            },
        },
    ],
};

struct AshikhminShirley<R> {
    specular: Spectrum<R>,
    /// `diffuse` (1 - `specular`).
    diffuse: Spectrum<R>,
    exponent_x: R,
    exponent_y: R,
    /// sqrt((nx + 1)(ny + 1)) / (2 pi): the density of half vectors at the normal.
    peak: R,
}

fn build<R: Real>(params: &ParamSet) -> Box<dyn Scatterer<R>> {
    let one = R::one();
    let specular = Spectrum::of(params.rgb("specular"));
    let (nx, ny) = (
        R::of(params.number("exponent_x")),
        R::of(params.number("exponent_y")),
    );
    Box::new(Mixture(AshikhminShirley {
        specular,
        diffuse: Spectrum::of(params.rgb("diffuse")) * specular.map(|rs| one - rs),
        exponent_x: nx,
        exponent_y: ny,
        peak: ((nx + one) * (ny + one)).sqrt() * R::of(0.5) * R::frac_1_pi(),
    }))
}

/// 1 - (1 - mu/2)^5, as mu/2 times the geometric sum: without cancellation at grazing angles.
#[inline(always)]
fn let_through<R: Real>(mu: R) -> R {
    let (one, x) = (R::one(), mu * R::of(0.5));
    let m = one - x;
    x * (one + m * (one + m * (one + m * (one + m))))
}

impl<R: Real> AshikhminShirley<R> {
    /// (n.wh)^(e - 1).
    #[inline(always)]
    fn power_less_one(&self, wh: Vec3<R>) -> R {
        let one = R::one();
        let (ln_cos_over_sin2, _) = ln_cos_over_sin2(wh);
        let weighted =
            (self.exponent_x - one) * (wh.x * wh.x) + (self.exponent_y - one) * (wh.y * wh.y);
        (weighted * ln_cos_over_sin2).exp()
    }
}

impl<R: Real> OverDiffuse<R> for AshikhminShirley<R> {
    #[inline(always)]
    fn glossy(&self, pair: &Pair<R>) -> Spectrum<R> {
        let Pair { wo, wi, wh, cos_d } = *pair;
        // peak/4 (n.wh)^(e-1) times (n.wh) / ((wo.wh) max(mu_o, mu_i)).
        let power = self.peak * R::of(0.125) * self.power_less_one(wh);
        let cosines = (wo.z + wi.z) / wo.z.max(wi.z);
        let lobe = (power * cosines / cos_d / cos_d).saturated();
        self.specular.map(|f0| fresnel::schlick(cos_d, f0)) * lobe
    }

    #[inline(always)]
    fn glossy_pdf(&self, pair: &Pair<R>) -> R {
        let Pair { wh, cos_d, .. } = *pair;
        let of_wh = self.peak * self.power_less_one(wh) * wh.z;
        (of_wh / (R::of(4.0) * cos_d)).saturated()
    }

    #[inline(always)]
    fn sample_glossy(&self, wo: Vec3<R>, u: [R; 2]) -> Option<Vec3<R>> {
        // Equal areas of the ellipse with these half axes: tan(phi) = sqrt((nx + 1)/(ny + 1)) tan(2 pi u).
        let (cos, sin) = azimuth(u[1]);
        let (ax, ay) = (self.exponent_x + R::one(), self.exponent_y + R::one());
        let (x, y) = (cos / ax.sqrt(), sin / ay.sqrt());
        let radius = (x * x + y * y).sqrt();
        let (cos_phi, sin_phi) = (x / radius, y / radius);
        let e = self.exponent_x * cos_phi * cos_phi + self.exponent_y * sin_phi * sin_phi;
        Some(reflected(wo, sample_about_z(e, u[0], (cos_phi, sin_phi))))
    }

    #[inline(always)]
    fn diffuse(&self, pair: &Pair<R>) -> Spectrum<R> {
        let normalisation = R::of(28.0) / R::of(23.0) * R::frac_1_pi();
        self.diffuse * (normalisation * let_through(pair.wo.z) * let_through(pair.wi.z))
    }

    #[inline(always)]
    fn shares(&self, wo: Vec3<R>) -> [R; 2] {
        let glossy = self.specular.map(|f0| fresnel::schlick(wo.z, f0));
        // The diffuse lobe's albedo exactly: 28/23 is one over the cosine-weighted mean of the last factor.
        shares(glossy, self.diffuse * let_through(wo.z))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Material;
    use crate::math::frame::direction_from_degrees;
    use std::f64::consts::PI;

    #[test]
    fn the_value_is_the_published_one() {
        let model: Material =
            "ashikhmin_shirley:diffuse=.5,specular=.2,exponent_x=40,exponent_y=10"
                .parse()
                .unwrap();
        let model = model.build::<f64>();
        // In the plane of incidence along t: the half vector stands at 10 degrees, 50 degrees from both.
        let wo = direction_from_degrees(60.0, 270.0).into();
        let wi = direction_from_degrees(40.0, 90.0).into();
        let cos = |degrees: f64| degrees.to_radians().cos();
        let fresnel = 0.2 + 0.8 * (1.0 - cos(50.0)).powi(5);
        let glossy = (41.0_f64 * 11.0).sqrt() / (8.0 * PI) * cos(10.0).powi(10) * fresnel
            / (cos(50.0) * cos(40.0));
        let diffuse = 28.0 * 0.5 / (23.0 * PI)
            * 0.8
            * (1.0 - (1.0 - cos(60.0) / 2.0).powi(5))
            * (1.0 - (1.0 - cos(40.0) / 2.0).powi(5));
        for (index, expected) in [glossy, diffuse].into_iter().enumerate() {
            let found = model.lobe_f(index, wo, wi).0[0];
            assert!((found / expected - 1.0).abs() < 1e-14, "{index}: {found}");
        }
        assert!((model.f(wo, wi).0[0] / (glossy + diffuse) - 1.0).abs() < 1e-14);
    }

    #[test]
    fn the_diffuse_lobe_reflects_what_the_shares_say() {
        let steps = 2000;
        let sum: f64 = (0..steps)
            .map(|i| {
                let mu = (f64::from(i) + 0.5) / f64::from(steps);
                2.0 * mu * let_through(mu) / f64::from(steps)
            })
            .sum();
        // Midpoint rule.
        assert!((28.0 / 23.0 * sum - 1.0).abs() < 1e-6, "{sum}");
        assert!((let_through(1e-9_f64) / 2.5e-9 - 1.0).abs() < 2e-9);
    }
}
