//! The lobes over all directions.

use super::kind::ViewKind;
use crate::data::Data;
use crate::export::names::Names;
use crate::export::table::{Table, shown};
use crate::session::Session;
use bxdf_lab::analysis::lobe3d::Vertex;

pub(super) const KIND: ViewKind = ViewKind {
    id: "lobe3d",
    title: "3D lobe",
    is_of_held: |_| true,
    what_you_see: "The lobe over all directions: the distance from the centre is the value f; \
        drag to orbit",
    table: Some(table),
    is_mesh: true,
};

/// Of the 3D lobe: the vertices of the mesh.
fn table(session: &Session, data: &mut Data) -> Table {
    let columns = ["material", "w_x", "w_y", "w_z"];
    let mut table = Table::named(Names::of_lobe(session).columns(&columns));
    for (entry, title) in shown(session) {
        let mesh = data.ask(session, entry, session.mesh_request());
        for Vertex {
            direction: w,
            value,
        } in &mesh.vertices
        {
            let cosine = if session.with_cosine { w.z.abs() } else { 1.0 };
            table.push_value(&title, [w.x, w.y, w.z], value.map(|f| f * cosine));
        }
        for arrow in data.arrows(session, entry).iter() {
            table.push_delta(&title, arrow.direction.to_array(), arrow.flux);
        }
    }
    table
}
