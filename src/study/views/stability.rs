//! Where digits are lost.

use super::kind::ViewKind;
use crate::data::Data;
use crate::export::table::Table;
use crate::session::Session;
use crate::session::StabilityPlot;

pub(super) const KIND: ViewKind = ViewKind {
    id: "stability",
    title: "Stability",
    is_of_held: |session| session.views.stability.plot == StabilityPlot::Map,
    what_you_see: "How far f32 and f64 are off, over two angles or parameters: bright where digits \
        are lost, contours where the inputs themselves explain it",
    table: Some(table),
    is_mesh: false,
};

/// Of the stability: the errors over the two axes, through the mirror direction of the held one.
fn table(session: &Session, data: &mut Data) -> Table {
    let mut table = Table::new(&[
        "material",
        "x",
        "y",
        "error_f32",
        "error_f64",
        "of_bound_f32",
        "of_bound_f64",
        "condition_number",
    ]);
    let request = session.stability_request();
    let entry = session.materials.selected();
    let title = session.materials.title(entry);
    let map = data.ask(session, entry, request.clone());
    for (index, cell) in map.pixels.iter().enumerate() {
        let share = |index: usize, n: usize| (index as f64 + 0.5) / n as f64;
        let x = request.x.value(share(index % map.width, map.width));
        let y = request.y.value(1.0 - share(index / map.width, map.height));
        let ([e32, e64], [r32, r64]) = (cell.errors, cell.ratios);
        if cell.kappa.is_finite() {
            table.push(&title, [x, y, e32, e64, r32, r64, cell.kappa]);
        }
    }
    table
}
