//! The share of light that leaves.

use super::kind::ViewKind;
use crate::data::Data;
use crate::export::table::{Table, Value, shown};
use crate::session::Session;

pub(super) const KIND: ViewKind = ViewKind {
    id: "reflectance",
    title: "Reflectance",
    is_of_held: |_| false,
    what_you_see: "The share of the light arriving at an angle that leaves, in all directions \
        together: above 1 energy is created",
    table: Some(table),
    is_mesh: false,
};

/// Of the reflectance: what each lobe does at each angle.
fn table(session: &Session, data: &mut Data) -> Table {
    let mut table = Table::new(&[
        "material",
        "category",
        "side",
        "lobe",
        "theta_i (degrees)",
        "rho_r",
        "rho_g",
        "rho_b",
        "error",
    ]);
    for (entry, title) in shown(session) {
        let curve = data.ask(session, entry, session.reflectance_request());
        for row in &curve.rows {
            for share in &row.shares {
                let [r, g, b] = share.value;
                let lobe = share.lobe;
                let words = [&title, lobe.category.id(), lobe.side.id(), lobe.name];
                let mut cells: Vec<Value> = words.map(|word| Value::Text(word.to_owned())).into();
                cells.extend([row.theta_deg, r, g, b, share.error].map(Value::Number));
                table.rows.push(cells);
            }
        }
    }
    table
}
