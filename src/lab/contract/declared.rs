//! What models declare: the laws that they break as published, each with a witness that must break it.

use super::law::{LawReport, Status};
use super::{energy, pointwise};
use bxdf::{Declaration, Law, ModelSpec};

/// A sweep may exceed the break that a witness shows by this factor: a witness stands for the worst break, and the
/// directions of the sweep need not be its own. A larger break is another one.
pub(super) const WITNESS_MARGIN: f64 = 1.05;

/// `report` with the model's declarations of its law taken into account.
pub(super) fn judged(model: &ModelSpec, mut report: LawReport) -> LawReport {
    let declarations = report.law.declarations(model);
    let declared_breaks = declarations.map(|declaration| declared_break(model, declaration));
    let mut allowed: Option<f64> = None;
    for shown in declared_breaks {
        report.n += 1;
        match shown {
            Ok(deviation) => allowed = Some(allowed.unwrap_or(0.0).max(deviation)),
            Err(problem) => {
                report.status = Status::Misdeclared;
                report.witness = problem.into();
                return report;
            }
        }
    }
    if let Some(deviation) = allowed {
        if report.worst <= WITNESS_MARGIN * deviation {
            report.status = Status::Declared;
        }
        if report.worst < deviation {
            report.worst = deviation;
            report.witness = "the declared witness".to_owned().into();
        }
    }
    report
}

/// By how much `model` breaks a law at a declared witness, or what is wrong with the witness.
pub(super) fn declared_break(model: &ModelSpec, declaration: &Declaration) -> Result<f64, String> {
    match declaration.law {
        Law::Energy => energy::declared_break(model, declaration),
        Law::Reciprocity => pointwise::declared_break(model, declaration),
    }
}
