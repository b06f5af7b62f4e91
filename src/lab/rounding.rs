//! The stability law: how far rounding may take a model's numbers from the reference precision.
//!
//! A result may be off by what the rounding of its inputs explains, and by that of some dozen operations: relative error
//! <= 16 (1 + kappa) u. An ill-conditioned input, where kappa is large, is so told apart from an unstable formula.
//!
//! # Source
//! The condition number is that of Higham 2002, "Accuracy and Stability of Numerical Algorithms", section 1.6, by
//! components (`higham2002`).

use glam::DVec3;
use xprec::Df64;

use super::specimen::{Neighbour, Specimen};
use bxdf::Scatterer;
use bxdf::math::{Real, Vec3};

/// What the law allows in units of (1 + kappa) u: the roundings of some two dozen operations, which rarely all add up.
const ROUNDINGS: f64 = 16.0;

/// The largest relative error that the law allows.
#[must_use]
pub fn stability_bound(kappa: f64, unit_roundoff: f64) -> f64 {
    ROUNDINGS * (1.0 + kappa) * unit_roundoff
}

/// How far the square of a sampled direction's length may be from 1, in units of round-off.
///
/// To first order the roundings of wi = 2 (wo.wh) wh - wo add up to 54 at most: 9 in |wh|^2 of a normal scaled to length 1 by
/// one root and one division, four times that in |wi|^2; 12 of the dot product, 4 and 2 of the product and the difference.
/// The given direction brings its own.
pub const UNIT_LENGTH_ROUNDOFFS: f64 = 60.0;

/// A number that a model gives for a pair of directions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// A channel of `f`: 0, 1 or 2.
    F(usize),
    /// The density.
    Pdf,
}

impl Quantity {
    /// All of them, in the order of [`quantities`].
    pub const ALL: [Self; 4] = [Self::F(0), Self::F(1), Self::F(2), Self::Pdf];

    /// Its place in [`Self::ALL`].
    const fn index(self) -> usize {
        match self {
            Self::F(channel) => channel,
            Self::Pdf => 3,
        }
    }

    /// Its one of `all`, which are in the order of [`Self::ALL`].
    #[must_use]
    pub fn of<T: Copy>(self, all: [T; 4]) -> T {
        let [first, ..] = all;
        all.into_iter().nth(self.index()).unwrap_or(first)
    }
}

/// The numbers that `bxdf` gives for a pair, in the order of [`Quantity::ALL`].
pub fn quantities<R: Real>(bxdf: &dyn Scatterer<R>, wo: Vec3<R>, wi: Vec3<R>) -> [R; 4] {
    let (f, pdf) = bxdf.f_pdf(wo, wi);
    let [r, g, b] = f.0;
    [r, g, b, pdf]
}

/// Relative step of the derivatives by the directions' components, in reference precision: small beside alpha mu, the
/// width in which the narrowest lobe reacts between grazing directions (1e-4 times 1e-9), large beside 1e-32.
const COMPONENT_STEP: f64 = 1e-16;

/// The condition number of each quantity at a pair: the sum of |x d/dx| over its absolute value, over the six components
/// of the directions and the numeric parameters, by differences in the reference precision. At an edge it depends on how far
/// a rounding reaches: that of a precision of `unit_roundoff`.
///
/// They are sums of terms that are not negative: where all have reached `enough`, the rest is left out.
#[must_use]
pub fn condition_numbers(
    (reference, neighbours): (&dyn Scatterer<Df64>, &[Neighbour]),
    (wo, wi): (DVec3, DVec3),
    unit_roundoff: f64,
    enough: [f64; 4],
) -> [f64; 4] {
    let (wo_exact, wi_exact): (Vec3<Df64>, Vec3<Df64>) = (wo.into(), wi.into());
    let here = quantities(reference, wo_exact, wi_exact).map(|value| value.as_f64().abs());
    let mut sums = [0.0; 4];
    // Adds what the quantities change by, per step; says whether that is enough.
    let mut add = |[up, down]: [[Df64; 4]; 2], step: f64| {
        for (sum, (up, down)) in sums.iter_mut().zip(up.into_iter().zip(down)) {
            *sum += (up - down).as_f64().abs() / step;
        }
        let limits = enough.into_iter().zip(here);
        sums.iter()
            .zip(limits)
            .all(|(sum, (enough, here))| *sum >= enough * here)
    };
    let moved = |w: Vec3<Df64>, axis: usize, sign: f64| {
        let step = Df64::of(1.0) + Df64::of(sign * COMPONENT_STEP);
        match axis {
            0 => Vec3::new(w.x * step, w.y, w.z),
            1 => Vec3::new(w.x, w.y * step, w.z),
            _ => Vec3::new(w.x, w.y, w.z * step),
        }
    };
    let is_of = |neighbour: &&Neighbour| neighbour.unit_roundoff.is_none_or(|u| u == unit_roundoff);
    // The normal component first: it says most where directions graze.
    let by_component = [2, 0, 1].into_iter().any(|axis| {
        let of_wo = |sign| quantities(reference, moved(wo_exact, axis, sign), wi_exact);
        let of_wi = |sign| quantities(reference, wo_exact, moved(wi_exact, axis, sign));
        let step = 2.0 * COMPONENT_STEP;
        add([1.0, -1.0].map(of_wo), step) || add([1.0, -1.0].map(of_wi), step)
    });
    if !by_component {
        let mut all = neighbours.iter().filter(is_of);
        let _ = all.any(|neighbour| {
            let pair = neighbour.pair.each_ref();
            let of = pair.map(|bxdf| quantities(&**bxdf, wo_exact, wi_exact));
            add(of, neighbour.relative_step)
        });
    }
    let mut here = here.into_iter();
    // A value of 0 all around is exact; one at the edge of a lobe may be anything nearby.
    sums.map(|sum| {
        let here = here.next().unwrap_or(0.0);
        if sum == 0.0 { 0.0 } else { sum / here }
    })
}

/// For [`condition_numbers`]: all of it.
pub const WHOLE: [f64; 4] = [f64::INFINITY; 4];

impl Specimen {
    /// The condition numbers of what it gives for a pair in a precision of `unit_roundoff`; see [`condition_numbers`].
    #[must_use]
    pub fn condition_numbers(&self, pair: (DVec3, DVec3), unit_roundoff: f64) -> [f64; 4] {
        condition_numbers(
            (&*self.reference, &self.neighbours),
            pair,
            unit_roundoff,
            WHOLE,
        )
    }
}

/// What the stability law allows for `quantity` at a pair, in a precision of `unit_roundoff`; the condition number is
/// measured only where `deviation` needs it.
#[must_use]
pub fn rounding_bound(
    specimen: &Specimen,
    (wo, wi): (DVec3, DVec3),
    quantity: Quantity,
    deviation: f64,
    unit_roundoff: f64,
) -> f64 {
    let well_conditioned = stability_bound(0.0, unit_roundoff);
    if deviation <= well_conditioned {
        well_conditioned
    } else {
        let kappa = quantity.of(specimen.condition_numbers((wo, wi), unit_roundoff));
        stability_bound(kappa, unit_roundoff)
    }
}

/// |a - b| over the larger of the two; 0 where both are 0, infinite where one is no finite number.
#[must_use]
pub fn relative_difference(a: f64, b: f64) -> f64 {
    if a == b {
        0.0
    } else if a.is_finite() && b.is_finite() {
        (a - b).abs() / a.abs().max(b.abs())
    } else {
        f64::INFINITY
    }
}

/// Whether `x` is so small in precision `R`, or in the reference's, that its digits are no longer all there.
#[must_use]
pub fn is_subnormal<R: Real>(x: f64) -> bool {
    x.abs() < (least::<R>() * 4.0).max(least::<Df64>() * REFERENCE_MARGIN)
}

/// How far above its smallest number the reference may have lost digits: factors of a value underflow before it does.
const REFERENCE_MARGIN: f64 = 1e30;

/// The smallest normal number.
fn least<R: Real>() -> f64 {
    R::min_positive_value().as_f64()
}

#[cfg(test)]
mod tests {
    use super::*;
    use bxdf::Catalogue;
    use bxdf::math::frame::direction_from_degrees;

    #[test]
    fn a_blade_is_worse_conditioned_than_paper() {
        let (wo, wi) = (
            direction_from_degrees(40.0, 10.0),
            direction_from_degrees(41.0, 190.0),
        );
        let kappa = |id: &str, alpha: Option<f64>| {
            let model = Catalogue::current().find(id).unwrap();
            let mut params = model.defaults();
            if let Some(alpha) = alpha {
                params.set_text("alpha", &alpha.to_string()).unwrap();
            }
            Specimen::new(model, &params).condition_numbers((wo, wi), f64::UNIT_ROUNDOFF)
        };
        let paper = kappa("lambertian_reflection", None);
        // f is the reflectance over pi: it follows the one parameter, and no direction.
        assert!(
            Quantity::ALL
                .iter()
                .take(3)
                .all(|q| (q.of(paper) - 1.0).abs() < 1e-6),
            "{paper:?}"
        );
        let (wide, narrow) = (
            kappa("rough_conductor", Some(0.5)),
            kappa("rough_conductor", Some(0.001)),
        );
        assert!(
            narrow[0] > 50.0 * wide[0] && wide[0] > 1.0,
            "{wide:?} {narrow:?}"
        );
        // Halfway down the GGX lobe the density falls like its width to the power -4: the law allows for that.
        assert!(stability_bound(narrow[3], 6e-8) > 1e-4);
    }
}
