//! Arrangements of views that are ready to be shown.

use super::layout::{Part, Place};

/// A ready arrangement.
pub struct ReadyLayout {
    /// Its name at the screen.
    pub name: &'static str,
    /// A sign that stands for it.
    pub icon: &'static str,
    /// What it is good for.
    pub meaning: &'static str,
    /// Where views stand in it, by the ids of their kinds.
    pub layout: fn() -> Place<&'static str>,
}

/// The ready arrangements, in the order of the window; the first one is that of the start.
pub static READY_LAYOUTS: [ReadyLayout; 5] = [
    ReadyLayout {
        name: "Look",
        icon: "👁",
        meaning: "The lobe, large, with its section beside it",
        layout: || {
            Place::Row(vec![
                Part::of(1.5, Place::View("lobe3d")),
                Part::of(1.0, Place::View("polar")),
            ])
        },
    },
    ReadyLayout {
        name: "Compare",
        icon: "⚖",
        meaning: "Lobe and section above the inspector, which gives every material's numbers at the cursor",
        layout: || {
            let above = Place::row(vec![Place::View("lobe3d"), Place::View("polar")]);
            Place::Column(vec![
                Part::of(1.6, above),
                Part::of(1.0, Place::View("inspector")),
            ])
        },
    },
    ReadyLayout {
        name: "Reflectance",
        icon: "☀",
        meaning: "How much light leaves, the integral behind it, how it looks on a body, and what it is made of",
        layout: || {
            let parts = vec!["decomposition", "fresnel", "slice"];
            Place::row(vec![
                Place::column(vec![Place::View("reflectance"), Place::View("integral")]),
                Place::column(vec![
                    Place::View("sphere"),
                    Place::Tabs {
                        views: parts,
                        active: 0,
                    },
                ]),
            ])
        },
    },
    ReadyLayout {
        name: "Sampling",
        icon: "🎲",
        meaning: "Where the sampler sends directions, beside the density and the value it should follow",
        layout: || {
            Place::row(vec![
                Place::View("sampling"),
                Place::column(vec![Place::View("hemisphere"), Place::View("cartesian")]),
            ])
        },
    },
    ReadyLayout {
        name: "Numerics",
        icon: "🔬",
        meaning: "What accuracy costs, where f32 and f64 lose digits, and the lobe there",
        layout: || {
            let labs = Place::Tabs {
                views: vec!["tradeoff", "stability"],
                active: 0,
            };
            let beside = Place::column(vec![Place::View("hemisphere"), Place::View("polar")]);
            Place::Row(vec![Part::of(2.0, labs), Part::of(1.0, beside)])
        },
    },
];
