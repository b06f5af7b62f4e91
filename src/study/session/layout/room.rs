//! The room of places in a window, and where another view finds most of it.

use super::{Part, Place};

/// The least width and height of a place that a view is given, in points: in less, plots have no room for their labels.
pub const LEAST_PLACE: [f32; 2] = [320.0, 260.0];

/// A place that is no row or column.
struct Leaf<V> {
    size: [f32; 2],
    views: Vec<V>,
}

impl<V> Leaf<V> {
    fn area(&self) -> f32 {
        self.size.iter().product()
    }

    /// Whether plots have no room for their labels in it.
    fn is_too_small(&self) -> bool {
        self.size
            .iter()
            .zip(LEAST_PLACE)
            .any(|(side, least)| *side < least)
    }
}

/// What makes a place of parts: a row or a column.
type Join<V> = fn(Vec<Part<V>>) -> Place<V>;

impl<V: Copy + PartialEq> Place<V> {
    /// Puts `view` where there is most room: the largest place is halved along its longer side, or gets another tab where
    /// its halves would be too small. `room`: the width and height of all.
    pub fn put_into_largest(&mut self, view: V, room: [f32; 2]) {
        let Some(([width, height], neighbour)) = self.largest(room) else {
            return;
        };
        let [least_width, least_height] = LEAST_PLACE;
        let halves = if width >= height {
            (width >= 2.0 * least_width).then_some(Self::Row as Join<V>)
        } else {
            (height >= 2.0 * least_height).then_some(Self::Column as Join<V>)
        };
        self.split(neighbour, view, halves);
    }

    /// These places with their row as a column, or the other way round, where that leaves the smallest of them more room to
    /// its shorter side; then [`Self::fitted`].
    #[must_use]
    pub fn turned_and_fitted(self, room: [f32; 2]) -> Self {
        let turned = match self.clone() {
            Self::Row(parts) => Self::Column(parts),
            Self::Column(parts) => Self::Row(parts),
            other => other,
        };
        let least = |place: &Self| {
            let leaves = place.leaves(room).into_iter();
            leaves
                .map(|leaf| leaf.size[0].min(leaf.size[1]))
                .fold(f32::INFINITY, f32::min)
        };
        let is_better = least(&turned) > least(&self);
        if is_better { turned } else { self }.fitted(room)
    }

    /// These places as they fit into a window with this `room`: as long as one is too small for a view, its views become
    /// further tabs of the place before it, or of the one after the first.
    #[must_use]
    pub fn fitted(mut self, room: [f32; 2]) -> Self {
        loop {
            let leaves = self.leaves(room);
            let too_small = leaves
                .iter()
                .enumerate()
                .filter(|(_, leaf)| leaf.is_too_small());
            let smallest = too_small
                .rev()
                .min_by(|(_, a), (_, b)| a.area().total_cmp(&b.area()));
            let Some((index, leaf)) = smallest else {
                return self;
            };
            let Some(host) = leaves.get(index.checked_sub(1).unwrap_or(index + 1)) else {
                return self;
            };
            let (moved, neighbour) = (leaf.views.clone(), host.views.first().copied());
            let left = self.filter_map(&mut |view| (!moved.contains(view)).then_some(*view));
            let (Some(mut left), Some(neighbour)) = (left, neighbour) else {
                return self;
            };
            for view in moved {
                left.put_behind(neighbour, view);
            }
            self = left;
        }
    }

    /// The largest place that is no row or column: its size, and a view in it.
    fn largest(&self, room: [f32; 2]) -> Option<([f32; 2], V)> {
        let leaves = self.leaves(room);
        let largest = leaves
            .iter()
            .rev()
            .max_by(|a, b| a.area().total_cmp(&b.area()))?;
        Some((largest.size, *largest.views.first()?))
    }

    /// The places that are no rows and columns, from the left and from the top.
    fn leaves(&self, [width, height]: [f32; 2]) -> Vec<Leaf<V>> {
        let (parts, is_row) = match self {
            Self::View(_) | Self::Tabs { .. } => {
                return vec![Leaf {
                    size: [width, height],
                    views: self.views().into_iter().copied().collect(),
                }];
            }
            Self::Row(parts) => (parts, true),
            Self::Column(parts) => (parts, false),
        };
        let all: f32 = parts.iter().map(|part| part.share).sum();
        let of_part = |part: &Part<V>| {
            let share = part.share / all;
            part.place.leaves(if is_row {
                [width * share, height]
            } else {
                [width, height * share]
            })
        };
        parts.iter().flat_map(of_part).collect()
    }

    /// Puts `view` behind the place of `neighbour`, as its last tab; what is seen there stays.
    fn put_behind(&mut self, neighbour: V, view: V) {
        match self {
            Self::Row(parts) | Self::Column(parts) => {
                for part in parts {
                    part.place.put_behind(neighbour, view);
                }
            }
            Self::View(own) if *own == neighbour => {
                *self = Self::Tabs {
                    views: vec![neighbour, view],
                    active: 0,
                };
            }
            Self::Tabs { views, .. } if views.contains(&neighbour) => views.push(view),
            Self::View(_) | Self::Tabs { .. } => {}
        }
    }

    /// Puts `view` into the place of `neighbour`, which becomes `halves` of the two, or tabs.
    fn split(&mut self, neighbour: V, view: V, halves: Option<Join<V>>) {
        match self {
            Self::Row(parts) | Self::Column(parts) => {
                for part in parts {
                    part.place.split(neighbour, view, halves);
                }
            }
            Self::View(_) | Self::Tabs { .. } if !self.views().contains(&&neighbour) => {}
            Self::View(own) => {
                *self = match halves {
                    Some(join) => join(vec![
                        Part::of(1.0, Self::View(*own)),
                        Part::of(1.0, Self::View(view)),
                    ]),
                    None => Self::Tabs {
                        views: vec![*own, view],
                        active: 1,
                    },
                };
            }
            Self::Tabs { views, active } => {
                if let Some(join) = halves {
                    let tabs = Self::Tabs {
                        views: std::mem::take(views),
                        active: *active,
                    };
                    *self = join(vec![Part::of(1.0, tabs), Part::of(1.0, Self::View(view))]);
                } else {
                    views.push(view);
                    *active = views.len() - 1;
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_view_is_put_where_there_is_most_room() {
        let mut places = Place::Row(vec![
            Part::of(1.0, Place::View(1)),
            Part::of(2.0, Place::View(2)),
        ]);
        // 700 by 700, and of those that are left 350 by 700 the first.
        let room = [1050.0, 700.0];
        for view in [3, 4, 5] {
            places.put_into_largest(view, room);
            assert_eq!(places.validate(), Ok(()));
        }
        assert_eq!(places.views(), [&1, &4, &2, &5, &3]);
        places.put_into_largest(6, room);
        assert!(!format!("{places:?}").contains("Tabs"));
        // 350 by 350 is too small to be halved either way: tabs, of which the new one is seen.
        places.put_into_largest(7, room);
        assert!(places.views().contains(&&7));
        assert!(format!("{places:?}").contains("active: 1"), "{places:?}");
        let mut tabs = Place::Tabs {
            views: vec![1, 2],
            active: 0,
        };
        tabs.put_into_largest(3, [300.0, 200.0]);
        assert_eq!(tabs.views(), [&1, &2, &3]);
    }

    #[test]
    fn what_is_too_small_becomes_tabs() {
        let above = Place::row(vec![Place::View(1), Place::View(2)]);
        let compare = Place::Column(vec![
            Part::of(1.6, above.clone()),
            Part::of(1.0, Place::View(3)),
        ]);
        assert_eq!(compare.clone().fitted([1000.0, 720.0]), compare);
        let tabs = |views: &[i32]| Place::Tabs {
            views: views.to_vec(),
            active: 0,
        };
        let behind = Place::row(vec![Place::View(1), tabs(&[2, 3])]);
        assert_eq!(compare.clone().fitted([960.0, 540.0]), behind);
        assert_eq!(compare.fitted([600.0, 540.0]), tabs(&[1, 2, 3]));
        // The first one has none before it.
        let first = Place::Row(vec![
            Part::of(1.0, Place::View(1)),
            Part::of(3.0, tabs(&[2])),
        ]);
        assert_eq!(first.fitted([960.0, 540.0]), tabs(&[2, 1]));
        assert_eq!(Place::View(1).fitted([1.0, 1.0]), Place::View(1));
    }
}
