//! `rho_hd` of a surface in a table: what a uniform dome shows.

use std::f64::consts::{FRAC_PI_2, TAU};

use glam::DVec3;
use rayon::prelude::*;

use crate::analysis::lobe::{HeldLobe, Hold};
use crate::analysis::polar::direction;
use crate::analysis::{Detail, IsWanted, isotropy};
use bxdf::Scatterer;
use bxdf::math::frame;

/// Absolute error aimed at in each lobe: half of what 8 bits tell apart.
const TOLERANCE: f64 = 1e-3;

/// Evaluations that a lobe may take in each direction.
const MAX_EVALUATIONS: usize = 20_000;

/// The last polar angle of the table stands this far from the horizon, which itself carries nothing, in radians.
const HORIZON_GAP: f64 = 1e-3;

/// `rho_hd` by the direction of the viewer above the surface, between whose entries cubics are laid.
///
/// # Source
/// The interpolation is that of `catmull1974`.
pub(super) struct Dome {
    /// By azimuth, then by polar angle from 0 to near the horizon.
    entries: Vec<Vec<[f64; 3]>>,
}

impl Dome {
    /// The table of `bxdf`; `None` where it was not wanted to the end. Surfaces that stay as they are when turned need but
    /// one azimuth.
    pub(super) fn new(
        bxdf: &dyn Scatterer<f64>,
        detail: Detail,
        is_wanted: IsWanted<'_>,
    ) -> Option<Self> {
        let (thetas, phis) = match (detail, isotropy::measured(bxdf)) {
            (Detail::Coarse, true) => (16, 1),
            (Detail::Coarse, false) => (10, 8),
            (Detail::Full, true) => (64, 1),
            (Detail::Full, false) => (64, 32),
        };
        let entry = |index: usize| {
            let theta = (index % thetas) as f64 / (thetas - 1) as f64 * (FRAC_PI_2 - HORIZON_GAP);
            let phi = (index / thetas) as f64 / phis as f64 * TAU;
            is_wanted().then(|| rho_hd(bxdf, direction(theta, phi)))
        };
        let entries = (0..thetas * phis).into_par_iter().map(entry);
        let entries: Vec<[f64; 3]> = entries.collect::<Option<_>>()?;
        Some(Self {
            entries: entries.chunks(thetas).map(<[_]>::to_vec).collect(),
        })
    }

    /// The radiance towards `wo`, which is above the surface.
    pub(super) fn radiance(&self, wo: DVec3) -> [f64; 3] {
        let phis = signed(self.entries.len());
        let along_theta = |azimuth: i64| self.at_azimuth(azimuth, frame::theta(wo));
        if phis == 1 {
            return along_theta(0);
        }
        let place = (frame::phi(wo) / TAU).rem_euclid(1.0) * phis as f64;
        cubic(place, along_theta)
    }

    /// The value at the polar angle `theta` of the azimuth at this index.
    fn at_azimuth(&self, azimuth: i64, theta: f64) -> [f64; 3] {
        let phis = signed(self.entries.len());
        let entry = |azimuth: i64, index: i64| {
            let column = self.entries.get(azimuth.rem_euclid(phis) as usize)?;
            column.get(usize::try_from(index).ok()?).copied()
        };
        let last = signed(self.entries.first().map_or(0, Vec::len)) - 1;
        let value = |index: i64| {
            let found = if index < 0 {
                // Beyond the pole, the half circle opposite.
                entry(azimuth + phis / 2, -index)
            } else if index > last {
                let ends = entry(azimuth, last).zip(entry(azimuth, last - 1));
                ends.map(|(end, before)| sum([(2.0, end), (-1.0, before)]))
            } else {
                entry(azimuth, index)
            };
            found.unwrap_or_default()
        };
        let place = theta / (FRAC_PI_2 - HORIZON_GAP) * last as f64;
        cubic(place.min(last as f64), value).map(|x| x.max(0.0))
    }
}

/// The integral of f(wo, wi) |cos(theta_i)| over all `wi`, and the weights of the deltas.
fn rho_hd(bxdf: &dyn Scatterer<f64>, wo: DVec3) -> [f64; 3] {
    let held = HeldLobe::new(bxdf, Hold::Viewer, wo);
    let integrals = held.integrals(TOLERANCE, MAX_EVALUATIONS).into_iter();
    let deltas = bxdf.deltas(wo.into()).into_iter().flatten();
    let deltas = deltas.map(|delta| delta.weight.to_f64());
    let parts = integrals.map(|integral| integral.value).chain(deltas);
    sum(parts.map(|part| (1.0, part)))
}

/// The size of a table as a number that may be counted below 0.
fn signed(size: usize) -> i64 {
    i64::try_from(size).unwrap_or(i64::MAX)
}

/// The sum of weighted triples.
fn sum(parts: impl IntoIterator<Item = (f64, [f64; 3])>) -> [f64; 3] {
    parts
        .into_iter()
        .fold([0.0; 3], |[a, b, c], (weight, [x, y, z])| {
            [a + weight * x, b + weight * y, c + weight * z]
        })
}

/// The cubic through `value` at whole numbers, at `place` between two of them.
fn cubic(place: f64, value: impl Fn(i64) -> [f64; 3]) -> [f64; 3] {
    let first = place.floor();
    let t = place - first;
    let first = first as i64;
    let weights = [
        ((2.0 - t) * t - 1.0) * t * 0.5,
        ((3.0 * t - 5.0) * t * t + 2.0) * 0.5,
        ((4.0 - 3.0 * t) * t + 1.0) * t * 0.5,
        (t - 1.0) * t * t * 0.5,
    ];
    sum(weights
        .into_iter()
        .zip(first - 1..)
        .map(|(weight, index)| (weight, value(index))))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::reflectance::directional_hemispherical;
    use bxdf::Material;
    use bxdf::math::frame::direction_from_degrees;

    fn error(material: &str) -> f64 {
        let material: Material = material.parse().unwrap();
        let model = material.build::<f64>();
        let dome = Dome::new(&*model, Detail::Full, &|| true).unwrap();
        let angles = [
            (0.0, 0.0),
            (13.0, 200.0),
            (47.3, -35.0),
            (71.9, 100.0),
            (86.0, 10.0),
        ];
        let error = |(theta, phi)| {
            let w = direction_from_degrees(theta, phi);
            // By reciprocity, for reflection: rho_hd of a direction is its rho_dh.
            let exact = directional_hemispherical(&*model, w, 1e-8).reflection;
            let found = dome.radiance(w);
            let errors = found.into_iter().zip(exact).map(|(a, b)| (a - b).abs());
            errors.fold(0.0, f64::max)
        };
        angles.into_iter().map(error).fold(0.0, f64::max)
    }

    #[test]
    fn the_table_is_the_reflectance() {
        for material in [
            "lambertian_reflection:reflectance=0.3/0.5/0.7",
            "rough_conductor:fresnel=one,alpha=0.5",
            "rough_conductor:fresnel=one,alpha_x=0.2,alpha_y=0.7",
            "plastic",
        ] {
            let error = error(material);
            // A bit of 8 is 4e-3 of a white.
            assert!(error < 2e-3, "{material}: {error}");
        }
    }

    #[test]
    fn cubics_meet_values_and_keep_parabolas() {
        let square = |x: i64| [(x * x) as f64; 3];
        assert_eq!(cubic(3.0, square), [9.0; 3]);
        assert!((cubic(2.5, square)[0] - 6.25).abs() < 1e-14);
    }
}
