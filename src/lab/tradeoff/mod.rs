//! The trade-off of speed against accuracy, measured for one material on this machine.
//!
//! Families of choices are each held against the most accurate of their kind: ways to estimate a reflectance, number
//! formats, stand-ins for terms and lobes, resolutions of what is drawn. Every choice has a cost, measured, and an error,
//! measured; from both follow the Pareto front and the cheapest choice within a tolerance.

mod advice;
mod bench;
mod channels;
mod errors;
mod estimators;
mod front;
mod mesh;
mod precision;
mod probe;
mod report;
mod request;
mod stand_ins;
mod study;
pub mod table;
mod tables;
mod verdict;

pub use advice::{Advice, DEFAULT_TOLERANCES, WHOLE, advise};
pub use bench::{Bench, Family, measure};
pub use errors::{Errors, Pair, colour_difference};
pub use probe::LIGHT;
pub use report::{CostUnit, FamilyReport, Point, Question, Report, Slopes};
pub use request::{Accuracy, Request};
pub use study::{DIRECTION_DEG, Stop, Study};
pub use verdict::{Verdict, verdict};

/// Every family, in the order in which they are measured and shown.
pub static FAMILIES: [&dyn Family; 6] = [
    &estimators::Estimators,
    &precision::Precisions,
    &stand_ins::StandIns,
    &tables::Tables,
    &channels::Channels,
    &mesh::Resolutions,
];

#[cfg(test)]
mod tests;
