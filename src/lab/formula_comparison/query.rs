//! What views ask of comparisons: they are of no material.

use super::{Comparison, Map, Outcome};
use crate::analysis::{Basis, Detail, IsWanted, Query, Subject};

/// The errors along the parameter of a comparison, with the values of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurveRequest {
    /// The comparison.
    pub of: &'static Comparison,
    /// How many values of the parameter are tried.
    pub count: usize,
}

/// The errors over both arguments of a comparison; nothing where it has one alone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MapRequest {
    /// The comparison.
    pub of: &'static Comparison,
    /// How many values of each argument are tried.
    pub size: usize,
}

impl Query for CurveRequest {
    type Answer = Vec<(f64, Outcome)>;

    const BASIS: Basis = Basis::Nothing;

    fn answer(&self, _: &Subject<'_>, _: Detail, _: IsWanted<'_>) -> Option<Self::Answer> {
        Some(self.of.curve(self.count).collect())
    }
}

impl Query for MapRequest {
    type Answer = Map;

    const BASIS: Basis = Basis::Nothing;

    fn answer(&self, _: &Subject<'_>, _: Detail, is_wanted: IsWanted<'_>) -> Option<Self::Answer> {
        if self.of.second.is_none() {
            return Some(Map::default());
        }
        self.of.map_while(self.size, is_wanted)
    }
}
