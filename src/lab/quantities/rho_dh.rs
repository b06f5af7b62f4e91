//! The directional-hemispherical reflectance.

use super::f::of_channel;
use super::quantity::{Argument, Given, Quantity, Value, word};
use super::scene::Scene;
use crate::analysis::reflectance::{directional_hemispherical_within, has_flux};
use glam::DVec3;

/// Which part of the light that leaves is meant; all of it where no word is given.
pub(super) const SIDE: Argument =
    Argument::word("side", &["both", "reflection", "transmission"]).optional();

/// The absolute error aimed at, and the evaluations of a lobe: four digits, in some milliseconds.
pub(super) const ACCURACY: (f64, usize) = (1e-5, 400_000);

/// Why there is no share of the light in the surface plane.
pub(super) const NO_FLUX: &str = "no light arrives along the horizon";

pub(super) const QUANTITY: Quantity = Quantity {
    id: "rho_dh",
    symbol: "ρ_dh",
    unit: "",
    meaning: "The directional-hemispherical reflectance: the share of the light's flux that leaves, in all directions together",
    arguments: &[SIDE],
    value: |scene, given| of(scene, scene.light(), given),
};

/// What leaves of the light that arrives along `w`.
pub(super) fn of(scene: &Scene, w: DVec3, given: &[Given]) -> Value {
    if !has_flux(w) {
        return Err(NO_FLUX.to_owned());
    }
    let (tolerance, evaluations) = ACCURACY;
    let all = directional_hemispherical_within(scene.surface(), w, tolerance, evaluations);
    let rgb = match word(given, 0).as_str() {
        "reflection" => all.reflection,
        "transmission" => all.transmission,
        _ => all.leaving(),
    };
    Ok(of_channel(rgb, ""))
}
