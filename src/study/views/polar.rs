//! A section of the lobes.

use super::kind::ViewKind;
use crate::data::Data;
use crate::export::names::Names;
use crate::export::table::{Table, shown};
use crate::session::Session;
use bxdf_lab::analysis::polar::Point;

pub(super) const KIND: ViewKind = ViewKind {
    id: "polar",
    title: "Polar plot",
    is_of_held: |_| true,
    what_you_see: "A section of the lobe through the normal n: the length of a ray is the \
        value f in its direction",
    table: Some(table),
    is_mesh: false,
};

/// Of the polar plot: the section.
fn table(session: &Session, data: &mut Data) -> Table {
    let columns = ["material", "angle (degrees)"];
    let mut table = Table::named(Names::of_lobe(session).columns(&columns));
    for (entry, title) in shown(session) {
        let section = data.ask(session, entry, session.section_request());
        for Point { angle, value } in section.lower.iter().chain(&section.upper) {
            table.push_value(&title, [angle.to_degrees()], *value);
        }
        table.push_stems(&title, &section.stems);
    }
    table
}
