//! What programs make of a roughness.

use super::quantity::{Argument, Given, Quantity, number, word};
use super::scene::Scene;

/// The names of the programs, each with the widths alpha that they make of the same number.
///
/// - `disney`, `gltf`, `openpbr`, `mitsuba_principled`: alpha = r^2 (Burley 2012, section 5.4; glTF 2.0, appendix B.2.4; OpenPBR
///   1.1, "Microfacet model").
/// - `mitsuba_roughconductor`: the number is alpha itself.
/// - `pbrt_v4`: alpha = sqrt(r) (`TrowbridgeReitzDistribution::RoughnessToAlpha`).
/// - `pbrt_v3`: a polynomial of ln r (same name there).
const PROGRAMS: &[&str] = &[
    "disney",
    "gltf",
    "openpbr",
    "mitsuba_principled",
    "mitsuba_roughconductor",
    "pbrt_v4",
    "pbrt_v3",
];

/// The coefficients of pbrt-v3's polynomial, from the constant on.
const PBRT_V3: [f64; 5] = [1.62142, 0.819_955, 0.1734, 0.017_120_1, 0.000_640_711];

/// The least roughness that pbrt-v3's polynomial is taken at.
const PBRT_V3_LEAST: f64 = 1e-3;

pub(super) const QUANTITY: Quantity = Quantity {
    id: "alpha_of_roughness",
    symbol: "α",
    unit: "",
    meaning: "The width alpha that a program makes of a roughness between 0 and 1",
    arguments: &[
        Argument::word("program", PROGRAMS),
        Argument::number("roughness", [0.0, 1.0]),
    ],
    value: |scene, given| Ok(value(scene, given)),
};

fn value(_: &Scene, given: &[Given]) -> f64 {
    let r = number(given, 1).unwrap_or_default();
    match word(given, 0).as_str() {
        "mitsuba_roughconductor" => r,
        "pbrt_v4" => r.sqrt(),
        "pbrt_v3" => {
            let x = r.max(PBRT_V3_LEAST).ln();
            let horner = |sum: f64, coefficient: &f64| sum * x + coefficient;
            PBRT_V3.iter().rev().fold(0.0, horner)
        }
        _ => r * r,
    }
}
