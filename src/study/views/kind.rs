//! What a kind of view says of itself.

use crate::export::Format;
use crate::export::table::Fill;
use crate::session::Session;

/// A kind of view.
pub struct ViewKind {
    /// The id: file name, command-line word and snapshot name.
    pub id: &'static str,
    /// The name at the screen.
    pub title: &'static str,
    /// What to see in it, in a sentence.
    pub what_you_see: &'static str,
    /// Whether, as the session has it, it shows what becomes of the held direction.
    pub is_of_held: fn(&Session) -> bool,
    /// The numbers behind it.
    pub table: Option<Fill>,
    /// Whether it is drawn by the graphics processor, so that it has no lines to export.
    pub is_mesh: bool,
}

impl ViewKind {
    /// Whether there is a file of this format of it.
    #[must_use]
    pub fn has_file(&self, format: Format) -> bool {
        match format {
            Format::Png | Format::Toml => true,
            Format::Svg => !self.is_mesh,
            Format::Csv => self.table.is_some(),
            Format::Obj | Format::Gltf => self.is_mesh,
        }
    }
}
