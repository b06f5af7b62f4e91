//! Materials made of data: what a file holds that a model of the catalogue shows.

use std::path::Path;
use std::sync::Arc;

use super::{Component, Material, file};
use crate::catalogue::Catalogue;
use crate::error::{Error, Result};
use crate::limits::MAX_DATA;
use crate::param::ParamSpec;
use crate::resource::{Decoded, Decoder, ReadFile, Recipe, Resource};
use crate::spec::ModelSpec;
use crate::table::{Shape, Table};

impl Material {
    /// Looks for the data that nobody has looked for yet: reads files by `read`, and bakes what was baked. What is not found
    /// is [`Content::Missing`](crate::resource::Content::Missing), and the material not complete.
    ///
    /// ```
    /// use bxdf::Material;
    ///
    /// # fn main() -> bxdf::Result<()> {
    /// let mut even: Material = "table:data=even.table".parse()?;
    /// assert!(!even.is_complete());
    /// let text = format!("2x2x2;{}", "AACAPgAAgD4AAIA+".repeat(8));
    /// even.fetch(&|_| Ok(text.clone().into_bytes()));
    /// assert!(even.is_complete());
    /// # Ok(())
    /// # }
    /// ```
    pub fn fetch(&mut self, read: ReadFile<'_>) {
        self.map_resources(&mut |spec, resource| fetch(spec, resource, read));
    }

    /// How the table of this shape is baked of it; `None` where it has data itself, of which a recipe says nothing.
    #[must_use]
    pub fn recipe(&self, shape: Shape) -> Option<Recipe> {
        (!self.has_data()).then(|| Recipe::new(self.to_text(), shape))
    }

    /// The material of the data that `bytes` are, where they, or the name of their file, are of a format that a model of the
    /// catalogue reads.
    ///
    /// # Errors
    /// Where such data is broken.
    #[must_use]
    pub fn of_data(bytes: &[u8], path: Option<&Path>) -> Option<Result<Self>> {
        let (model, spec) =
            formats().find(|(_, spec)| Decoder::of(spec.decoders, bytes, path).is_some())?;
        let read = || {
            let decoded = Arc::new(Decoded::read(bytes.to_vec(), path, spec.decoders)?);
            let resource = match path {
                Some(path) => Resource::read(path.to_owned(), decoded),
                None => Resource::inline(decoded),
            };
            let mut component = Component::of(model);
            component.set_resource(spec.name, resource)?;
            let name = path.and_then(Path::file_stem).unwrap_or_default();
            Ok(Self {
                name: name.to_string_lossy().into_owned(),
                ..Self::from(component)
            })
        };
        Some(read().map_err(|error| match (path, error) {
            (Some(path), Error::Parse { problem, .. }) => {
                Error::parse(path.display().to_string(), problem)
            }
            (_, error) => error,
        }))
    }
}

/// The parameters of the catalogue whose data files hold, each with its model.
pub fn formats() -> impl Iterator<Item = (&'static ModelSpec, &'static ParamSpec)> {
    let models = Catalogue::current().models().iter().copied();
    models.flat_map(|model| {
        let with_data = model
            .parameters
            .iter()
            .filter(|spec| !spec.decoders.is_empty());
        with_data.map(move |spec| (model, spec))
    })
}

/// Looks for data where nobody has yet: reads its file by `read`, or bakes it anew.
pub fn fetch(spec: &ParamSpec, resource: &mut Resource, read: ReadFile<'_>) {
    resource.fetch_with(spec.decoders, read, bake);
}

/// The table that a recipe names.
///
/// # Errors
/// As [`file::of_recipe`], and [`Error::Limit`] where it is larger than data may be: then nothing is computed.
fn bake(recipe: &Recipe) -> Result<Decoded> {
    let bxdf = file::of_recipe(recipe)?.build::<f64>();
    // The text of a table is longer than the table by a third.
    let most = MAX_DATA / 4 * 3;
    Table::bake(&*bxdf, recipe.shape(), most).map(Decoded::table)
}
