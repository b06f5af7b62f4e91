//! Layouts that are ready to be shown.

use super::layout::{Part, Place};

/// A ready layout.
pub struct ReadyLayout {
    /// Its name at the screen.
    pub name: &'static str,
    /// What it is good for.
    pub meaning: &'static str,
    /// Where views stand in it, by the ids of their kinds.
    pub layout: fn() -> Place<&'static str>,
}

/// The ready layouts, in the order of the menu; the first one is that of the start.
pub static READY_LAYOUTS: [ReadyLayout; 6] = [
    ReadyLayout {
        name: "Teach",
        meaning: "Section and lobe side by side, as large as possible: for projecting to a class",
        layout: || Place::row(vec![Place::View("polar"), Place::View("lobe3d")]),
    },
    ReadyLayout {
        name: "Compare",
        meaning: "Section and lobe above the inspector, which gives every material's numbers at the cursor",
        layout: || {
            let above = Place::row(vec![Place::View("polar"), Place::View("lobe3d")]);
            Place::Column(vec![
                Part::of(1.6, above),
                Part::of(1.0, Place::View("inspector")),
            ])
        },
    },
    ReadyLayout {
        name: "Reflectance",
        meaning: "How much light leaves, how it looks on a body, and what it is made of",
        layout: || {
            Place::row(vec![
                Place::column(vec![
                    Place::View("reflectance"),
                    Place::View("decomposition"),
                ]),
                Place::column(vec![Place::View("sphere"), Place::View("slice")]),
            ])
        },
    },
    ReadyLayout {
        name: "Trade-off",
        meaning: "What accuracy costs, and where the cheaper choice goes wrong",
        layout: || {
            let beside = Place::column(vec![Place::View("hemisphere"), Place::View("polar")]);
            Place::Row(vec![
                Part::of(2.0, Place::View("tradeoff")),
                Part::of(1.0, beside),
            ])
        },
    },
    ReadyLayout {
        name: "Sampling",
        meaning: "Where the sampler sends directions, beside the density and the value it should follow",
        layout: || {
            Place::row(vec![
                Place::View("sampling"),
                Place::column(vec![Place::View("hemisphere"), Place::View("cartesian")]),
            ])
        },
    },
    ReadyLayout {
        name: "Stability",
        meaning: "Where f32 and f64 lose digits, and the lobe there",
        layout: || {
            Place::Column(vec![
                Part::of(1.6, Place::View("stability")),
                Part::of(
                    1.0,
                    Place::row(vec![Place::View("polar"), Place::View("hemisphere")]),
                ),
            ])
        },
    },
];
