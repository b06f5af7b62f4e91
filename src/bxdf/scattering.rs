//! What a scattering model is.

use crate::math::{Real, Vec3};
use crate::optics::Spectrum;
use crate::sample::{Deltas, Sample};

/// A scattering model at one set of parameters: a BRDF, a BTDF or both, in precision `R`.
///
/// A model of one's own needs [`Self::f`], [`Self::pdf`] and [`Self::sample_f`], and [`Self::deltas`] where it has some. To be
/// built by a [`ModelSpec`](crate::ModelSpec) it is a [`Scatterer`](crate::Scatterer) too, of [`Lobes`](crate::Lobes).
///
/// ```
/// use bxdf::{Bxdf, Real, Sample, Spectrum, Vec3, both_above, math::warp, sample_reflection};
///
/// /// Half of the light comes back, evenly.
/// struct Grey;
///
/// impl<R: Real> Bxdf<R> for Grey {
///     fn f(&self, wo: Vec3<R>, wi: Vec3<R>) -> Spectrum<R> {
///         let is_reflection = both_above(wo, wi).is_some();
///         Spectrum::grey(if is_reflection { R::of(0.5) * R::frac_1_pi() } else { R::zero() })
///     }
///
///     fn pdf(&self, wo: Vec3<R>, wi: Vec3<R>) -> R {
///         both_above(wo, wi).map_or(R::zero(), |(_, wi)| warp::cosine_hemisphere_pdf(wi.z))
///     }
///
///     fn sample_f(&self, wo: Vec3<R>, _uc: R, u: [R; 2]) -> Option<Sample<R>> {
///         sample_reflection(self, wo, |_| Some(warp::cosine_hemisphere(u)))
///     }
/// }
///
/// let sample = Grey.sample_f(Vec3::new(0.0, 0.0, 1.0), 0.0, [0.3_f32, 0.7]).unwrap();
/// assert!((sample.weight().0[0] - 0.5).abs() < 1e-6);
/// ```
///
/// All three methods are total: for unit directions they return finite, non-negative values, saturated where the true
/// value overflows the type. A direction in the horizon plane itself (z = 0) carries nothing: 0, and no sample.
pub trait Bxdf<R: Real>: Send + Sync {
    /// The value f(wo, wi) in 1/sr, without the cosine, for radiance. Dirac deltas are not values: they count as 0.
    fn f(&self, wo: Vec3<R>, wi: Vec3<R>) -> Spectrum<R>;

    /// The density per solid angle with which [`Self::sample_f`] returns `wi` for `wo`, in 1/sr; 0 for deltas.
    ///
    /// Its integral over the sphere is the probability that `sample_f` returns a sample that is no delta.
    fn pdf(&self, wo: Vec3<R>, wi: Vec3<R>) -> R;

    /// [`Self::f`] and [`Self::pdf`], to the bit, where both are wanted: models compute once what the two share.
    #[inline(always)]
    fn f_pdf(&self, wo: Vec3<R>, wi: Vec3<R>) -> (Spectrum<R>, R) {
        (self.f(wo, wi), self.pdf(wo, wi))
    }

    /// A direction of incidence for `wo`: `uc` chooses among lobes, `u` a direction, all uniform in [0, 1).
    ///
    /// `None` is "no sample": a random choice that leaves the hemisphere, or total internal reflection.
    fn sample_f(&self, wo: Vec3<R>, uc: R, u: [R; 2]) -> Option<Sample<R>>;

    /// The sample `wi` for `wo`, with its value and its density; see [`Sample::with_density`].
    #[inline(always)]
    fn sample_at(&self, wo: Vec3<R>, wi: Vec3<R>) -> Option<Sample<R>> {
        let (f, pdf) = self.f_pdf(wo, wi);
        let sample = Sample {
            wi,
            f,
            pdf,
            is_delta: false,
        };
        sample.with_density()
    }

    /// The Dirac delta lobes of `w`, at most one to either side; none for most models.
    fn deltas(&self, _w: Vec3<R>) -> Deltas<R> {
        [None, None]
    }
}

/// `wo` and `wi` above the surface, for a two-sided reflection model: mirrored in the surface where both are below.
///
/// `None` where they are on different sides, or one of them lies in the horizon plane.
#[inline(always)]
pub fn both_above<R: Real>(wo: Vec3<R>, wi: Vec3<R>) -> Option<(Vec3<R>, Vec3<R>)> {
    let zero = R::zero();
    if wo.z > zero && wi.z > zero {
        Some((wo, wi))
    } else if wo.z < zero && wi.z < zero {
        Some((wo.mirrored_in_surface(), wi.mirrored_in_surface()))
    } else {
        None
    }
}

/// Whether `wo` and `wi` lie strictly on different sides of the surface.
#[inline(always)]
pub fn are_across<R: Real>(wo: Vec3<R>, wi: Vec3<R>) -> bool {
    let zero = R::zero();
    (wo.z > zero && wi.z < zero) || (wo.z < zero && wi.z > zero)
}

/// Samples a two-sided reflection model whose `sample_above` draws `wi` for a `wo` above the surface; see
/// [`reflected_direction`].
#[inline(always)]
pub fn sample_reflection<R: Real>(
    model: &impl Bxdf<R>,
    wo: Vec3<R>,
    sample_above: impl FnOnce(Vec3<R>) -> Option<Vec3<R>>,
) -> Option<Sample<R>> {
    let wi = reflected_direction(wo, sample_above)?;
    model.sample_at(wo, wi)
}

/// The direction on the side of `wo` that `sample_above` draws for a `wo` above the surface, mirrored where it is below.
///
/// `None` where `wo` lies in the horizon plane, and where the direction drawn is not above it.
#[inline(always)]
pub fn reflected_direction<R: Real>(
    wo: Vec3<R>,
    sample_above: impl FnOnce(Vec3<R>) -> Option<Vec3<R>>,
) -> Option<Vec3<R>> {
    let zero = R::zero();
    let is_above = wo.z > zero;
    let wo_above = if is_above {
        wo
    } else {
        wo.mirrored_in_surface()
    };
    if wo_above.z <= zero || wo_above.z.is_nan() {
        return None;
    }
    let wi_above = sample_above(wo_above)?;
    let wi = if is_above {
        wi_above
    } else {
        wi_above.mirrored_in_surface()
    };
    if wi_above.z > zero { Some(wi) } else { None }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_sided_models_see_both_directions_above() {
        let up = Vec3::new(0.6_f32, 0.0, 0.8);
        let tiny = Vec3::new(1.0_f32, 0.0, 1e-38);
        assert_eq!(
            both_above(-up, -tiny),
            Some((Vec3::new(-0.6, 0.0, 0.8), Vec3::new(-1.0, 0.0, 1e-38)))
        );
        assert_eq!(both_above(up, Vec3::new(1.0, 0.0, 0.0)), None);
        // The product of these cosines underflows; the signs do not.
        assert!(both_above(tiny, tiny).is_some() && are_across(tiny, -tiny));
    }
}
