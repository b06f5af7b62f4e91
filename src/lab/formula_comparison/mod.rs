//! Formulas compared: textbook forms that lose their digits, beside those of the core.
//!
//! Each [`Comparison`] is one quantity along one parameter, written twice: as textbooks and other renderers have it, and as the
//! core has it, by the core's own function. Both are run in f32 and f64 and held against the reference precision at the
//! same rounded parameter: the reason why the core's code looks as it does.

mod formulas;
mod query;

use xprec::Df64;

use super::analysis::IsWanted;
use super::analysis::raster::Raster;
use super::rounding::{relative_difference, stability_bound};
use bxdf::internals::Libm;
use bxdf::math::Real;

use formulas::Formula;
pub use query::{CurveRequest, MapRequest};

/// Errors at one value of the parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outcome {
    /// Relative error of the textbook's form in f32 and f64; infinite where it is not finite.
    pub textbook: [f64; 2],
    /// That of the core's form.
    pub stable: [f64; 2],
    /// What the stability law allows in f32 and f64, for what varies: the parameter, in a map the second argument too.
    pub allowed: [f64; 2],
}

/// What a quantity depends on beside the parameter along which it is compared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Argument {
    /// Its name, with its unit.
    pub axis: &'static str,
    /// Its smallest and largest value, above 0: it runs evenly over the decades.
    pub range: [f64; 2],
    /// Where it stays along a curve.
    pub at: f64,
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
    /// Where the second argument stays along a curve, in words; empty where there is none.
    pub fixed: &'static str,
    /// Smallest and largest value of the parameter, above 0: it runs evenly over the decades.
    pub range: [f64; 2],
    /// What it depends on besides, where it depends on two.
    pub second: Option<Argument>,
    outcome: fn([f64; 2], Inputs) -> Outcome,
}

/// The comparison of this id; the first where there is none.
#[must_use]
pub fn find(id: &str) -> &'static Comparison {
    let [first, ..] = &COMPARISONS;
    let found = COMPARISONS.iter().find(|comparison| comparison.id == id);
    found.unwrap_or(first)
}

impl PartialEq for Comparison {
    fn eq(&self, other: &Self) -> bool {
        self.id == other.id
    }
}

impl std::fmt::Debug for Comparison {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Comparison({})", self.id)
    }
}

/// Which of the arguments are inputs whose rounding is allowed for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Inputs {
    Parameter,
    Both,
}

/// The errors over both arguments of a comparison, row by row from the upper left: the second runs upwards.
pub type Map = Raster<Outcome>;

impl Comparison {
    /// The parameter, and where the second argument stays along a curve.
    #[must_use]
    pub fn axis_of_curve(&self) -> String {
        match self.fixed {
            "" => self.axis.to_owned(),
            fixed => format!("{}, {fixed}", self.axis),
        }
    }

    /// The errors at `x` of [`Self::range`].
    #[must_use]
    pub fn at(&self, x: f64) -> Outcome {
        let y = self.second.map_or(1.0, |second| second.at);
        (self.outcome)([x, y], Inputs::Parameter)
    }

    /// The errors at both arguments.
    #[must_use]
    pub fn at_both(&self, arguments: [f64; 2]) -> Outcome {
        (self.outcome)(arguments, Inputs::Both)
    }

    /// The errors over both arguments, `size` values of each; `None` where there is no second one.
    #[must_use]
    pub fn map(&self, size: usize) -> Option<Map> {
        self.map_while(size, &|| true)
    }

    /// The same, `None` also where it was not wanted to the end.
    fn map_while(&self, size: usize, is_wanted: IsWanted<'_>) -> Option<Map> {
        let second = self.second?;
        let middle = |index: usize| (index as f64 + 0.5) / size as f64;
        let row = |index: usize| {
            let y = along(second.range, 1.0 - middle(index));
            let cell = |index| self.at_both([along(self.range, middle(index)), y]);
            (0..size).map(cell).collect()
        };
        Raster::rows_while(size, size, is_wanted, row)
    }

    /// The errors at `count` values evenly over the decades of the range, with the values.
    pub fn curve(&self, count: usize) -> impl Iterator<Item = (f64, Outcome)> + '_ {
        (0..count).map(move |index| {
            let share = index as f64 / count.saturating_sub(1).max(1) as f64;
            let x = along(self.range, share);
            (x, self.at(x))
        })
    }
}

/// The value at a share of a range, 0..1, evenly over its decades.
#[must_use]
pub fn along([from, to]: [f64; 2], share: f64) -> f64 {
    from * (to / from).powf(share)
}

/// How far off the normal a distribution of normals is looked at.
const WIDTHS_OFF: Argument = Argument {
    axis: "Sine off the normal, in widths",
    range: [1e-2, 0.99],
    at: 0.5,
};

/// The cosine of the angle of incidence.
const fn cosine(at: f64) -> Argument {
    Argument {
        axis: "Cosine of the angle of incidence",
        range: [1e-4, 1.0],
        at,
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
        axis: "Width alpha",
        fixed: "half a width off the normal",
        range: [1e-4, 1.0],
        second: Some(WIDTHS_OFF),
        outcome: outcome::<formulas::Ggx>,
    },
    Comparison {
        id: "fresnel",
        title: "Fresnel reflectance near index 1",
        textbook: "((n cos_i - cos_t) / (n cos_i + cos_t))^2 and its like, cos_t by Snell's law",
        stable: "s polarisation by (n - 1)(n + 1) / (cos_i + n cos_t)^2: no difference of nearly equal numbers",
        why: "Both cosines are nearly equal, and so their difference is their rounding",
        axis: "Index n - 1",
        fixed: "at 45 degrees",
        range: [1e-7, 1.0],
        second: Some(cosine(std::f64::consts::FRAC_1_SQRT_2)),
        outcome: outcome::<formulas::NearIndexOne>,
    },
    Comparison {
        id: "conductor",
        title: "Fresnel reflectance with absorption",
        textbook: "a^2 + b^2 = sqrt((n^2 - k^2 - sin^2)^2 + 4 n^2 k^2), 2 a^2 = a^2 + b^2 + n^2 - k^2 - sin^2",
        stable: "The larger part of the root from the modulus, the smaller from the product n k; squares brought into range",
        why: "Where little is reflected it is a difference of nearly equal numbers, and fourth powers of a large k overflow",
        axis: "Absorption index k (n = 1)",
        fixed: "at 60 degrees",
        range: [1e-6, 1e10],
        second: Some(cosine(0.5)),
        outcome: outcome::<formulas::Metal>,
    },
    Comparison {
        id: "lambda",
        title: "Smith's Lambda",
        textbook: "(sqrt(1 + alpha^2 tan^2) - 1) / 2",
        stable: "alpha^2 sin^2 / (2 cos (cos + sqrt(cos^2 + alpha^2 sin^2)))",
        why: "Where little is masked the root is nearly 1, and what is left of the difference is its rounding",
        axis: "Polar angle (radians)",
        fixed: "alpha = .1",
        range: [1e-6, 1.57],
        second: Some(Argument {
            axis: "Width alpha",
            range: [1e-4, 1.0],
            at: 0.1,
        }),
        outcome: outcome::<formulas::Lambda>,
    },
    Comparison {
        id: "gtr1",
        title: "GTR1 distribution of a clear coat",
        textbook: "(a^2 - 1) / (pi log1p(a^2 - 1) (1 + (a^2 - 1) cos^2))",
        stable: "(1 - a)(1 + a) over -2 pi ln(a) (a^2 + (1 - a)(1 + a) sin^2)",
        why: "a^2 - 1 of a narrow coat rounds to -1: the logarithm and 1 + (a^2 - 1) cos^2 lose what a is",
        axis: "Width a",
        fixed: "half a width off the normal",
        range: [1e-5, 0.99],
        second: Some(WIDTHS_OFF),
        outcome: outcome::<formulas::ClearCoat>,
    },
    Comparison {
        id: "power",
        title: "Power of a cosine",
        textbook: "cos^n, the cosine's power as the library has it",
        stable: "exp(n ln(1 - sin^2) / 2), the sine from the components of the half vector",
        why: "A cosine near 1 is known to one rounding, and the power multiplies that by n",
        axis: "Exponent n",
        fixed: "where the lobe has fallen to three fifths",
        range: [1.0, 1e4],
        second: Some(Argument {
            axis: "Sine off the normal, over the root of 1/n",
            range: [1e-2, 3.0],
            at: 1.0,
        }),
        outcome: outcome::<formulas::Power>,
    },
    Comparison {
        id: "fujii",
        title: "Energy lost by Fujii's Oren-Nayar",
        textbook: "pi c1 - G, G = S (acos mu - S mu) + 2/3 ((S / mu)(1 - S^3) - S)",
        stable: "A sum of terms of the order of mu, by 1 - S = mu^2 / (1 + S)",
        why: "Towards the horizon 1 - S^3 rounds to 0 and is divided by mu, and G nears pi c1",
        axis: "Cosine mu",
        fixed: "",
        range: [1e-6, 1.0],
        second: None,
        outcome: outcome::<formulas::Fujii>,
    },
];

/// Relative step of the derivative by an argument.
const STEP: f64 = 1e-12;

/// The errors of both forms in f32 and f64 at `x` and `y`, rounded to each.
fn outcome<F: Formula>([x, y]: [f64; 2], inputs: Inputs) -> Outcome {
    let x = F::input(x);
    let [x32, y32] = [x, y].map(|argument| argument as f32);
    let exact = |x: f64, y: f64| F::stable(Df64::of(x), Df64::of(y)).as_f64();
    let (of_single, of_double) = (exact(x32.into(), y32.into()), exact(x, y));
    let moved = |of: f64, by: f64| Df64::of(of) * (Df64::of(1.0) + Df64::of(by));
    // By how much the rounding of an argument is multiplied, from the values a step on and a step back.
    let condition = |[up, down]: [Df64; 2]| ((up - down).as_f64() / (2.0 * STEP * of_double)).abs();
    let mut kappa = condition([STEP, -STEP].map(|by| F::stable(moved(x, by), Df64::of(y))));
    if inputs == Inputs::Both {
        kappa += condition([STEP, -STEP].map(|by| F::stable(Df64::of(x), moved(y, by))));
    }
    Outcome {
        textbook: [
            relative_difference(F::textbook(Libm(x32), Libm(y32)).as_f64(), of_single),
            relative_difference(F::textbook(x, y), of_double),
        ],
        stable: [
            relative_difference(F::stable(x32, y32).as_f64(), of_single),
            relative_difference(F::stable(x, y), of_double),
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
    fn maps_hold_the_curve_and_the_cores_forms_keep_the_law_all_over_them() {
        let mut mapped = 0;
        for comparison in &COMPARISONS {
            let Some(map) = comparison.map(48) else {
                continue;
            };
            mapped += 1;
            let ratio = |outcome: &Outcome, p: usize| outcome.stable[p] / outcome.allowed[p];
            for p in [0, 1] {
                let ratios = map.pixels.iter().map(|outcome| ratio(outcome, p));
                let largest = ratios.fold(0.0, f64::max);
                println!("{} {p}: {largest}", comparison.id);
                assert!(largest <= 1.0, "{} {p}: {largest}", comparison.id);
            }
            let at = comparison.second.unwrap().at;
            let (x, along_curve) = comparison.curve(5).nth(1).unwrap();
            let both = comparison.at_both([x, at]);
            assert_eq!(both.textbook, along_curve.textbook);
            assert!(both.allowed[0] >= along_curve.allowed[0]);
        }
        assert_eq!(mapped, COMPARISONS.len() - 1, "all but Fujii's");
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
