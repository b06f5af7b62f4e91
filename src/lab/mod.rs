//! Instruments: what holds of a model, and how exactly.

pub mod contract;
pub mod spectral;
pub mod speed;
pub mod timing;
pub mod tradeoff;
