//! f over an angle.

use super::kind::ViewKind;
use crate::data::Data;
use crate::export::names::{self, Names};
use crate::export::table::{Table, shown};
use crate::session::Session;
use bxdf_lab::analysis::cartesian::{Abscissa, Curve};

pub(super) const KIND: ViewKind = ViewKind {
    id: "cartesian",
    title: "Cartesian plot",
    is_of_held: |session| session.views.cartesian.abscissa == Abscissa::Free,
    what_you_see: "The value f over an angle, as papers print it: peaks, tails and what two \
        models differ by",
    table: Some(table),
    is_mesh: false,
};

/// Of the Cartesian plot: the curve.
fn table(session: &Session, data: &mut Data) -> Table {
    let options = session.views.cartesian;
    let angle = match options.abscissa {
        Abscissa::Free => "angle (degrees)",
        Abscissa::Half => "theta_h (degrees)",
        Abscissa::Difference => "theta_d (degrees)",
    };
    let names = Names::of_cartesian(session);
    let mut table = Table::named(names.columns(&["material", angle]));
    let reference = options.is_residual.then(|| session.materials.reference());
    for (entry, title) in shown(session) {
        let curve = data.compare(session, entry, reference, session.cartesian_request());
        let peaks = options.is_normalised.then(|| peaks(&curve));
        for point in curve.lines.iter().flatten() {
            let row = names::value(point.value);
            let over = |(index, x): (usize, f64)| {
                let peak = peaks.and_then(|peaks| peaks.get(index).copied());
                x / peak.filter(|peak| *peak > 0.0).unwrap_or(1.0)
            };
            let row = row.enumerate().map(over);
            table.push(&title, std::iter::once(point.x_deg).chain(row));
        }
        table.push_stems(&title, &curve.stems);
    }
    table
}

/// The largest magnitude of each channel of a curve.
fn peaks(curve: &Curve) -> [f64; names::CHANNELS.len()] {
    names::CHANNELS.map(|(channel, _)| {
        let points = curve.lines.iter().flatten();
        let values = points.map(|point| channel.of(point.value).abs());
        values.fold(0.0, f64::max)
    })
}
