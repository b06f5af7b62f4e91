//! The room of places in a window, and where another view finds most of it.

use super::{Part, Place};

/// The least width and height of a place that a view is given, in points: in less, plots have no room for their labels.
pub const LEAST_PLACE: [f32; 2] = [320.0, 260.0];

/// What makes a place of parts: a row or a column.
type Join<V> = fn(Vec<Part<V>>) -> Place<V>;

impl<V: Copy + PartialEq> Place<V> {
    /// Puts `view` where there is most room: the largest place is halved along its longer side, or gets another tab where
    /// its halves would be too small. `room`: the width and height of all.
    pub fn put_into_largest(&mut self, view: V, room: [f32; 2]) {
        let Some((_, [width, height], neighbour)) = self.largest(room) else {
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

    /// The largest place that is no row or column: its area, its size, and a view in it.
    fn largest(&self, [width, height]: [f32; 2]) -> Option<(f32, [f32; 2], V)> {
        let (parts, is_row) = match self {
            Self::View(view) => return Some((width * height, [width, height], *view)),
            Self::Tabs { views, .. } => {
                let first = views.first()?;
                return Some((width * height, [width, height], *first));
            }
            Self::Row(parts) => (parts, true),
            Self::Column(parts) => (parts, false),
        };
        let all: f32 = parts.iter().map(|part| part.share).sum();
        let of_part = |part: &Part<V>| {
            let share = part.share / all;
            part.place.largest(if is_row {
                [width * share, height]
            } else {
                [width, height * share]
            })
        };
        let found = parts.iter().rev().filter_map(of_part);
        found.max_by(|a, b| a.0.total_cmp(&b.0))
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
}
