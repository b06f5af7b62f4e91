//! Lunar soil: grains that scatter light among one another, brightest with the light behind the viewer.
//!
//! # Source
//! Hapke 1981, "Bidirectional Reflectance Spectroscopy: 1. Theory" (`hapke1981`); Hapke 1986 for the opposition surge
//! (`hapke1986`); Hapke 2002 for the approximation of Chandrasekhar's H (`hapke2002`). The phase function is that of
//! Henyey & Greenstein 1941 (`henyey1941`). The papers' w, b, B0, h are the four parameters in this order.
//!
//! # Departures
//! No macroscopic roughness, no coherent backscatter. The sign of `asymmetry` is that of the phase angle's own: with
//! cos(g) = wi.wo it is negative where grains scatter back. H H - 1 is summed from H - 1, which keeps its digits at small
//! albedo; the phase function from |wi - wo| or |wi + wo|, whichever is small at its peak.
//!
//! # Validity
//! Repeated scattering is taken as isotropic, whatever the phase function, and the surge and the phase function multiply
//! the first alone: at albedo 1 more light leaves than arrives, 1.083 times as much at the defaults, 2.56 times at the
//! worst corner of the ranges (declared below; at albedo .95 and the defaults .82). Where both directions graze, the value
//! grows without bound, as published; it saturates at the largest number. Samples mix the phase function, where it is
//! far from even, with uniform and cosine directions that follow mu_i / (mu_i + mu_o): weights stay bounded, the surge
//! raising them by no more than 1 + B0.

use crate::common::*;
use crate::math::warp;
use crate::optics::Spectrum;
use crate::param::{ParamSet, Scale};
use crate::{both_above, reflected_direction, sample_reflection};

/// The list entry.
pub(super) static SPEC: ModelSpec = ModelSpec {
    id: "hapke",
    title: "Hapke",
    source: "Hapke 1981, 1986, 2002, Bidirectional Reflectance Spectroscopy",
    summary: "The full moon: no darkening towards the rim, and a surge of brightness when the light stands behind the viewer",
    lobes: &[Lobe::reflection(Category::RetroReflective)],
    parameters: &[
        ParamSpec::rgb(
            "single_scattering_albedo",
            [0.3; 3],
            "Share of the light that a single grain scatters, per channel; the rest it absorbs",
        ),
        ParamSpec::number(
            "asymmetry",
            -0.2,
            "Where a single grain sends the light: negative back to its source, 0 everywhere alike, positive onwards",
        )
        .hard(-0.9, 0.9),
        ParamSpec::number(
            "opposition_strength",
            1.0,
            "Height of the surge with the light behind the viewer, where grains hide their own shadows",
        )
        .hard(0.0, 3.0),
        ParamSpec::number(
            "opposition_width",
            0.06,
            "Width of that surge, as the tangent of half the angle between light and viewer",
        )
        .hard(0.001, 1.0)
        .scale(Scale::Logarithmic),
    ],
    properties: Properties {
        declarations: &[
            Declaration {
                law: Law::Energy,
                parameters: "single_scattering_albedo=1",
                theta_deg: 0.0,
                note: "rho_dh reaches 1.083: phase function and surge multiply the first scattering, and the repeated one \
                       gives nothing back for it",
                when: Declaration::always,
            },
            Declaration {
                law: Law::Energy,
                parameters: "single_scattering_albedo=1,asymmetry=-.9",
                theta_deg: 0.0,
                note: "rho_dh reaches 1.505: half the light returns at once, and as much as from even grains thereafter",
                when: Declaration::always,
            },
            Declaration {
                law: Law::Energy,
                parameters: "single_scattering_albedo=1,opposition_width=1",
                theta_deg: 89.9,
                note: "rho_dh reaches 1.273: a surge this wide multiplies the first scattering everywhere",
                when: Declaration::always,
            },
        ],
        ..Properties::PLAIN
    },
    validate: ModelSpec::any,
    builders: builders!(build),
    stand_ins: &[
        StandIn {
            name: "Without opposition surge",
            lost: "The surge of brightness with the light behind the viewer",
            replace: |params| params.replaced(&[("opposition_strength", Value::Number(0.0))]),
        },
        StandIn {
            name: "Isotropic grains",
            lost: "The preference of a grain for back or forward: the first scattering goes everywhere alike",
            replace: |params| params.replaced(&[("asymmetry", Value::Number(0.0))]),
        },
    ],
};

/// What becomes of its one lobe when light is counted by how often it is scattered.
const LOBES: &[Lobe] = &[
    Lobe::reflection(Category::RetroReflective).named("single scattering"),
    Lobe::reflection(Category::RetroReflective).named("multiple scattering"),
];

struct Hapke<R> {
    albedo: Spectrum<R>,
    /// The paper's r0, the diffusive reflectance of each channel.
    r0: Spectrum<R>,
    asymmetry: R,
    strength: R,
    width: R,
    /// The share of samples for the phase function, before the angle of a forward one counts.
    phase_share: R,
}

fn build<R: Real>(params: &ParamSet) -> Box<dyn Scatterer<R>> {
    let albedo = Spectrum::of(params.rgb("single_scattering_albedo"));
    let asymmetry = R::of(params.number("asymmetry"));
    let r0 = albedo.map(|w| {
        let gamma = (R::one() - w).sqrt_clamped();
        (R::one() - gamma) / (R::one() + gamma)
    });
    let mut model = Hapke {
        albedo,
        r0,
        asymmetry,
        strength: R::of(params.number("opposition_strength")),
        width: R::of(params.number("opposition_width")),
        phase_share: R::zero(),
    };
    // The more even the phase function and the more light is scattered repeatedly (1 single to H H - 1 repeated parts, at
    // the middle cosine), the less is it worth a lobe of its own.
    let middle = R::of(0.5);
    let repeated = model.repeated(middle, middle).max_channel();
    model.phase_share = asymmetry.abs() / (R::one() + repeated);
    Box::new(model)
}

/// H - 1 at the cosine `mu`: Hapke 2002, eq. 13, with 1/(1 - y) - 1 taken as y / (1 - y).
#[inline(always)]
fn h_minus_1<R: Real>(mu: R, w: R, r0: R) -> R {
    let half = R::of(0.5);
    // ln((1 + mu) / mu): both parts are positive, and 1/mu may overflow.
    let log = mu.ln_1p() - mu.ln();
    let y = w * mu * (r0 + (half - r0 * mu) * log);
    y / (R::one() - y)
}

impl<R: Real> Hapke<R> {
    /// H(mu_i) H(mu_o) - 1: what is scattered more than once, in units of what an isotropic grain scatters once.
    #[inline(always)]
    fn repeated(&self, mu_i: R, mu_o: R) -> Spectrum<R> {
        let at = |mu: R| self.albedo.zip(self.r0, |w, r0| h_minus_1(mu, w, r0));
        at(mu_i).zip(at(mu_o), |i, o| (i + o) + i * o)
    }

    /// The phase function, whose mean over the sphere is 1. `d2`, `s2`: the squares of |wi - wo| and |wi + wo|.
    #[inline(always)]
    fn phase(&self, d2: R, s2: R) -> R {
        let (one, x) = (R::one(), self.asymmetry.abs());
        // 1 + 2 x cos(g) + x^2, with 1 -+ cos(g) = |wi -+ wo|^2 / 2.
        let off_peak = if self.asymmetry < R::zero() { d2 } else { s2 };
        let q = (one - x).sqr() + x * off_peak;
        (one - x) * (one + x) / (q * q.sqrt())
    }

    /// What is scattered once: the surge of opposition times the phase function.
    #[inline(always)]
    fn single(&self, wo: Vec3<R>, wi: Vec3<R>) -> R {
        let (d2, s2) = chords(wo, wi);
        // B0 / (1 + tan(g/2) / h) with tan(g/2) = |wi - wo| / |wi + wo|: the two are never 0 together.
        let near = self.width * s2.sqrt();
        let surge = self.strength * near / (near + d2.sqrt());
        (R::one() + surge) * self.phase(d2, s2)
    }

    /// f in 1/sr for what is `scattered` by grains in all, relative to an isotropic one.
    #[inline(always)]
    fn value(&self, wo: Vec3<R>, wi: Vec3<R>, scattered: Spectrum<R>) -> Spectrum<R> {
        let scale = R::of(0.25) * R::frac_1_pi() / (wi.z + wo.z);
        (self.albedo * scattered).map(|x| (x * scale).saturated())
    }

    /// The density of [`Self::sample_phase`], in 1/sr.
    #[inline(always)]
    fn phase_pdf(&self, wo: Vec3<R>, wi: Vec3<R>) -> R {
        let (d2, s2) = chords(wo, wi);
        self.phase(d2, s2) * R::of(0.25) * R::frac_1_pi()
    }

    /// The shares of the phase function and of the cosine among the samples at `mu_o`, the latter of what is left.
    ///
    /// A forward phase function reaches above the surface only from grazing directions. mu_i / (mu_i + mu_o) is at most
    /// (1 + mu_i mu_o) / (1 + mu_o)^2, the harmonic and the arithmetic mean of 1 and mu_i.
    #[inline(always)]
    fn shares(&self, mu_o: R) -> (R, R) {
        let reach = if self.asymmetry < R::zero() {
            R::one()
        } else {
            (R::one() - mu_o).max(R::zero())
        };
        (self.phase_share * reach, mu_o / (R::of(2.0) + mu_o))
    }

    /// A direction by the phase function about `wo`, which is above the surface: back along it or onwards.
    #[inline(always)]
    fn sample_phase(&self, wo: Vec3<R>, u: [R; 2]) -> Vec3<R> {
        warp::henyey_greenstein(wo, -self.asymmetry, u)
    }
}

/// The squares of |wi - wo| and |wi + wo|.
#[inline(always)]
fn chords<R: Real>(wo: Vec3<R>, wi: Vec3<R>) -> (R, R) {
    ((wi - wo).length_squared(), (wi + wo).length_squared())
}

impl<R: Real> Bxdf<R> for Hapke<R> {
    #[inline(always)]
    fn f(&self, wo: Vec3<R>, wi: Vec3<R>) -> Spectrum<R> {
        let Some((wo, wi)) = both_above(wo, wi) else {
            return Spectrum::black();
        };
        let single = self.single(wo, wi);
        let scattered = self.repeated(wi.z, wo.z).map(|repeated| single + repeated);
        self.value(wo, wi, scattered)
    }

    #[inline(always)]
    fn pdf(&self, wo: Vec3<R>, wi: Vec3<R>) -> R {
        let Some((wo, wi)) = both_above(wo, wi) else {
            return R::zero();
        };
        let (phase_share, cosine_share) = self.shares(wo.z);
        let phase = self.phase_pdf(wo, wi);
        let broad = warp::mixed_hemisphere_pdf(cosine_share, wi.z);
        phase_share * phase + (R::one() - phase_share) * broad
    }

    #[inline(always)]
    fn sample_f(&self, wo: Vec3<R>, uc: R, u: [R; 2]) -> Option<Sample<R>> {
        sample_reflection(
            self,
            wo,
            #[inline(always)]
            |wo| {
                let (phase_share, cosine_share) = self.shares(wo.z);
                if uc < phase_share {
                    Some(self.sample_phase(wo, u))
                } else {
                    let rest = (uc - phase_share) / (R::one() - phase_share);
                    Some(warp::mixed_hemisphere(cosine_share, rest, u))
                }
            },
        )
    }
}

impl<R: Real> Lobes<R> for Hapke<R> {
    fn lobes(&self) -> &[Lobe] {
        LOBES
    }

    #[inline(always)]
    fn lobe_f(&self, index: usize, wo: Vec3<R>, wi: Vec3<R>) -> Spectrum<R> {
        let Some((wo, wi)) = both_above(wo, wi) else {
            return Spectrum::black();
        };
        let scattered = match index {
            0 => Spectrum::grey(self.single(wo, wi)),
            _ => self.repeated(wi.z, wo.z),
        };
        self.value(wo, wi, scattered)
    }

    #[inline(always)]
    fn lobe_pdf(&self, index: usize, wo: Vec3<R>, wi: Vec3<R>) -> R {
        let Some((wo, wi)) = both_above(wo, wi) else {
            return R::zero();
        };
        match index {
            0 => self.phase_pdf(wo, wi),
            _ => warp::uniform_hemisphere_pdf(),
        }
    }

    #[inline(always)]
    fn sample_lobe(&self, index: usize, wo: Vec3<R>, u: [R; 2]) -> Option<Vec3<R>> {
        reflected_direction(
            wo,
            #[inline(always)]
            |wo| match index {
                0 => Some(self.sample_phase(wo, u)),
                _ => Some(warp::uniform_hemisphere(u)),
            },
        )
    }
}

impl<R: Real> Scatterer<R> for Hapke<R> {
    loops!(R, if R::FUNCTIONS_VECTORISE);
}

#[cfg(test)]
mod tests {
    use super::h_minus_1;
    use crate::Material;
    use crate::math::Vec3;
    use crate::math::frame::direction_from_degrees;
    use std::f64::consts::PI;

    fn f(material: &str, theta_o: f64, theta_i: f64) -> f64 {
        let direction = |theta| direction_from_degrees(theta, 0.0).into();
        let material = material.parse::<Material>().unwrap();
        let bxdf = material.build::<f64>();
        bxdf.f(direction(theta_o), direction(theta_i)).0[0]
    }

    #[test]
    fn h_is_within_a_percent_of_chandrasekhars() {
        // `chandrasekhar1960`, table XI, conservative isotropic scattering.
        for (mu, exact) in [(0.5_f64, 2.0128), (1.0, 2.9078)] {
            let h = 1.0 + h_minus_1(mu, 1.0, 1.0);
            assert!((h / exact - 1.0).abs() < 0.01, "{mu}: {h}");
        }
        assert_eq!(h_minus_1(0.5, 1.0, 1.0), 1.0, "ln 3 has no part in it");
        assert!(h_minus_1(5e-324_f64, 1.0, 1.0).abs() < 1e-300);
    }

    #[test]
    fn dark_isotropic_grains_are_lommel_and_seeligers() {
        let dark = "hapke:single_scattering_albedo=.000001,asymmetry=0,opposition_strength=0";
        let found = f(dark, 0.0, 60.0) / 1e-6;
        assert!((found * 4.0 * PI * 1.5 - 1.0).abs() < 1e-5);
    }

    #[test]
    fn the_surge_doubles_the_light_of_dark_grains() {
        let with = |strength| {
            let dark =
                format!("hapke:single_scattering_albedo=.000001,opposition_strength={strength}");
            f(&dark, 40.0, 40.0)
        };
        assert!((with(1.0) / with(0.0) - 2.0).abs() < 1e-5);
        // Half of it is left where tan(g/2) is the width.
        let g = 2.0 * 0.06_f64.atan().to_degrees();
        let at = |strength| {
            let dark =
                format!("hapke:single_scattering_albedo=.000001,opposition_strength={strength}");
            f(&dark, 40.0, 40.0 - g)
        };
        assert!((at(1.0) / at(0.0) - 1.5).abs() < 1e-5);
    }

    #[test]
    fn the_phase_function_has_the_printed_form() {
        for (x, theta_i) in [(-0.9_f64, -50.0_f64), (0.7, 80.0)] {
            let dark = format!(
                "hapke:single_scattering_albedo=.000001,opposition_strength=0,asymmetry={x}"
            );
            let cos_g = (30.0 - theta_i).to_radians().cos();
            let phase = (1.0 - x * x) / (1.0 + 2.0 * x * cos_g + x * x).powf(1.5);
            let mu = 30_f64.to_radians().cos() + theta_i.to_radians().cos();
            let found = f(&dark, 30.0, theta_i) / 1e-6 * 4.0 * PI * mu;
            // Repeated scattering adds of the order of the albedo, over a phase function of .03.
            assert!((found / phase - 1.0).abs() < 1e-4, "{x}: {found} {phase}");
        }
    }

    #[test]
    fn weights_are_bounded_whatever_the_angle() {
        for asymmetry in ["-0.9", "-0.2", "0", "0.9"] {
            let soil: Material = format!("hapke:asymmetry={asymmetry}").parse().unwrap();
            let model = soil.build::<f64>();
            for theta in [0.0, 45.0, 80.0, 89.0, 89.9999, 90.0 - 1e-9] {
                let wo: Vec3<f64> = direction_from_degrees(theta, 30.0).into();
                for i in 0..512 {
                    let at = |n: i32| (f64::from(i / n % 8) + 0.5) / 8.0;
                    let weight = model
                        .sample_f(wo, at(64), [at(8), at(1)])
                        .map_or(0.0, |s| s.weight().0[0]);
                    // w (1 + B0) over the phase function's share, and what is scattered repeatedly: below 5 here.
                    assert!(weight < 5.0, "{asymmetry} {theta}: {weight}");
                }
            }
        }
    }
}
