//! Parameters that move together: the widths of a material, and what is locked across materials.

use std::collections::BTreeSet;

use super::entry::MaterialEntry;
use super::materials::Materials;
use bxdf::param::{Kind, ParamSpec, Value};
use bxdf::{Component, Material};

/// The other one of the widths of `component` that are linked, along s and t.
fn partner(component: &Component, name: &str) -> Option<&'static str> {
    let [s, t] = component.params().widths()?;
    [(s, t), (t, s)]
        .into_iter()
        .find(|(width, _)| *width == name)
        .map(|(_, other)| other)
}

/// A parameter of a lobe that was changed.
struct Change {
    lobe: usize,
    name: &'static str,
    value: Value,
}

impl Materials {
    /// Whether another material than the selected one has this parameter too.
    #[must_use]
    pub fn is_shared(&self, spec: &ParamSpec) -> bool {
        // Data is no value that others could have too.
        if spec.kind == Kind::Data {
            return false;
        }
        let selected = self.selected().id();
        let has = |component: &Component| {
            let mut specs = component.model().parameters.iter();
            specs.any(|other| other.name == spec.name && other.kind == spec.kind)
        };
        self.iter()
            .filter(|entry| entry.id() != selected)
            .any(|entry| entry.material.components().iter().any(has))
    }

    /// Lets follow what is tied to what was changed in the selected material since it was `before`: its linked widths,
    /// and the parameters `locked` of all other materials. Where a model refuses the value, its own stays.
    pub fn follow(&mut self, before: &MaterialEntry, locked: &BTreeSet<String>) {
        let selected = self.selected_mut();
        if selected.id() != before.id() {
            return;
        }
        if selected.has_linked_widths {
            let is_linked_now = !before.has_linked_widths;
            link(&mut selected.material, &before.material, is_linked_now);
        }
        let changes = changes(&before.material, &selected.material);
        let id = selected.id();
        for change in changes.iter().filter(|change| locked.contains(change.name)) {
            for entry in self.iter_mut().filter(|entry| entry.id() != id) {
                set_everywhere(entry, change);
            }
        }
    }
}

/// What was changed from `before` to `after`; nothing where the lobes are of other models.
fn changes(before: &Material, after: &Material) -> Vec<Change> {
    let ids = |material: &Material| -> Vec<&str> {
        let models = material.components().iter().map(Component::model);
        models.map(|model| model.id).collect()
    };
    if ids(before) != ids(after) {
        return Vec::new();
    }
    let lobes = before.components().iter().zip(after.components());
    lobes
        .enumerate()
        .flat_map(|(lobe, (before, after))| {
            let pairs = before.params().iter().zip(after.params().iter());
            pairs
                .filter(|((_, old), (_, new))| old != new)
                .map(move |(_, (spec, value))| Change {
                    lobe,
                    name: spec.name,
                    value,
                })
        })
        .collect()
}

/// Gives each width that was left alone the value of its partner that was changed; `is_new`: that along t the value along
/// s, whatever was changed.
fn link(material: &mut Material, before: &Material, is_new: bool) {
    let mut components = material.components().to_vec();
    if is_new {
        for component in &mut components {
            let params = component.params();
            if let Some([s, t]) = params.widths()
                && let Some(value) = params.get(s)
            {
                // A model that refuses it keeps its own.
                let _ = component.set(t, value);
            }
        }
    }
    let changes = changes(before, material);
    for change in &changes {
        let Some(component) = components.get_mut(change.lobe) else {
            continue;
        };
        let Some(other) = partner(component, change.name) else {
            continue;
        };
        let is_changed_too = changes
            .iter()
            .any(|own| own.lobe == change.lobe && own.name == other);
        if !is_changed_too {
            let _ = component.set(other, change.value);
        }
    }
    if let Ok(linked) = material.with_components(components) {
        *material = linked;
    }
}

/// Sets the parameter in every lobe of `entry` that has it, and its partner where these are linked.
fn set_everywhere(entry: &mut MaterialEntry, change: &Change) {
    let mut components = entry.material.components().to_vec();
    let is_linked = entry.has_linked_widths;
    for component in &mut components {
        let names = [Some(change.name), partner(component, change.name)];
        for name in names.into_iter().take(1 + usize::from(is_linked)).flatten() {
            // A model without the parameter, or with another range, is as it was.
            let _ = component.set(name, change.value);
        }
    }
    if let Ok(changed) = entry.material.with_components(components) {
        entry.material = changed;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn materials(texts: &[&str]) -> Materials {
        let read = |text: &&str| text.parse().unwrap();
        Materials::new(texts.iter().map(read).collect()).unwrap()
    }

    /// What becomes of the materials where the selected one is edited to `text`.
    fn edited(materials: &mut Materials, text: &str, locked: &[&str]) -> Vec<String> {
        let before = materials.selected().clone();
        materials.selected_mut().material = text.parse().unwrap();
        let locked = locked.iter().copied().map(str::to_owned).collect();
        materials.follow(&before, &locked);
        let texts = materials.iter().map(|entry| entry.material.to_string());
        texts.collect()
    }

    #[test]
    fn widths_move_together_until_they_are_unlinked() {
        let mut one = materials(&["ward:alpha=0.2"]);
        assert!(one.selected().has_linked_widths);
        let texts = edited(&mut one, "ward:alpha_x=0.4,alpha_y=0.2", &[]);
        assert_eq!(texts, ["ward:alpha_x=0.4,alpha_y=0.4"]);
        let texts = edited(&mut one, "ward:alpha_x=0.4,alpha_y=0.1", &[]);
        assert_eq!(texts, ["ward:alpha_x=0.1,alpha_y=0.1"]);
        one.selected_mut().has_linked_widths = false;
        let texts = edited(&mut one, "ward:alpha_x=0.3,alpha_y=0.1", &[]);
        assert_eq!(texts, ["ward:alpha_x=0.3,alpha_y=0.1"]);
        let before = one.selected().clone();
        one.selected_mut().has_linked_widths = true;
        one.follow(&before, &BTreeSet::new());
        let text = one.selected().material.to_string();
        assert_eq!(text, "ward:alpha_x=0.3,alpha_y=0.3");
        assert!(
            !materials(&["ward:alpha_x=0.4"])
                .selected()
                .has_linked_widths
        );
    }

    #[test]
    fn a_locked_parameter_is_set_where_it_is() {
        let mut all = materials(&[
            "rough_conductor",
            "phong",
            "ward:alpha_x=0.1,alpha_y=0.3",
            "ward:alpha=0.1",
        ]);
        let wide = "rough_conductor:alpha=0.5";
        let texts = edited(&mut all, wide, &["alpha_x"]);
        assert_eq!(texts[1], "phong");
        assert_eq!(texts[2], "ward:alpha_x=0.5,alpha_y=0.3");
        assert_eq!(texts[3], "ward:alpha_x=0.5,alpha_y=0.5", "they are linked");
        let texts = edited(&mut all, "rough_conductor:alpha=0.6", &["exponent"]);
        assert_eq!(texts[2], "ward:alpha_x=0.5,alpha_y=0.3");
        let is_shared = |materials: &Materials, name: &str| {
            let mut specs = materials.selected().material.components()[0]
                .model()
                .parameters
                .iter();
            materials.is_shared(specs.find(|spec| spec.name == name).unwrap())
        };
        assert!(is_shared(&all, "alpha_y") && !is_shared(&all, "fresnel"));
    }

    #[test]
    fn what_a_model_refuses_stays() {
        let mut all = materials(&["rough_dielectric", "fresnel_specular:eta=1.2"]);
        let texts = edited(&mut all, "rough_dielectric:eta=1.7", &["eta"]);
        assert_eq!(texts[1], "fresnel_specular:eta=1.7");
        let before = all.selected().clone();
        all.selected_mut().replace("phong".parse().unwrap());
        all.follow(&before, &["eta".to_owned()].into());
        let second = all.iter().nth(1).unwrap();
        assert_eq!(second.material.to_string(), "fresnel_specular:eta=1.7");
    }
}
