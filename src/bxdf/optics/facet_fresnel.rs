//! The reflectances a facet may have, as types: models are compiled for each.

use super::Spectrum;
use super::conductor::Conductor;
use super::fresnel;
use super::metal::{GreyMetal, Metal};
use crate::math::Real;
use crate::math::quadrature::gauss_legendre;
use crate::param::ParamSet;

/// The reflectance of a mirror facet.
pub trait FacetFresnel<R: Real>: Copy + Send + Sync + 'static {
    /// Whether loops over it can be compiled for wide registers.
    const VECTORISES: bool = true;

    /// At the cosine `cos_d` with the facet's normal, 0..1.
    fn at(&self, cos_d: R) -> Spectrum<R>;

    /// [`Self::at`], where the square of the sine is known better than by a cosine near 1.
    #[inline(always)]
    fn with_sine(&self, cos_d: R, _sin2: impl FnOnce() -> R) -> Spectrum<R> {
        self.at(cos_d)
    }

    /// The cosine-weighted mean Fbar = 2 int F(mu) mu dmu.
    fn mean(&self) -> Spectrum<R> {
        cosine_weighted_nodes().fold(Spectrum::black(), |sum, (mu, weight)| {
            sum + self.at(mu) * weight
        })
    }
}

/// Cosines mu and weights of the mean 2 int F(mu) mu dmu.
pub(super) fn cosine_weighted_nodes<R: Real>() -> impl Iterator<Item = (R, R)> {
    // mu = x^2 puts the nodes where a good conductor's reflectance bends, near grazing.
    gauss_legendre(NODES).into_iter().map(|(node, weight)| {
        let x = (R::one() + R::of(node)) * R::of(0.5);
        (x * x, R::of(2.0) * x * x * x * R::of(weight))
    })
}

/// Schlick's approximation, by the reflectance at normal incidence.
#[derive(Clone, Copy, Debug)]
pub struct Schlick<R>(pub Spectrum<R>);

/// Schlick's approximation less the error term of Lazanyi & Szirmay-Kalos, which makes it exact at the cosine 1/7 too, where
/// metals dip (`lazanyi2005`, `hoffman2019`).
#[derive(Clone, Copy, Debug)]
pub struct Lazanyi<R> {
    f0: Spectrum<R>,
    /// The factor of the term.
    error: Spectrum<R>,
}

impl<R: Real> Lazanyi<R> {
    /// The approximation of `metal`.
    pub fn new(metal: &Conductor<R>) -> Self {
        let f0 = metal.at(R::one());
        let at = fresnel::lazanyi_cosine();
        let excess = |f0, exact| fresnel::schlick(at, f0) - exact;
        Self {
            f0,
            error: f0.zip(metal.at(at), |f0, exact| {
                fresnel::lazanyi_factor(excess(f0, exact))
            }),
        }
    }
}

/// Nodes of the mean Fresnel reflectance: 1e-6 for metals; 1e-4 where the reflectance has the kink of a critical angle.
const NODES: usize = 32;

/// Exactly.
impl<R: Real> FacetFresnel<R> for Conductor<R> {
    #[inline(always)]
    fn at(&self, cos_d: R) -> Spectrum<R> {
        Spectrum(self.reflectance(cos_d))
    }

    #[inline(always)]
    fn with_sine(&self, cos_d: R, sin2: impl FnOnce() -> R) -> Spectrum<R> {
        Spectrum(self.reflectance_with_sine(cos_d.at_most(R::one()), sin2()))
    }
}

/// As exactly as the precision is.
impl<R: Real> FacetFresnel<R> for Metal<R> {
    #[inline(always)]
    fn at(&self, cos_d: R) -> Spectrum<R> {
        Spectrum(self.reflectance(cos_d))
    }
}

/// As [`Metal`].
impl<R: Real> FacetFresnel<R> for GreyMetal<R> {
    #[inline(always)]
    fn at(&self, cos_d: R) -> Spectrum<R> {
        Spectrum::grey(self.reflectance(cos_d))
    }
}

impl<R: Real> FacetFresnel<R> for Schlick<R> {
    #[inline(always)]
    fn at(&self, cos_d: R) -> Spectrum<R> {
        self.0.map(|f0| fresnel::schlick(cos_d, f0))
    }

    fn mean(&self) -> Spectrum<R> {
        // 2 int (1 - mu)^5 mu dmu = 1/21.
        self.0.map(|f0| f0 + (R::one() - f0) / R::of(21.0))
    }
}

impl<R: Real> FacetFresnel<R> for Lazanyi<R> {
    #[inline(always)]
    fn at(&self, cos_d: R) -> Spectrum<R> {
        let term = fresnel::lazanyi_term(cos_d);
        self.f0.zip(self.error, |f0, error| {
            let reflectance = fresnel::schlick(cos_d, f0) - error * term;
            reflectance.at_least(R::zero()).at_most(R::one())
        })
    }
}

/// One of them, chosen when the program runs.
#[derive(Clone, Copy, Debug)]
pub enum AnyFresnel<R> {
    /// Exactly.
    Conductor(Conductor<R>),
    /// By Schlick's approximation.
    Schlick(Schlick<R>),
    /// By that with the term of Lazanyi & Szirmay-Kalos.
    Lazanyi(Lazanyi<R>),
}

impl<R: Real> AnyFresnel<R> {
    /// The choice `fresnel` in `params`: by Schlick from `f0`, 1 at every angle, or a metal's of index `eta` and `k`, exact or
    /// by the term of Lazanyi & Szirmay-Kalos.
    #[must_use]
    pub fn from_params(params: &ParamSet) -> Self {
        let spectrum = |name| Spectrum::of(params.rgb(name));
        match params.choice("fresnel") {
            "schlick" => Self::Schlick(Schlick(spectrum("f0"))),
            "one" => Self::Schlick(Schlick(Spectrum::grey(R::one()))),
            word => {
                let exact = Conductor::new(spectrum("eta").0, spectrum("k").0);
                if word == "lazanyi" {
                    Self::Lazanyi(Lazanyi::new(&exact))
                } else {
                    Self::Conductor(exact)
                }
            }
        }
    }
}

impl<R: Real> FacetFresnel<R> for AnyFresnel<R> {
    const VECTORISES: bool = false;

    #[inline(always)]
    fn at(&self, cos_d: R) -> Spectrum<R> {
        match self {
            Self::Conductor(exact) => exact.at(cos_d),
            Self::Schlick(schlick) => schlick.at(cos_d),
            Self::Lazanyi(lazanyi) => lazanyi.at(cos_d),
        }
    }

    #[inline(always)]
    fn with_sine(&self, cos_d: R, sin2: impl FnOnce() -> R) -> Spectrum<R> {
        match self {
            Self::Conductor(exact) => exact.with_sine(cos_d, sin2),
            other => other.at(cos_d),
        }
    }

    fn mean(&self) -> Spectrum<R> {
        match self {
            Self::Conductor(exact) => exact.mean(),
            Self::Schlick(schlick) => schlick.mean(),
            Self::Lazanyi(lazanyi) => lazanyi.mean(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lazanyis_term_is_nearer_to_metals_than_schlick_alone() {
        // Root mean squares over the cosine of gold's and aluminium's errors, red, green and blue, from a scan of the
        // textbook form with a complex root: Schlick's and those with the term.
        let gold = ([0.143, 0.375, 1.442], [3.983, 2.386, 1.603]);
        let aluminium = ([1.657, 0.88, 0.521], [9.224, 6.269, 4.837]);
        for ((eta, k), schlicks, lazanyis) in [
            (
                gold,
                [0.008_550, 0.003_119, 0.016_777],
                [0.002_367, 0.002_793, 0.016_384],
            ),
            (
                aluminium,
                [0.053_947, 0.040_700, 0.028_119],
                [0.011_599, 0.003_366, 0.004_097],
            ),
        ] {
            let metal = Conductor::<f64>::new(eta, k);
            let rms = |approximate: &dyn Fn(f64) -> Spectrum<f64>| {
                let steps = 20_000_u32;
                let mut squares = [0.0; 3];
                for step in 1..=steps {
                    let c = f64::from(step) / f64::from(steps);
                    let Spectrum(errors) =
                        approximate(c).zip(metal.at(c), |found, exact| found - exact);
                    for (sum, error) in squares.iter_mut().zip(errors) {
                        *sum += error * error;
                    }
                }
                squares.map(|sum| (sum / f64::from(steps)).sqrt())
            };
            let (schlick, lazanyi) = (Schlick(metal.at(1.0)), Lazanyi::new(&metal));
            let found = [rms(&|c| schlick.at(c)), rms(&|c| lazanyi.at(c))];
            for (found, expected) in found.into_iter().zip([schlicks, lazanyis]) {
                for (found, expected) in found.into_iter().zip(expected) {
                    assert!((found - expected).abs() < 2e-6, "{found} {expected}");
                }
            }
            let at = 1.0 / 7.0;
            let Spectrum(errors) = lazanyi
                .at(at)
                .zip(metal.at(at), |found, exact| found - exact);
            assert!(errors.iter().all(|error| error.abs() < 1e-15), "{errors:?}");
        }
    }
}
