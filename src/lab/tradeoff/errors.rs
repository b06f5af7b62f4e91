//! How far one choice is from another: in value, in reflectance, and to the eye.

use std::f64::consts::FRAC_1_PI;

use glam::DVec3;
use palette::color_difference::Ciede2000 as _;
use palette::white_point::D65;
use palette::{FromColor as _, Lab, LinSrgb};
use serde::{Serialize, Serializer};

use super::probe::Probe;
use crate::analysis::statistics::Random;

/// Below this part of a diffuse lobe of the same reflectance a value counts as this part in the largest relative error:
/// far out in a lobe's tail ratios say nothing.
const FLOOR: f64 = 1e-3;

/// Rounds in which the largest error is followed to where it is largest, and directions tried in each.
const ROUNDS: u32 = 12;
const TRIES: usize = 64;

/// A pair of directions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pair {
    /// The outgoing direction, a unit vector.
    pub wo: DVec3,
    /// The incident direction, a unit vector.
    pub wi: DVec3,
}

impl Serialize for Pair {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(Serialize)]
        struct Components {
            wo: [f64; 3],
            wi: [f64; 3],
        }
        let [wo, wi] = [self.wo, self.wi].map(|w| w.to_array());
        Components { wo, wi }.serialize(serializer)
    }
}

/// The values of a choice at pairs (wo, wi), in 1/sr per channel.
pub type Values<'a> = &'a dyn Fn(&[(DVec3, DVec3)]) -> Vec<[f64; 3]>;

/// The difference of a choice from what it is held against.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Errors {
    /// sqrt of the integral of (f' - f)^2 |cos| |cos| over that of f^2 |cos| |cos|, all channels together.
    pub rms: f64,
    /// The largest |f' - f| / f of a channel; where f is below 1e-3 of a diffuse lobe of the same reflectance, that takes
    /// its place.
    pub max: f64,
    /// Where it is.
    pub worst: Pair,
    /// The largest difference of `rho_hd` of a channel over the directions of view looked at.
    pub albedo: f64,
    /// The largest CIEDE2000 difference of a pixel of a sphere under light of one direction, the irradiance pi on a surface
    /// that faces it; radiance above 1 is cut off, as a screen does.
    pub delta_e: f64,
}

/// What choices of a material are held against: its values at the pairs of a [`Probe`].
pub struct Baseline<'a> {
    probe: &'a Probe,
    values: Vec<[f64; 3]>,
    /// The integral of f^2 with both cosines.
    square: f64,
    /// What values below it count as, in relative errors.
    floor: f64,
    /// The most accurate choice.
    exact: Values<'a>,
}

impl<'a> Baseline<'a> {
    /// Whose values `exact` gives.
    #[must_use]
    pub fn new(probe: &'a Probe, exact: Values<'a>) -> Self {
        let values = exact(&probe.pairs);
        let square = probe.integral(|index| values.get(index).map_or(0.0, |f| squared(*f)));
        let largest = |rho: [f64; 3]| rho.into_iter().fold(0.0, f64::max);
        let mean: f64 = probe
            .groups()
            .iter()
            .map(|group| largest(probe.reflectance(group, &values)))
            .sum();
        let mean = mean / probe.groups().len().max(1) as f64;
        Self {
            probe,
            square,
            floor: FLOOR * mean * FRAC_1_PI,
            values,
            exact,
        }
    }

    /// Whether there is nothing to be held against: all light is in Dirac deltas, or there is none.
    #[must_use]
    pub fn is_black(&self) -> bool {
        self.square == 0.0
    }

    /// The errors of `choice`.
    #[must_use]
    pub fn errors(&self, choice: Values<'_>) -> Errors {
        let values = choice(&self.probe.pairs);
        let differences = self.differences(&values);
        let rho = self.probe.groups().iter().flat_map(|group| {
            let rho = self.probe.reflectance(group, &differences);
            rho.map(f64::abs)
        });
        let (max, worst) = self.largest(&values, choice);
        let sphere = self.probe.sphere();
        let lights = sphere.of(&self.probe.pairs).iter().map(|(_, wi)| wi.z);
        let pixels = sphere.of(&values).iter().zip(sphere.of(&self.values));
        Errors {
            rms: self.rms_of(&differences),
            max,
            worst,
            albedo: rho.fold(0.0, f64::max),
            delta_e: pixels
                .zip(lights)
                .map(|((a, b), cosine)| {
                    colour_difference(radiance(*a, cosine), radiance(*b, cosine))
                })
                .fold(0.0, f64::max),
        }
    }

    /// [`Errors::rms`] of a choice with these values at the pairs of the probe.
    #[must_use]
    pub fn rms(&self, values: &[[f64; 3]]) -> f64 {
        self.rms_of(&self.differences(values))
    }

    fn differences(&self, values: &[[f64; 3]]) -> Vec<[f64; 3]> {
        let pairs = values.iter().zip(&self.values);
        pairs.map(|(a, b)| minus(*a, *b)).collect()
    }

    fn rms_of(&self, differences: &[[f64; 3]]) -> f64 {
        let square = |index| {
            differences
                .get(index)
                .map_or(0.0, |d: &[f64; 3]| squared(*d))
        };
        (self.probe.integral(square) / self.square).sqrt()
    }

    /// The largest relative error and where it is: the largest of the probe, followed uphill.
    fn largest(&self, values: &[[f64; 3]], choice: Values<'_>) -> (f64, Pair) {
        let all = values
            .iter()
            .zip(&self.values)
            .map(|(a, b)| self.relative(*a, *b));
        let (index, mut largest) =
            all.enumerate().fold(
                (0, 0.0),
                |best, (i, e)| if e > best.1 { (i, e) } else { best },
            );
        let mut at = self
            .probe
            .pairs
            .get(index)
            .copied()
            .unwrap_or((DVec3::Z, DVec3::Z));
        let mut random = Random::new(1);
        let mut reach = 0.1;
        for _ in 0..ROUNDS {
            let nearby = |w: DVec3, random: &mut Random| {
                let moved = w + random.direction() * (reach * random.unit());
                // Rounded as those of the probe; on the side where it was.
                let moved = moved.try_normalize().unwrap_or(w).as_vec3();
                if f64::from(moved.z) * w.z > 0.0 {
                    moved.into()
                } else {
                    w
                }
            };
            let pairs: Vec<_> = (0..TRIES)
                .map(|_| (nearby(at.0, &mut random), nearby(at.1, &mut random)))
                .collect();
            let tried = choice(&pairs);
            let exact = (self.exact)(&pairs);
            let mut is_better = false;
            for ((pair, a), b) in pairs.into_iter().zip(tried).zip(exact) {
                let error = self.relative(a, b);
                if error > largest {
                    (largest, at, is_better) = (error, pair, true);
                }
            }
            if !is_better {
                reach *= 0.5;
            }
        }
        let (wo, wi) = at;
        (largest, Pair { wo, wi })
    }

    /// The largest relative error of a channel.
    fn relative(&self, value: [f64; 3], exact: [f64; 3]) -> f64 {
        let channel = |(value, exact): (f64, f64)| (value - exact).abs() / exact.max(self.floor);
        value
            .into_iter()
            .zip(exact)
            .map(channel)
            .fold(0.0, f64::max)
    }
}

/// The CIEDE2000 difference of two colours in linear R, G, B (ITU-R BT.709 primaries, white D65), 0..1 each.
///
/// # Source
/// Sharma, Wu & Dalal 2005 (`sharma2005`), as in the library `palette`.
#[must_use]
pub fn colour_difference(a: [f64; 3], b: [f64; 3]) -> f64 {
    let lab = |[r, g, b]: [f64; 3]| Lab::<D65, f64>::from_color(LinSrgb::new(r, g, b));
    if a == b {
        0.0
    } else {
        lab(a).difference(lab(b))
    }
}

/// What a pixel shows where f is this, under light from a direction of this cosine.
fn radiance(f: [f64; 3], cosine: f64) -> [f64; 3] {
    f.map(|f| (f * cosine * std::f64::consts::PI).clamp(0.0, 1.0))
}

fn squared(f: [f64; 3]) -> f64 {
    f.into_iter().map(|x| x * x).sum()
}

fn minus([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    [a - x, b - y, c - z]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::lobe::pair_values;
    use bxdf::Material;

    #[test]
    fn a_fault_of_a_known_size_is_measured() {
        let material: Material = "lambertian_reflection:reflectance=0.5".parse().unwrap();
        let bxdf = material.build::<f64>();
        let probe = Probe::new(&material, &*bxdf);
        let exact = |pairs: &[(DVec3, DVec3)]| pair_values(&*bxdf, pairs);
        let baseline = Baseline::new(&probe, &exact);
        // A hundredth too bright everywhere, and 5 % at one direction's height.
        let brighter = |pairs: &[(DVec3, DVec3)]| {
            let mut values = exact(pairs);
            for f in &mut values {
                *f = f.map(|f| 1.01 * f);
            }
            values
        };
        let errors = baseline.errors(&brighter);
        assert!((errors.rms - 0.01).abs() < 1e-12 && (errors.max - 0.01).abs() < 1e-12);
        // The reflectance: the quadrature of the probe is good to a thousandth.
        assert!((errors.albedo - 0.005).abs() < 2e-5, "{errors:?}");
        assert!(errors.delta_e > 0.1 && errors.delta_e < 1.0, "{errors:?}");
        let same = baseline.errors(&exact);
        assert_eq!([same.rms, same.max, same.albedo, same.delta_e], [0.0; 4]);
    }

    #[test]
    fn the_peak_of_an_error_is_found() {
        let material: Material = "lambertian_reflection".parse().unwrap();
        let bxdf = material.build::<f64>();
        let probe = Probe::new(&material, &*bxdf);
        let exact = |pairs: &[(DVec3, DVec3)]| pair_values(&*bxdf, pairs);
        let baseline = Baseline::new(&probe, &exact);
        let place = DVec3::new(0.6, 0.0, 0.8);
        // A bump of a tenth, .02 wide, about one direction of incidence.
        let bump = |pairs: &[(DVec3, DVec3)]| {
            let mut values = exact(pairs);
            for (f, (_, wi)) in values.iter_mut().zip(pairs) {
                let high = 0.1 * (-((*wi - place).length() / 0.02).powi(2)).exp();
                *f = f.map(|f| f * (1.0 + high));
            }
            values
        };
        let errors = baseline.errors(&bump);
        assert!((errors.max - 0.1).abs() < 1e-4, "{errors:?}");
        assert!((errors.worst.wi - place).length() < 1e-3, "{errors:?}");
    }

    #[test]
    fn white_and_grey_differ_as_published() {
        // CIE L* of a tenth of white is 37.84; of white 100, and the colours have no chroma.
        let grey = Lab::<D65, f64>::from_color(LinSrgb::new(0.1, 0.1, 0.1));
        assert!((grey.l - 37.842).abs() < 1e-2, "{grey:?}");
        let difference = colour_difference([0.1; 3], [1.0; 3]);
        // Delta L over S_L, which at the mean lightness 68.92 is 1 + .015 m / sqrt(20 + m), m = (68.92 - 50)^2.
        let m = (68.92_f64 - 50.0).powi(2);
        let expected = (100.0 - 37.842) / (1.0 + 0.015 * m / (20.0 + m).sqrt());
        assert!(
            (difference - expected).abs() < 0.02,
            "{difference} {expected}"
        );
    }
}
