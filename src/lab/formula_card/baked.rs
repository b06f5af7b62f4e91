//! A table of values.

use super::place::Place;
use super::term::Terms;
use bxdf::models::MODELS;
use bxdf::param::ParamSet;
use bxdf::{ModelSpec, Spectrum};

const TABLE: &str = r"\frac{t(\theta_h, \theta_d, \phi_d)}{\light{\mu_i} + \viewer{\mu_o}}";

pub(super) fn formulas(_: &ParamSet) -> Vec<&'static str> {
    vec![TABLE]
}

pub(super) fn terms<'a>(place: &Place<'a>) -> Option<Terms<'a>> {
    let pair = place.pair()?;
    let mut models = MODELS.iter();
    let model: &ModelSpec = models.find(|model| model.id == "table")?;
    let surface = model.build::<f64>(place.params);
    let f: Spectrum<f64> = surface.f(pair.wo.into(), pair.wi.into());
    let mut terms = place.terms();
    terms.cosines(&pair);
    let sum = pair.mu_i() + pair.mu_o();
    let held = terms.value(
        [r"t(\theta_h, \theta_d, \phi_d)", "", "What the table holds at the half vector and the difference: between its nodes, along straight lines"],
        f * sum,
    );
    terms.f(TABLE, held * (1.0 / sum));
    Some(terms)
}
