//! The hemisphere's data: what a lobe is in every direction of one side of the surface, as a picture of the disc.
//!
//! # Source
//! The equal-area disc is the azimuthal projection of Lambert; both projections as in `snyder1987`.

pub mod contour;
mod deltas;
mod request;

use glam::DVec3;

use super::raster::Raster;
use super::scale::Channel;
use super::{Detail, IsWanted, Pace, Query, Subject};

pub use deltas::DeltaValue;
pub use request::{Comparison, Projection, Quantity, Request};

/// The coarse map has a quarter of the pixels along either side.
const COARSER: usize = 4;

impl Query for Request {
    type Answer = Map;

    const PACE: Pace = Pace::CoarseFirst;

    fn place(&self) -> usize {
        usize::from(!self.is_upper)
    }

    fn answer(
        &self,
        subject: &Subject<'_>,
        detail: Detail,
        is_wanted: IsWanted<'_>,
    ) -> Option<Map> {
        let size = match detail {
            Detail::Coarse => self.size.div_ceil(COARSER),
            Detail::Full => self.size,
        };
        if self.comparison != Comparison::None && subject.against.is_none() {
            return Some(Map::default());
        }
        let place = |index: usize| 2.0 * (index as f64 + 0.5) / size as f64 - 1.0;
        let raster = Raster::rows_while(size, size, is_wanted, |row| {
            let at = |column| {
                let place = [place(column), -place(row)];
                self.projection.direction(place, self.is_upper)
            };
            let directions: Vec<Option<DVec3>> = (0..size).map(at).collect();
            let free: Vec<DVec3> = directions.iter().flatten().copied().collect();
            let mut values = self.values(subject, &free).unwrap_or_default().into_iter();
            let value = |w: Option<DVec3>| w.and_then(|_| values.next());
            let row = directions.into_iter().map(value);
            row.map(|value| value.unwrap_or([f64::NAN; 3])).collect()
        })?;
        Some(Map::new(raster, self.deltas(subject)))
    }
}

/// What the values of a map reach.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// The smallest value above 0; infinite where there is none.
    pub smallest_positive: f64,
    /// The lowest value; infinite where there is none.
    pub lowest: f64,
    /// The highest value; minus infinity where there is none.
    pub highest: f64,
}

impl Range {
    /// That of the finite ones of `values`.
    #[must_use]
    pub fn of(values: impl Iterator<Item = f64>) -> Self {
        let nothing = Self {
            smallest_positive: f64::INFINITY,
            lowest: f64::INFINITY,
            highest: f64::NEG_INFINITY,
        };
        values
            .filter(|value| value.is_finite())
            .fold(nothing, |range, value| Self {
                smallest_positive: if value > 0.0 {
                    range.smallest_positive.min(value)
                } else {
                    range.smallest_positive
                },
                lowest: range.lowest.min(value),
                highest: range.highest.max(value),
            })
    }

    /// The union of two ranges: one scale for several maps.
    #[must_use]
    pub fn with(self, other: Self) -> Self {
        Self {
            smallest_positive: self.smallest_positive.min(other.smallest_positive),
            lowest: self.lowest.min(other.lowest),
            highest: self.highest.max(other.highest),
        }
    }

    /// Whether there was any value.
    #[must_use]
    pub fn is_some(self) -> bool {
        self.lowest <= self.highest
    }
}

/// A map of one side of the surface.
#[derive(Clone, Debug, Default)]
pub struct Map {
    /// The values per channel, s to the right and t up; NaN outside the disc and where the value is undefined.
    pub raster: Raster<[f64; 3]>,
    /// The Dirac deltas, on both sides: they are no values of the map.
    pub deltas: Vec<DeltaValue>,
    /// By channel, luminance first.
    ranges: Vec<(Channel, Range)>,
}

impl Map {
    fn new(raster: Raster<[f64; 3]>, deltas: Vec<DeltaValue>) -> Self {
        let channels = [
            Channel::Luminance,
            Channel::Red,
            Channel::Green,
            Channel::Blue,
        ];
        let range = |channel: Channel| {
            let values = raster.pixels.iter().map(|rgb| channel.of(*rgb));
            (channel, Range::of(values))
        };
        Self {
            ranges: channels.map(range).to_vec(),
            deltas,
            raster,
        }
    }

    /// What the finite values of `channel` reach.
    #[must_use]
    pub fn range(&self, channel: Channel) -> Range {
        let found = self.ranges.iter().find(|(other, _)| *other == channel);
        found.map_or_else(|| Range::of(std::iter::empty()), |(_, range)| *range)
    }

    /// The values of `channel`: for colours and for [`contour::lines`].
    #[must_use]
    pub fn channel(&self, channel: Channel) -> Raster<f64> {
        self.raster.map(|rgb| channel.of(*rgb))
    }
}

#[cfg(test)]
mod tests;
