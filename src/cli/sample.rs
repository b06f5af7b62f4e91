//! `sample`: directions of incidence as the model draws them.

use std::path::PathBuf;

use xprec::Df64;

use super::args::{self, Angles, Given, PrecisionName, STANDARD_STREAM};
use super::output::Table;
use bxdf::Precision;
use bxdf::error::{Error, Result, shown};
use bxdf::math::Real;
use bxdf::math::frame::direction_from_degrees;
use bxdf_lab::analysis::sampling::{CHUNK, Draw, Draws, FIRST_SEED};

/// The columns written.
const COLUMNS: [&str; 11] = [
    "u0", "u1", "uc", "wi_x", "wi_y", "wi_z", "f_r", "f_g", "f_b", "pdf", "delta",
];

/// The most samples of one run: some 200 GB of text.
const MAX_SAMPLES: u64 = 1_000_000_000;

#[derive(clap::Args)]
pub(super) struct Arguments {
    /// The material: id of a model or named material, id:name=value,name=value, a material file or a file of data
    #[arg(value_parser = args::material())]
    material: Given,
    /// The direction to the viewer in degrees, theta from the normal
    #[arg(long, value_name = "THETA,PHI", value_parser = args::angles)]
    wo: Angles,
    /// How many samples
    #[arg(short, value_name = "N", value_parser = sample_count)]
    n: u64,
    /// The seed of the random numbers; the sampling view draws the same ones
    #[arg(long, value_parser = seed, default_value_t = FIRST_SEED.into())]
    seed: u64,
    /// The precision of the arithmetic: f32, f64 or reference
    #[arg(long, value_parser = args::precision, default_value = <f64 as Real>::NAME)]
    precision: PrecisionName,
    /// The file to write; - is standard output
    #[arg(long = "out", value_name = "FILE", default_value = STANDARD_STREAM)]
    output: PathBuf,
}

fn sample_count(text: &str) -> Result<u64> {
    let count = text
        .parse()
        .map_err(|_| Error::parse(format!("-n '{}'", shown(text)), "expected a whole number"))?;
    if count > MAX_SAMPLES {
        return Err(Error::Limit {
            what: "-n",
            value: text.to_owned(),
            limit: format!("{MAX_SAMPLES} samples"),
        });
    }
    Ok(count)
}

fn seed(text: &str) -> Result<u64> {
    text.parse().map_err(|_| {
        Error::parse(
            format!("--seed '{}'", shown(text)),
            format!("expected a whole number from 0 to {}", u64::MAX),
        )
    })
}

pub(super) fn run(arguments: &Arguments) -> Result<()> {
    match arguments.precision {
        PrecisionName::F32 => draw::<f32>(arguments),
        PrecisionName::F64 => draw::<f64>(arguments),
        PrecisionName::Reference => draw::<Df64>(arguments),
    }
}

fn draw<R: Precision>(arguments: &Arguments) -> Result<()> {
    let bxdf = arguments.material.checked().build::<R>();
    let wo = direction_from_degrees(arguments.wo.theta_deg, arguments.wo.phi_deg).into();
    let mut table = Table::open(&arguments.output, &COLUMNS)?;
    for first in (0..arguments.n).step_by(CHUNK) {
        let count = (arguments.n - first).min(CHUNK as u64) as usize;
        for draw in Draws::new(&*bxdf, wo, arguments.seed, first, count).iter() {
            write(&draw, &mut table)?;
        }
    }
    table.finish()
}

/// Writes a row.
fn write<R: Real>(draw: &Draw<R>, table: &mut Table) -> Result<()> {
    table.numbers(&[draw.u[0], draw.u[1], draw.uc].map(R::as_f64))?;
    if draw.is_lost() {
        for field in ["", "", "", "", "", "", "0", "0"] {
            table.text(field)?;
        }
    } else {
        table.numbers(&[draw.wi.x, draw.wi.y, draw.wi.z].map(R::as_f64))?;
        table.numbers(&draw.f.map(R::as_f64))?;
        table.numbers(&[draw.pdf.as_f64()])?;
        table.text(if draw.is_delta { "1" } else { "0" })?;
    }
    table.end_row()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_and_seeds_are_whole() {
        assert_eq!(sample_count("1000000000").unwrap(), MAX_SAMPLES);
        assert_eq!(
            sample_count("1000000001").unwrap_err().to_string(),
            "-n is 1000000001; the limit is 1000000000 samples"
        );
        for text in ["-1", "1e3", ""] {
            assert!(sample_count(text).is_err() && seed(text).is_err());
        }
    }
}
