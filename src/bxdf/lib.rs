//! Models of surface reflection and transmission, from Lambert to microfacets: each has its value, its density, its sampling
//! and its Dirac deltas, in f32, f64 and double-double from one source.
//!
//! # In a minute
//! ```
//! use bxdf::math::frame::direction_from_degrees;
//! use bxdf::{Material, Result, Vec3};
//!
//! # fn main() -> Result<()> {
//! // A model with parameters, one of the named materials, or the path of a file.
//! let brass = Material::open("brass")?;
//! let surface = brass.build::<f64>();
//!
//! // Directions are unit vectors that point away from the surface, whose normal is (0, 0, 1).
//! let viewer: Vec3<f64> = direction_from_degrees(30.0, 180.0).into();
//! let light = Vec3::new(0.6, 0.0, 0.8);
//!
//! // The value in 1/sr, without the cosine, and the density with which samples would find the light.
//! let (f, density) = surface.f_pdf(viewer, light);
//! assert!(f.to_f64()[0] > 0.0 && density > 0.0);
//!
//! // A direction of the light, drawn by three numbers in [0, 1), and what a path's throughput is multiplied by.
//! if let Some(sample) = surface.sample_f(viewer, 0.5, [0.25, 0.75]) {
//!     println!("{:?}: {:?}", sample.wi, sample.weight().to_f64());
//! }
//!
//! // What leaves in a single direction is no value: deltas are listed.
//! let mirror = Material::open("mirror")?.build::<f64>();
//! assert_eq!(mirror.f(viewer, light).to_f64(), [0.0; 3]);
//! assert_eq!(mirror.deltas(viewer).into_iter().flatten().count(), 1);
//! # Ok(())
//! # }
//! ```
//! [`Material`] is what most begin with: a weighted sum of models at their parameters, read from text. [`Bxdf`] is what it
//! builds. [`material::library`] has the named materials, [`Catalogue`] the models, to which you may add yours: it needs
//! three functions of [`Bxdf`] and a [`ModelSpec`] (`examples/own_model.rs` beside the labs). Whole arrays of directions are
//! computed several times as fast by [`Bxdf::batch`] (`examples/histogram.rs`). Each model's file says where it comes from,
//! where it departs from its source, and how far it is valid.
//!
//! There are no threads, no clock, and no files but in [`Material::open`], which the feature `files` brings.
//!
//! # Conventions
//! * **Shading frame**: orthonormal (s, t, n), local x = s, y = t, z = n. theta is measured from n, phi from s in the
//!   s-t plane. Radians inside, degrees at the screen and the command line.
//! * **Directions**: `wo` goes to the viewer (given), `wi` to the light (sampled). Both are unit vectors that point
//!   *away* from the surface, also when the light travels the other way. `wm` is a microfacet normal, `wh` the half
//!   vector.
//! * **f(wo, wi)** in 1/sr, without the cosine, for radiance: the radiance leaving along `wo` is the integral of
//!   f(wo, wi) L(wi) |cos(theta_i)| over `wi`. Across the surface it carries 1/e^2, e being the index of refraction on
//!   wi's side over that on wo's side; reciprocity reads n_i^2 f(wo, wi) = n_o^2 f(wi, wo).
//! * **pdf(wo, wi)** is the density of `wi` per solid angle given `wo`.
//! * **Dirac deltas** are not values: `f` and `pdf` are 0 for them, `sample_f` returns them, and views draw them as
//!   arrows whose length is the share of the flux.
//! * **Reflectances** (unit 1): `rho_dh(wi)` = integral of f(wo, wi) |cos(theta_o)| over `wo`, the share of the flux
//!   arriving along `wi` that leaves; at most 1 where energy is conserved.

pub mod batch;
mod catalogue;
mod delta_only;
#[cfg(feature = "files")]
mod encoding;
pub mod error;
#[cfg(feature = "files")]
mod files;
mod glossy;
#[doc(hidden)]
pub mod internals;
pub mod material;
pub mod math;
mod microfacet;
pub mod models;
pub mod optics;
pub mod param;
mod rotated;
mod sample;
pub mod spec;
pub mod table;

pub use catalogue::Catalogue;
pub use error::{Error, Result};
pub use material::{Component, Material};
pub use math::{Real, Vec3};
pub use optics::Spectrum;
pub use param::{ParamSet, ParamSpec, Value};
pub use rotated::Rotated;
pub use sample::{Delta, Deltas, Sample};
pub use spec::{
    Builders, Category, Declaration, Law, Lobe, ModelSpec, Precision, Properties, Side, StandIn,
};

/// The examples of the readme, which run with the tests.
#[cfg(doctest)]
#[doc = include_str!("README.md")]
struct Readme;

use batch::{Job, Path};

/// A scattering model at one set of parameters: a BRDF, a BTDF or both, in precision `R`.
///
/// A model of one's own needs [`Self::f`], [`Self::pdf`] and [`Self::sample_f`], and [`Self::deltas`] where it has some; the
/// rest follows. [`Self::lobes`] names what integrals should look for.
///
/// ```
/// use bxdf::{Bxdf, Category, Lobe, Real, Sample, Spectrum, Vec3, both_above, math::warp, sample_reflection};
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
///
///     fn lobes(&self) -> &[Lobe] {
///         const { &[Lobe::reflection(Category::Diffuse)] }
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

    /// The lobes that have a value at these parameters, each of which can be evaluated, drawn and integrated by itself
    /// under its index. Dirac deltas are not among them.
    fn lobes(&self) -> &[Lobe] {
        &[]
    }

    /// The part of `f` that belongs to the lobe at `index` of [`Self::lobes`], in 1/sr; the parts sum to `f`.
    ///
    /// Models with one lobe need not say more than `f`. `index` must be within [`Self::lobes`].
    #[inline(always)]
    fn lobe_f(&self, _index: usize, wo: Vec3<R>, wi: Vec3<R>) -> Spectrum<R> {
        self.f(wo, wi)
    }

    /// The density per solid angle of [`Self::sample_lobe`], in 1/sr.
    ///
    /// Models whose `sample_f` needs no choice need not say more than `pdf`.
    #[inline(always)]
    fn lobe_pdf(&self, _index: usize, wo: Vec3<R>, wi: Vec3<R>) -> R {
        self.pdf(wo, wi)
    }

    /// A direction of incidence for `wo` that follows the lobe at `index` alone: a smooth map of the unit square, so that
    /// integrals over the lobe are integrals over `u`. `None` where the direction drawn is lost.
    #[inline(always)]
    fn sample_lobe(&self, _index: usize, wo: Vec3<R>, u: [R; 2]) -> Option<Vec3<R>> {
        Some(self.sample_f(wo, R::zero(), u)?.wi)
    }

    /// The factors of a microfacet model at a pair of directions. `None` for other models, and where there is no
    /// half vector.
    fn microfacet(&self, _wo: Vec3<R>, _wi: Vec3<R>) -> Option<Microfacet<R>> {
        None
    }

    /// Computes `job` for a whole batch: the same results, element by element, in one call.
    fn batch(&self, _path: Path, job: Job<'_, R>) {
        batch::plain(self, job);
    }

    /// The Dirac delta lobes of `w`, at most one to either side; none for most models.
    fn deltas(&self, _w: Vec3<R>) -> Deltas<R> {
        [None, None]
    }
}

/// The factors of a microfacet lobe: its value is F D G over 4 |cos(theta_o) cos(theta_i)| in reflection.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Microfacet<R> {
    /// The density of microfacet normals at the half vector, in 1/sr.
    pub d: R,
    /// Masking and shadowing together, 0..1.
    pub g: R,
    /// The Fresnel factor of a facet: reflectance, or transmittance where the directions are across the surface.
    pub fresnel: Spectrum<R>,
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
