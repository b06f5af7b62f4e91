//! How data was made that has no file: a material, and how finely its table was baked.

use crate::table::Shape;

/// A material as text, and the shape of its table: what baked data is made of again; see
/// [`Material::recipe`](crate::Material::recipe).
#[derive(Clone, Debug, PartialEq)]
pub struct Recipe {
    text: String,
    shape: Shape,
}

impl Recipe {
    /// The table of this shape of the material that `text` describes.
    #[must_use]
    pub(crate) fn new(text: String, shape: Shape) -> Self {
        Self { text, shape }
    }

    /// What is baked, as text: `id:name=value,name=value`, or the text of a file.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// How finely.
    #[must_use]
    pub fn shape(&self) -> Shape {
        self.shape
    }

    /// What it is called: the text where that is a line, else the name that stands in it.
    #[must_use]
    pub(super) fn name(&self) -> String {
        let named = |text: &str| {
            let table: toml::Table = text.parse().ok()?;
            table.get("name")?.as_str().map(str::to_owned)
        };
        let material = if self.text.contains('\n') {
            named(&self.text).unwrap_or_else(|| "a mixture".to_owned())
        } else {
            self.text.clone()
        };
        format!("{material} in a table of {} nodes", self.shape)
    }
}
