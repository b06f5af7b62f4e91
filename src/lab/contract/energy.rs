//! Energy: no more flux leaves than arrives.

use glam::DVec3;

use super::integrals::ESTIMATE;
use super::{LawId, Tallies};
use crate::analysis::reflectance::{directional_hemispherical, directional_hemispherical_within};
use crate::bxdf::math::frame::direction_from_degrees;
use crate::bxdf::{Declaration, ModelSpec};
use crate::lab::subject::Subject;

/// Absolute error wanted of the reflectances, and the excess let pass: a hundredth of the smallest one worth declaring.
const TOLERANCE: f64 = 1e-5;

/// Absolute error wanted where it is to be quick, and the evaluations of a lobe it may take.
const QUICK_TOLERANCE: f64 = 1e-4;
const QUICK_EVALUATIONS: usize = 8000;

/// `rho_dh` <= 1, both sides and the deltas together, in every channel; `integral` is that of f |cos| and its error.
pub(super) fn energy(
    subject: &Subject,
    wi: DVec3,
    (integral, error): ([f64; 3], f64),
    tallies: &mut Tallies,
) {
    let mut rho = integral;
    for delta in subject.double.deltas(wi.into()).into_iter().flatten() {
        rho.iter_mut()
            .zip(delta.flux.0)
            .for_each(|(sum, x)| *sum += x);
    }
    record(subject, wi, rho, error.max(TOLERANCE), tallies);
}

/// The same, integrated over the squares that the lobes are drawn from: fast, and trusting their maps.
pub(super) fn energy_by_lobes(subject: &Subject, wi: DVec3, tallies: &mut Tallies) {
    let bxdf = &*subject.double;
    let found = directional_hemispherical_within(bxdf, wi, QUICK_TOLERANCE, QUICK_EVALUATIONS);
    let mut rho = found.reflection;
    rho.iter_mut()
        .zip(found.transmission)
        .for_each(|(sum, x)| *sum += x);
    let error = ESTIMATE * found.error.max(QUICK_TOLERANCE);
    record(subject, wi, rho, error, tallies);
}

fn record(subject: &Subject, wi: DVec3, rho: [f64; 3], error: f64, tallies: &mut Tallies) {
    let excess = worst(rho) - 1.0;
    // A NaN stays one and breaks the law.
    let excess = if excess < 0.0 { 0.0 } else { excess };
    tallies.record(LawId::Energy, excess, error, || {
        subject.witness(&[("wi", wi)])
    });
}

/// The largest channel, or a NaN if there is one.
fn worst(rgb: [f64; 3]) -> f64 {
    rgb.into_iter().fold(
        f64::NEG_INFINITY,
        |worst, x| if x <= worst { worst } else { x },
    )
}

/// The subject of a declaration's witness, or what is wrong with its parameters.
pub(super) fn declared_subject(
    model: &ModelSpec,
    declaration: &Declaration,
) -> Result<Subject, String> {
    let mut params = model.defaults();
    for assignment in declaration
        .parameters
        .split(',')
        .filter(|part| !part.is_empty())
    {
        let (name, value) = assignment
            .split_once('=')
            .ok_or_else(|| format!("declaration: '{assignment}' is not name=value"))?;
        params
            .set_text(name, value)
            .map_err(|error| format!("declaration: {error}"))?;
    }
    (model.validate)(&params).map_err(|error| format!("declaration: {error}"))?;
    Ok(Subject::new(model, &params))
}

/// By how much energy is created at a declared witness, or what is wrong with the witness.
pub(super) fn declared_break(model: &ModelSpec, declaration: &Declaration) -> Result<f64, String> {
    let subject = declared_subject(model, declaration)?;
    let wi = direction_from_degrees(declaration.theta_deg, 0.0);
    let rho = directional_hemispherical(&*subject.double, wi, TOLERANCE);
    let ([r0, r1, r2], [t0, t1, t2]) = (rho.reflection, rho.transmission);
    let excess = worst([r0 + t0, r1 + t1, r2 + t2]) - 1.0;
    if excess > rho.error.max(TOLERANCE) {
        Ok(excess)
    } else {
        Err(format!(
            "{} keeps energy at the declared witness: rho_dh - 1 = {excess}",
            subject.name
        ))
    }
}
