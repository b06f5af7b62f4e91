//! Whether a lobe stays as it is when the surface turns about its normal.

use glam::DVec3;

use bxdf::math::frame::{direction_from_degrees, turned_about_normal};
use bxdf::{Delta, Scatterer};

/// A lobe that changes by less counts as isotropic. Turning a direction moves it by a unit round-off, which the
/// narrowest lobe (alpha 1e-4, measured 7e-12) and powers of 1e4 magnify by far less than this.
pub const MAX_DEVIATION: f64 = 1e-6;

/// Polar angles of the directions tried, in degrees: near the normal, grazing, and both sides.
const THETAS_DEG: [f64; 6] = [8.0, 35.0, 60.0, 82.0, 125.0, 165.0];

/// Azimuths of the directions tried, in degrees: off the symmetry planes of an anisotropic lobe.
const PHIS_DEG: [f64; 2] = [10.0, 55.0];

/// The turns tried, in degrees: none is a symmetry of an anisotropic lobe.
const TURNS_DEG: [f64; 3] = [23.0, 90.0, 137.0];

/// How many samples of the model's own are drawn along each side of the unit square, and of the lobe choice.
const SAMPLES_PER_SIDE: u32 = 5;

/// Whether f and the deltas of `bxdf` are the same, but for rounding, when both directions turn about the normal.
#[must_use]
pub fn measured(bxdf: &dyn Scatterer<f64>) -> bool {
    largest_deviation(bxdf) < MAX_DEVIATION
}

/// The largest relative change of f, or of the weight, flux or direction of a delta, over a set of pairs of directions
/// and turns, 0 to 1. The pairs are the model's own samples, so that they meet narrow lobes.
#[must_use]
pub fn largest_deviation(bxdf: &dyn Scatterer<f64>) -> f64 {
    largest_change(bxdf).deviation
}

/// What turning a surface changes most.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Change {
    /// By how much, 0 to 1; see [`largest_deviation`].
    pub deviation: f64,
    /// The direction to the viewer before the turn; `None` where nothing changes.
    pub wo: Option<DVec3>,
    /// The direction to the light before the turn; `None` for deltas, and where nothing changes.
    pub wi: Option<DVec3>,
    /// How many values were compared.
    pub n: usize,
}

impl Change {
    fn take(&mut self, deviation: f64, wo: DVec3, wi: Option<DVec3>) {
        self.n += 1;
        if deviation > self.deviation {
            (self.deviation, self.wo, self.wi) = (deviation, Some(wo), wi);
        }
    }
}

/// The change that [`largest_deviation`] measures, and where it is.
#[must_use]
pub fn largest_change(bxdf: &dyn Scatterer<f64>) -> Change {
    let mut largest = Change::default();
    for (theta_deg, phi_deg) in pairs(THETAS_DEG, PHIS_DEG) {
        let wo = direction_from_degrees(theta_deg, phi_deg);
        let partners = partners(bxdf, wo);
        for turn in TURNS_DEG.map(f64::to_radians) {
            largest.take(delta_deviation(bxdf, wo, turn), wo, None);
            for wi in &partners {
                let deviation = value_deviation(bxdf, wo, *wi, turn);
                largest.take(deviation, wo, Some(*wi));
            }
        }
    }
    largest
}

/// Directions `wi` where the lobe of `wo` is.
fn partners(bxdf: &dyn Scatterer<f64>, wo: DVec3) -> Vec<DVec3> {
    let u: [f64; SAMPLES_PER_SIDE as usize] =
        std::array::from_fn(|i| (i as f64 + 0.5) / f64::from(SAMPLES_PER_SIDE));
    pairs(u, u)
        .flat_map(|(u0, u1)| u.map(|uc| bxdf.sample_f(wo.into(), uc, [u0, u1])))
        .flatten()
        .filter(|sample| !sample.is_delta)
        .map(|sample| sample.wi.into())
        .collect()
}

fn pairs<const N: usize, const M: usize>(
    a: [f64; N],
    b: [f64; M],
) -> impl Iterator<Item = (f64, f64)> {
    a.into_iter().flat_map(move |x| b.map(|y| (x, y)))
}

fn value_deviation(bxdf: &dyn Scatterer<f64>, wo: DVec3, wi: DVec3, turn: f64) -> f64 {
    let turned = |w: DVec3| turned_about_normal(w, turn).into();
    let before = bxdf.f(wo.into(), wi.into()).to_f64();
    let after = bxdf.f(turned(wo), turned(wi)).to_f64();
    spectral_deviation(before, after)
}

fn delta_deviation(bxdf: &dyn Scatterer<f64>, w: DVec3, turn: f64) -> f64 {
    let before = bxdf.deltas(w.into());
    let after = bxdf.deltas(turned_about_normal(w, turn).into());
    let deviation =
        |(before, after): (Option<Delta<f64>>, Option<Delta<f64>>)| match (before, after) {
            (None, None) => 0.0,
            (Some(before), Some(after)) => {
                let direction = turned_about_normal(before.direction.into(), turn);
                let moved = direction.distance(after.direction.into());
                spectral_deviation(before.flux.to_f64(), after.flux.to_f64())
                    .max(spectral_deviation(
                        before.weight.to_f64(),
                        after.weight.to_f64(),
                    ))
                    .max(moved.min(1.0))
            }
            _ => 1.0,
        };
    before
        .into_iter()
        .zip(after)
        .map(deviation)
        .fold(0.0, f64::max)
}

/// The largest relative difference of two channels.
fn spectral_deviation(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.into_iter()
        .zip(b)
        .filter(|(a, b)| a != b)
        .map(|(a, b)| (a - b).abs() / a.max(b))
        .fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use bxdf::math::Vec3;
    use bxdf::models::MODELS;
    use bxdf::optics::Spectrum;
    use bxdf::{Bxdf, Lobes};
    use bxdf::{Deltas, Material, Sample};

    fn deviation(material: &str) -> f64 {
        largest_deviation(&*material.parse::<Material>().unwrap().build())
    }

    #[test]
    fn every_model_is_what_it_declares_at_its_defaults() {
        for model in MODELS {
            let material = Material::of(model);
            let found = deviation(model.id);
            assert_eq!(
                found < MAX_DEVIATION,
                material.is_isotropic(),
                "{}: {found}",
                model.id
            );
        }
    }

    #[test]
    fn narrow_lobes_are_met() {
        for alpha in ["0.0001", "0.01", "1"] {
            let found = deviation(&format!("rough_conductor:alpha={alpha}"));
            assert!(found < MAX_DEVIATION / 100.0, "{alpha}: {found}");
        }
        for widths in [
            "alpha_x=0.0001,alpha_y=0.0002",
            "alpha_x=0.3,alpha_y=0.301",
            "alpha_x=0.0001,alpha_y=1",
        ] {
            for model in ["rough_conductor", "retro_reflector"] {
                let found = deviation(&format!("{model}:{widths}"));
                assert!(found > 1e-3, "{model}:{widths}: {found}");
            }
        }
    }

    /// A mirror whose flux depends on the azimuth.
    struct StripedMirror;

    impl Bxdf<f64> for StripedMirror {
        fn f(&self, _: Vec3<f64>, _: Vec3<f64>) -> Spectrum<f64> {
            Spectrum::black()
        }

        fn pdf(&self, _: Vec3<f64>, _: Vec3<f64>) -> f64 {
            0.0
        }

        fn sample_f(&self, wo: Vec3<f64>, uc: f64, _: [f64; 2]) -> Option<Sample<f64>> {
            bxdf::internals::sample_deltas(self.deltas(wo), uc)
        }

        fn deltas(&self, w: Vec3<f64>) -> Deltas<f64> {
            let flux = Spectrum::grey(w.x * w.x);
            let delta = Delta {
                direction: w.mirrored_about_normal(),
                flux,
                weight: flux,
                probability: 1.0,
                side: bxdf::Side::Reflection,
            };
            [Some(delta), None]
        }
    }

    impl Lobes<f64> for StripedMirror {}

    impl Scatterer<f64> for StripedMirror {}

    #[test]
    fn deltas_are_compared_too() {
        assert!(!measured(&StripedMirror));
        assert_eq!(deviation("lambertian_reflection"), 0.0);
    }
}
