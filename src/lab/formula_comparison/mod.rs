//! Formulas compared: textbook forms that lose their digits, beside those of the core.
//!
//! Each [`Comparison`] is one quantity along one parameter, written twice: as textbooks and other renderers have it, and as the
//! core has it, by the core's own function. Both are run in f32 and f64 and held against the reference precision at the
//! same rounded parameter: the reason why the core's code looks as it does.

mod formulas;

use xprec::Df64;

use super::rounding::{relative_difference, stability_bound};
use bxdf::internals::Libm;
use bxdf::math::Real;

use formulas::Formula;

/// Errors at one value of the parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outcome {
    /// Relative error of the textbook's form in f32 and f64; infinite where it is not finite.
    pub textbook: [f64; 2],
    /// That of the core's form.
    pub stable: [f64; 2],
    /// What the stability law allows in f32 and f64, as the parameter is the only input.
    pub allowed: [f64; 2],
}

/// A quantity compared along a parameter.
pub struct Comparison {
    /// The word for it.
    pub id: &'static str,
    /// The name at the screen.
    pub title: &'static str,
    /// The textbook's form.
    pub textbook: &'static str,
    /// The core's form.
    pub stable: &'static str,
    /// Why the textbook's form loses its digits, one sentence without a full stop.
    pub why: &'static str,
    /// Name of the parameter, with its unit.
    pub axis: &'static str,
    /// Smallest and largest value of the parameter, above 0: it runs evenly over the decades.
    pub range: [f64; 2],
    outcome: fn(f64) -> Outcome,
}

impl Comparison {
    /// The errors at `x` of [`Self::range`].
    #[must_use]
    pub fn at(&self, x: f64) -> Outcome {
        (self.outcome)(x)
    }

    /// The errors at `count` values evenly over the decades of the range, with the values.
    pub fn curve(&self, count: usize) -> impl Iterator<Item = (f64, Outcome)> + '_ {
        let [from, to] = self.range;
        (0..count).map(move |index| {
            let x = from * (to / from).powf(index as f64 / count.saturating_sub(1).max(1) as f64);
            (x, self.at(x))
        })
    }
}

/// Every comparison.
pub static COMPARISONS: [Comparison; 7] = [
    Comparison {
        id: "ggx",
        title: "GGX distribution",
        textbook: "1 / (pi alpha^2 cos^4 (1 + tan^2 / alpha^2)^2), tan^2 = (1 - cos^2) / cos^2",
        stable: "From the components of the half vector: x^2 / alpha^2 + y^2 / alpha^2 + z^2, squared",
        why: "1 - cos^2 of a cosine near 1 is a difference of nearly equal numbers: a narrow lobe sees nothing but its rounding",
        axis: "Width alpha, one width off the normal",
        range: [1e-4, 1.0],
        outcome: outcome::<formulas::Ggx>,
    },
    Comparison {
        id: "fresnel",
        title: "Fresnel reflectance near index 1",
        textbook: "((n cos_i - cos_t) / (n cos_i + cos_t))^2 and its like, cos_t by Snell's law",
        stable: "s polarisation by (n - 1)(n + 1) / (cos_i + n cos_t)^2: no difference of nearly equal numbers",
        why: "Both cosines are nearly equal, and so their difference is their rounding",
        axis: "Index n - 1, at 45 degrees",
        range: [1e-7, 1.0],
        outcome: outcome::<formulas::NearIndexOne>,
    },
    Comparison {
        id: "conductor",
        title: "Fresnel reflectance with absorption",
        textbook: "a^2 + b^2 = sqrt((n^2 - k^2 - sin^2)^2 + 4 n^2 k^2), 2 a^2 = a^2 + b^2 + n^2 - k^2 - sin^2",
        stable: "The larger part of the root from the modulus, the smaller from the product n k; squares brought into range",
        why: "Where little is reflected it is a difference of nearly equal numbers, and fourth powers of a large k overflow",
        axis: "Absorption index k, n = 1, at 60 degrees",
        range: [1e-6, 1e10],
        outcome: outcome::<formulas::Metal>,
    },
    Comparison {
        id: "lambda",
        title: "Smith's Lambda",
        textbook: "(sqrt(1 + alpha^2 tan^2) - 1) / 2",
        stable: "alpha^2 sin^2 / (2 cos (cos + sqrt(cos^2 + alpha^2 sin^2)))",
        why: "Where little is masked the root is nearly 1, and what is left of the difference is its rounding",
        axis: "Polar angle (radians), alpha = .1",
        range: [1e-6, 1.57],
        outcome: outcome::<formulas::Lambda>,
    },
    Comparison {
        id: "gtr1",
        title: "GTR1 distribution of a clear coat",
        textbook: "(a^2 - 1) / (pi log1p(a^2 - 1) (1 + (a^2 - 1) cos^2))",
        stable: "(1 - a)(1 + a) over -2 pi ln(a) (a^2 + (1 - a)(1 + a) sin^2)",
        why: "a^2 - 1 of a narrow coat rounds to -1: the logarithm and 1 + (a^2 - 1) cos^2 lose what a is",
        axis: "Width a, one width off the normal",
        range: [1e-5, 0.99],
        outcome: outcome::<formulas::ClearCoat>,
    },
    Comparison {
        id: "power",
        title: "Power of a cosine",
        textbook: "cos^n, the cosine's power as the library has it",
        stable: "exp(n ln(1 - sin^2) / 2), the sine from the components of the half vector",
        why: "A cosine near 1 is known to one rounding, and the power multiplies that by n",
        axis: "Exponent n, where the lobe has fallen to a third",
        range: [1.0, 1e4],
        outcome: outcome::<formulas::Power>,
    },
    Comparison {
        id: "fujii",
        title: "Energy lost by Fujii's Oren-Nayar",
        textbook: "pi c1 - G, G = S (acos mu - S mu) + 2/3 ((S / mu)(1 - S^3) - S)",
        stable: "A sum of terms of the order of mu, by 1 - S = mu^2 / (1 + S)",
        why: "Towards the horizon 1 - S^3 rounds to 0 and is divided by mu, and G nears pi c1",
        axis: "Cosine mu",
        range: [1e-6, 1.0],
        outcome: outcome::<formulas::Fujii>,
    },
];

/// Relative step of the derivative by the parameter.
const STEP: f64 = 1e-12;

/// The errors of both forms in f32 and f64 at `x`, rounded to each.
fn outcome<F: Formula>(x: f64) -> Outcome {
    let x = F::input(x);
    let single = f64::from(x as f32);
    let exact = |x: f64| F::stable(Df64::of(x)).as_f64();
    let kappa = {
        let moved = |by: f64| Df64::of(x) * (Df64::of(1.0) + Df64::of(by));
        let [up, down] = [STEP, -STEP].map(|by| F::stable(moved(by)));
        ((up - down).as_f64() / (2.0 * STEP * exact(x))).abs()
    };
    let (of_single, of_double) = (exact(single), exact(x));
    Outcome {
        textbook: [
            relative_difference(F::textbook(Libm(single as f32)).as_f64(), of_single),
            relative_difference(F::textbook(x), of_double),
        ],
        stable: [
            relative_difference(F::stable(single as f32).as_f64(), of_single),
            relative_difference(F::stable(x), of_double),
        ],
        allowed: [f32::UNIT_ROUNDOFF, f64::UNIT_ROUNDOFF].map(|u| stability_bound(kappa, u)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Values tried along each parameter.
    const COUNT: usize = 2000;

    /// The largest of what `of` gives in f32 and f64 along the comparison.
    fn largest(comparison: &Comparison, of: impl Fn(&Outcome, usize) -> f64) -> [f64; 2] {
        [0, 1].map(|precision| {
            let all = comparison
                .curve(COUNT)
                .map(|(_, outcome)| of(&outcome, precision));
            all.fold(0.0, f64::max)
        })
    }

    #[test]
    fn the_cores_forms_keep_the_law_and_lose_far_less_than_the_textbooks() {
        for comparison in &COMPARISONS {
            let ratio = largest(comparison, |outcome, p| {
                outcome.stable[p] / outcome.allowed[p]
            });
            let stable = largest(comparison, |outcome, p| outcome.stable[p]);
            let textbook = largest(comparison, |outcome, p| outcome.textbook[p]);
            println!(
                "{}: stable {stable:?}, {ratio:?} of the bound; textbook {textbook:?}",
                comparison.id
            );
            assert!(
                ratio.into_iter().all(|ratio| ratio <= 1.0),
                "{} {ratio:?}",
                comparison.id
            );
            for (textbook, stable) in textbook.into_iter().zip(stable) {
                assert!(
                    textbook > 100.0 * stable,
                    "{}: {textbook:e} {stable:e}",
                    comparison.id
                );
            }
        }
    }

    #[test]
    fn both_forms_are_the_same_quantity() {
        for comparison in &COMPARISONS {
            // Where the textbook's form still has digits, in f64, at the better end of the range or in its middle.
            let agree = comparison
                .curve(COUNT)
                .filter(|(_, outcome)| outcome.textbook[1] < 1e-11)
                .count();
            assert!(agree > COUNT / 4, "{}: {agree} of {COUNT}", comparison.id);
        }
    }
}
