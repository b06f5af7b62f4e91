//! Lessons: texts that ask to predict, to move something and to see, each step with a state of the session.
//!
//! A lesson is a file in Markdown: see `assets/lessons/README.md` for how one is written.

mod ask;
mod call;
mod check;
mod expression;
pub mod formula;
mod lesson;
mod named;
mod node;
mod parse;
mod patch;
mod read;
mod scenes;
mod shelf;
mod text;
mod tokens;
mod work;
mod worth;

pub use ask::{
    Ask, Choice, Cover, Kind, Number, Reach, Tolerance, Verdict, right_choice, typed_number,
};
pub use check::{Fault, check};
pub use expression::{Condition, Expression};
pub use lesson::{Lesson, Start, Step};
pub use named::Named;
pub use patch::Patch;
pub use read::read;
pub use scenes::Scenes;
pub use shelf::{EXTENSION, Shelf, is_lesson, lessons, questions};
pub use text::{Block, Span, Style, Thing, plain, plain_spans, spans};
pub use work::Work;
pub use worth::Worth;

#[cfg(test)]
mod tests;
