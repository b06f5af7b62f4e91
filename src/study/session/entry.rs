//! A material of a session, with how it is shown.

use bxdf::Material;

/// What tells a material of a session from the others, whatever becomes of its name and its place in the list.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct EntryId(pub(super) u32);

/// The place in the palette of materials: a colour and a line style that it keeps.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct PaletteIndex(pub u8);

/// A material of the session, and how it is shown.
#[derive(Clone, Debug, PartialEq)]
pub struct MaterialEntry {
    pub(super) id: EntryId,
    pub(super) slot: PaletteIndex,
    /// The name the user gave it; empty for that of the material.
    pub name: String,
    /// The material.
    pub material: Material,
    /// Whether the views show it, where no other is alone.
    pub is_visible: bool,
    /// Whether the widths along s and t move together.
    pub has_linked_widths: bool,
}

impl MaterialEntry {
    pub(super) fn new(id: EntryId, slot: PaletteIndex, material: Material) -> Self {
        Self {
            id,
            slot,
            name: String::new(),
            has_linked_widths: has_equal_widths(&material),
            material,
            is_visible: true,
        }
    }

    /// What it is known by.
    #[must_use]
    pub fn id(&self) -> EntryId {
        self.id
    }

    /// Its colour and line style.
    #[must_use]
    pub fn slot(&self) -> PaletteIndex {
        self.slot
    }

    /// Its name at the screen, which others may share: see [`super::Materials::title`].
    #[must_use]
    pub fn title(&self) -> String {
        if self.name.is_empty() {
            self.material.title()
        } else {
            self.name.clone()
        }
    }

    /// Gives it this name; nothing, or the name of the material, is no name of its own.
    pub fn rename(&mut self, name: &str) {
        let name = name.trim();
        self.name = if name == self.material.title() {
            String::new()
        } else {
            name.to_owned()
        };
    }

    /// Replaces the material; its widths are linked where they are equal.
    pub fn replace(&mut self, material: Material) {
        self.has_linked_widths = has_equal_widths(&material);
        self.material = material;
    }
}

/// Whether no lobe of `material` is wider along s than along t.
pub(super) fn has_equal_widths(material: &Material) -> bool {
    material.components().iter().all(|component| {
        let params = component.params();
        let widths = params
            .widths()
            .map(|names| names.map(|name| params.get(name)));
        widths.is_none_or(|[s, t]| s == t)
    })
}
