//! The list of materials: which there are, which are seen, which is selected, in which order.

use egui::{Context, Rect, ScrollArea, Ui, UiBuilder};

use crate::theme::{self, Palette};
use crate::widgets::thumbnails::Thumbnails;
use action::{Action, grip_id, row_id};
use bxdf::error::Result;
use bxdf_lab::contract::Witness;
use bxdf_study::answers::Answers;
use bxdf_study::session::{EntryId, Materials};
use icons::Icon;
use row::Row;

mod action;
mod icons;
mod row;

/// The share of the panel's height that the list takes at least, in whole rows and whatever is in it: what stands below it does
/// not move when one of the first materials is added. More rows take what room the parameters leave.
const LIST_SHARE: f32 = 0.2;

/// The fewest rows that are in sight, where they leave room for the parameters, and the most of that share.
const ROWS: [f32; 2] = [3.0, 8.0];

/// The largest share of the panel's height that the fewest rows may take.
const LARGEST_SHARE: f32 = 0.4;

/// What the list keeps between frames.
#[derive(Default)]
pub struct MaterialList {
    /// The material whose name is being typed, and what it is so far.
    renaming: Option<(EntryId, String)>,
    /// The selected material, as the list last showed it.
    scrolled_to: Option<EntryId>,
    thumbnails: Thumbnails,
    /// The height of what stands below the list, as it was last drawn, in points.
    below: f32,
}

impl MaterialList {
    /// Leaves so much room below the list from the next frame on, in points.
    pub fn leave_below(&mut self, ctx: &Context, height: f32) {
        if self.below != height {
            self.below = height;
            ctx.request_repaint();
        }
    }

    /// The list; it changes `materials`. Returns the place to go to where a badge is clicked: its material is selected.
    ///
    /// # Errors
    /// [`bxdf::Error::Limit`] where there are as many materials as a session has.
    pub fn show(
        &mut self,
        ui: &mut Ui,
        materials: &mut Materials,
        answers: &mut Answers,
        palette: &Palette,
    ) -> Result<Option<Witness>> {
        let mut wished = Vec::new();
        self.thumbnails.keep_those_of(materials);
        let [fewest, most] = ROWS;
        let rows_of = |share: f32| (share * ui.available_height() / theme::ROW_HEIGHT).floor();
        let fewest = fewest.min(rows_of(LARGEST_SHARE)).max(1.0);
        let least = rows_of(LIST_SHARE).clamp(fewest, most);
        let free = (ui.available_height() - self.below) / theme::ROW_HEIGHT;
        let rows = free.floor().min(materials.count() as f32).max(least);
        let height = rows * theme::ROW_HEIGHT;
        let area = ScrollArea::vertical()
            .id_salt("material list")
            .max_height(height)
            .min_scrolled_height(height)
            .auto_shrink([false, false]);
        area.show(ui, |ui| {
            ui.set_max_width(ui.available_width() - theme::SCROLL_ROOM);
            ui.spacing_mut().item_spacing.y = 0.0;
            let rects = self.rows(ui, materials, answers, palette, &mut wished);
            if let Some((id, place)) = dragged_to(ui, materials, &rects) {
                wished.push((id, Action::MoveTo(place)));
            }
        });
        let mut result = Ok(None);
        for (id, action) in wished {
            match self.act(ui, materials, id, action) {
                Ok(None) => {}
                found => result = found,
            }
        }
        result
    }

    /// The list as icons below one another, where there is no room for more; a click selects.
    pub fn icons(
        &mut self,
        ui: &mut Ui,
        materials: &mut Materials,
        answers: &mut Answers,
        palette: &Palette,
    ) {
        self.thumbnails.keep_those_of(materials);
        let mut chosen = None;
        let area = ScrollArea::vertical()
            .id_salt("material icons")
            .auto_shrink([false, true]);
        area.show(ui, |ui| {
            for entry in materials.iter() {
                let icon = Icon { materials, entry };
                if icon
                    .show(ui, &mut self.thumbnails, answers, palette)
                    .clicked()
                {
                    chosen = Some(entry.id());
                }
            }
        });
        if let Some(id) = chosen {
            materials.select(id);
        }
    }

    /// Every row; returns where they are.
    fn rows(
        &mut self,
        ui: &mut Ui,
        materials: &Materials,
        answers: &mut Answers,
        palette: &Palette,
        wished: &mut Vec<(EntryId, Action)>,
    ) -> Vec<Rect> {
        let selected = materials.selected().id();
        let mut rects = Vec::new();
        for entry in materials.iter() {
            let id = entry.id();
            let typed = self.renaming.as_ref().filter(|(renamed, _)| *renamed == id);
            let row = Row {
                materials,
                entry,
                title: materials.title(entry),
                typed: typed.map(|(_, name)| name.as_str()),
            };
            // A row keeps its ids, and with them the focus, when it moves.
            let scope = UiBuilder::new().scope_id(row_id(id));
            let thumbnails = &mut self.thumbnails;
            let response = ui.scope_builder(scope, |ui| row.show(ui, thumbnails, answers, palette));
            wished.extend(response.inner.into_iter().map(|action| (id, action)));
            let response = response.response;
            rects.push(response.rect);
            if id == selected && self.scrolled_to != Some(id) {
                self.scrolled_to = Some(id);
                response.scroll_to_me(None);
            }
        }
        rects
    }

    fn act(
        &mut self,
        ui: &Ui,
        materials: &mut Materials,
        id: EntryId,
        action: Action,
    ) -> Result<Option<Witness>> {
        match action {
            Action::Select => materials.select(id),
            Action::SetVisible(is_visible) => {
                if let Some(entry) = materials.get_mut(id) {
                    entry.is_visible = is_visible;
                }
            }
            Action::SetSolo(is_alone) => materials.set_solo(is_alone.then_some(id)),
            Action::StartRenaming => {
                materials.select(id);
                self.renaming = materials.get(id).map(|entry| (id, entry.title()));
            }
            Action::Type(name) => self.renaming = Some((id, name)),
            Action::EndRenaming(is_taken) => {
                if let Some((_, name)) = self.renaming.take().filter(|_| is_taken)
                    && let Some(entry) = materials.get_mut(id)
                {
                    entry.rename(&name);
                }
            }
            Action::Duplicate => {
                materials.duplicate(id)?;
            }
            Action::MoveTo(place) => materials.move_to(id, place),
            Action::Copy => {
                if let Some(entry) = materials.get(id) {
                    ui.copy_text(entry.to_text());
                }
            }
            Action::Remove => materials.remove(id),
            Action::Inspect(witness) => {
                materials.select(id);
                return Ok(Some(witness));
            }
        }
        Ok(None)
    }
}

/// The material whose grip is dragged, and the place it is dragged to where that is another one.
fn dragged_to(ui: &Ui, materials: &Materials, rects: &[Rect]) -> Option<(EntryId, usize)> {
    let pointer = ui.ctx().pointer_interact_pos()?;
    let dragged = ui.ctx().dragged_id()?;
    let entry = materials
        .iter()
        .find(|entry| grip_id(entry.id()) == dragged)?;
    let is_above = |rect: &&Rect| rect.bottom() < pointer.y;
    let place = rects.iter().filter(is_above).count();
    let place = place.min(materials.count() - 1);
    (materials.position(entry.id()) != Some(place)).then_some((entry.id(), place))
}
