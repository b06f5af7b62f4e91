//! The samples of a held direction, with what they weigh.

use glam::DVec3;
use rayon::prelude::*;

use super::draws::{CHUNK, Draw, Draws};
use crate::analysis::{HeldLobe, IsWanted};

/// A sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// The numbers that chose the direction, in [0, 1).
    pub u: [f64; 2],
    /// The number that chose the lobe, in [0, 1).
    pub uc: f64,
    /// The direction drawn, a unit vector.
    pub direction: DVec3,
    /// f |cos(theta)| / pdf, per channel.
    pub weight: [f64; 3],
    /// Whether it comes from a Dirac delta.
    pub is_delta: bool,
}

/// Samples, and how many draws gave none.
pub(super) struct Samples {
    pub(super) points: Vec<Point>,
    pub(super) lost: usize,
}

/// `count` draws of `sample_f` for the direction held by `lobe`; `None` where they were not wanted to the end.
pub(super) fn drawn(
    lobe: &HeldLobe<'_>,
    count: usize,
    seed: u64,
    is_wanted: IsWanted<'_>,
) -> Option<Samples> {
    let chunk = |index: usize| {
        let first = index * CHUNK;
        let size = CHUNK.min(count - first);
        is_wanted().then(|| chunk(lobe, seed, first as u64, size))
    };
    let chunks = (0..count.div_ceil(CHUNK)).into_par_iter().map(chunk);
    let chunks: Vec<Vec<Point>> = chunks.collect::<Option<_>>()?;
    let points: Vec<Point> = chunks.into_iter().flatten().collect();
    Some(Samples {
        lost: count - points.len(),
        points,
    })
}

/// The samples of `count` draws from number `first` on.
fn chunk(lobe: &HeldLobe<'_>, seed: u64, first: u64, count: usize) -> Vec<Point> {
    let draws = Draws::new(lobe.surface(), lobe.held().into(), seed, first, count);
    let found = draws.iter().filter(|draw| !draw.is_lost());
    let point = |draw: Draw<f64>| Point {
        u: draw.u,
        uc: draw.uc,
        direction: draw.wi.into(),
        weight: draw.f.map(|f| f * draw.wi.z.abs() / draw.pdf),
        is_delta: draw.is_delta,
    };
    found.map(point).collect()
}
