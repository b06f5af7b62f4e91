//! `albedo`: the directional-hemispherical reflectance.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use rayon::prelude::*;
use serde::Serialize;

use super::args::{self, Given};
use super::output;
use bxdf::Scatterer;
use bxdf::error::{Result, line};
use bxdf::math::frame::direction_from_degrees;
use bxdf_lab::analysis::isotropy;
use bxdf_lab::analysis::reflectance::{
    LobeShare, MAX_EVALUATIONS, Reflectance, by_kind, lobe_shares,
};

/// The absolute error asked of the quadrature: a few digits beyond those printed, at no wait for any model.
const TOLERANCE: f64 = 1e-9;

#[derive(clap::Args)]
pub(super) struct Arguments {
    /// The material: id of a model or named material, id:name=value,name=value, a material file or a file of data
    #[arg(value_parser = args::material())]
    material: Given,
    /// The polar angles of incidence in degrees, 0 to 180
    #[arg(
        long,
        value_parser = args::polar_angle,
        value_delimiter = ',',
        default_value = "0,30,60,85"
    )]
    theta: Vec<f64>,
    /// The azimuth of incidence in degrees
    #[arg(long, value_parser = args::azimuth, default_value = "0")]
    phi: f64,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

/// What is printed, named as in the contract.
#[derive(Serialize)]
struct Report {
    material: String,
    phi: f64,
    rows: Vec<Row>,
    isotropic: Isotropic,
}

/// What becomes of the light arriving at `theta` degrees; no numbers where none arrives.
#[derive(Serialize)]
struct Row {
    theta: f64,
    reflection: Option<[f64; 3]>,
    transmission: Option<[f64; 3]>,
    absorbed: Option<[f64; 3]>,
    error: Option<f64>,
    shares: Shares,
}

/// Flux shares by the ids of category and side.
type Shares = BTreeMap<&'static str, BTreeMap<&'static str, [f64; 3]>>;

#[derive(Serialize)]
struct Isotropic {
    declared: bool,
    measured: bool,
}

pub(super) fn run(arguments: &Arguments) -> Result<()> {
    let report = report(arguments);
    if arguments.json {
        output::print_json(&report)
    } else {
        output::print(&listing(&report))
    }
}

fn report(arguments: &Arguments) -> Report {
    let material = arguments.material.checked();
    let bxdf = material.build::<f64>();
    let row = |&theta: &f64| row(&*bxdf, theta, arguments.phi);
    Report {
        material: material.to_string(),
        phi: arguments.phi,
        rows: arguments.theta.par_iter().map(row).collect(),
        isotropic: Isotropic {
            declared: material.is_isotropic(),
            measured: isotropy::measured(&*bxdf),
        },
    }
}

fn row(bxdf: &dyn Scatterer<f64>, theta: f64, phi: f64) -> Row {
    let wi = direction_from_degrees(theta, phi);
    let lobes = lobe_shares(bxdf, wi, TOLERANCE, MAX_EVALUATIONS);
    let found = lobes.as_deref().map(Reflectance::of);
    Row {
        theta,
        reflection: found.map(|found| found.reflection),
        transmission: found.map(|found| found.transmission),
        absorbed: found.map(|found| found.absorbed()),
        error: found.map(|found| found.error),
        shares: shares(&lobes.unwrap_or_default()),
    }
}

/// The shares of the lobes, those of the same category and side together.
fn shares(lobes: &[LobeShare]) -> Shares {
    let mut shares = Shares::new();
    for LobeShare { lobe, value, .. } in by_kind(lobes) {
        let sides = shares.entry(lobe.category.id()).or_default();
        sides.insert(lobe.side.id(), value);
    }
    shares
}

/// The report for people.
fn listing(report: &Report) -> String {
    let mut text = format!(
        "{}, light arriving at azimuth {} degrees\n",
        line(&report.material),
        report.phi
    );
    text.push_str("Shares of the flux, red green blue\n\n");
    // Writing to a string cannot fail.
    let _ = writeln!(
        text,
        "{:>7}   {:26}   {:26}   {:26}   error",
        "theta", "reflection", "transmission", "absorbed"
    );
    for row in &report.rows {
        let [reflection, transmission, absorbed] =
            [row.reflection, row.transmission, row.absorbed].map(channels);
        let _ = writeln!(
            text,
            "{:>7}   {reflection:26}   {transmission:26}   {absorbed:26}   {}",
            row.theta,
            row.error
                .map_or(NONE.to_owned(), |error| format!("{error:.0e}"))
        );
    }
    if report.rows.iter().any(|row| row.error.is_none()) {
        text.push_str("\nAt 90 degrees no light arrives, as cos theta is 0: its shares are undefined (try 89.999)\n");
    }
    let word = |is_isotropic| {
        if is_isotropic {
            "isotropic"
        } else {
            "anisotropic"
        }
    };
    let _ = writeln!(
        text,
        "\n{} by declaration, {} as measured",
        word(report.isotropic.declared),
        word(report.isotropic.measured)
    );
    text
}

/// What stands for a number that there is none of.
const NONE: &str = "-";

/// Three channels to six decimals; rounding noise about 0 is shown as 0.
fn channels(rgb: Option<[f64; 3]>) -> String {
    let Some(rgb) = rgb else {
        return NONE.to_owned();
    };
    let number = |x: f64| {
        let text = format!("{x:.6}");
        match text.strip_prefix('-') {
            Some(digits) if digits.bytes().all(|b| matches!(b, b'0' | b'.')) => digits.to_owned(),
            _ => text,
        }
    };
    rgb.map(number).join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use bxdf::{Category, Lobe};

    #[test]
    fn lobes_of_one_kind_count_together() {
        let share = |lobe, value| LobeShare {
            lobe,
            value: [value; 3],
            error: 0.0,
        };
        let shares = shares(&[
            share(Lobe::reflection(Category::Diffuse).named("ground"), 0.5),
            share(Lobe::reflection(Category::Diffuse).named("sheen"), 0.25),
            share(Lobe::transmission(Category::Diffuse), 0.125),
        ]);
        assert_eq!(shares.len(), 1);
        assert_eq!(shares["diffuse"]["reflection"], [0.75; 3]);
        assert_eq!(shares["diffuse"]["transmission"], [0.125; 3]);
    }

    #[test]
    fn rounding_noise_prints_as_zero() {
        let text = channels(Some([-1e-17, 0.0, -0.5]));
        assert_eq!(text, "0.000000 0.000000 -0.500000");
    }
}
