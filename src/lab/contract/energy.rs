//! Energy: no more flux leaves than arrives.

use glam::DVec3;

use super::integrals::ESTIMATE;
use super::law::LawId;
use super::law_tally::Tallies;
use super::sweep::directions;
use crate::analysis::reflectance::{directional_hemispherical, directional_hemispherical_within};
use crate::specimen::Specimen;
use bxdf::math::frame::direction_from_degrees;
use bxdf::{Component, Declaration, ModelSpec};

/// Absolute error wanted of the reflectances, and the excess let pass: a hundredth of the smallest one worth declaring.
const TOLERANCE: f64 = 1e-5;

/// Absolute error wanted where it is to be quick, and the evaluations of a lobe it may take.
pub(super) const QUICK_TOLERANCE: f64 = 1e-4;
pub(super) const QUICK_EVALUATIONS: usize = 8000;

/// The polar angles and azimuths, in degrees, at which the energy of a material is measured besides the directions of all
/// laws: sums of lobes are often brightest shortly before the horizon.
const BETWEEN_DEG: [(f64, f64); 5] = [
    (20.0, 75.0),
    (48.0, -140.0),
    (72.0, 10.0),
    (80.0, 160.0),
    (87.5, -30.0),
];

/// Where the energy of a material is measured besides the directions of all laws: above the surface, and below where light
/// crosses one of `components`.
pub(super) fn directions_between<'a>(
    mut components: impl Iterator<Item = &'a Component>,
) -> Vec<DVec3> {
    let is_crossed = components.any(|component| component.model().transmits());
    let above = BETWEEN_DEG.into_iter();
    let all = above.flat_map(|(theta_deg, phi_deg)| {
        let below = is_crossed.then_some((180.0 - theta_deg, phi_deg));
        std::iter::once((theta_deg, phi_deg)).chain(below)
    });
    all.map(|(theta_deg, phi_deg)| direction_from_degrees(theta_deg, phi_deg))
        .collect()
}

/// Where the energy of a material of `components` is measured.
pub(super) fn directions_of<'a>(components: impl Iterator<Item = &'a Component>) -> Vec<DVec3> {
    let mut all = directions();
    all.extend(directions_between(components));
    all
}

/// `rho_dh` <= 1, both sides and the deltas together, in every channel; `integral` is that of f |cos| and its error.
pub(super) fn energy(
    specimen: &Specimen,
    wi: DVec3,
    (integral, error): ([f64; 3], f64),
    tallies: &mut Tallies,
) {
    let mut rho = integral;
    for delta in specimen.double.deltas(wi.into()).into_iter().flatten() {
        rho.iter_mut()
            .zip(delta.flux.0)
            .for_each(|(sum, x)| *sum += x);
    }
    record(specimen, wi, rho, error.max(TOLERANCE), tallies);
}

/// The same, integrated over the squares that the lobes are drawn from: fast, and trusting their maps.
pub(super) fn energy_by_lobes(specimen: &Specimen, wi: DVec3, tallies: &mut Tallies) {
    let bxdf = &*specimen.double;
    let found = directional_hemispherical_within(bxdf, wi, QUICK_TOLERANCE, QUICK_EVALUATIONS);
    let error = ESTIMATE * found.error.max(QUICK_TOLERANCE);
    record(specimen, wi, found.leaving(), error, tallies);
}

fn record(specimen: &Specimen, wi: DVec3, rho: [f64; 3], error: f64, tallies: &mut Tallies) {
    let excess = worst(rho) - 1.0;
    // A NaN stays one and breaks the law.
    let excess = if excess < 0.0 { 0.0 } else { excess };
    tallies.record(LawId::Energy, excess, error, || {
        specimen.witness(&[("wi", wi)])
    });
}

/// The largest channel, or a NaN if there is one.
pub(super) fn worst(rgb: [f64; 3]) -> f64 {
    rgb.into_iter().fold(
        f64::NEG_INFINITY,
        |worst, x| if x <= worst { worst } else { x },
    )
}

/// The specimen of a declaration's witness, or what is wrong with its parameters.
pub(super) fn declared_subject(
    model: &ModelSpec,
    declaration: &Declaration,
) -> Result<Specimen, String> {
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
    Ok(Specimen::new(model, &params))
}

/// By how much energy is created at a declared witness, or what is wrong with the witness.
pub(super) fn declared_break(model: &ModelSpec, declaration: &Declaration) -> Result<f64, String> {
    let specimen = declared_subject(model, declaration)?;
    let wi = direction_from_degrees(declaration.theta_deg, 0.0);
    let rho = directional_hemispherical(&*specimen.double, wi, TOLERANCE);
    let excess = worst(rho.leaving()) - 1.0;
    if excess > rho.error.max(TOLERANCE) {
        Ok(excess)
    } else {
        Err(format!(
            "{} keeps energy at the declared witness: rho_dh - 1 = {excess}",
            specimen.name
        ))
    }
}
