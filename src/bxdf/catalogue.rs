//! The models that texts, lists and laws know: those of this crate, and those that a program adds.

use std::collections::BTreeSet;
use std::sync::OnceLock;

use crate::error::{Error, Result, shown};
use crate::material::embedded;
use crate::models::MODELS;
use crate::spec::ModelSpec;

/// The models that are known, in the order in which they are listed.
///
/// What reads materials by name, lists models or puts them through laws asks [`Catalogue::current`]. A program with models
/// of its own adds them before anything else, and they take part in all of it:
///
/// ```
/// use bxdf::{Catalogue, ModelSpec};
///
/// fn with(mine: &'static ModelSpec) -> bxdf::Result<()> {
///     Catalogue::default().with(mine)?.install()
/// }
/// ```
#[derive(Clone)]
pub struct Catalogue {
    models: Vec<&'static ModelSpec>,
}

static CURRENT: OnceLock<Catalogue> = OnceLock::new();

/// Where errors are, in their text.
const PLACE: &str = "catalogue";

impl Default for Catalogue {
    /// The models of this crate.
    fn default() -> Self {
        Self {
            models: MODELS.to_vec(),
        }
    }
}

impl Catalogue {
    /// This catalogue with `model` at its end.
    ///
    /// # Errors
    /// [`Error::Parse`] where its id is no word of lower-case letters, digits and underscores or is that of another model
    /// or of a named material, where two of its parameters have one name, and where its defaults are refused.
    pub fn with(mut self, model: &'static ModelSpec) -> Result<Self> {
        let id = model.id;
        let refused = |problem: &str| {
            let problem = format!("model '{}': {problem}", shown(id));
            Err(Error::parse(PLACE, problem))
        };
        let is_letter = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_';
        if id.is_empty() || !id.chars().all(is_letter) {
            return refused("an id is a word of lower-case letters, digits and underscores");
        }
        if self.find(id).is_ok() || embedded::ids().any(|other| other == id) {
            return refused("there is another one of this id");
        }
        let names: BTreeSet<&str> = model.parameters.iter().map(|spec| spec.name).collect();
        if names.len() < model.parameters.len() {
            return refused("two of its parameters have one name");
        }
        if model.lobes.is_empty() {
            return refused("a model has one lobe at least");
        }
        let defaults = model.defaults();
        if let Some((spec, _)) = defaults.iter().find(|(spec, value)| !spec.allows(*value)) {
            let name = shown(spec.name);
            return refused(&format!("the default of '{name}' is out of its range"));
        }
        if let Err(error) = (model.validate)(&defaults) {
            return refused(&format!("its defaults are refused: {error}"));
        }
        self.models.push(model);
        Ok(self)
    }

    /// Makes this the catalogue of the process.
    ///
    /// # Errors
    /// [`Error::Parse`] where one is in use already: materials that were read hold its models.
    pub fn install(self) -> Result<()> {
        let taken = |_| Error::parse(PLACE, "it is in use already; models are added first");
        CURRENT.set(self).map_err(taken)
    }

    /// The catalogue of the process: that of [`Catalogue::install`], else the models of this crate.
    #[must_use]
    pub fn current() -> &'static Self {
        CURRENT.get_or_init(Self::default)
    }

    /// The models.
    #[must_use]
    pub fn models(&self) -> &[&'static ModelSpec] {
        &self.models
    }

    /// The model with this id.
    ///
    /// # Errors
    /// [`Error::UnknownId`], with the nearest ids.
    pub fn find(&self, id: &str) -> Result<&'static ModelSpec> {
        let found = self.models.iter().find(|model| model.id == id).copied();
        found.ok_or_else(|| Error::unknown("model", id, self.models.iter().map(|model| model.id)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::param::ParamSpec;

    /// Phong's model under another id, with these parameters.
    fn phong(id: &'static str, parameters: &'static [ParamSpec]) -> &'static ModelSpec {
        let phong = Catalogue::default().find("phong").unwrap();
        Box::leak(Box::new(ModelSpec {
            id,
            parameters,
            ..*phong
        }))
    }

    #[test]
    fn a_model_from_outside_is_found_beside_the_others() {
        let mine = phong("mine_2", &[]);
        let catalogue = Catalogue::default().with(mine).unwrap();
        assert!(std::ptr::eq(catalogue.find("mine_2").unwrap(), mine));
        assert_eq!(catalogue.models().len(), MODELS.len() + 1);
        assert!(catalogue.find("phong").is_ok());
        let line = catalogue.find("mine").err().unwrap().to_string();
        assert!(
            line.starts_with("unknown model 'mine'; nearest: mine_2"),
            "{line}"
        );
    }

    #[test]
    fn what_would_break_the_lists_is_refused() {
        const TWICE: &[ParamSpec] = &[
            ParamSpec::number("a", 0.5, "one"),
            ParamSpec::number("a", 0.5, "another"),
        ];
        const OUTSIDE: &[ParamSpec] = &[ParamSpec::number("a", 2.0, "too much").hard(0.0, 1.0)];
        for (model, expected) in [
            (phong("phong", &[]), "another one of this id"),
            (phong("gold", &[]), "another one of this id"),
            (phong("My model", &[]), "an id is a word"),
            (phong("a:b", &[]), "an id is a word"),
            (phong("", &[]), "an id is a word"),
            (phong("twice", TWICE), "two of its parameters"),
            (
                phong("outside", OUTSIDE),
                "the default of 'a' is out of its range",
            ),
        ] {
            let line = Catalogue::default().with(model).err().unwrap().to_string();
            assert!(line.contains(expected), "{line}");
        }
    }
}
