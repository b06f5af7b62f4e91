//! The factors of a microfacet model.

use glam::DVec3;

use super::f::{CHANNEL, of_channel};
use super::quantity::{Argument, Given, Quantity, Value, word};
use super::scene::Scene;
use bxdf::Microfacet;

pub(super) const DENSITY: Quantity = Quantity {
    id: "D",
    symbol: "D(h)",
    unit: "1/sr",
    meaning: "The density of microfacet normals at the half vector of light and viewer",
    arguments: &[],
    value: |scene, _| Ok(here(scene)?.d),
};

pub(super) const MASKING: Quantity = Quantity {
    id: "G",
    symbol: "G",
    unit: "",
    meaning: "The share of the facets that both light and viewer see",
    arguments: &[],
    value: |scene, _| Ok(here(scene)?.g),
};

/// With the other direction at n nothing is hidden from it, so that both factors together are that of the one.
pub(super) const MASKING_OF_ONE: Quantity = Quantity {
    id: "G1",
    symbol: "G₁",
    unit: "",
    meaning: "The share of the facets that one direction sees, the light's or the viewer's",
    arguments: &[Argument::word("direction", &["light", "viewer"])],
    value: |scene, given| {
        let w = match word(given, 0).as_str() {
            "light" => scene.light(),
            _ => scene.viewer(),
        };
        Ok(factors(scene, DVec3::Z, w)?.g)
    },
};

pub(super) const FRESNEL: Quantity = Quantity {
    id: "F",
    symbol: "F",
    unit: "",
    meaning: "The Fresnel factor of the facet that sends light to the viewer: reflectance, or transmittance across the surface",
    arguments: &[CHANNEL],
    value: fresnel,
};

fn fresnel(scene: &Scene, given: &[Given]) -> Value {
    let factors = here(scene)?;
    Ok(of_channel(factors.fresnel.to_f64(), &word(given, 0)))
}

fn here(scene: &Scene) -> Result<Microfacet<f64>, String> {
    factors(scene, scene.viewer(), scene.light())
}

/// The factors at a pair.
pub(super) fn factors(scene: &Scene, wo: DVec3, wi: DVec3) -> Result<Microfacet<f64>, String> {
    let factors = scene.surface().microfacet(wo.into(), wi.into());
    factors.ok_or_else(|| {
        "the material is no single microfacet model, or there is no half vector".to_owned()
    })
}
