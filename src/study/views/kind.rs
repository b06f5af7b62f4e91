//! What a kind of view says of itself, and of the options of its instances.

use super::caption::Caption;
use super::scale::{Arrangement, Scale};
use super::section::OwnSection;
use crate::answers::Answers;
use crate::export::Format;
use crate::export::table::Table;
use crate::number::{Numbers, Refused};
use crate::session::Session;

/// Pixels along either side of a map of values.
pub(super) const MAP_SIZE: usize = 256;

/// A kind of view.
pub struct ViewKind {
    /// The id: file name, command-line word, snapshot name and the word for it in sessions.
    pub id: &'static str,
    /// The name at the screen.
    pub title: &'static str,
    /// What to see in it, in a sentence.
    pub what_you_see: &'static str,
    /// Whether it has words in its place where every material is hidden; else it shows its frame, or measures the selected
    /// material.
    pub says_hidden: bool,
    /// What becomes of Dirac deltas.
    pub deltas: Deltas,
    /// Whether its values carry the cosine where the session says so.
    pub with_cosine: bool,
    /// The numbers behind it: those of [`ViewOptions::table`].
    pub table: TableKind,
    /// Whether it shows the lobes as meshes, which have files of their own.
    pub is_mesh: bool,
}

/// What becomes of Dirac deltas in a view.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Deltas {
    /// Each has a mark with its share.
    Marked,
    /// They are parts of sums, where they matter.
    Summed,
    /// They have no place: where all light is in them, it says so.
    Told,
}

/// The numbers behind a view.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TableKind {
    /// None that a file would hold.
    None,
    /// Computed, and the same each time.
    Computed,
    /// Measured on this machine, so that they take seconds and are others each time.
    Measured,
}

impl ViewKind {
    /// Whether there is a file of this format of it.
    #[must_use]
    pub fn has_file(&self, format: Format) -> bool {
        match format {
            Format::Png | Format::Svg | Format::Toml => true,
            Format::Csv => self.table != TableKind::None,
            Format::Obj | Format::Gltf => self.is_mesh,
        }
    }
}

/// What the options of a kind of view say of themselves.
pub trait ViewOptions: Default {
    /// What the title of a figure says of the view.
    fn caption(&self, session: &Session) -> Caption;

    /// Whether the view, with these options, shows what becomes of the held direction.
    fn is_of_held(&self) -> bool {
        true
    }

    /// The section of the view's own, where it shows a section.
    fn own_section(&mut self) -> Option<&mut OwnSection> {
        None
    }

    /// How values become radii, where the view shows radii.
    fn radial_scale(&mut self) -> Option<&mut Scale> {
        None
    }

    /// How several materials stand, where that can be chosen.
    fn arrangement(&mut self) -> Option<&mut Arrangement> {
        None
    }

    /// The numbers among them.
    fn numbers(&mut self) -> Numbers<'_> {
        Vec::new()
    }

    /// Checks the whole numbers among them, which no gesture leads out of their range.
    ///
    /// # Errors
    /// The number that is refused.
    fn check_whole(&self) -> Result<(), Refused> {
        Ok(())
    }

    /// The texts among them that may be long.
    fn texts(&self) -> Vec<&str> {
        Vec::new()
    }

    /// The numbers that the view shows.
    fn table(&self, _session: &Session, _answers: &mut Answers) -> Table {
        Table::default()
    }
}
