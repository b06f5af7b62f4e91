//! The four kinds of reflection, side by side.

use super::materials::Materials;
use super::{READY_LAYOUTS, Session};
use crate::views::{Arrangement, ScaleChoice};
use bxdf::material::library;

/// A named material of each category: diffuse, glossy, perfect specular, retro-reflective.
const OF_EACH_KIND: [&str; 4] = ["chalk", "brass", "mirror", "road_sign"];

impl Session {
    /// Shows a material of each of the four categories of reflection side by side under one light, each lobe to its peak, in
    /// place of the materials there are, in a window with this `room` for views.
    pub fn show_four_kinds(&mut self, room: [f32; 2]) {
        let named = OF_EACH_KIND.iter().filter_map(|id| library::find(id).ok());
        let mut found = named.map(|named| named.material.clone());
        let Some(first) = found.next() else {
            return;
        };
        let mut materials = Materials::of(first);
        for other in found {
            // Four are never too many.
            let _ = materials.add(other);
        }
        let first = materials.iter().next().map(super::MaterialEntry::id);
        if let Some(first) = first {
            materials.select(first);
        }
        self.materials = materials;
        let [look, ..] = &READY_LAYOUTS;
        self.views.show_ready(look, room);
        self.views
            .each_scale(|scale| scale.choose(ScaleChoice::EachToPeak));
        self.views
            .each_arrangement(|arrangement| *arrangement = Arrangement::SideBySide);
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use bxdf::Category;

    #[test]
    fn each_kind_stands_for_itself() {
        let mut session = Session::default();
        session.show_four_kinds([1280.0, 720.0]);
        assert_eq!(session.materials.shown().count(), 4);
        let mut kinds = BTreeSet::new();
        for entry in session.materials.iter() {
            let surface = entry.material.build::<f64>();
            if entry.material.is_delta_only() {
                kinds.insert(format!("{:?}", Category::PerfectSpecular));
            }
            // The strongest lobe of each stands first.
            let first = surface.lobes().first();
            kinds.extend(first.map(|lobe| format!("{:?}", lobe.category)));
        }
        assert_eq!(kinds.len(), OF_EACH_KIND.len(), "{kinds:?}");
        let text = session.to_toml().unwrap();
        assert_eq!(Session::from_toml(&text, "s").unwrap(), session);
    }
}
