//! The share of one kind of reflection.

use super::f::of_channel;
use super::quantity::{Argument, Given, Quantity, Value, word};
use super::rho_dh::{ACCURACY, NO_FLUX};
use super::scene::Scene;
use crate::analysis::reflectance::{by_kind, lobe_shares};

pub(super) const QUANTITY: Quantity = Quantity {
    id: "share",
    symbol: "share",
    unit: "",
    meaning: "The part of the light's flux that leaves as one kind of reflection, on one side or on both",
    arguments: &[
        Argument::word(
            "category",
            &[
                "diffuse",
                "glossy_specular",
                "perfect_specular",
                "retro_reflective",
            ],
        ),
        Argument::word("side", &["reflection", "transmission"]).optional(),
    ],
    value,
};

fn value(scene: &Scene, given: &[Given]) -> Value {
    let [category, side] = [0, 1].map(|index| word(given, index));
    let (tolerance, evaluations) = ACCURACY;
    let shares = lobe_shares(scene.surface(), scene.light(), tolerance, evaluations);
    let shares = shares.ok_or(NO_FLUX)?;
    let kinds = by_kind(&shares).into_iter().filter(|share| {
        share.lobe.category.id() == category && (side.is_empty() || share.lobe.side.id() == side)
    });
    Ok(kinds.map(|share| of_channel(share.value, "")).sum())
}
