//! The lobes over all directions.

use serde::{Deserialize, Serialize};

use super::caption::{Caption, Subjects, value_of_f};
use super::kind::{Deltas, TableKind, ViewKind, ViewOptions};
use super::scale::{Arrangement, Scale};
use crate::answers::Answers;
use crate::export::names::Names;
use crate::export::table::{Table, shown};
use crate::number::Numbers;
use crate::session::Session;
use bxdf_lab::analysis::deltas::Arrows;
use bxdf_lab::analysis::lobe3d::{Request, Vertex};

pub(super) const KIND: ViewKind = ViewKind {
    id: "lobe3d",
    title: "3D lobe",
    what_you_see: "The lobe over all directions: the distance from the centre is the value f; \
        drag to orbit",
    says_hidden: false,
    deltas: Deltas::Marked,
    with_cosine: true,
    table: TableKind::Computed,
    is_mesh: true,
};

/// How the lobes are shown; camera and surface are the session's.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Options {
    /// How values become radii.
    #[serde(skip_serializing_if = "Scale::is_first")]
    pub scale: Scale,
    /// How several materials stand.
    #[serde(skip_serializing_if = "Arrangement::is_first")]
    pub arrangement: Arrangement,
}

impl Options {
    /// The mesh.
    #[must_use]
    pub fn request(&self, session: &Session) -> Request {
        Request {
            scale: self.scale.lengths,
            with_cosine: session.with_cosine,
        }
    }
}

impl ViewOptions for Options {
    fn caption(&self, session: &Session) -> Caption {
        Caption::of(value_of_f(session)).naming(self.arrangement.subjects(Subjects::Colors))
    }

    fn radial_scale(&mut self) -> Option<&mut Scale> {
        Some(&mut self.scale)
    }

    fn arrangement(&mut self) -> Option<&mut Arrangement> {
        Some(&mut self.arrangement)
    }

    fn numbers(&mut self) -> Numbers<'_> {
        self.scale.numbers()
    }

    /// The vertices of the mesh.
    fn table(&self, session: &Session, answers: &mut Answers) -> Table {
        let columns = ["material", "w_x", "w_y", "w_z"];
        let mut table = Table::named(Names::of_lobe(session, self.scale).columns(&columns));
        for (entry, title) in shown(session) {
            let mesh = answers.ask(session, entry, self.request(session));
            for Vertex {
                direction: w,
                value,
            } in &mesh.vertices
            {
                let cosine = if session.with_cosine { w.z.abs() } else { 1.0 };
                table.push_value(&title, [w.x, w.y, w.z], value.map(|f| f * cosine));
            }
            for arrow in answers.ask(session, entry, Arrows).iter() {
                table.push_delta(&title, arrow.direction.to_array(), arrow.flux);
            }
        }
        table
    }
}
