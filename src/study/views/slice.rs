//! f over the angles of half vector and difference.

use super::kind::ViewKind;
use crate::data::Data;
use crate::export::names::Names;
use crate::export::table::{Table, shown};
use crate::session::Session;
use bxdf_lab::analysis::Subject;
use bxdf_lab::analysis::slice::{self, mirrored_at};

pub(super) const KIND: ViewKind = ViewKind {
    id: "slice",
    title: "Slice",
    is_of_held: |_| false,
    what_you_see: "f over the angles of half vector (to the right) and difference (upwards): \
        the fingerprint of a material",
    table: Some(table),
    is_mesh: false,
};

/// Of the slice: its pixels that lie above the surface, and what is mirrored at each theta_d.
fn table(session: &Session, data: &mut Data) -> Table {
    let columns = ["material", "theta_h (degrees)", "theta_d (degrees)"];
    let mut table = Table::named(Names::of_slice(session).columns(&columns));
    let request = session.slice_request();
    for (entry, title) in shown(session) {
        let slice::Slice { raster } = &*data.ask(session, entry, request);
        let share = |index: usize, n: usize| (index as f64 + 0.5) / n as f64;
        let theta_d = |row: usize| 90.0 * (1.0 - share(row, raster.height));
        for (index, rgb) in raster.pixels.iter().enumerate() {
            let x = share(index % raster.width, raster.width);
            let theta_h = 90.0 * if request.is_square_root { x * x } else { x };
            if rgb.iter().all(|x| x.is_finite()) {
                table.push_value(&title, [theta_h, theta_d(index / raster.width)], *rgb);
            }
        }
        for theta_d in (0..raster.height).map(theta_d) {
            let of = |subject: &Subject<'_>| mirrored_at(&request, subject, theta_d);
            if let Some(flux) = data.with_subject(session, entry, of) {
                table.push_delta(&title, [0.0, theta_d], flux);
            }
        }
    }
    table
}
