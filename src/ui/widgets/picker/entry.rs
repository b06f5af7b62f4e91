//! What the picker lists: models and named materials.

use std::borrow::Cow;

use crate::widgets::hits::Known;
use bxdf::Catalogue;
use bxdf::material::library::{self, Named};
use bxdf::{Category, Material, ModelSpec, Side};

/// Which list is shown.
#[derive(Clone, Copy, Default, PartialEq, Eq)]
pub(super) enum List {
    Models,
    #[default]
    Materials,
}

impl List {
    /// The word for it.
    pub(super) fn word(self) -> &'static str {
        match self {
            Self::Models => "models",
            Self::Materials => "materials",
        }
    }

    /// What stands in it, by category.
    pub(super) fn entries(self) -> Vec<Entry> {
        let mut all: Vec<Entry> = match self {
            Self::Models => {
                let models = Catalogue::current().models().iter();
                models.copied().map(Entry::Model).collect()
            }
            Self::Materials => library::all().iter().map(Entry::Named).collect(),
        };
        all.sort_by_key(|entry| entry.category());
        all
    }

    /// Both, in the order of the tabs: its title and what stands in it.
    pub(super) const ALL: [(Self, &str, &str); 2] = [
        (
            Self::Materials,
            "Materials",
            "Things to recognise: one or several models with parameters from a stated source",
        ),
        (
            Self::Models,
            "Models",
            "Formulas at their default parameters, each by itself",
        ),
    ];

    /// The one in which what `material` was chosen as stands; `None` for a file of the user's own.
    pub(super) fn of(material: &Material) -> Option<Self> {
        Entry::of(material).map(|entry| match entry {
            Entry::Model(_) => Self::Models,
            Entry::Named(_) => Self::Materials,
        })
    }

    /// The other one.
    pub(super) fn other(self) -> Self {
        match self {
            Self::Models => Self::Materials,
            Self::Materials => Self::Models,
        }
    }
}

/// A row of a list.
#[derive(Clone, Copy)]
pub(super) enum Entry {
    Model(&'static ModelSpec),
    Named(&'static Named),
}

impl Entry {
    /// What `material` was chosen as, whatever was changed since. `None` for a file of the user's own.
    pub(super) fn of(material: &Material) -> Option<Self> {
        if material.name.is_empty() {
            let model = material.components().first()?.model();
            return Catalogue::current().find(model.id).ok().map(Self::Model);
        }
        library::origin(material).map(Self::Named)
    }

    /// Whether `material` was chosen as this.
    pub(super) fn is_origin_of(self, material: &Material) -> bool {
        Self::of(material).is_some_and(|origin| origin.id() == self.id())
    }

    /// Its id: no model has that of a named material.
    pub(super) fn id(self) -> &'static str {
        match self {
            Self::Model(model) => model.id,
            Self::Named(named) => named.id,
        }
    }

    pub(super) fn category(self) -> Category {
        match self {
            Self::Model(model) => model.category(),
            Self::Named(named) => named.material.category(),
        }
    }

    /// The material as it stands in the list.
    pub(super) fn material(self) -> Cow<'static, Material> {
        match self {
            Self::Model(model) => Cow::Owned(Material::of(model)),
            Self::Named(named) => Cow::Borrowed(&named.material),
        }
    }

    /// What it is called in the grid.
    pub(super) fn title(self) -> String {
        match self {
            Self::Model(model) => title(model),
            Self::Named(named) => named.material.name.clone(),
        }
    }

    pub(super) fn hint(self) -> String {
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

    /// What it is found by: names, then category, author or note, and models.
    pub(super) fn known(self) -> Known<'static> {
        let category = self.category().title();
        match self {
            Self::Model(model) => Known {
                names: vec![model.title, model.id],
                texts: vec![category, model.source],
            },
            Self::Named(Named { id, material }) => {
                let models = material.components().iter();
                let models = models.flat_map(|one| [one.model().title, one.model().id]);
                Known {
                    names: vec![material.name.as_str(), *id],
                    texts: [category, material.note.as_str()]
                        .into_iter()
                        .chain(models)
                        .collect(),
                }
            }
        }
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
