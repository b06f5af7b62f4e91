//! The document a person works on, and the answers to it: the session with its history and files, the kinds of views, the
//! jobs that answer what views ask. No window is known here.

#[doc = include_str!("DECISIONS.md")]
pub mod decisions {}

pub mod answers;
pub mod colors;
pub mod cursor;
pub mod export;
pub mod files;
pub mod format;
pub mod history;
pub mod jobs;
pub mod lessons;
pub mod link;
pub mod memo;
pub mod number;
pub mod parallel;
pub mod parameters;
pub mod platform;
pub mod readers;
pub mod session;
pub mod store;
pub mod views;
