//! How many nodes a table has along each coordinate.

use std::str::FromStr;

use super::coordinates::{Cell, Place};
use crate::error::{Error, Result};
use crate::math::Real;

/// Bytes of a node: three channels of `f32`.
const NODE_BYTES: u64 = 12;

/// The most nodes along a coordinate: more would say nothing that `f32` could tell.
const MAX_COUNT: usize = 4096;

/// The number of nodes along each coordinate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shape {
    /// Along the half vector's azimuth, all around; 1 where the surface may be turned.
    turns: usize,
    /// Along theta_h, both ends among them.
    halves: usize,
    /// Along theta_d, both ends among them.
    differences: usize,
    /// Along phi_d: half a turn; a quarter, both ends among them, where the surface may be turned.
    azimuths: usize,
}

impl Shape {
    /// The fewest nodes there may be.
    pub const SMALLEST: Self = Self {
        turns: 1,
        halves: 2,
        differences: 2,
        azimuths: 2,
    };

    /// `halves` by `differences` by `azimuths`, by `turns` all around: 1 for an isotropic surface.
    ///
    /// # Errors
    /// [`Error::Parse`] where there are fewer than 2 (turns: 1) or more than 4096.
    pub fn new(turns: usize, [halves, differences, azimuths]: [usize; 3]) -> Result<Self> {
        let shape = Self {
            turns,
            halves,
            differences,
            azimuths,
        };
        let is_sound = |count: &usize| (2..=MAX_COUNT).contains(count);
        let [_, rest @ ..] = shape.counts();
        if rest.iter().all(is_sound) && (1..=MAX_COUNT).contains(&turns) {
            Ok(shape)
        } else {
            Err(Error::parse(
                format!("table of {shape}"),
                format!("each number but that of turns is from 2 to {MAX_COUNT}"),
            ))
        }
    }

    /// `n` along each coordinate; turns only for a surface that may not be turned.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn of(n: usize, is_isotropic: bool) -> Result<Self> {
        Self::new(if is_isotropic { 1 } else { n }, [n; 3])
    }

    /// Turns, halves, differences, azimuths.
    #[must_use]
    pub fn counts(&self) -> [usize; 4] {
        [self.turns, self.halves, self.differences, self.azimuths]
    }

    /// Whether it holds a surface that may be turned.
    #[must_use]
    pub fn is_isotropic(&self) -> bool {
        self.turns == 1
    }

    /// All nodes.
    #[must_use]
    pub fn nodes(&self) -> usize {
        self.counts().into_iter().product()
    }

    /// The memory that its table takes.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        let counts = self.counts().map(|count| count as u64);
        counts.into_iter().product::<u64>() * NODE_BYTES
    }

    /// # Errors
    /// [`Error::Limit`] where the table takes more than `max_bytes`.
    pub fn within(&self, max_bytes: u64) -> Result<()> {
        if self.bytes() <= max_bytes {
            return Ok(());
        }
        let mebibytes = |bytes: u64| format!("{:.1} MiB", bytes as f64 / f64::from(1 << 20));
        Err(Error::Limit {
            what: "the table",
            value: format!("of {self} nodes, {}", mebibytes(self.bytes())),
            limit: mebibytes(max_bytes),
        })
    }

    /// The place of a node in the list of all.
    #[inline(always)]
    pub(super) fn index(&self, [turn, half, difference, azimuth]: [usize; 4]) -> usize {
        ((turn * self.halves + half) * self.differences + difference) * self.azimuths + azimuth
    }

    /// Where the nodes stand, in the order of the list.
    pub(super) fn places(self) -> impl Iterator<Item = Place<f64>> {
        let closed = |index: usize, count: usize| index as f64 / (count - 1) as f64;
        let azimuth = move |index: usize| {
            if self.is_isotropic() {
                closed(index, self.azimuths)
            } else {
                2.0 * index as f64 / self.azimuths as f64
            }
        };
        (0..self.nodes()).map(move |node| {
            let (rest, last) = (node / self.azimuths, node % self.azimuths);
            let (rest, difference) = (rest / self.differences, rest % self.differences);
            let (turn, half) = (rest / self.halves, rest % self.halves);
            Place {
                turn: 4.0 * turn as f64 / self.turns as f64,
                half: closed(half, self.halves),
                difference: closed(difference, self.differences),
                azimuth: azimuth(last),
            }
        })
    }

    /// The cosine of theta_h at the node `half`.
    pub(super) fn cos_half(&self, half: usize) -> f64 {
        1.0 - (half as f64 / (self.halves - 1) as f64).powi(4)
    }

    /// The cell of `place` along each coordinate, in the order of [`Self::counts`].
    #[inline(always)]
    pub(super) fn cells<R: Real>(&self, place: &Place<R>) -> [Cell<R>; 4] {
        let two = R::of(2.0);
        let azimuths = if self.is_isotropic() {
            // The lobe is the same on both sides of the plane of incidence.
            closed(place.azimuth.at_most(two - place.azimuth), self.azimuths)
        } else {
            around(place.azimuth * R::of(0.5), self.azimuths)
        };
        [
            around(place.turn * R::of(0.25), self.turns),
            closed(place.half, self.halves),
            closed(place.difference, self.differences),
            azimuths,
        ]
    }
}

impl std::fmt::Display for Shape {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}x{}x{}", self.halves, self.differences, self.azimuths)?;
        if !self.is_isotropic() {
            write!(f, "x{}", self.turns)?;
        }
        Ok(())
    }
}

impl FromStr for Shape {
    type Err = Error;

    /// Reads `HALVESxDIFFERENCESxAZIMUTHS`, or `..xTURNS`.
    fn from_str(text: &str) -> Result<Self> {
        let counts: std::result::Result<Vec<usize>, _> =
            text.split('x').map(|count| count.trim().parse()).collect();
        match counts.as_deref() {
            Ok([halves, differences, azimuths]) => Self::new(1, [*halves, *differences, *azimuths]),
            Ok([halves, differences, azimuths, turns]) => {
                Self::new(*turns, [*halves, *differences, *azimuths])
            }
            _ => Err(Error::parse(
                "table",
                "three or four numbers of nodes are needed",
            )),
        }
    }
}

/// The cell of `x`, 0..1, among `count` nodes, two of them at the ends.
#[inline(always)]
fn closed<R: Real>(x: R, count: usize) -> Cell<R> {
    let x = x.at_least(R::zero()) * R::of((count - 1) as f64);
    let first = (x.as_f64() as usize).min(count - 2);
    Cell {
        first,
        second: first + 1,
        t: (x - R::of(first as f64)).at_most(R::one()),
    }
}

/// The cell of `x`, 0..1, among `count` nodes all around.
#[inline(always)]
fn around<R: Real>(x: R, count: usize) -> Cell<R> {
    let x = x.at_least(R::zero()) * R::of(count as f64);
    let first = (x.as_f64() as usize).min(count - 1);
    let next = first + 1;
    Cell {
        first,
        second: if next == count { 0 } else { next },
        t: (x - R::of(first as f64)).at_most(R::one()),
    }
}
