//! Data of parameters: where it comes from, what stands there, and what a decoder made of it.
//!
//! A parameter of kind data holds a [`Resource`]: the name of a file, the recipe of what was baked, or bytes that stand in
//! the text itself. Reading a text looks into no file and bakes nothing: that is done by
//! [`Material::fetch`](crate::Material::fetch), with whatever reads files. So a material whose file is missing is still a material, which says what is missing.

mod decoder;
mod hash;
mod recipe;
mod stored;
#[cfg(test)]
mod tests;

use std::fmt;
use std::path::{Path, PathBuf};
use std::sync::{Arc, OnceLock};

pub use decoder::{Data, Decoder, decoders_in_words};
pub use hash::Hash;
pub use recipe::Recipe;
pub(crate) use stored::Stored;

use crate::error::Result;
use crate::limits::MAX_INLINE;
use crate::table::Table;

/// What reads the file at a path, at most [`MAX_DATA`](crate::limits::MAX_DATA) of it.
pub type ReadFile<'a> = &'a dyn Fn(&Path) -> Result<Vec<u8>>;

/// What bakes a table: this module knows no materials.
pub(crate) type Bake = fn(&Recipe) -> Result<Decoded>;

/// Where data comes from.
#[derive(Clone, Debug, PartialEq)]
pub enum Origin {
    /// It stands in the text of the material.
    Inline,
    /// A file.
    File(PathBuf),
    /// It was baked, and can be again.
    Baked(Recipe),
}

/// Bytes, and what a decoder made of them.
pub struct Decoded {
    value: Data,
    /// As they were read; those of what was baked are made when they are asked for.
    bytes: OnceLock<Vec<u8>>,
    hash: OnceLock<Hash>,
}

impl Decoded {
    /// What one of `decoders` makes of `bytes`; `path`: the file they come from, whose name tells the format where they
    /// themselves do not.
    ///
    /// # Errors
    /// [`Error::Parse`](crate::Error::Parse) where none of them reads such bytes, and what the one that does refuses.
    pub fn read(bytes: Vec<u8>, path: Option<&Path>, decoders: &[&Decoder]) -> Result<Self> {
        let decoder = Decoder::of(decoders, &bytes, path);
        let decoder = decoder.ok_or_else(|| decoder::refused(decoders))?;
        Ok(Self {
            value: (decoder.decode)(&bytes)?,
            bytes: bytes.into(),
            hash: OnceLock::new(),
        })
    }

    /// A table, whose bytes are its text.
    #[must_use]
    pub fn table(table: Table) -> Self {
        Self {
            value: Arc::new(table),
            bytes: OnceLock::new(),
            hash: OnceLock::new(),
        }
    }

    /// The bytes.
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        self.bytes.get_or_init(|| {
            let table = self.value.downcast_ref::<Table>();
            table
                .map(ToString::to_string)
                .unwrap_or_default()
                .into_bytes()
        })
    }

    /// How many there are.
    #[must_use]
    pub fn size(&self) -> u64 {
        match (self.bytes.get(), self.value.downcast_ref::<Table>()) {
            (None, Some(table)) => table.text_bytes(),
            _ => self.bytes().len() as u64,
        }
    }

    /// What tells them from others.
    #[must_use]
    pub fn hash(&self) -> Hash {
        *self.hash.get_or_init(|| Hash::of(self.bytes()))
    }

    /// What the decoder made, where it is of this type.
    #[must_use]
    pub fn value<T: Send + Sync + 'static>(&self) -> Option<Arc<T>> {
        Arc::clone(&self.value).downcast().ok()
    }
}

impl fmt::Debug for Decoded {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} bytes", self.size())
    }
}

/// What is known of the content.
#[derive(Clone, Debug)]
pub enum Content {
    /// Nobody has looked yet.
    Pending,
    /// It is here.
    Here(Arc<Decoded>),
    /// It cannot be had, for this reason.
    Missing(Arc<str>),
}

impl PartialEq for Content {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Pending, Self::Pending) => true,
            (Self::Here(a), Self::Here(b)) => Arc::ptr_eq(a, b) || a.hash() == b.hash(),
            (Self::Missing(a), Self::Missing(b)) => a == b,
            _ => false,
        }
    }
}

impl From<Result<Decoded>> for Content {
    fn from(found: Result<Decoded>) -> Self {
        match found {
            Ok(decoded) => Self::Here(Arc::new(decoded)),
            Err(error) => Self::Missing(reason(error).into()),
        }
    }
}

/// The data of a parameter. Two are equal that come from one place and are the same there; how they stand in texts does not
/// matter.
#[derive(Clone, Debug)]
pub struct Resource {
    origin: Origin,
    /// The hash it had when the text was written that names it.
    expected: Option<Hash>,
    content: Content,
    /// Whether it stood in the text beside its origin, and is to stand there again.
    is_embedded: bool,
}

impl PartialEq for Resource {
    fn eq(&self, other: &Self) -> bool {
        let is_awaited = self.content == Content::Pending;
        self.origin == other.origin
            && self.content == other.content
            && self.is_changed() == other.is_changed()
            && (!is_awaited || self.expected == other.expected)
    }
}

impl Resource {
    /// Data that stands in a text, or has no other place.
    #[must_use]
    pub fn inline(decoded: Arc<Decoded>) -> Self {
        Self {
            origin: Origin::Inline,
            expected: None,
            content: Content::Here(decoded),
            is_embedded: true,
        }
    }

    /// The data of a file that has not been read yet.
    #[must_use]
    pub fn file(path: PathBuf) -> Self {
        Self::pending(Origin::File(path), None)
    }

    /// A table baked by `recipe`.
    #[must_use]
    pub fn baked(recipe: Recipe, table: Table) -> Self {
        Self::pending(Origin::Baked(recipe), None).filled(Arc::new(Decoded::table(table)))
    }

    fn pending(origin: Origin, expected: Option<Hash>) -> Self {
        Self {
            origin,
            expected,
            content: Content::Pending,
            is_embedded: false,
        }
    }

    fn filled(self, decoded: Arc<Decoded>) -> Self {
        Self {
            content: Content::Here(decoded),
            ..self
        }
    }

    /// What was read of the file at `path`.
    #[must_use]
    pub fn read(path: PathBuf, decoded: Arc<Decoded>) -> Self {
        Self::file(path).filled(decoded)
    }

    /// Where it comes from.
    #[must_use]
    pub fn origin(&self) -> &Origin {
        &self.origin
    }

    /// What is known of its content.
    #[must_use]
    pub fn content(&self) -> &Content {
        &self.content
    }

    /// The content, where it is here.
    #[must_use]
    pub fn decoded(&self) -> Option<&Arc<Decoded>> {
        match &self.content {
            Content::Here(decoded) => Some(decoded),
            Content::Pending | Content::Missing(_) => None,
        }
    }

    /// Whether the content is another one than when the text was written that names it.
    #[must_use]
    pub fn is_changed(&self) -> bool {
        let here = self.decoded().zip(self.expected);
        here.is_some_and(|(decoded, expected)| decoded.hash() != expected)
    }

    /// What is wrong with it, as a phrase: `gold.table: missing`. `None` where it is here, as it was.
    #[must_use]
    pub fn problem(&self) -> Option<String> {
        let name = self.name();
        match (&self.content, &self.origin) {
            (Content::Here(_), Origin::Baked(_)) if self.is_changed() => Some(format!(
                "{name} is another one than when it was saved: this program or machine bakes it otherwise"
            )),
            (Content::Here(_), _) if self.is_changed() => {
                Some(format!("{name} has changed since this was saved"))
            }
            (Content::Here(_), _) => None,
            (Content::Pending, Origin::Baked(_)) => Some(format!("{name} is being baked")),
            (Content::Pending, _) => Some(format!("{name} is not read yet")),
            (Content::Missing(reason), _) => Some(format!("{name} is missing: {reason}")),
        }
    }

    /// What it is called: the name of its file, or what was baked how finely.
    #[must_use]
    pub fn name(&self) -> String {
        match &self.origin {
            Origin::Inline => "data in the text".to_owned(),
            Origin::File(path) => path.display().to_string(),
            Origin::Baked(recipe) => recipe.name(),
        }
    }

    /// Looks for the content where nobody has yet: reads the file by `read`, or bakes the recipe anew.
    pub(crate) fn fetch_with(&mut self, decoders: &[&Decoder], read: ReadFile<'_>, bake: Bake) {
        if self.content != Content::Pending {
            return;
        }
        self.content = match &self.origin {
            // Where it stands in the text it came with it.
            Origin::Inline => return,
            Origin::File(path) => read(path)
                .and_then(|bytes| Decoded::read(bytes, Some(path), decoders))
                .into(),
            Origin::Baked(recipe) => bake(recipe).into(),
        };
    }

    /// Whether nobody has looked for the content yet.
    #[must_use]
    pub fn is_pending(&self) -> bool {
        self.content == Content::Pending
    }

    /// Takes what was found for `awaited`, where it is that.
    pub fn take(&mut self, awaited: &Self, found: &Content) {
        if self.is_pending() && self == awaited {
            self.content.clone_from(found);
        }
    }

    /// Lets the content be missing for this reason, where nobody has looked for it yet: nobody will.
    pub fn strand(&mut self, reason: &str) {
        if self.is_pending() {
            self.content = Content::Missing(reason.into());
        }
    }

    /// The same, to be looked for anew.
    #[must_use]
    pub fn again(&self) -> Self {
        Self::pending(self.origin.clone(), None)
    }

    /// Whether it is missing, and of a file of the same name as the one at `path`, in whatever folder.
    #[must_use]
    pub fn is_missing_file(&self, path: &Path) -> bool {
        let is_named = |own: &Path| own.file_name() == path.file_name();
        matches!(&self.origin, Origin::File(own) if is_named(own))
            && matches!(self.content, Content::Missing(_))
    }

    /// The same, to be looked for in the file at `path`.
    #[must_use]
    pub fn moved_to(&self, path: &Path) -> Self {
        Self::pending(Origin::File(path.to_owned()), self.expected)
    }

    /// Whether its content stands in the texts that name it: what has no other place, what came so, and what is small.
    #[must_use]
    pub fn is_embedded(&self) -> bool {
        let is_small = || {
            let decoded = self.decoded();
            decoded.is_some_and(|decoded| decoded.size() <= MAX_INLINE)
        };
        self.is_embedded || is_small()
    }

    /// Lets its content stand in the texts that name it, where it is here.
    pub fn embed(&mut self) {
        self.is_embedded |= self.decoded().is_some();
    }

    /// Changes the name of its file, if it has one.
    pub fn map_path(&mut self, change: impl FnOnce(&Path) -> Option<PathBuf>) {
        if let Origin::File(path) = &mut self.origin
            && let Some(changed) = change(path)
        {
            *path = changed;
        }
    }
}

/// An error about a file whose name is said already.
fn reason(error: crate::Error) -> String {
    match error {
        crate::Error::Io { source, .. } => source.to_string(),
        crate::Error::Parse { problem, .. } => problem,
        other => other.to_string(),
    }
}
