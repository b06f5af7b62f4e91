//! The reflectances a facet may have, as types: models are compiled for each.

use super::Spectrum;
use super::conductor::Conductor;
use super::fresnel;
use super::metal::{GreyMetal, Metal};
use crate::bxdf::math::Real;
use crate::bxdf::math::quadrature::gauss_legendre;

/// The reflectance of a mirror facet.
pub trait FacetFresnel<R: Real>: Copy + Send + Sync + 'static {
    /// At the cosine `cos_d` with the facet's normal, 0..1.
    fn at(&self, cos_d: R) -> Spectrum<R>;

    /// The cosine-weighted mean Fbar = 2 int F(mu) mu dmu.
    fn mean(&self) -> Spectrum<R> {
        // mu = x^2 puts the nodes where a good conductor's reflectance bends, near grazing.
        gauss_legendre(NODES)
            .into_iter()
            .fold(Spectrum::black(), |sum, (node, weight)| {
                let x = (R::one() + R::of(node)) * R::of(0.5);
                let measure = R::of(2.0) * x * x * x * R::of(weight);
                sum + self.at(x * x) * measure
            })
    }
}

/// Schlick's approximation, by the reflectance at normal incidence.
#[derive(Clone, Copy, Debug)]
pub struct Schlick<R>(pub Spectrum<R>);

/// All light, at every angle.
#[derive(Clone, Copy, Debug)]
pub struct One;

/// Nodes of the mean Fresnel reflectance: 1e-6 for metals; 1e-4 where the reflectance has the kink of a critical angle.
const NODES: usize = 32;

/// Exactly.
impl<R: Real> FacetFresnel<R> for Conductor<R> {
    #[inline(always)]
    fn at(&self, cos_d: R) -> Spectrum<R> {
        Spectrum(self.reflectance(cos_d))
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

impl<R: Real> FacetFresnel<R> for One {
    #[inline(always)]
    fn at(&self, _cos_d: R) -> Spectrum<R> {
        Spectrum::grey(R::one())
    }

    fn mean(&self) -> Spectrum<R> {
        Spectrum::grey(R::one())
    }
}

/// One of them, chosen when the program runs.
#[derive(Clone, Copy, Debug)]
pub enum AnyFresnel<R> {
    /// Exactly.
    Conductor(Conductor<R>),
    /// By Schlick's approximation.
    Schlick(Schlick<R>),
    /// All light.
    One(One),
}

impl<R: Real> FacetFresnel<R> for AnyFresnel<R> {
    #[inline(always)]
    fn at(&self, cos_d: R) -> Spectrum<R> {
        match self {
            Self::Conductor(exact) => exact.at(cos_d),
            Self::Schlick(schlick) => schlick.at(cos_d),
            Self::One(one) => one.at(cos_d),
        }
    }

    fn mean(&self) -> Spectrum<R> {
        match self {
            Self::Conductor(exact) => exact.mean(),
            Self::Schlick(schlick) => schlick.mean(),
            Self::One(one) => FacetFresnel::<R>::mean(one),
        }
    }
}
