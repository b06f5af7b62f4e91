//! What the command line says on standard error.

use std::io::{self, Write as _};

#[cfg(not(all(feature = "gui", not(target_arch = "wasm32"))))]
use bxdf::error::Error;
use bxdf::error::printable;

/// The longest line on standard error, in characters: an error's parts are shorter, but not what others say.
const MAX_LINE: usize = 4000;

/// Writes `line` to standard error, as one line that does nothing else to a terminal. Where that is closed, there is nobody
/// to tell.
pub(super) fn say(line: &str) {
    let _ = writeln!(io::stderr(), "{}", printable(line, MAX_LINE));
}

/// What is said where a build has no window.
#[cfg(not(all(feature = "gui", not(target_arch = "wasm32"))))]
pub(super) fn no_window() -> Error {
    Error::Platform {
        problem: "this build has no window and draws no pictures".to_owned(),
        remedy: "build it with the gui feature, or name another verb (see --help)".to_owned(),
    }
}
