//! BRDF Explorer: sample, plot, compare and check models of surface reflection.
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
//!
//! # Modules and the dependency rule
//! `bxdf` (models) -> `analysis` (what each view shows, as data) -> `lab` (instruments) -> `cli`, `ui`. An arrow may be
//! skipped, never reversed; egui is named only under `ui` and by the `render` verb.

pub mod analysis;
pub mod bxdf;
pub mod cli;
mod encoding;
pub mod error;
pub mod files;
pub mod lab;
pub mod parallel;
pub mod study;
#[cfg(feature = "gui")]
pub mod ui;

pub use error::{Error, Result};
