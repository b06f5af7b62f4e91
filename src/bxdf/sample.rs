//! What is drawn: samples, and the Dirac deltas among them.

use crate::lobe::Side;
use crate::math::{Real, Vec3};
use crate::optics::Spectrum;

/// What [`Bxdf::sample_f`](crate::Bxdf::sample_f) returns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample<R> {
    /// The direction sampled, a unit vector.
    pub wi: Vec3<R>,
    /// f(wo, wi) in 1/sr; for a delta its weight over |cos(theta_i)|.
    pub f: Spectrum<R>,
    /// The density of `wi` in 1/sr; for a delta the probability of choosing it.
    pub pdf: R,
    /// Whether `wi` comes from a Dirac delta.
    pub is_delta: bool,
}

impl<R: Real> Sample<R> {
    /// f |cos(theta_i)| / pdf: what a path's throughput is multiplied by.
    ///
    /// ```
    /// use bxdf::{Material, Vec3};
    ///
    /// # fn main() -> bxdf::Result<()> {
    /// // Samples of a grey diffuse surface all weigh what it reflects.
    /// let grey: Material = "lambertian_reflection:reflectance=0.5".parse()?;
    /// let sample = grey.build::<f64>().sample_f(Vec3::new(0.0, 0.0, 1.0), 0.0, [0.2, 0.9]);
    /// assert!(sample.is_some_and(|sample| (sample.weight().0[0] - 0.5).abs() < 1e-15));
    /// # Ok(())
    /// # }
    /// ```
    #[inline(always)]
    pub fn weight(&self) -> Spectrum<R> {
        self.f * (self.wi.z.abs() / self.pdf)
    }

    /// The sample, unless its density has underflown. Where `wo` grazes, a rounded direction may lie so far out in the
    /// tail of the density, or beyond its edge: such a sample has no weight and is lost.
    #[must_use]
    #[inline(always)]
    pub fn with_density(self) -> Option<Self> {
        if self.pdf >= R::min_positive_value() {
            Some(self)
        } else {
            None
        }
    }
}

/// A Dirac delta lobe of a direction `w`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Delta<R> {
    /// Where it points: both where light arriving along `w` leaves, and where light leaving along `w` came from.
    pub direction: Vec3<R>,
    /// The share of the flux arriving along `w` that leaves along `direction`.
    pub flux: Spectrum<R>,
    /// Radiance along `w` over radiance along `direction`: the flux share over e^2, e being the index on
    /// `direction`'s side over that on `w`'s side; f |cos(theta_i)| of the delta.
    pub weight: Spectrum<R>,
    /// The probability with which [`Bxdf::sample_f`](crate::Bxdf::sample_f) chooses it.
    pub probability: R,
    /// To which side it goes.
    pub side: Side,
}

/// The deltas of a direction; models have at most one to either side.
pub type Deltas<R> = [Option<Delta<R>>; 2];

impl<R: Real> Delta<R> {
    /// The sample that stands for this delta.
    #[inline(always)]
    pub fn sample(&self) -> Sample<R> {
        let cos = self.direction.z.abs().at_least(R::min_positive_value());
        Sample {
            wi: self.direction,
            f: self.weight.map(|weight| (weight / cos).saturated()),
            pdf: self.probability,
            is_delta: true,
        }
    }
}

/// The sample of one of `deltas`, chosen by `uc` with their probabilities. `None` where they leave a rest and `uc`
/// falls into it.
#[inline(always)]
pub fn sample_deltas<R: Real>(deltas: Deltas<R>, uc: R) -> Option<Sample<R>> {
    // Written out: an inner loop would keep a batch's from being vectorised.
    let [first, second] = deltas;
    let rest = match first {
        Some(delta) if uc < delta.probability => return Some(delta.sample()),
        Some(delta) => uc - delta.probability,
        None => uc,
    };
    match second {
        Some(delta) if rest < delta.probability => Some(delta.sample()),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn deltas_are_chosen_by_their_probability() {
        let delta = |z: f64, probability: f64| {
            let spectrum = Spectrum::grey(probability);
            let side = if z > 0.0 {
                Side::Reflection
            } else {
                Side::Transmission
            };
            Some(Delta {
                direction: Vec3::new(0.0, 0.0, z),
                flux: spectrum,
                weight: spectrum,
                probability,
                side,
            })
        };
        let deltas = [delta(1.0, 0.25), delta(-1.0, 0.5)];
        assert!(
            sample_deltas(deltas, 0.2).is_some_and(|s| s.wi.z > 0.0 && s.pdf == 0.25 && s.is_delta)
        );
        assert!(
            sample_deltas(deltas, 0.3).is_some_and(|s| s.wi.z < 0.0 && s.weight().0 == [1.0; 3])
        );
        assert!(sample_deltas(deltas, 0.8).is_none());
    }
}
