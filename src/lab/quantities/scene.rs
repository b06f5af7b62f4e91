//! What quantities are of: a material, turned about n, a light and a viewer.

use std::sync::OnceLock;

use glam::DVec3;

use crate::analysis::{HeldLobe, Hold};
use bxdf::math::frame;
use bxdf::{Component, Error, Material, Rotated, Scatterer};

/// A surface with a light and a viewer.
pub struct Scene {
    material: Material,
    rotation_deg: f64,
    light: DVec3,
    viewer: DVec3,
    surface: OnceLock<Box<dyn Scatterer<f64>>>,
}

impl Clone for Scene {
    fn clone(&self) -> Self {
        Self::new(
            self.material.clone(),
            self.rotation_deg,
            self.light,
            self.viewer,
        )
    }
}

impl PartialEq for Scene {
    fn eq(&self, other: &Self) -> bool {
        (self.rotation_deg, self.light, self.viewer)
            == (other.rotation_deg, other.light, other.viewer)
            && self.material == other.material
    }
}

impl Scene {
    /// `material`, turned about n by `rotation_deg`, with the unit vectors to the light and to the viewer.
    #[must_use]
    pub fn new(material: Material, rotation_deg: f64, light: DVec3, viewer: DVec3) -> Self {
        Self {
            material,
            rotation_deg,
            light,
            viewer,
            surface: OnceLock::new(),
        }
    }

    /// The material.
    #[must_use]
    pub fn material(&self) -> &Material {
        &self.material
    }

    /// By how much the surface is turned about n, in degrees.
    pub(super) fn rotation_deg(&self) -> f64 {
        self.rotation_deg
    }

    /// The unit vector to the light.
    #[must_use]
    pub fn light(&self) -> DVec3 {
        self.light
    }

    /// The unit vector to the viewer.
    #[must_use]
    pub fn viewer(&self) -> DVec3 {
        self.viewer
    }

    /// The unit vector halfway between both; `None` where they are opposite.
    pub(super) fn half(&self) -> Option<DVec3> {
        (self.light + self.viewer).try_normalize()
    }

    /// The surface.
    pub(super) fn surface(&self) -> &dyn Scatterer<f64> {
        let surface = self.surface.get_or_init(|| {
            let turn = frame::cos_sin_deg(self.rotation_deg);
            Box::new(Rotated::new(self.material.build(), turn))
        });
        &**surface
    }

    /// The surface with the light or the viewer held.
    pub(super) fn held(&self, hold: Hold) -> HeldLobe<'_> {
        let held = match hold {
            Hold::Light => self.light,
            Hold::Viewer => self.viewer,
        };
        HeldLobe::new(self.surface(), hold, held)
    }

    /// The scene with another material.
    #[must_use]
    pub fn with_material(self, material: Material) -> Self {
        Self::new(material, self.rotation_deg, self.light, self.viewer)
    }

    /// The scene with the light at this angle from n, in degrees, where it was around it; to the left where it was at n.
    #[must_use]
    pub fn with_light(self, theta_deg: f64) -> Self {
        let light = lifted(self.light, theta_deg, 180.0);
        Self { light, ..self }
    }

    /// The scene with the viewer at this angle from n, in degrees, where it was around it; to the right where it was at n.
    #[must_use]
    pub fn with_viewer(self, theta_deg: f64) -> Self {
        let viewer = lifted(self.viewer, theta_deg, 0.0);
        Self { viewer, ..self }
    }

    /// The scene with the light at this azimuth from s, in degrees, as far from n as it was.
    #[must_use]
    pub fn with_light_azimuth(self, phi_deg: f64) -> Self {
        let light = turned_to(self.light, phi_deg);
        Self { light, ..self }
    }

    /// The scene with the viewer at this azimuth from s, in degrees, as far from n as it was.
    #[must_use]
    pub fn with_viewer_azimuth(self, phi_deg: f64) -> Self {
        let viewer = turned_to(self.viewer, phi_deg);
        Self { viewer, ..self }
    }

    /// The scene with a parameter of its material at the value that this text says, in every component that has it.
    ///
    /// # Errors
    /// Where no component has it, and where the value is not allowed.
    pub fn with_parameter(self, name: &str, text: &str) -> Result<Self, String> {
        let mut components: Vec<Component> = self.material.components().to_vec();
        let mut is_known = false;
        for component in &mut components {
            let known = component.params().targets(name);
            if known.is_empty()
                || known
                    .iter()
                    .any(|one| component.params().get(one).is_none())
            {
                continue;
            }
            is_known = true;
            component
                .set_text(name, text)
                .map_err(|error| error.to_string())?;
        }
        if !is_known {
            return Err(unknown_parameter(&self.material, name));
        }
        let changed = self
            .material
            .with_components(components)
            .map_err(|error| error.to_string())?;
        Ok(self.with_material(changed))
    }
}

/// A sentence that says which parameters `material` has in place of `name`.
pub(super) fn unknown_parameter(material: &Material, name: &str) -> String {
    let names = material.components().iter();
    let names = names.flat_map(|component| component.params().iter().map(|(spec, _)| spec.name));
    Error::unknown("parameter", name, names).to_string()
}

/// The direction as far from n in this azimuth.
fn turned_to(w: DVec3, phi_deg: f64) -> DVec3 {
    frame::direction_from_degrees(frame::theta(w).to_degrees(), phi_deg)
}

/// The direction in the same azimuth at this angle from n; in the azimuth `else_deg` where it has none.
fn lifted(w: DVec3, theta_deg: f64, else_deg: f64) -> DVec3 {
    let has_azimuth = w.x != 0.0 || w.y != 0.0;
    let phi_deg = if has_azimuth {
        frame::phi(w).to_degrees()
    } else {
        else_deg
    };
    frame::direction_from_degrees(theta_deg, phi_deg)
}
