//! The lit sphere.

use super::kind::ViewKind;
use crate::data::Data;
use crate::export::table::{Table, shown};
use crate::session::Session;

pub(super) const KIND: ViewKind = ViewKind {
    id: "sphere",
    title: "Lit sphere",
    is_of_held: |_| false,
    what_you_see: "A sphere of the material under a light, in true proportion; a click takes \
        the directions of that point",
    table: Some(table),
    is_mesh: false,
};

/// Of the lit sphere: the radiance of its pixels.
fn table(session: &Session, data: &mut Data) -> Table {
    let mut table = Table::new(&[
        "material",
        "x",
        "y",
        "radiance_r",
        "radiance_g",
        "radiance_b",
        "coverage",
    ]);
    let request = session.sphere_request(f32::INFINITY);
    for (entry, title) in shown(session) {
        let picture = data.ask(session, entry, request);
        for (index, [r, g, b, coverage]) in picture.pixels.iter().enumerate() {
            if *coverage > 0.0 {
                let place = |index: usize, n: usize| 2.0 * (index as f64 + 0.5) / n as f64 - 1.0;
                let (x, y) = (index % picture.width, index / picture.width);
                let place = [place(x, picture.width), -place(y, picture.height)];
                table.push(
                    &title,
                    place
                        .into_iter()
                        .chain([*r, *g, *b, *coverage].map(f64::from)),
                );
            }
        }
    }
    table
}
