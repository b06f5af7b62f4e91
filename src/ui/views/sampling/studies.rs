//! What is drawn of all materials shown: their samples, each in the colour of its material.

use std::sync::Arc;

use egui::Color32;

use super::super::context::ViewContext;
use bxdf_lab::analysis::sampling::Study;
use bxdf_study::session::{EntryId, MaterialEntry};
use bxdf_study::views::sampling::Options;

/// The samples of every material shown.
pub(super) fn studies(cx: &mut ViewContext<'_, Options>) -> Vec<(EntryId, Arc<Study>)> {
    let (session, answers) = (&*cx.session, &mut *cx.answers);
    let request = cx.options.request(session);
    let study = |entry: &MaterialEntry| (entry.id(), answers.ask(session, entry, request));
    session.materials.shown().map(study).collect()
}

/// The colour of a material.
pub(super) fn color_of(cx: &ViewContext<'_, Options>, entry: EntryId) -> Color32 {
    let found = cx.session.materials.get(entry);
    found.map_or(cx.palette.ink, |entry| cx.palette.material(entry.slot()))
}
