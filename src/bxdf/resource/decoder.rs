//! What makes values of the bytes of a file.

use std::any::Any;
use std::fmt;
use std::path::Path;
use std::sync::Arc;

use crate::error::{Error, Result};

/// What a decoder makes: a type of the model's own, which it asks back by [`ParamSet::data`](crate::ParamSet::data).
pub type Data = Arc<dyn Any + Send + Sync>;

/// A format of data, and what reads it. A parameter of kind data names those it takes, and by that alone every reader of
/// files knows them: command line, dialogs, what is dropped on the window or pasted.
pub struct Decoder {
    /// What a file of it is, at the screen: `Table of values`.
    pub title: &'static str,
    /// What the names of its files end in, without the dot and in small letters.
    pub extensions: &'static [&'static str],
    /// Whether bytes that begin so are of this format.
    pub begins: fn(&[u8]) -> bool,
    /// Reads the bytes of a file, all of them.
    pub decode: fn(&[u8]) -> Result<Data>,
}

impl fmt::Debug for Decoder {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.title)
    }
}

impl PartialEq for Decoder {
    fn eq(&self, other: &Self) -> bool {
        std::ptr::eq(self, other)
    }
}

impl Decoder {
    /// Whether the name of a file ends as those of this format.
    #[must_use]
    pub fn has_extension(&self, path: &Path) -> bool {
        path.extension().is_some_and(|extension| {
            let mut own = self.extensions.iter();
            own.any(|own| extension.eq_ignore_ascii_case(own))
        })
    }

    /// The format of `bytes` among `decoders`: the one that they begin as, else the one that the name of their file ends as.
    #[must_use]
    pub fn of<'a>(decoders: &[&'a Self], bytes: &[u8], path: Option<&Path>) -> Option<&'a Self> {
        let begins = decoders.iter().find(|decoder| (decoder.begins)(bytes));
        let ends = || {
            let mut all = decoders.iter();
            all.find(|decoder| path.is_some_and(|path| decoder.has_extension(path)))
        };
        begins.or_else(ends).copied()
    }
}

/// What `decoders` read, as a phrase: `a table of values (.table)`.
#[must_use]
pub fn decoders_in_words(decoders: &[&Decoder]) -> String {
    let each = decoders.iter().map(|decoder| {
        let endings: Vec<String> = decoder.extensions.iter().map(|e| format!(".{e}")).collect();
        format!("{} ({})", decoder.title.to_lowercase(), endings.join(", "))
    });
    each.collect::<Vec<_>>().join(" or ")
}

/// The refusal of bytes that none of the `decoders` reads.
pub(super) fn refused(decoders: &[&Decoder]) -> Error {
    Error::parse("data", format!("read is {}", decoders_in_words(decoders)))
}
