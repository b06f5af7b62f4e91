//! Why a material breaks a law: by its weights, or by a model that says so; and the weights that keep energy.

use glam::DVec3;

use super::declared::{WITNESS_MARGIN, declared_break};
use super::energy::{self, QUICK_EVALUATIONS, QUICK_TOLERANCE};
use super::law::{LawId, LawReport, Status};
use super::pointwise;
use crate::analysis::reflectance::directional_hemispherical_within;
use crate::specimen::Specimen;
use bxdf::{Component, Declaration, Law, Material};

/// Weights of lobes that are added are whole multiples of one over this.
const STEPS_OF_WEIGHT: f64 = 100.0;

/// What a weight may be short of a step and is still taken for it: the error of the reflectances that it comes from.
const ALMOST: f64 = 1e-5 * STEPS_OF_WEIGHT;

/// `report` of `material`, as measured, with the status and the reason that the declarations of its models give it where it
/// breaks its law: it is excused where every lobe that does so by itself declares it, at its parameters, and the weights
/// add nothing.
pub(super) fn judged(material: &Material, mut report: LawReport) -> LawReport {
    if report.status == Status::Violated {
        let found = match report.law {
            LawId::Energy => of_energy(material, &report),
            LawId::Reciprocity => of_reciprocity(material, &report),
            _ => None,
        };
        if let Some((status, reason)) = found {
            report.status = status;
            report.reason = reason;
        }
    }
    report
}

/// What became of the law, and why.
type Verdict = (Status, String);

fn of_energy(material: &Material, report: &LawReport) -> Option<Verdict> {
    let wi = report.witness.wi?;
    let components = material.components();
    let mut weighed = [0.0; 3];
    let mut causes = Causes::default();
    for component in components.iter().filter(|one| one.weight() > 0.0) {
        let alone = reflectance(component, wi);
        for (sum, rho) in weighed.iter_mut().zip(alone) {
            *sum += component.weight() * rho.min(1.0);
        }
        let excess = energy::worst(alone) - 1.0;
        if excess > report.error {
            let what = format!("{} alone gives back more than it gets", title(component));
            causes.add(component, Law::Energy, excess, &what);
        }
    }
    if energy::worst(weighed) - 1.0 > report.error {
        causes.status = Status::Violated;
        let by_weights = match components {
            [only] => format!("its weight is {}", only.weight()),
            _ => "the lobes add up".to_owned(),
        };
        causes.reasons.insert(0, by_weights);
    }
    causes.verdict()
}

fn of_reciprocity(material: &Material, report: &LawReport) -> Option<Verdict> {
    let pair = (report.witness.wo?, report.witness.wi?);
    let mut causes = Causes::default();
    for component in material.components().iter().filter(|c| c.weight() > 0.0) {
        let specimen = Specimen::new(component.model(), component.params());
        let deviation = pointwise::reciprocity_broken(&specimen, &[pair]);
        if deviation > 0.0 {
            let what = format!("{} is not reciprocal", title(component));
            causes.add(component, Law::Reciprocity, deviation, &what);
        }
    }
    causes.verdict()
}

fn title(component: &Component) -> &'static str {
    component.model().title
}

/// What is known so far of why a law breaks.
struct Causes {
    status: Status,
    reasons: Vec<String>,
}

impl Default for Causes {
    fn default() -> Self {
        Self {
            status: Status::Declared,
            reasons: Vec::new(),
        }
    }
}

impl Causes {
    /// Adds that `component` breaks `law` by itself, by `deviation`; `what`: the same in words.
    fn add(&mut self, component: &Component, law: Law, deviation: f64, what: &str) {
        let (model, params) = (component.model(), component.params());
        let speaks = |declaration: &&'static Declaration| {
            declaration.law == law && (declaration.when)(params)
        };
        let mut allowed: f64 = 0.0;
        let mut notes = Vec::new();
        for declaration in model.properties.declarations.iter().filter(speaks) {
            match declared_break(model, declaration) {
                Ok(shown) => allowed = allowed.max(shown),
                Err(problem) => {
                    self.status = Status::Misdeclared;
                    self.reasons.push(problem);
                    return;
                }
            }
            notes.push(declaration.note);
        }
        if deviation <= WITNESS_MARGIN * allowed {
            let notes = notes.join("; ");
            self.reasons.push(format!("{what}, as published: {notes}"));
        } else {
            // Misdeclared is worse: it stays.
            if self.status == Status::Declared {
                self.status = Status::Violated;
            }
            self.reasons.push(what.to_owned());
        }
    }

    /// `None` where no cause was found.
    fn verdict(self) -> Option<Verdict> {
        let reason = self.reasons.join(", and ");
        (!reason.is_empty()).then_some((self.status, reason))
    }
}

/// The share of the light arriving along `wi` that leaves, per channel, with `component` taken once.
fn reflectance(component: &Component, wi: DVec3) -> [f64; 3] {
    let bxdf = component.build::<f64>();
    directional_hemispherical_within(&*bxdf, wi, QUICK_TOLERANCE, QUICK_EVALUATIONS).leaving()
}

/// The largest weight up to `wanted` with which `added` joins `material` and no more light leaves than arrives, at the
/// directions that the law of energy is checked at; rounded down to hundredths. 0 where the others give back everything.
/// Takes some milliseconds.
#[must_use]
pub fn weight_that_keeps_energy(material: &Material, added: &Component, wanted: f64) -> f64 {
    let all: Vec<&Component> = material.components().iter().chain([added]).collect();
    let largest =
        energy::directions_of(all.iter().copied())
            .into_iter()
            .fold(wanted, |largest, wi| {
                let mut room = [1.0; 3];
                for component in material.components() {
                    for (room, rho) in room.iter_mut().zip(reflectance(component, wi)) {
                        *room -= component.weight() * rho;
                    }
                }
                let own = reflectance(added, wi);
                let in_channel = room.into_iter().zip(own);
                in_channel.fold(largest, |largest, (room, own)| {
                    if own * largest > room {
                        (room / own).max(0.0)
                    } else {
                        largest
                    }
                })
            });
    (largest * STEPS_OF_WEIGHT + ALMOST).floor() / STEPS_OF_WEIGHT
}
