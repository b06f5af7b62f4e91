//! Where the views stand: side by side, one above the other, or as tabs in one place.

use std::fmt;

use serde::de::{self, Deserializer};
use serde::{Deserialize, Serialize, Serializer};

use super::numbers::SHARE;
use crate::views;

/// A place of the window that views share, and how.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Layout {
    /// One view, alone.
    View(ViewId),
    /// Parts side by side, from the left.
    Row(Vec<Part>),
    /// Parts one above the other, from the top.
    Column(Vec<Part>),
    /// Views in one place, of which one is seen.
    Tabs {
        /// The views, from the left.
        views: Vec<ViewId>,
        /// The one that is seen: an index of `views`.
        #[serde(default)]
        active: usize,
    },
}

/// A part of a row or a column.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Part {
    /// Its share of the room, relative to those of its neighbours.
    #[serde(default = "one")]
    pub share: f32,
    /// What is in it.
    pub place: Layout,
}

impl Part {
    /// A part that has this share, or the nearest one that a file may give.
    #[must_use]
    pub fn of(share: f32, place: Layout) -> Self {
        let mut nearest = 1.0;
        SHARE.put(&mut nearest, f64::from(share));
        Self {
            share: nearest as f32,
            place,
        }
    }
}

/// The id of a view of [`views::VIEWS`].
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct ViewId(&'static str);

impl fmt::Debug for ViewId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.0)
    }
}

impl ViewId {
    /// The view of this id.
    #[must_use]
    pub fn of(view: &'static views::ViewKind) -> Self {
        Self(view.id)
    }

    /// The id.
    #[must_use]
    pub fn as_str(self) -> &'static str {
        self.0
    }
}

impl Serialize for ViewId {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.0)
    }
}

impl<'de> Deserialize<'de> for ViewId {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let id = String::deserialize(deserializer)?;
        views::find(&id).map(Self::of).map_err(de::Error::custom)
    }
}

fn one() -> f32 {
    1.0
}

/// The deepest that places may lie in one another: no hand makes more, and a file that says so is broken.
const MAX_DEPTH: usize = 16;

/// A ready layout.
pub struct ReadyLayout {
    /// Its name at the screen.
    pub name: &'static str,
    /// What it is good for.
    pub meaning: &'static str,
    /// The layout.
    pub layout: fn() -> Layout,
}

/// The ready layouts, in the order of the menu; the first one is that of the start.
pub static READY_LAYOUTS: [ReadyLayout; 6] = [
    ReadyLayout {
        name: "Teach",
        meaning: "The section and the lobe side by side, as large as they go: for the screen in front of a class",
        layout: || Layout::row(vec![Layout::view("polar"), Layout::view("lobe3d")]),
    },
    ReadyLayout {
        name: "Compare",
        meaning: "Section and lobe above the inspector, which gives every material's numbers at the cursor",
        layout: || {
            let above = Layout::row(vec![Layout::view("polar"), Layout::view("lobe3d")]);
            Layout::Column(vec![
                Part {
                    share: 1.6,
                    place: above,
                },
                Part {
                    share: 1.0,
                    place: Layout::view("inspector"),
                },
            ])
        },
    },
    ReadyLayout {
        name: "Reflectance",
        meaning: "How much light leaves, how it looks on a body, and what it is made of",
        layout: || {
            Layout::row(vec![
                Layout::column(vec![
                    Layout::view("reflectance"),
                    Layout::view("decomposition"),
                ]),
                Layout::column(vec![Layout::view("sphere"), Layout::view("slice")]),
            ])
        },
    },
    ReadyLayout {
        name: "Trade-off",
        meaning: "What accuracy costs, and where the cheaper choice goes wrong",
        layout: || {
            let beside = Layout::column(vec![Layout::view("hemisphere"), Layout::view("polar")]);
            Layout::Row(vec![
                Part {
                    share: 2.0,
                    place: Layout::view("tradeoff"),
                },
                Part {
                    share: 1.0,
                    place: beside,
                },
            ])
        },
    },
    ReadyLayout {
        name: "Sampling",
        meaning: "Where the sampler sends directions, beside the density and the value it should follow",
        layout: || {
            Layout::row(vec![
                Layout::view("sampling"),
                Layout::column(vec![Layout::view("hemisphere"), Layout::view("cartesian")]),
            ])
        },
    },
    ReadyLayout {
        name: "Stability",
        meaning: "Where f32 and f64 lose digits, and the lobe there",
        layout: || {
            Layout::Column(vec![
                Part {
                    share: 1.6,
                    place: Layout::view("stability"),
                },
                Part {
                    share: 1.0,
                    place: Layout::row(vec![Layout::view("polar"), Layout::view("hemisphere")]),
                },
            ])
        },
    },
];

impl Default for Layout {
    fn default() -> Self {
        let [first, ..] = &READY_LAYOUTS;
        (first.layout)()
    }
}

impl Layout {
    fn view(id: &'static str) -> Self {
        Self::View(ViewId(id))
    }

    /// Equal parts side by side.
    fn row(places: Vec<Self>) -> Self {
        let part = |place| Part { share: 1.0, place };
        Self::Row(places.into_iter().map(part).collect())
    }

    /// Equal parts one above the other.
    fn column(places: Vec<Self>) -> Self {
        let part = |place| Part { share: 1.0, place };
        Self::Column(places.into_iter().map(part).collect())
    }

    /// The views in it, from the left and from the top, those behind other tabs too.
    #[must_use]
    pub fn views(&self) -> Vec<ViewId> {
        match self {
            Self::View(view) => vec![*view],
            Self::Row(parts) | Self::Column(parts) => {
                parts.iter().flat_map(|part| part.place.views()).collect()
            }
            Self::Tabs { views, .. } => views.clone(),
        }
    }

    /// This layout with `view` beside it, to the right.
    #[must_use]
    pub fn with(self, view: ViewId) -> Self {
        let part = |place, share| Part { share, place };
        let added = part(Self::View(view), 1.0);
        match self {
            Self::Row(mut parts) => {
                let mean = parts.iter().map(|part| part.share).sum::<f32>() / parts.len() as f32;
                parts.push(Part {
                    share: mean,
                    ..added
                });
                Self::Row(parts)
            }
            other => {
                let columns = 2.0;
                Self::Row(vec![part(other, columns), added])
            }
        }
    }

    /// What is wrong with a layout from a file.
    ///
    /// # Errors
    /// One sentence, where there is no view, a view stands twice, or a share is out of its range.
    pub fn validate(&self) -> Result<(), String> {
        let views = self.views();
        if views.is_empty() {
            return Err("a layout needs a view".to_owned());
        }
        let is_repeated = |(index, view)| views.iter().take(index).any(|other| other == view);
        if let Some((_, view)) = views.iter().enumerate().find(|pair| is_repeated(*pair)) {
            return Err(format!("the layout has the view '{}' twice", view.as_str()));
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
                SHARE.checked(f64::from(part.share))?;
                part.place.validate_place(depth + 1)
            }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Debug, PartialEq, Serialize, Deserialize)]
    struct File {
        layout: Layout,
    }

    fn read(text: &str) -> Result<Layout, String> {
        let file: File = toml::from_str(text).map_err(|error| error.message().to_owned())?;
        file.layout.validate().map(|()| file.layout)
    }

    #[test]
    fn ready_layouts_are_valid_and_round_trip() {
        for ready in &READY_LAYOUTS {
            let file = File {
                layout: (ready.layout)(),
            };
            let text = toml::to_string(&file).unwrap();
            assert_eq!(read(&text), Ok(file.layout), "{text}");
        }
        let tabs = "layout.tabs = { views = [\"lobe3d\", \"polar\"], active = 1 }";
        assert_eq!(read(tabs).unwrap().views().len(), 2);
    }

    #[test]
    fn broken_layouts_are_refused() {
        for (text, expected) in [
            ("layout.row = []", "needs a view"),
            (
                "layout.view = \"pola\"",
                "unknown view 'pola'; nearest: polar",
            ),
            (
                "layout.tabs = { views = [\"polar\", \"polar\"] }",
                "the view 'polar' twice",
            ),
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
    fn a_view_is_added_beside_the_others() {
        let [polar, lobe] = ["polar", "lobe3d"].map(|id| ViewId::of(views::find(id).unwrap()));
        let both = Layout::View(polar).with(lobe);
        assert_eq!(both.views(), [polar, lobe]);
        assert_eq!(both.validate(), Ok(()));
    }
}
