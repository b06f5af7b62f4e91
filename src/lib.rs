//! BRDF Explorer: sample, plot, compare and check models of surface reflection.
//!
//! The program's command line, and its parts under one name. Each part is a package of its own and names only those before it:
//! [`bxdf`] (models; its documentation states the conventions of frame, directions, units and deltas) -> [`analysis`] (what
//! each view shows, as data) -> [`lab`] (instruments) -> [`study`] (the document a person works on, and the answers to it) ->
//! `ui` (the window) and [`cli`].

pub mod cli;

pub use bxdf;
pub use bxdf::{Error, Result, error};
pub use bxdf_lab::{self as lab, analysis};
pub use bxdf_study::{self as study, files, parallel};
#[cfg(feature = "gui")]
pub use bxdf_ui as ui;
