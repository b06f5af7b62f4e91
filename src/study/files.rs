//! What every reader of files keeps, in the window and at the command line: how much text is read.

pub use bxdf::internals::files::{MAX_TEXT, in_words, read_bytes, require_fit, text_at, text_of};
