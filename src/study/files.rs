//! What every reader of files keeps, in the window and at the command line: how much text is read.

pub use bxdf::internals::files::{data_at, read_bytes, text_at, text_of};
pub use bxdf::limits::{MAX_DATA, MAX_TEXT, in_words, require_fit};
