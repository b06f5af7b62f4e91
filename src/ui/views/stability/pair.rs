//! Going to a pair of directions.

use super::super::context::ViewContext;
use bxdf_lab::contract::Witness;
use bxdf_study::cursor::Cursor;
use bxdf_study::views::stability::Options;

/// Holds one direction of this pair of the selected material's surface, and points at the other.
pub(super) fn go_to(cx: &mut ViewContext<'_, Options>, wo: glam::DVec3, wi: glam::DVec3) {
    let witness = Witness {
        text: String::new(),
        wo: Some(wo),
        wi: Some(wi),
    };
    let selected = cx.session.materials.selected().id();
    *cx.pointed = Cursor::jump(cx.session, selected, &witness);
}
