//! The picker: every model and every named material under its category.

use egui::{
    Align, Atom, Button, Color32, IdSalt, Key, Layout, Rect, Response, RichText, ScrollArea,
    TextEdit, Ui, Vec2, pos2,
};

use super::thumbnails::Thumbnails;
use crate::bxdf::material::library::{self, Named};
use crate::bxdf::models::{self, MODELS};
use crate::bxdf::{Category, Material, ModelSpec, Side};
use crate::error::Result;
use crate::ui::session::{EntryId, MaterialEntry, Materials};
use crate::ui::theme;

/// The share of the panel's height that the list may take; the rest is for the parameters.
const LIST_SHARE: f32 = 0.45;

/// What the picker keeps between frames.
pub struct Picker {
    list: List,
    search: String,
    /// Materials looked at before: their sliders stand as they were left.
    shelf: Vec<(EntryId, Material)>,
    /// The id of the chosen entry that its list was last scrolled to.
    scrolled_to: &'static str,
    thumbnails: Thumbnails,
    /// The material it was last shown beside.
    beside: Option<EntryId>,
    /// Whether the list is folded away, to leave its room to the parameters.
    is_folded: bool,
    /// Whether the next choice is added, in place of replacing the selected material.
    pub is_adding: bool,
}

/// Which list is shown.
#[derive(Clone, Copy, PartialEq, Eq)]
enum List {
    Models,
    Materials,
}

impl List {
    /// The word for it, and what the search says where it finds nothing.
    fn words(self) -> [&'static str; 2] {
        match self {
            Self::Models => ["models", "No model has this name, category or author"],
            Self::Materials => [
                "materials",
                "No material has this name, note, category or model",
            ],
        }
    }
}

/// A row of a list.
#[derive(Clone, Copy)]
enum Entry {
    Model(&'static ModelSpec),
    Named(&'static Named),
}

impl Entry {
    /// What `material` was chosen as, whatever was changed since. `None` for a file of the user's own.
    fn of(material: &Material) -> Option<Self> {
        if material.name.is_empty() {
            let model = material.components().first()?.model();
            return models::find(model.id).ok().map(Self::Model);
        }
        library::origin(material).map(Self::Named)
    }

    /// Whether `material` was chosen as this.
    fn is_origin_of(self, material: &Material) -> bool {
        Self::of(material).is_some_and(|origin| origin.id() == self.id())
    }

    /// Its id: no model has that of a named material.
    fn id(self) -> &'static str {
        match self {
            Self::Model(model) => model.id,
            Self::Named(named) => named.id,
        }
    }

    fn category(self) -> Category {
        match self {
            Self::Model(model) => model.category(),
            Self::Named(named) => named.material.category(),
        }
    }

    /// The material as it stands in the list.
    fn material(self) -> Material {
        match self {
            Self::Model(model) => Material::of(model),
            Self::Named(named) => named.material.clone(),
        }
    }

    fn hint(self) -> String {
        match self {
            Self::Model(model) => {
                let ModelSpec {
                    summary, source, ..
                } = model;
                format!("{summary}\n\n{source}\n\nR: reflects, T: transmits")
            }
            Self::Named(Named { material, .. }) => {
                format!("{}\n\n{}", material.note, material.source)
            }
        }
    }

    /// Whether `wanted`, in lower case, stands somewhere in what is known of it.
    fn is_found(self, wanted: &str) -> bool {
        let has = |text: &str| text.to_lowercase().contains(wanted);
        has(self.id())
            || has(self.category().title())
            || match self {
                Self::Model(model) => has(model.title) || has(model.source),
                Self::Named(Named { material, .. }) => {
                    let mut components = material.components().iter();
                    has(&material.name)
                        || has(&material.note)
                        || components.any(|component| {
                            has(component.model().id) || has(component.model().title)
                        })
                }
            }
    }
}

impl Picker {
    /// The picker. `is_at_once`: see [`Thumbnails::new`].
    #[must_use]
    pub fn new(is_at_once: bool) -> Self {
        Self {
            list: List::Models,
            search: String::new(),
            shelf: Vec::new(),
            scrolled_to: "",
            thumbnails: Thumbnails::new(is_at_once),
            beside: None,
            is_folded: false,
            is_adding: false,
        }
    }

    /// The switch, the search field, and the list that the search leaves. Choosing an entry replaces the selected
    /// material by the one chosen as that before, or by the entry as it stands in the list; while one is to be added, it
    /// adds that.
    ///
    /// # Errors
    /// [`crate::Error::Limit`] where there are as many materials as a session has.
    pub fn show(&mut self, ui: &mut Ui, materials: &mut Materials) -> Result<()> {
        self.follow(materials.selected());
        if self.is_adding {
            self.is_folded = false;
            self.say_adding(ui);
        }
        self.switch(ui);
        if self.is_folded {
            return Ok(());
        }
        let [what, _] = self.list.words();
        let name = format!("Search {what}");
        let field = TextEdit::singleline(&mut self.search)
            .hint_text(&name)
            .desired_width(f32::INFINITY);
        let hint = match self.list {
            List::Models => "Find a model by name, id, category or author",
            List::Materials => "Find a material by name, note, category or model",
        };
        let field = ui.add(field).on_hover_text(hint);
        ui.ctx()
            .accesskit_node_builder(field.id, |node| node.set_label(name));
        let wanted = self.search.trim().to_lowercase();
        let height = LIST_SHARE * ui.available_height();
        let area = ScrollArea::vertical()
            .id_salt(what)
            .max_height(height)
            .auto_shrink([false, true]);
        let chosen = area.show(ui, |ui| self.entries(ui, &wanted, materials.selected()));
        match chosen.inner {
            Some(entry) if self.is_adding => {
                self.is_adding = false;
                materials.add(entry.material()).map(|_| ())
            }
            Some(entry) => {
                self.replace(materials.selected_mut(), entry);
                Ok(())
            }
            None => Ok(()),
        }
    }

    /// Which list is shown, and whether.
    fn switch(&mut self, ui: &mut Ui) {
        ui.horizontal(|ui| {
            for (list, name, hint) in [
                (List::Models, "Models", "Formulas at their default parameters, each by itself"),
                (
                    List::Materials,
                    "Materials",
                    "Things to recognise: one or several models with parameters from a stated source",
                ),
            ] {
                let is_shown = self.list == list && !self.is_folded;
                if ui.selectable_label(is_shown, name).on_hover_text(hint).clicked() {
                    (self.list, self.is_folded) = (list, false);
                }
            }
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                let word = if self.is_folded { "Unfold" } else { "Fold" };
                let hint = "Fold the list away, to leave its room to the parameters, or unfold it";
                if ui.small_button(word).on_hover_text(hint).clicked() {
                    self.is_folded = !self.is_folded;
                }
            });
        });
    }

    /// Shows the list in which the selected material stands, where another one has been selected.
    fn follow(&mut self, selected: &MaterialEntry) {
        if self.beside == Some(selected.id()) {
            return;
        }
        self.beside = Some(selected.id());
        self.scrolled_to = "";
        match Entry::of(&selected.material) {
            Some(Entry::Named(_)) => self.list = List::Materials,
            Some(Entry::Model(_)) => self.list = List::Models,
            None => {}
        }
    }

    /// Says what the next choice does; Escape ends it.
    fn say_adding(&mut self, ui: &mut Ui) {
        ui.horizontal(|ui| {
            ui.label(RichText::new("Choose what to add").strong());
            let cancel = ui
                .small_button("Cancel")
                .on_hover_text("Add nothing (Escape)");
            let is_escaped = ui.input(|input| input.key_pressed(Key::Escape));
            self.is_adding &= !cancel.clicked() && !is_escaped;
        });
    }

    /// Replaces the material; it is kept as it was left.
    fn replace(&mut self, chosen: &mut MaterialEntry, entry: Entry) {
        let id = chosen.id();
        // It is under the pointer: the list stays where it is.
        self.scrolled_to = entry.id();
        let is_kept = |(of, kept): &(EntryId, Material)| *of == id && entry.is_origin_of(kept);
        let kept = self.shelf.iter().position(is_kept);
        let next = kept.map_or_else(|| entry.material(), |index| self.shelf.swap_remove(index).1);
        self.shelf.push((id, chosen.material.clone()));
        chosen.replace(next);
    }

    /// The entries that hold `wanted`. Returns the one that is chosen now.
    fn entries(&mut self, ui: &mut Ui, wanted: &str, selected: &MaterialEntry) -> Option<Entry> {
        let mut chosen = None;
        let listed: Vec<Entry> = match self.list {
            List::Models => MODELS.into_iter().map(Entry::Model).collect(),
            List::Materials => library::all().iter().map(Entry::Named).collect(),
        };
        let mut is_empty = true;
        for category in Category::ALL {
            let is_shown = |entry: &&Entry| entry.category() == category && entry.is_found(wanted);
            let shown: Vec<&Entry> = listed.iter().filter(is_shown).collect();
            if shown.is_empty() {
                continue;
            }
            is_empty = false;
            ui.label(RichText::new(category.title()).strong())
                .on_hover_text(category.meaning());
            ui.indent(category.id(), |ui| {
                for entry in shown {
                    if self.row(ui, *entry, selected) {
                        chosen = Some(*entry);
                    }
                }
            });
        }
        if is_empty {
            let [_, nothing] = self.list.words();
            ui.weak(nothing);
        }
        chosen
    }

    /// A row. Returns whether it is chosen now.
    fn row(&mut self, ui: &mut Ui, entry: Entry, selected: &MaterialEntry) -> bool {
        let is_chosen = !self.is_adding && entry.is_origin_of(&selected.material);
        let row = match entry {
            Entry::Model(model) => ui.selectable_label(is_chosen, title(model)),
            Entry::Named(named) => self.pictured(ui, named, is_chosen),
        };
        let row = row.on_hover_text(entry.hint());
        if is_chosen && self.scrolled_to != entry.id() {
            self.scrolled_to = entry.id();
            row.scroll_to_me(Some(Align::Center));
        }
        row.clicked() && !is_chosen
    }

    /// A row with a picture; the name says it all to those who do not see.
    fn pictured(&mut self, ui: &mut Ui, named: &'static Named, is_chosen: bool) -> Response {
        let salt = IdSalt::new(named.id);
        let picture = Atom::custom(salt, Vec2::splat(theme::THUMBNAIL_SIZE));
        let row = Button::selectable(is_chosen, (picture, named.material.name.as_str())).truncate();
        let row = row.atom_ui(ui);
        if let Some(rect) = row.rect(salt)
            && ui.is_rect_visible(rect)
            && let Some(texture) = self.thumbnails.get(ui.ctx(), named)
        {
            let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
            ui.painter().image(texture, rect, whole, Color32::WHITE);
        }
        row.response
    }
}

/// The title, and the sides where they are not plain from it.
#[must_use]
pub fn title(model: &ModelSpec) -> String {
    let sides: Vec<&str> = [(Side::Reflection, "R"), (Side::Transmission, "T")]
        .into_iter()
        .filter(|(side, _)| model.lobes.iter().any(|lobe| lobe.side == *side))
        .map(|(_, letter)| letter)
        .collect();
    format!("{}  ({})", model.title, sides.join(" + "))
}
