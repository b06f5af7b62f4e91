//! Sliders, drop-downs and colour buttons, made from the parameter specs.

use egui::Ui;

use super::chevron;
use bxdf::Component;
use bxdf::material::WEIGHT;
use bxdf::param::Value;
use bxdf_study::store::Side;
use order::Row;
use row::Place;
pub use ties::Ties;
pub use words::reason;

mod controls;
mod metal;
mod order;
pub mod pinned;
mod row;
mod ties;
mod words;

/// The weight of `component`; `ordinal` as for [`show`].
pub fn show_weight(ui: &mut Ui, component: &mut Component, ordinal: Option<usize>) {
    let weight = component.weight();
    let mut edited = Value::Number(weight);
    let place = Place {
        spec: &WEIGHT,
        ordinal,
    };
    row::show(ui, place, &mut edited, None, &|_| Ok(()));
    if let Value::Number(edited) = edited
        && edited != weight
    {
        // Within the range of the slider nothing is refused.
        let _ = component.set_weight(edited);
    }
}

/// The parameters of `component`, in the order in which people ask for them; those without effect at present are left out, and
/// `side` says which others are folded away.
///
/// `ordinal`: the number of `component` among several lobes, from 1, which their accessible names then say.
pub fn show(
    ui: &mut Ui,
    component: &mut Component,
    ordinal: Option<usize>,
    ties: &mut Ties<'_>,
    side: &mut Side,
) {
    let [always, more] = order::rows(component.params());
    for row in always {
        show_row(ui, component, row, ordinal, ties, side);
    }
    if more.is_empty() {
        return;
    }
    let params = component.params();
    let specs = more.iter().flat_map(|row| row.specs());
    let changed = specs
        .filter(|spec| params.get(spec.name) != Some(spec.default))
        .count();
    let text = match changed {
        0 => "More".to_owned(),
        n => format!("More ({n} changed)"),
    };
    let name = words::accessible("More parameters", ordinal);
    let hint = "Show or hide the parameters that are asked for less often";
    chevron::heading(ui, &mut side.shows_more, &text, &name, hint);
    if side.shows_more {
        for row in more {
            show_row(ui, component, row, ordinal, ties, side);
        }
    }
}

fn show_row(
    ui: &mut Ui,
    component: &mut Component,
    row: Row,
    ordinal: Option<usize>,
    ties: &mut Ties<'_>,
    side: &mut Side,
) {
    match row {
        Row::One(spec) => {
            let place = Place { spec, ordinal };
            row::of_component(ui, component, place, Some(ties));
            if row::is_last_width(spec) {
                ties.widths_box(ui, ordinal);
            }
        }
        Row::Metal(specs) => {
            let is_open = &mut side.shows_indices;
            metal::show(ui, component, specs, ordinal, ties, is_open);
        }
    }
}
