//! The commands: what each is, and how it is run, by buttons and by keys.

mod command;
mod directions;
mod edits;
mod files;
pub mod help;
mod keys;
mod learn;
mod list;
pub mod search;

pub use command::{Command, Group};
pub use edits::*;
pub use files::*;
pub use keys::run_pressed;
pub use learn::*;
pub use list::*;
