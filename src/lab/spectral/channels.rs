//! The n and k of red, green and blue that give a metal the colour of its spectrum.
//!
//! Three wavelengths are no three channels: with n and k read at 611, 549 and 464 nm gold is olive. Here each channel gets
//! the n and k with which it reflects, at 0 and at 82 degrees, what light of the whole spectrum does in that channel: under
//! D65, seen by the CIE 1931 observer, in linear sRGB. Reflectance at 0 degrees leaves a curve of n and k, along which that
//! at 82 degrees falls while n grows: one point of it is left.
//!
//! A channel holds no more than 1. The red of gold would be 1.04, as its colour lies outside sRGB: it is held at 1.

use super::colour::{FINEST, rgb_weights};
use bxdf::internals::Conductor;
use bxdf::math::frame::cos_sin_deg;

/// The polar angles at which a channel reflects what the spectrum does, in degrees: normal incidence, which makes the
/// colour, and the dip that metals have before the horizon.
pub const MATCHED_DEG: [f64; 2] = [0.0, 82.0];

/// Halvings of the range of n: below the rounding of what is left.
const HALVINGS: usize = 60;

/// What a smooth surface whose n and k are `at` a wavelength in nm reflects, as [`colour`](super::colour()) has it.
pub(super) fn colour_by(at: impl Fn(f64) -> [f64; 2], theta_deg: f64) -> [f64; 3] {
    let parts = rgb_weights(FINEST).into_iter();
    parts.fold([0.0; 3], |mut sum, (nm, weights)| {
        let reflected = reflectance(at(nm), theta_deg);
        sum.iter_mut()
            .zip(weights)
            .for_each(|(sum, weight)| *sum += weight * reflected);
        sum
    })
}

/// n and k of each channel for the substance that has n and k `at` a wavelength in nm. `read_at_nm`: the wavelengths whose k
/// the channels take that reflect everything, where n is 0 and any k does.
pub(super) fn indices(at: impl Fn(f64) -> [f64; 2], read_at_nm: [f64; 3]) -> [[f64; 2]; 3] {
    let [normal, grazing] = MATCHED_DEG.map(|theta_deg| colour_by(&at, theta_deg));
    let mut wanted = normal.into_iter().zip(grazing);
    read_at_nm.map(|nm| {
        let [_, k] = at(nm);
        wanted
            .next()
            .map_or([0.0, k], |wanted| index_of_channel(wanted, k))
    })
}

/// The n and k that reflect `normal` at 0 degrees and as nearly `grazing` at 82 as they can; [0, `k`] where all is reflected.
fn index_of_channel((normal, grazing): (f64, f64), k: f64) -> [f64; 2] {
    if normal >= 1.0 {
        return [0.0, k];
    }
    let normal = normal.max(0.0);
    let root = normal.sqrt();
    // r (n + 1)^2 - (n - 1)^2 = (1 - r) k^2, from k = 0 to k = 0.
    let k_of =
        |n: f64| ((normal * (n + 1.0).powi(2) - (n - 1.0).powi(2)) / (1.0 - normal)).max(0.0);
    let at = |n: f64| [n, k_of(n).sqrt()];
    let [mut low, mut high] = [(1.0 - root) / (1.0 + root), (1.0 + root) / (1.0 - root)];
    let [_, steep] = MATCHED_DEG;
    if reflectance([high, 0.0], steep) >= grazing {
        return [high, 0.0];
    }
    for _ in 0..HALVINGS {
        let middle = f64::midpoint(low, high);
        if reflectance(at(middle), steep) > grazing {
            low = middle;
        } else {
            high = middle;
        }
    }
    at(f64::midpoint(low, high))
}

/// What n + ik reflects at `theta_deg`, 0 to 1.
fn reflectance([n, k]: [f64; 2], theta_deg: f64) -> f64 {
    let (cos, _) = cos_sin_deg(theta_deg);
    let [reflected, ..] = Conductor::new([n; 3], [k; 3]).reflectance(cos);
    reflected
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_grey_substance_keeps_its_index() {
        for [n, k] in [[0.05, 3.6], [1.0, 2.6], [2.9, 3.0], [1.5, 0.01]] {
            for [found_n, found_k] in indices(|_| [n, k], [600.0, 550.0, 450.0]) {
                // Near k = 0 the reflectances hardly depend on k: it has half of the digits.
                assert!((found_n - n).abs() < 1e-7 * n, "{n} {k}: {found_n}");
                assert!((found_k - k).abs() < 1e-5 * k, "{n} {k}: {found_k}");
            }
        }
    }

    #[test]
    fn what_a_channel_cannot_hold_is_held_at_the_end() {
        assert_eq!(index_of_channel((1.03, 0.99), 3.2), [0.0, 3.2]);
        // Less than glass has at 82 degrees, whatever its k: none at all is nearest.
        let [n, k] = index_of_channel((0.04, 0.1), 1.0);
        assert!((n - 1.5).abs() < 1e-9 && k == 0.0, "{n} {k}");
    }
}
