//! The disc of directions.

use super::kind::ViewKind;
use crate::data::Data;
use crate::export::names::Names;
use crate::export::table::{Table, shown};
use crate::session::Session;
use bxdf_lab::analysis::hemisphere::Comparison;

pub(super) const KIND: ViewKind = ViewKind {
    id: "hemisphere",
    title: "Hemisphere",
    is_of_held: |_| true,
    what_you_see: "The value in every direction of one side: n in the middle, the horizon at \
        the rim, colours for values",
    table: Some(table),
    is_mesh: false,
};

/// Of the hemisphere: the pixels of the disc, and the deltas on its side.
fn table(session: &Session, data: &mut Data) -> Table {
    let columns = ["material", "w_x", "w_y", "w_z"];
    let mut table = Table::named(Names::of_hemisphere(session).columns(&columns));
    let request = session.hemisphere_request();
    let is_compared = request.comparison != Comparison::None;
    let reference = is_compared.then(|| session.materials.reference());
    for (entry, title) in shown(session) {
        let map = data.compare(session, entry, reference, request);
        let (width, height) = (map.raster.width, map.raster.height);
        for (index, rgb) in map.raster.pixels.iter().enumerate() {
            let place = |index: usize, n: usize| 2.0 * (index as f64 + 0.5) / n as f64 - 1.0;
            let place = [place(index % width, width), -place(index / width, height)];
            if let Some(w) = request.projection.direction(place, request.is_upper) {
                table.push_value(&title, w.to_array(), *rgb);
            }
        }
        for delta in &map.deltas {
            if (delta.direction.z > 0.0) == request.is_upper {
                table.push_delta(&title, delta.direction.to_array(), delta.value);
            }
        }
    }
    table
}
