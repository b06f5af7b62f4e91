//! The materials of a session with its light and its viewer, as quantities are asked of them.

use super::call::{Call, Setting};
use crate::session::Session;
use bxdf_lab::quantities::{Given, Scene};

/// A scene for each material of a session.
#[derive(Clone, PartialEq)]
pub struct Scenes {
    /// The names at the screen, each with its scene.
    all: Vec<(String, Scene)>,
    selected: usize,
}

impl Scenes {
    /// Those of a session.
    #[must_use]
    pub fn of(session: &Session) -> Self {
        let (light, viewer) = (session.light(), session.viewer());
        let scene = |material: &bxdf::Material| {
            Scene::new(material.clone(), session.rotation_deg, light, viewer)
        };
        let entries = session.materials.iter();
        let all = entries.map(|entry| (entry.title(), scene(&entry.material)));
        let selected = session.materials.selected().id();
        Self {
            all: all.collect(),
            selected: session.materials.position(selected).unwrap_or(0),
        }
    }

    /// What a quantity is worth where its settings say.
    pub(super) fn value(&self, call: &Call) -> Result<f64, String> {
        let at = self.all.get(self.selected).map(|(_, scene)| scene);
        let at = at.ok_or("there is no material")?;
        if call.settings.is_empty() {
            return call.quantity.value(at, &call.given);
        }
        let (materials, others): (Vec<&Setting>, Vec<&Setting>) = call
            .settings
            .iter()
            .partition(|setting| setting.name == "material");
        let mut scene = match materials.last() {
            Some(setting) => self.named(&setting.value)?.clone(),
            None => at.clone(),
        };
        for setting in others {
            scene = changed(scene, setting)?;
        }
        call.quantity.value(&scene, &call.given)
    }

    /// The scene of a material by its number in the list, from 1 on, or by its name.
    fn named(&self, given: &Given) -> Result<&Scene, String> {
        let found = match given {
            Given::Number(number) => {
                let is_it = |(index, _): &(usize, _)| (*index + 1) as f64 == *number;
                let mut all = self.all.iter().enumerate();
                all.find(is_it).map(|(_, (_, scene))| scene)
            }
            Given::Word(word) => {
                let is_it =
                    |(name, _): &&(String, Scene)| name.to_lowercase() == word.to_lowercase();
                self.all.iter().find(is_it).map(|(_, scene)| scene)
            }
        };
        found.ok_or_else(|| {
            let names: Vec<&str> = self.all.iter().map(|(name, _)| name.as_str()).collect();
            let shown = match given {
                Given::Number(number) => number.to_string(),
                Given::Word(word) => format!("'{word}'"),
            };
            format!(
                "there is no material {shown}: there is {}",
                names.join(", ")
            )
        })
    }
}

/// A scene with one thing other than it was.
fn changed(scene: Scene, setting: &Setting) -> Result<Scene, String> {
    let Setting { name, value } = setting;
    let angle = || match value {
        Given::Number(angle) if (0.0..=180.0).contains(angle) => Ok(*angle),
        other => Err(format!(
            "{name} '{other}': expected an angle from 0 to 180 degrees"
        )),
    };
    let azimuth = || match value {
        Given::Number(azimuth) if azimuth.abs() <= 360.0 => Ok(*azimuth),
        other => Err(format!(
            "{name} '{other}': expected an angle from -360 to 360 degrees"
        )),
    };
    match name.as_str() {
        "light" => Ok(scene.with_light(angle()?)),
        "viewer" => Ok(scene.with_viewer(angle()?)),
        "light azimuth" => Ok(scene.with_light_azimuth(azimuth()?)),
        "viewer azimuth" => Ok(scene.with_viewer_azimuth(azimuth()?)),
        _ => scene.with_parameter(name, &value.text()),
    }
}
