//! The parameters of the selected material: what is changed of them, and which are pinned.

use super::App;
use bxdf_study::parameters::changed;
use bxdf_study::session::{MaterialEntry, Session};

impl App {
    /// Takes what controls have made of the selected material; what is tied to that follows.
    pub(crate) fn take_edited(&mut self, edited: MaterialEntry) {
        let Session {
            materials, locked, ..
        } = &mut self.session;
        let before = materials.selected().clone();
        if edited == before {
            return;
        }
        let specs = changed(&before.material, &edited.material);
        self.last_changed = specs.first().map(|spec| spec.name).or(self.last_changed);
        *materials.selected_mut() = edited;
        materials.follow(&before, locked);
    }

    /// Pins the parameter that was changed last, or no longer.
    pub fn pin_last(&mut self) {
        if let Some(name) = self.last_changed
            && !self.session.pinned.remove(name)
        {
            self.session.pinned.insert(name.to_owned());
        }
    }

    /// What that would do, in words.
    #[must_use]
    pub fn pin_now(&self) -> Option<String> {
        let name = self.last_changed?;
        let mut lobes = self.session.material().components().iter();
        let specs = lobes.find_map(|lobe| {
            let mut specs = lobe.model().parameters.iter();
            specs.find(|spec| spec.name == name)
        });
        let verb = if self.session.pinned.contains(name) {
            "Unpin"
        } else {
            "Pin"
        };
        specs.map(|spec| format!("{verb}: {}", bxdf_study::parameters::label(spec)))
    }
}
