//! Instruments: what holds of a model, and how exactly.

#[doc = include_str!("DECISIONS.md")]
pub mod decisions {}

pub mod analysis;
pub mod coat_forms;
pub mod contract;
pub mod control;
pub mod formula_card;
pub mod formula_comparison;
pub mod quantities;
pub mod rounding;
pub mod specimen;
pub mod spectral;
pub mod speed;
pub mod stability;
pub mod timing;
pub mod tradeoff;
