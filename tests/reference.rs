//! Every model agrees with values computed elsewhere: the published formulas in 40-digit arithmetic.

#![allow(
    clippy::panic,
    clippy::indexing_slicing,
    clippy::unwrap_used,
    reason = "a test's own helpers may fail as loudly as the test"
)]

use std::path::{Path, PathBuf};

use brdf_explorer::bxdf::math::Vec3;
use brdf_explorer::bxdf::{Material, Precision, Scatterer};
use glam::DVec3;
use xprec::Df64;

/// A file of `tests/reference`, which must be there.
struct File {
    name: &'static str,
    /// Number of rows it must hold.
    rows: usize,
    /// Relative error allowed in the reference precision.
    tolerance: f64,
}

/// The values are printed to 17 digits, that is to 1.1e-16; one more unit for the last digit read.
const PRINTED: f64 = 2.3e-16;

/// The directions are unit vectors to 1e-16 only, and the cosine with the facet, |wo + wi| / 2, presumes unit ones: a
/// relative error of 1e-16 / |wo + wi|^2, 1e-13 where both graze. It shows through the Fresnel factor (1.4e-14).
const UNIT_INPUT: f64 = 1e-13;

/// As [`UNIT_INPUT`], in a model divided by the cosine with the facet, at a pair .1 degrees from the horizon and opposed:
/// |wo + wi| is .0035 there, and 1e-16 / |wo + wi|^2 is 8e-12. Measured: 8.3e-13.
const OPPOSED_INPUT: f64 = 8e-12;

const FILES: [File; 19] = [
    file("ashikhmin_shirley_1.csv", 37, OPPOSED_INPUT),
    file("burley_diffuse_1.csv", 37, PRINTED),
    file("eon_1.csv", 37, PRINTED),
    file("lambertian_reflection_1.csv", 41, PRINTED),
    file("lambertian_transmission_1.csv", 43, PRINTED),
    file("oren_nayar_1.csv", 37, PRINTED),
    file("phong_1.csv", 37, UNIT_INPUT),
    file("principled_1.csv", 37, UNIT_INPUT),
    file("principled_2.csv", 37, UNIT_INPUT),
    file("rough_conductor_1.csv", 37, PRINTED),
    file("rough_conductor_2.csv", 37, PRINTED),
    file("rough_conductor_3.csv", 37, PRINTED),
    file("rough_conductor_4.csv", 37, UNIT_INPUT),
    file("rough_conductor_5.csv", 37, UNIT_INPUT),
    file("rough_conductor_6.csv", 37, UNIT_INPUT),
    file("rough_dielectric_1.csv", 53, UNIT_INPUT),
    file("rough_dielectric_2.csv", 53, UNIT_INPUT),
    file("rough_dielectric_3.csv", 53, 2.0 * UNIT_INPUT),
    file("ward_1.csv", 37, PRINTED),
];

const fn file(name: &'static str, rows: usize, tolerance: f64) -> File {
    File {
        name,
        rows,
        tolerance,
    }
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/reference")
}

struct Row {
    wo: DVec3,
    wi: DVec3,
    /// f in three channels, then the density unless it is left to the implementer.
    expected: Vec<f64>,
    line: usize,
}

fn read(file: &str) -> (Material, Vec<Row>) {
    let text =
        std::fs::read_to_string(folder().join(file)).unwrap_or_else(|e| panic!("{file}: {e}"));
    let material = text
        .lines()
        .find_map(|line| line.strip_prefix("# material:"))
        .unwrap_or_else(|| panic!("{file}: no material"))
        .trim()
        .parse()
        .unwrap_or_else(|e| panic!("{file}: {e}"));
    let mut lines = text
        .lines()
        .enumerate()
        .filter(|(_, line)| !line.starts_with('#'));
    let header = lines.next().map(|(_, line)| line);
    assert_eq!(
        header,
        Some("wo_x,wo_y,wo_z,wi_x,wi_y,wi_z,f_r,f_g,f_b,pdf"),
        "{file}"
    );
    let rows = lines.map(|(index, line)| {
        let line_number = index + 1;
        let fields: Vec<&str> = line.split(',').collect();
        assert_eq!(fields.len(), 10, "{file}:{line_number}");
        let numbers: Vec<f64> = fields
            .iter()
            .take(if fields[9].is_empty() { 9 } else { 10 })
            .map(|field| {
                field
                    .parse()
                    .unwrap_or_else(|e| panic!("{file}:{line_number}: {e}"))
            })
            .collect();
        Row {
            wo: DVec3::from_slice(&numbers[0..3]),
            wi: DVec3::from_slice(&numbers[3..6]),
            expected: numbers[6..].to_vec(),
            line: line_number,
        }
    });
    (material, rows.collect())
}

/// The smallest width among the parameters, 1 where there is none.
fn smallest_width(material: &Material) -> f64 {
    ["alpha_x", "alpha_y"]
        .into_iter()
        .filter(|name| material.components()[0].params().get(name).is_some())
        .map(|name| material.components()[0].params().number(name))
        .fold(1.0, f64::min)
}

/// Compares every number of every file in precision `R`, to a relative error of `tolerance`, which is given the file and
/// the smallest width of the lobe.
fn compare<R: Precision>(tolerance: fn(&File, f64) -> f64) {
    let mut failures = Vec::new();
    for file in &FILES {
        let (material, rows) = read(file.name);
        assert_eq!(rows.len(), file.rows, "{}", file.name);
        let model: Box<dyn Scatterer<R>> = material.build();
        let allowed = tolerance(file, smallest_width(&material));
        for row in &rows {
            let (wo, wi): (Vec3<R>, Vec3<R>) = (row.wo.into(), row.wi.into());
            let [r, g, b] = model.f(wo, wi).to_f64();
            let found = [r, g, b, model.pdf(wo, wi).as_f64()];
            for ((found, expected), name) in found
                .into_iter()
                .zip(&row.expected)
                .zip(["f_r", "f_g", "f_b", "pdf"])
            {
                // What lies below the smallest normal number has no digits to compare.
                let smallest = R::min_positive_value().as_f64();
                let error = if expected.abs() < smallest {
                    (found.abs() / smallest - 1.0).max(0.0)
                } else {
                    (found / expected - 1.0).abs()
                };
                let allowed = allowed * tail(*expected);
                if error.is_nan() || error > allowed {
                    failures.push(format!(
                        "{}:{} {name} in {}: {found} for {expected}, off by {error:.1e}, allowed {allowed:.1e}",
                        file.name,
                        row.line,
                        R::NAME
                    ));
                }
            }
        }
    }
    assert!(failures.is_empty(), "\n{}", failures.join("\n"));
}

/// By how much a value far out in the tail of a Gaussian may be worse: exp(-q) multiplies the error of q by q. A part of
/// 25 of that is what the measured errors need (1.5e-5 in f32 at 1e-38).
fn tail(value: f64) -> f64 {
    1.0 + (-value.ln()).clamp(0.0, 1e3) / 25.0
}

#[test]
fn f64_agrees() {
    // Two dozen roundings, and UNIT_INPUT's; a formula that cancels loses 3e-15 / alpha^2 = 3e-9 in the first
    // conductor's file. Measured: 1.4e-14.
    compare::<f64>(|file, _| file.tolerance.max(1e-13));
}

#[test]
fn the_reference_precision_agrees() {
    compare::<Df64>(|file, _| file.tolerance);
}

#[test]
fn f32_agrees() {
    // 16 (1 + kappa) 6e-8: rounding the directions moves the slope of the half vector by about 6e-8, which its width
    // turns into a condition number of 1/alpha. Measured: 1.1e-7 without a width, 1.3e-5 at .05, 2.1e-4 at .001.
    compare::<f32>(|_, alpha| 1e-6 * (1.0 + 1.0 / alpha));
}

#[test]
fn every_file_is_used() {
    let mut found: Vec<String> = std::fs::read_dir(folder())
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    found.sort();
    assert_eq!(found, FILES.map(|file| file.name));
}
