//! Where views stand: side by side, one above the other, or as tabs in one place.

use serde::{Deserialize, Serialize};

use super::numbers::SHARE;
pub use room::LEAST_PLACE;

mod room;

/// What tells a view of a session from the others, whatever becomes of its place. It is given when the view is opened or
/// read, and stands in no file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ViewId(pub(super) u32);

/// Where the views of a session stand.
pub type Layout = Place<ViewId>;

/// A place of the window that views share, and how; `V` is what stands for a view.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Place<V> {
    /// One view, alone.
    View(V),
    /// Parts side by side, from the left.
    Row(Vec<Part<V>>),
    /// Parts one above the other, from the top.
    Column(Vec<Part<V>>),
    /// Views in one place, of which one is seen.
    Tabs {
        /// The views, from the left.
        views: Vec<V>,
        /// The one that is seen: an index of `views`.
        #[serde(default)]
        active: usize,
    },
}

/// A part of a row or a column.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Part<V> {
    /// Its share of the room, relative to those of its neighbours.
    #[serde(default = "one")]
    pub share: f32,
    /// What is in it.
    pub place: Place<V>,
}

impl<V> Part<V> {
    /// A part that has this share, or the nearest one that a file may give.
    #[must_use]
    pub fn of(share: f32, place: Place<V>) -> Self {
        let mut nearest = 1.0;
        SHARE.put(&mut nearest, f64::from(share));
        Self {
            share: nearest as f32,
            place,
        }
    }
}

fn one() -> f32 {
    1.0
}

/// The deepest that places may lie in one another: no hand makes more, and a file that says so is broken.
const MAX_DEPTH: usize = 16;

impl<V> Place<V> {
    /// Equal parts side by side.
    #[must_use]
    pub fn row(places: Vec<Self>) -> Self {
        Self::Row(
            places
                .into_iter()
                .map(|place| Part::of(1.0, place))
                .collect(),
        )
    }

    /// Equal parts one above the other.
    #[must_use]
    pub fn column(places: Vec<Self>) -> Self {
        Self::Column(
            places
                .into_iter()
                .map(|place| Part::of(1.0, place))
                .collect(),
        )
    }

    /// The views in it, from the left and from the top, those behind other tabs too.
    #[must_use]
    pub fn views(&self) -> Vec<&V> {
        match self {
            Self::View(view) => vec![view],
            Self::Row(parts) | Self::Column(parts) => {
                parts.iter().flat_map(|part| part.place.views()).collect()
            }
            Self::Tabs { views, .. } => views.iter().collect(),
        }
    }

    /// The same places, with what `of` makes of each view; those of which it makes nothing are left out, and the places in
    /// which nothing is left.
    pub fn filter_map<'a, W>(
        &'a self,
        of: &mut impl FnMut(&'a V) -> Option<W>,
    ) -> Option<Place<W>> {
        match self {
            Self::View(view) => of(view).map(Place::View),
            Self::Row(parts) => joined(parts, Place::Row, of),
            Self::Column(parts) => joined(parts, Place::Column, of),
            Self::Tabs { views, active } => {
                let kept: Vec<Option<W>> = views.iter().map(of).collect();
                let before = kept.iter().take(*active).flatten().count();
                let views: Vec<W> = kept.into_iter().flatten().collect();
                let last = views.len().checked_sub(1)?;
                Some(Place::Tabs {
                    views,
                    active: before.min(last),
                })
            }
        }
    }

    /// Whether the places are those of `other`, and each view is the `same` as the one there.
    pub fn is_like<W>(&self, other: &Place<W>, same: &impl Fn(&V, &W) -> bool) -> bool {
        let are_alike = |parts: &[Part<V>], others: &[Part<W>]| {
            parts.len() == others.len()
                && parts.iter().zip(others).all(|(part, other)| {
                    part.share == other.share && part.place.is_like(&other.place, same)
                })
        };
        match (self, other) {
            (Self::View(view), Place::View(other)) => same(view, other),
            (Self::Row(parts), Place::Row(others))
            | (Self::Column(parts), Place::Column(others)) => are_alike(parts, others),
            (
                Self::Tabs { views, active },
                Place::Tabs {
                    views: others,
                    active: other,
                },
            ) => {
                active == other
                    && views.len() == others.len()
                    && views
                        .iter()
                        .zip(others)
                        .all(|(view, other)| same(view, other))
            }
            _ => false,
        }
    }

    /// What is wrong with places from a file, or made by hand.
    ///
    /// # Errors
    /// One sentence, where there is no view, a tab is none, a share is out of its range, or places lie too deep in one
    /// another.
    pub fn validate(&self) -> Result<(), String> {
        if self.views().is_empty() {
            return Err("a layout needs a view".to_owned());
        }
        self.validate_place(0)
    }

    fn validate_place(&self, depth: usize) -> Result<(), String> {
        if depth > MAX_DEPTH {
            return Err(format!("the layout is more than {MAX_DEPTH} places deep"));
        }
        match self {
            Self::Tabs { views, active } if *active >= views.len() => {
                Err(format!("the layout has no tab {active}"))
            }
            Self::View(_) | Self::Tabs { .. } => Ok(()),
            Self::Row(parts) | Self::Column(parts) => parts.iter().try_for_each(|part| {
                let share = SHARE.checked(f64::from(part.share));
                share.map_err(|refused| refused.to_string())?;
                part.place.validate_place(depth + 1)
            }),
        }
    }
}

/// What is left of the parts of a row or a column.
fn joined<'a, V, W>(
    parts: &'a [Part<V>],
    join: fn(Vec<Part<W>>) -> Place<W>,
    of: &mut impl FnMut(&'a V) -> Option<W>,
) -> Option<Place<W>> {
    let mut kept: Vec<Part<W>> = Vec::new();
    for part in parts {
        let place = part.place.filter_map(of);
        kept.extend(place.map(|place| Part {
            share: part.share,
            place,
        }));
    }
    if kept.len() < 2 {
        return kept.pop().map(|part| part.place);
    }
    Some(join(kept))
}

impl<V: Copy + PartialEq> Place<V> {
    /// This place with `view` beside it, to the right.
    #[must_use]
    pub fn with(self, view: V) -> Self {
        let added = Self::View(view);
        match self {
            Self::Row(mut parts) => {
                let mean = parts.iter().map(|part| part.share).sum::<f32>() / parts.len() as f32;
                parts.push(Part::of(mean, added));
                Self::Row(parts)
            }
            other => {
                let columns = 2.0;
                Self::Row(vec![Part::of(columns, other), Part::of(1.0, added)])
            }
        }
    }

    /// Puts `view` beside `neighbour`: as the next tab where that is one, else to its right.
    pub fn put_beside(&mut self, neighbour: V, view: V) {
        match self {
            Self::View(other) if *other == neighbour => {
                *self = Self::row(vec![Self::View(neighbour), Self::View(view)]);
            }
            Self::View(_) => {}
            Self::Row(parts) => {
                let is_it = |part: &Part<V>| part.place == Self::View(neighbour);
                match parts.iter().position(is_it) {
                    Some(index) => {
                        let share = parts.get(index).map_or(1.0, |part| part.share);
                        parts.insert(index + 1, Part::of(share, Self::View(view)));
                    }
                    None => put_into(parts, neighbour, view),
                }
            }
            Self::Column(parts) => put_into(parts, neighbour, view),
            Self::Tabs { views, active } => {
                if let Some(index) = views.iter().position(|other| *other == neighbour) {
                    views.insert(index + 1, view);
                    *active = index + 1;
                }
            }
        }
    }
}

fn put_into<V: Copy + PartialEq>(parts: &mut [Part<V>], neighbour: V, view: V) {
    for part in parts {
        part.place.put_beside(neighbour, view);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Debug, PartialEq, Serialize, Deserialize)]
    struct File {
        layout: Place<String>,
    }

    fn read(text: &str) -> Result<Place<String>, String> {
        let file: File = toml::from_str(text).map_err(|error| error.message().to_owned())?;
        file.layout.validate().map(|()| file.layout)
    }

    #[test]
    fn tabs_are_read() {
        let tabs = "layout.tabs = { views = [\"lobe3d\", \"polar\"], active = 1 }";
        assert_eq!(read(tabs).unwrap().views().len(), 2);
    }

    #[test]
    fn broken_layouts_are_refused() {
        for (text, expected) in [
            ("layout.row = []", "needs a view"),
            (
                "layout.tabs = { views = [\"polar\"], active = 1 }",
                "no tab 1",
            ),
            (
                "layout.row = [{ share = -1.0, place.view = \"polar\" }]",
                "share = -1",
            ),
        ] {
            let problem = read(text).unwrap_err();
            assert!(problem.contains(expected), "{text}: {problem}");
        }
    }

    #[test]
    fn a_view_is_put_beside_the_others_or_beside_one() {
        let both = Place::View(1).with(2);
        assert_eq!(both.views(), [&1, &2]);
        let mut nested = Place::column(vec![both, Place::View(3)]);
        nested.put_beside(1, 4);
        nested.put_beside(3, 5);
        assert_eq!(nested.views(), [&1, &4, &2, &3, &5]);
        assert_eq!(nested.validate(), Ok(()));
        let mut tabs = Place::Tabs {
            views: vec![1, 2],
            active: 1,
        };
        tabs.put_beside(1, 3);
        let expected = Place::Tabs {
            views: vec![1, 3, 2],
            active: 1,
        };
        assert_eq!(tabs, expected);
    }

    #[test]
    fn what_is_left_out_leaves_no_empty_place() {
        let tabs = Place::Tabs {
            views: vec![3, 1, 4],
            active: 2,
        };
        let places = Place::row(vec![
            Place::View(1),
            Place::column(vec![tabs, Place::View(1)]),
        ]);
        let left = places.filter_map(&mut |view| (*view != 1).then_some(*view));
        let expected = Place::Tabs {
            views: vec![3, 4],
            active: 1,
        };
        assert_eq!(left, Some(expected));
        assert_eq!(places.filter_map(&mut |_| None::<u8>), None);
    }
}
