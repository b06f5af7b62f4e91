//! How data stands in the texts of materials.
//!
//! As a word: the name of a file, or the bytes themselves where they are text. As a table: `file` or `baked` (the material
//! as text) with `shape`, then `sha256` of what was there, and the bytes as `text` or `base64` where they stand in the text
//! too.

use std::path::PathBuf;
use std::sync::Arc;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use toml::de::{DeTable, DeValue};

use super::{Content, Decoded, Decoder, Origin, Recipe, Resource};
use crate::error::{Error, Result, shown};

const FILE: &str = "file";
const BAKED: &str = "baked";
const SHAPE: &str = "shape";
const SHA256: &str = "sha256";
const TEXT: &str = "text";
const BASE64: &str = "base64";

/// The keys of the table.
const KEYS: [&str; 6] = [FILE, BAKED, SHAPE, SHA256, TEXT, BASE64];

/// The most bytes that a byte of a name takes where TOML writes it as an escape sequence.
const ESCAPED: u64 = 6;

/// More than the keys of the table have as text, with the hash.
const KEYS_ROOM: u64 = 256;

/// Reads and writes data in texts.
pub(crate) struct Stored<'a> {
    /// What reads it.
    pub(crate) decoders: &'a [&'a Decoder],
}

impl Stored<'_> {
    /// What a word says: bytes that one of the decoders knows, else the name of a file.
    ///
    /// # Errors
    /// What the decoder refuses.
    pub(crate) fn word(&self, word: &str) -> Result<Resource> {
        let bytes = word.as_bytes();
        if self.decoders.iter().any(|decoder| (decoder.begins)(bytes)) {
            let decoded = Decoded::read(bytes.to_vec(), None, self.decoders)?;
            Ok(Resource::inline(Arc::new(decoded)))
        } else if word.is_empty() {
            Err(super::decoder::refused(self.decoders))
        } else {
            Ok(Resource::file(PathBuf::from(word)))
        }
    }

    /// What the value of a parameter says in the text of a material.
    ///
    /// # Errors
    /// [`Error::Parse`] for what is neither a word nor a table of these keys, and as [`Self::word`].
    pub(crate) fn value(&self, value: &DeValue<'_>) -> Result<Resource> {
        match value {
            DeValue::String(word) => self.word(word),
            DeValue::Table(table) => self.table(table),
            _ => Err(Error::parse("data", "is no text and no table")),
        }
    }

    fn table(&self, table: &DeTable<'_>) -> Result<Resource> {
        let wrong = |problem: String| Error::parse("data", problem);
        let mut words = [const { None }; KEYS.len()];
        for (key, value) in table {
            let place = KEYS.iter().position(|known| key.get_ref() == known);
            let slot = place
                .and_then(|place| words.get_mut(place))
                .ok_or_else(|| {
                    let (key, known) = (shown(key.get_ref()), KEYS.join(", "));
                    wrong(format!("unknown key '{key}'; known are {known}"))
                })?;
            let DeValue::String(word) = value.get_ref() else {
                return Err(wrong(format!("{} is not in quotes", key.get_ref())));
            };
            *slot = Some(word.as_ref());
        }
        let [file, baked, shape, sha256, text, base64] = words;
        let origin = match (file, baked, shape) {
            (None, None, None) => Origin::Inline,
            (Some(file), None, None) => Origin::File(PathBuf::from(file)),
            (None, Some(material), Some(shape)) => {
                Origin::Baked(Recipe::new(material.to_owned(), shape.parse()?))
            }
            _ => return Err(wrong("is either a file, or baked with a shape".to_owned())),
        };
        let bytes = match (text, base64) {
            (None, None) => None,
            (Some(text), None) => Some(text.as_bytes().to_vec()),
            (None, Some(base64)) => {
                let bytes = STANDARD.decode(base64.trim());
                Some(bytes.map_err(|error| wrong(format!("base64: {error}")))?)
            }
            (Some(_), Some(_)) => return Err(wrong("is text or base64, not both".to_owned())),
        };
        let mut resource = Resource::pending(origin, sha256.map(str::parse).transpose()?);
        if let Some(bytes) = bytes {
            let decoded = Decoded::read(bytes, None, self.decoders)?;
            resource.content = Content::Here(Arc::new(decoded));
            resource.is_embedded = true;
            // Its file, or its recipe, is not asked.
            resource.expected = None;
        } else if resource.origin == Origin::Inline {
            return Err(wrong("neither a file nor its bytes".to_owned()));
        }
        Ok(resource)
    }
}

impl Resource {
    /// The data in the text of a material: `Self::word` or the table, which [`Stored`] reads back.
    pub(crate) fn to_toml(&self) -> toml::Value {
        let decoded = self.decoded().filter(|_| self.is_embedded());
        let bytes = decoded.map(|decoded| match plain(decoded.bytes()) {
            Some(text) => (TEXT, text.to_owned()),
            None => (BASE64, STANDARD.encode(decoded.bytes())),
        });
        if let (Origin::Inline, Some((TEXT, text))) = (&self.origin, &bytes) {
            return text.clone().into();
        }
        let mut table = toml::Table::new();
        let mut put = |key: &str, text: String| table.insert(key.to_owned(), text.into());
        match &self.origin {
            Origin::Inline => {}
            Origin::File(path) => {
                put(FILE, path.to_string_lossy().into_owned());
            }
            Origin::Baked(recipe) => {
                put(BAKED, recipe.text().to_owned());
                put(SHAPE, recipe.shape().to_string());
            }
        }
        let hash = self.decoded().map(|decoded| decoded.hash());
        if let Some(hash) = hash
            .or(self.expected)
            .filter(|_| self.origin != Origin::Inline)
        {
            put(SHA256, hash.to_string());
        }
        if let Some((key, text)) = bytes {
            put(key, text);
        }
        table.into()
    }

    /// At least as many bytes as it has in the text of a material.
    #[must_use]
    pub fn text_bound(&self) -> u64 {
        let name = match &self.origin {
            Origin::File(path) => path.as_os_str().len(),
            Origin::Baked(recipe) => recipe.text().len(),
            Origin::Inline => 0,
        };
        let decoded = self.decoded().filter(|_| self.is_embedded());
        // What is not plain text is written in base 64, four characters for every three bytes that are begun.
        let bytes = decoded.map_or(0, |decoded| match plain(decoded.bytes()) {
            Some(text) => text.len() as u64,
            None => 4 * (decoded.bytes().len() as u64).div_ceil(3),
        });
        KEYS_ROOM + ESCAPED * name as u64 + bytes
    }
}

/// Bytes as text, where each is written in TOML as it is.
fn plain(bytes: &[u8]) -> Option<&str> {
    let is_plain = |byte: &u8| matches!(byte, b' '..=b'~') && !matches!(byte, b'"' | b'\\' | b'\'');
    let text = std::str::from_utf8(bytes).ok()?;
    bytes.iter().all(is_plain).then_some(text)
}
