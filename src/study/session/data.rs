//! The data of the materials of a session: reading it, baking it, and texts that hold all of it.

use std::path::Path;

use super::Session;
use super::file::Read;
use crate::files;
use bxdf::error::{Error, Result};
use bxdf::material;
use bxdf::resource::{Content, Origin, ReadFile};
use bxdf::{Material, ParamSpec, Resource};

impl Session {
    pub(crate) fn map_resources(&mut self, change: &mut dyn FnMut(&mut Resource)) {
        for entry in self.materials.iter_mut() {
            entry
                .material
                .map_resources(&mut |_, resource| change(resource));
        }
    }

    fn resources(&self) -> impl Iterator<Item = &Resource> {
        let entries = self.materials.iter();
        let resources = entries.flat_map(|entry| entry.material.resources());
        resources.map(|(_, resource)| resource)
    }

    /// Names files of data from the root on that are named from `folder` on.
    pub fn rooted_at(&mut self, folder: &Path) {
        for entry in self.materials.iter_mut() {
            entry.material.rooted_at(folder);
        }
    }

    /// The session as it stands in a file in `folder`: files of data in it are named from there on.
    #[must_use]
    pub fn relative_to(&self, folder: &Path) -> Self {
        let mut session = self.clone();
        for entry in session.materials.iter_mut() {
            entry.material.relative_to(folder);
        }
        session
    }

    /// Reads the files of data that nobody has read yet.
    pub fn read_files(&mut self, read: ReadFile<'_>) {
        for entry in self.materials.iter_mut() {
            read_files(&mut entry.material, read);
        }
    }

    /// The data that nobody has looked for yet, with the specs of its parameters: until then its materials are not shown.
    #[must_use]
    pub fn awaited(&self) -> Vec<(&'static ParamSpec, Resource)> {
        let entries = self.materials.iter();
        let resources = entries.flat_map(|entry| entry.material.resources());
        let awaited = resources.filter(|(_, resource)| resource.is_pending());
        awaited
            .map(|(spec, resource)| (spec, resource.clone()))
            .collect()
    }

    /// Whether data of a file with the name of the one at `path` is missing.
    #[must_use]
    pub fn is_missing_file(&self, path: &Path) -> bool {
        self.resources()
            .any(|resource| resource.is_missing_file(path))
    }

    /// Looks anew for the data that is missing of a file of this name: in the one at `path`.
    pub fn look_in(&mut self, path: &Path) {
        self.map_resources(&mut |resource| {
            if resource.is_missing_file(path) {
                *resource = resource.moved_to(path);
            }
        });
    }

    /// Takes what was found for data that was awaited, wherever it is.
    pub fn take_data(&mut self, awaited: &Resource, found: &Content) {
        self.map_resources(&mut |resource| resource.take(awaited, found));
    }

    /// Looks here and now for the data that nobody has looked for yet.
    pub fn fetch(&mut self, read: ReadFile<'_>) {
        for entry in self.materials.iter_mut() {
            entry.material.fetch(read);
        }
    }

    /// The session with all data that is here in its text, which then needs no file.
    ///
    /// # Errors
    /// [`Error::Limit`] where its text would be longer than [`files::MAX_TEXT`], with the sizes of its data.
    pub fn with_data(&self) -> Result<Self> {
        let mut whole = self.clone();
        whole.map_resources(&mut Resource::embed);
        let fits = whole.require_fit_as("the session with its data");
        fits.map_err(|error| match error {
            Error::Limit { what, value, limit } => {
                let sizes = self.resources().filter_map(|resource| {
                    let size = files::in_words(resource.decoded()?.size());
                    Some(format!("{}: {size}", resource.name()))
                });
                let sizes = sizes.collect::<Vec<_>>().join(", ");
                let limit = format!("{limit} ({sizes})");
                Error::Limit { what, value, limit }
            }
            other => other,
        })?;
        Ok(whole)
    }

    /// Which data is missing or has changed, a line for each material.
    pub fn problems(&self) -> impl Iterator<Item = String> {
        self.materials
            .iter()
            .flat_map(|entry| problems(&entry.material))
    }
}

impl Read {
    /// What there is to be said of it, a line each: what is left out, and which data is missing or has changed.
    #[must_use]
    pub fn remarks(&self) -> Vec<String> {
        let left_out = self.left_out.iter().cloned();
        left_out.chain(self.session.problems()).collect()
    }
}

/// Reads the files of data that nobody has read yet; what is to be baked waits.
pub(super) fn read_files(material: &mut Material, read: ReadFile<'_>) {
    material.map_resources(&mut |spec, resource| {
        if matches!(resource.origin(), Origin::File(_)) {
            material::data::fetch(spec, resource, read);
        }
    });
}

/// Which data of a material is missing or has changed: what is still awaited is neither.
pub(super) fn problems(material: &Material) -> impl Iterator<Item = String> {
    let resources = material.resources().map(|(_, resource)| resource);
    let found = resources.filter(|resource| !resource.is_pending());
    found.filter_map(|resource| Some(format!("{}: {}", material.title(), resource.problem()?)))
}
