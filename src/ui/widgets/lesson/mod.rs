//! The panel of lessons: the list of them, or one step of one with its question.

mod contents;
mod prose;
mod question;
mod step;

pub use contents::Group;
pub use contents::show as list;
pub use prose::{Prose, written};
pub use question::Done;
pub use step::{Shown, Turn, show as step};
