//! Functions that no library gives in the form needed here.

pub mod error_function;
pub mod polynomial;
pub mod turn;
