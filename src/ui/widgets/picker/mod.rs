//! The picker: every named material and every model as a picture under its category, beside the panel and over the views.

use egui::{Context, Rect};

use super::thumbnails::Thumbnails;
use bxdf::Material;
use bxdf::error::Result;
use bxdf_study::answers::Answers;
use bxdf_study::session::{EntryId, MaterialEntry, Materials};
use entry::Entry;
pub use entry::title;
use open::{Open, field_id};

mod cell;
mod entry;
mod grid;
mod open;

/// What the picker keeps between frames.
#[derive(Default)]
pub struct Picker {
    /// What is shown of it; `None` while it is closed.
    open: Option<Open>,
    /// Materials looked at before: their sliders stand as they were left.
    shelf: Vec<(EntryId, Material)>,
    thumbnails: Thumbnails,
}

impl Picker {
    /// Shows it, so that the next choice replaces the selected material, or is added where it `is_adding`; or closes it, if
    /// that is what it is for already.
    pub fn toggle(&mut self, ctx: &Context, is_adding: bool, selected: &MaterialEntry) {
        let is_it = |open: &Open| open.is_adding == is_adding;
        if self.open.as_ref().is_some_and(is_it) {
            self.close(ctx);
            return;
        }
        self.open = Some(Open::new(is_adding, selected));
        ctx.memory_mut(|memory| memory.request_focus(field_id()));
    }

    /// Closes it.
    pub fn close(&mut self, ctx: &Context) {
        self.open = None;
        ctx.memory_mut(|memory| memory.surrender_focus(field_id()));
    }

    /// Whether it is shown.
    #[must_use]
    pub fn is_open(&self) -> bool {
        self.open.is_some()
    }

    /// Whether what is typed next goes to the search.
    #[must_use]
    pub fn has_focus(&self, ctx: &Context) -> bool {
        self.is_open() && ctx.memory(|memory| memory.has_focus(field_id()))
    }

    /// What is shown of it, over `room`. Choosing an entry replaces the selected material by the one chosen as that before, or
    /// by the entry as it stands in the list; while one is to be added, it adds that.
    ///
    /// # Errors
    /// [`bxdf::Error::Limit`] where there are as many materials as a session has.
    pub fn show(
        &mut self,
        ctx: &Context,
        room: Rect,
        materials: &mut Materials,
        answers: &mut Answers,
    ) -> Result<()> {
        let Some(open) = &mut self.open else {
            return Ok(());
        };
        let outcome = open.show(ctx, room, materials, (&mut self.thumbnails, answers));
        let mut result = Ok(());
        let mut is_left = outcome.is_left;
        if let Some((entry, is_added_and_stays)) = outcome.chosen {
            if is_added_and_stays || open.is_adding {
                result = materials.add(entry.material().into_owned()).map(|_| ());
            } else if !entry.is_origin_of(&materials.selected().material) {
                self.replace(materials.selected_mut(), entry);
            }
            is_left |= !is_added_and_stays;
        }
        if is_left {
            self.close(ctx);
        }
        result
    }

    /// Replaces the material; it is kept as it was left.
    fn replace(&mut self, chosen: &mut MaterialEntry, entry: Entry) {
        let id = chosen.id();
        let is_kept = |(of, kept): &(EntryId, Material)| *of == id && entry.is_origin_of(kept);
        let kept = self.shelf.iter().position(is_kept);
        let next = kept.map_or_else(
            || entry.material().into_owned(),
            |index| self.shelf.swap_remove(index).1,
        );
        self.shelf.push((id, chosen.material.clone()));
        chosen.replace(next);
    }
}
