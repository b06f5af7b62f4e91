//! The materials of a session: their order, which is selected, which are seen.

use std::fmt;

use super::entry::{EntryId, MaterialEntry, PaletteIndex};
use bxdf::Material;
use bxdf::error::{Error, Result};

/// The most materials of a session: more cannot be told apart, and a file of thousands would stop the window.
pub const MAX_MATERIALS: usize = 32;

/// The materials of a session, at least one, in the order of the list. One is selected: the panels edit it.
#[derive(Clone, PartialEq)]
pub struct Materials {
    pub(super) entries: Vec<MaterialEntry>,
    pub(super) selected: EntryId,
    pub(super) solo: Option<EntryId>,
    pub(super) reference: Option<EntryId>,
}

impl Materials {
    /// One material.
    #[must_use]
    pub fn of(material: Material) -> Self {
        let id = EntryId(1);
        Self {
            entries: vec![MaterialEntry::new(id, PaletteIndex(0), material)],
            selected: id,
            solo: None,
            reference: None,
        }
    }

    /// These materials, the first one selected.
    ///
    /// # Errors
    /// [`Error::Limit`] for none and for more than [`MAX_MATERIALS`].
    pub fn new(materials: Vec<Material>) -> Result<Self> {
        let n = materials.len();
        let mut materials = materials.into_iter();
        let Some(first) = materials.next().filter(|_| n <= MAX_MATERIALS) else {
            return Err(limit(n));
        };
        let mut all = Self::of(first);
        for material in materials {
            all.add(material)?;
        }
        all.selected = EntryId(1);
        Ok(all)
    }

    /// Every material, in the order of the list.
    #[must_use]
    pub fn iter(&self) -> impl ExactSizeIterator<Item = &MaterialEntry> + Clone {
        self.entries.iter()
    }

    /// Every material, to be changed.
    pub fn iter_mut(&mut self) -> impl Iterator<Item = &mut MaterialEntry> {
        self.entries.iter_mut()
    }

    /// How many there are.
    #[must_use]
    pub fn count(&self) -> usize {
        self.entries.len()
    }

    /// The material of this id.
    #[must_use]
    pub fn get(&self, id: EntryId) -> Option<&MaterialEntry> {
        self.entries.iter().find(|entry| entry.id == id)
    }

    /// The material of this id, to be changed.
    pub fn get_mut(&mut self, id: EntryId) -> Option<&mut MaterialEntry> {
        self.entries.iter_mut().find(|entry| entry.id == id)
    }

    /// The place in the list.
    #[must_use]
    pub fn position(&self, id: EntryId) -> Option<usize> {
        self.entries.iter().position(|entry| entry.id == id)
    }

    /// The selected material.
    #[must_use]
    #[expect(clippy::indexing_slicing, reason = "there is at least one")]
    pub fn selected(&self) -> &MaterialEntry {
        &self.entries[self.position(self.selected).unwrap_or(0)]
    }

    /// The selected material, to be changed.
    #[must_use]
    #[expect(clippy::indexing_slicing, reason = "there is at least one")]
    pub fn selected_mut(&mut self) -> &mut MaterialEntry {
        let index = self.position(self.selected).unwrap_or(0);
        &mut self.entries[index]
    }

    /// The material that others are compared with: the one chosen, else the first one shown, else the first.
    #[must_use]
    pub fn reference(&self) -> &MaterialEntry {
        let chosen = self.reference.and_then(|id| self.get(id));
        let first = || self.shown().next();
        chosen.or_else(first).unwrap_or_else(|| self.selected())
    }

    /// Chooses the material that others are compared with.
    pub fn compare_with(&mut self, id: EntryId) {
        self.reference = Some(id);
    }

    /// Selects a material; one that is not in the list changes nothing.
    pub fn select(&mut self, id: EntryId) {
        if self.get(id).is_some() {
            self.selected = id;
        }
    }

    /// Selects the material so many places below the selected one, or above; beyond the ends there is none.
    pub fn select_neighbour(&mut self, places: isize) {
        let index = self.position(self.selected().id).unwrap_or(0);
        let neighbour = index.checked_add_signed(places);
        if let Some(entry) = neighbour.and_then(|index| self.entries.get(index)) {
            self.selected = entry.id;
        }
    }

    /// Whether the views show it: one whose data is missing they cannot.
    #[must_use]
    pub fn is_shown(&self, entry: &MaterialEntry) -> bool {
        let is_wanted = self
            .solo
            .map_or(entry.is_visible, |alone| alone == entry.id);
        is_wanted && entry.material.is_complete()
    }

    /// The materials that the views show, in the order of the list.
    pub fn shown(&self) -> impl Iterator<Item = &MaterialEntry> + Clone {
        self.iter().filter(|entry| self.is_shown(entry))
    }

    /// Whether the views show several.
    #[must_use]
    pub fn is_overlay(&self) -> bool {
        self.shown().nth(1).is_some()
    }

    /// The material that is shown alone, whichever others are visible.
    #[must_use]
    pub fn solo(&self) -> Option<EntryId> {
        self.solo
    }

    /// Shows one material alone, or ends that.
    pub fn set_solo(&mut self, alone: Option<EntryId>) {
        self.solo = alone.filter(|id| self.get(*id).is_some());
    }

    /// The name of a material at the screen; equal ones are numbered in the order in which they were added.
    #[must_use]
    pub fn title(&self, entry: &MaterialEntry) -> String {
        let title = entry.title();
        let is_older = |other: &&MaterialEntry| other.id < entry.id && other.title() == title;
        match self.iter().filter(is_older).count() {
            0 => title,
            older => format!("{title} {}", older + 1),
        }
    }

    /// Adds a material at the end, and selects it. One that is alone is so no longer.
    ///
    /// # Errors
    /// [`Error::Limit`] where there are [`MAX_MATERIALS`].
    pub fn add(&mut self, material: Material) -> Result<EntryId> {
        let entry = MaterialEntry::new(self.free_id(), self.free_slot(), material);
        self.insert(self.entries.len(), entry)
    }

    /// Adds the same material with its name below the original, and selects it. One that is alone is so no longer.
    ///
    /// # Errors
    /// [`Error::Limit`] where there are [`MAX_MATERIALS`].
    pub fn duplicate(&mut self, id: EntryId) -> Result<EntryId> {
        let index = self.position(id).unwrap_or(0);
        let original = self.get(id).unwrap_or_else(|| self.selected()).clone();
        let entry = MaterialEntry {
            id: self.free_id(),
            slot: self.free_slot(),
            is_visible: true,
            ..original
        };
        self.insert(index + 1, entry)
    }

    fn insert(&mut self, index: usize, entry: MaterialEntry) -> Result<EntryId> {
        if self.entries.len() >= MAX_MATERIALS {
            return Err(limit(self.entries.len() + 1));
        }
        let id = entry.id;
        self.entries.insert(index.min(self.entries.len()), entry);
        self.selected = id;
        self.solo = None;
        Ok(id)
    }

    /// Removes a material, unless it is the only one; its neighbour is selected.
    pub fn remove(&mut self, id: EntryId) {
        let Some(index) = self.position(id).filter(|_| self.entries.len() > 1) else {
            return;
        };
        self.entries.remove(index);
        self.solo = self.solo.filter(|alone| *alone != id);
        if self.selected == id {
            let next = self.entries.get(index).or(self.entries.last());
            self.selected = next.map_or(id, |entry| entry.id);
        }
    }

    /// Moves a material to this place in the list, or to the end.
    pub fn move_to(&mut self, id: EntryId, place: usize) {
        if let Some(index) = self.position(id) {
            let entry = self.entries.remove(index);
            self.entries.insert(place.min(self.entries.len()), entry);
        }
    }

    pub(super) fn free_id(&self) -> EntryId {
        let last = self.iter().map(|entry| entry.id.0).max().unwrap_or(0);
        EntryId(last.wrapping_add(1))
    }

    /// The first place of the palette that none has.
    pub(super) fn free_slot(&self) -> PaletteIndex {
        let is_free = |slot: &PaletteIndex| self.iter().all(|entry| entry.slot != *slot);
        (0..=u8::MAX)
            .map(PaletteIndex)
            .find(is_free)
            .unwrap_or(PaletteIndex(u8::MAX))
    }
}

impl fmt::Debug for Materials {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(&self.entries).finish()
    }
}

pub(super) fn limit(n: usize) -> Error {
    Error::Limit {
        what: "the number of materials",
        value: n.to_string(),
        limit: format!("1 to {MAX_MATERIALS}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn three() -> Materials {
        let texts = ["phong", "oren_nayar", "phong"];
        Materials::new(texts.map(|text| text.parse().unwrap()).to_vec()).unwrap()
    }

    fn ids(materials: &Materials) -> Vec<u32> {
        materials.iter().map(|entry| entry.id.0).collect()
    }

    #[test]
    fn colours_stay_when_the_order_changes_and_are_used_again() {
        let mut materials = three();
        assert_eq!(ids(&materials), [1, 2, 3]);
        materials.move_to(EntryId(3), 0);
        assert_eq!(ids(&materials), [3, 1, 2]);
        assert_eq!(materials.get(EntryId(3)).unwrap().slot(), PaletteIndex(2));
        materials.remove(EntryId(1));
        let added = materials.add("ward".parse().unwrap()).unwrap();
        assert_eq!(materials.get(added).unwrap().slot(), PaletteIndex(0));
        assert_eq!(materials.selected().id(), added);
    }

    #[test]
    fn equal_names_are_numbered_by_age() {
        let mut materials = three();
        materials.move_to(EntryId(3), 0);
        let titles: Vec<String> = materials.iter().map(|e| materials.title(e)).collect();
        assert_eq!(titles, ["Phong 2", "Phong", "Oren-Nayar"]);
        materials.get_mut(EntryId(1)).unwrap().name = "Wall".to_owned();
        let titles: Vec<String> = materials.iter().map(|e| materials.title(e)).collect();
        assert_eq!(titles, ["Phong", "Wall", "Oren-Nayar"]);
    }

    #[test]
    fn one_is_left_and_one_is_selected() {
        let mut materials = three();
        materials.select(EntryId(3));
        materials.remove(EntryId(3));
        assert_eq!(materials.selected().id(), EntryId(2));
        materials.remove(EntryId(2));
        materials.remove(EntryId(1));
        assert_eq!(ids(&materials), [1]);
        materials.select(EntryId(9));
        assert_eq!(materials.selected().id(), EntryId(1));
        let mut materials = three();
        for (places, expected) in [(1, 2), (1, 3), (1, 3), (-1, 2), (-1, 1), (-1, 1)] {
            materials.select_neighbour(places);
            assert_eq!(materials.selected().id(), EntryId(expected));
        }
    }

    #[test]
    fn one_alone_hides_the_others_until_one_is_added() {
        let mut materials = three();
        materials.get_mut(EntryId(2)).unwrap().is_visible = false;
        assert_eq!(materials.shown().count(), 2);
        materials.set_solo(Some(EntryId(2)));
        assert!(materials.shown().map(MaterialEntry::id).eq([EntryId(2)]));
        assert!(!materials.is_overlay());
        let copy = materials.duplicate(EntryId(2)).unwrap();
        assert_eq!(materials.solo(), None);
        assert_eq!(
            materials.position(copy),
            Some(2),
            "it stands below the original"
        );
        assert!(materials.get(copy).unwrap().is_visible);
    }

    #[test]
    fn there_is_a_limit() {
        let mut materials = three();
        while materials.count() < MAX_MATERIALS {
            materials.duplicate(EntryId(1)).unwrap();
        }
        let line = materials.duplicate(EntryId(1)).unwrap_err().to_string();
        assert!(line.contains("the number of materials"), "{line}");
        assert!(Materials::new(Vec::new()).is_err());
    }
}
