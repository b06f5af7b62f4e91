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
//! [`Material`] is what most begin with: a weighted sum of models at their parameters, read from text. A [`Scatterer`]
//! is what it builds: a [`Bxdf`] that knows its [`Lobes`]. [`material::library`] has the named materials, [`Catalogue`]
//! the models, to which you may add yours: it needs three functions of [`Bxdf`], its lobes, and a [`ModelSpec`]
//! (`examples/own_model.rs` beside the labs). Whole arrays of directions are computed several times as fast by
//! [`Scatterer::batch`] (`examples/histogram.rs`). Each model's file says where it comes from, where it departs from
//! its source, and how far it is valid.
//!
//! There are no threads, no clock, and no files but in [`Material::open`], which the feature `files` brings. Without it, what
//! reads files is given to [`Material::fetch`].
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

#[doc = include_str!("DECISIONS.md")]
pub mod decisions {}

pub mod batch;
mod catalogue;
mod common;
mod delta_only;
#[cfg(feature = "files")]
mod encoding;
pub mod error;
#[cfg(feature = "files")]
mod files;
mod glossy;
#[doc(hidden)]
pub mod internals;
pub mod limits;
mod lobe;
mod lobes;
pub mod material;
pub mod math;
mod microfacet;
pub mod models;
pub mod optics;
pub mod param;
pub mod resource;
mod rotated;
mod sample;
mod scattering;
pub mod spec;
pub mod table;

pub use batch::Scatterer;
pub use catalogue::Catalogue;
pub use error::{Error, Result};
pub use lobe::{Category, Lobe, Side};
pub use lobes::{Lobes, Microfacet};
pub use material::{Component, Material};
pub use math::{Real, Vec3};
pub use optics::Spectrum;
pub use param::{ParamSet, ParamSpec, Value};
pub use resource::Resource;
pub use rotated::Rotated;
pub use sample::{Delta, Deltas, Sample};
pub use scattering::{Bxdf, are_across, both_above, reflected_direction, sample_reflection};
pub use spec::{Builders, Declaration, Law, ModelSpec, Precision, Properties, StandIn};

/// The examples of the readme, which run with the tests.
#[cfg(doctest)]
#[doc = include_str!("README.md")]
struct Readme;
