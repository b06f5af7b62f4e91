//! What accuracy costs.

use super::kind::ViewKind;
use crate::data::Data;
use crate::export::table::{Table, Value};
use crate::session::Session;
use bxdf_lab::tradeoff::table::{COLUMNS, rows as tradeoff_rows};

pub(super) const KIND: ViewKind = ViewKind {
    id: "tradeoff",
    title: "Trade-off",
    is_of_held: |_| false,
    what_you_see: "What accuracy costs: each mark is a choice, its measured error over its measured \
        cost; what lies lowest and furthest left is worth choosing",
    table: Some(table),
    is_mesh: false,
};

/// The points of the trade-off, measured if they are not yet.
fn table(session: &Session, data: &mut Data) -> Table {
    if !data.tradeoff.is_of(session) {
        data.tradeoff.start(session, || {});
    }
    let report = data.tradeoff.report();
    let rows = report.iter().flat_map(|report| tradeoff_rows(report));
    Table {
        columns: COLUMNS.map(str::to_owned).to_vec(),
        rows: rows.map(|row| row.map(Value::Text).to_vec()).collect(),
    }
}
