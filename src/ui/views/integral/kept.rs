//! What is drawn of a sum that rests, kept between frames.

use std::collections::HashMap;
use std::sync::Arc;

use egui::{Color32, Rect, Shape, Theme, Ui};

use super::super::context::ViewContext;
use crate::widgets::pictures::{ColorScale, Turned};
use bxdf_lab::analysis::integral::{Request, Sum};
use bxdf_study::memo::Same;
use bxdf_study::session::EntryId;
use bxdf_study::views::integral::Options;

/// Where and how a sum stands: what was drawn for another place is of no use.
#[derive(Clone, Copy, PartialEq)]
pub(super) struct Place {
    pub(super) rect: Rect,
    pub(super) request: Request,
    pub(super) theme: Theme,
    /// The colour of the material.
    pub(super) color: Color32,
}

/// What is drawn of the sum of each material.
#[derive(Default)]
struct All(HashMap<EntryId, Kept>);

#[derive(Default)]
struct Kept {
    place: Option<Place>,
    shapes: Turned<(Same<Sum>, ColorScale), Vec<Shape>>,
}

/// What `make` draws of the sum of a material, made anew only where something of it is another one, and in its turn.
pub(super) fn shapes(
    ui: &Ui,
    cx: &mut ViewContext<'_, Options>,
    (entry, sum): (EntryId, &Arc<Sum>),
    (place, scale): (Place, ColorScale),
    make: impl FnOnce() -> Vec<Shape>,
) -> Arc<Vec<Shape>> {
    let mut all = std::mem::take(cx.state.own::<All>(cx.view));
    all.0
        .retain(|entry, _| cx.session.materials.get(*entry).is_some());
    let kept = all.0.entry(entry).or_default();
    if kept.place != Some(place) {
        *kept = Kept {
            place: Some(place),
            ..Kept::default()
        };
    }
    let turns = (&mut cx.state.textures.turns, ui.ctx());
    let key = (Same(Arc::clone(sum)), scale);
    let shapes = kept.shapes.get(turns, key, make);
    *cx.state.own(cx.view) = all;
    shapes
}
