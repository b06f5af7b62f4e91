//! The same value as other programs and papers return it.

use std::f64::consts::PI;

/// A value as somebody has it.
#[derive(Clone, Debug, PartialEq)]
pub struct Convention {
    /// What it is, in TeX.
    pub formula: &'static str,
    /// Who has it so, without a full stop.
    pub whose: &'static str,
    /// Its unit; empty for a pure number.
    pub unit: &'static str,
    /// Its channels.
    pub rgb: [f64; 3],
}

/// What a value is converted by.
#[derive(Clone, Copy, Debug)]
pub struct Value {
    /// f in 1/sr; of a delta its weight.
    pub rgb: [f64; 3],
    /// The same with light and viewer exchanged.
    pub swapped: [f64; 3],
    /// |cos(theta_i)|.
    pub cos: f64,
    /// The index of refraction on the light's side over that on the viewer's.
    pub index: f64,
    /// Whether it is a delta's.
    pub is_delta: bool,
}

impl Value {
    /// The value by each convention.
    #[must_use]
    pub fn conventions(&self) -> Vec<Convention> {
        let times = |factor: f64| self.rgb.map(|x| x * factor);
        let of = |formula, whose, unit, rgb| Convention {
            formula,
            whose,
            unit,
            rgb,
        };
        let square = self.index * self.index;
        if self.is_delta {
            return vec![
                of(
                    r"\lobe{w}",
                    "Mitsuba's sample, whose weight it is; this program's deltas",
                    "",
                    self.rgb,
                ),
                of(
                    r"\lobe{w} / |\light{\mu_i}|",
                    "pbrt's Sample_f, so that times the cosine it is the weight again",
                    "",
                    times(1.0 / self.cos),
                ),
                of(
                    r"\lobe{w}\,e^2",
                    "TransportMode::Importance of pbrt and Mitsuba: the share of the flux, as radiance alone carries 1/e^2",
                    "",
                    times(square),
                ),
            ];
        }
        vec![
            of(
                r"\lobe{f}(\viewer{\omega_o}, \light{\omega_i})",
                "This program, and pbrt's f: radiance out over irradiance in, without the cosine",
                "1/sr",
                self.rgb,
            ),
            of(
                r"\lobe{f}\,|\light{\mu_i}|",
                "Mitsuba's eval; in pbrt f times AbsDot(wi, n)",
                "1/sr",
                times(self.cos),
            ),
            of(
                r"\lobe{f}(\light{\omega_i}, \viewer{\omega_o})",
                "Papers that call the light o and the viewer i: the same where the surface is reciprocal",
                "1/sr",
                self.swapped,
            ),
            of(
                r"\lobe{f}\,e^2",
                "TransportMode::Importance of pbrt and Mitsuba: without the 1/e^2 of radiance across the surface",
                "1/sr",
                times(square),
            ),
            of(
                r"\pi\,\lobe{f}",
                "The reflectance factor of measurements: 1 is a white Lambertian surface. Also called the normalised BRDF",
                "",
                times(PI),
            ),
        ]
    }
}
