//! `eval`: f and pdf for rows of directions.

use std::path::PathBuf;

use xprec::Df64;

use super::args::{self, Given, PrecisionName, STANDARD_STREAM};
use super::input::{COLUMNS, Rows};
use super::output::Table;
use super::say;
use crate::bxdf::Precision;
use crate::bxdf::math::Real;
use crate::error::Result;

/// The columns added to those read.
const RESULTS: [&str; 4] = ["f_r", "f_g", "f_b", "pdf"];

#[derive(clap::Args)]
pub(super) struct Arguments {
    /// The material: id of a model or named material, id:name=value,name=value, or a .toml file
    #[arg(value_parser = args::material)]
    material: Given,
    /// The precision of the arithmetic: f32, f64 or reference
    #[arg(long, value_parser = args::precision, default_value = <f64 as Real>::NAME)]
    precision: PrecisionName,
    /// The rows to read, with columns wo_x,wo_y,wo_z,wi_x,wi_y,wi_z; - is standard input
    #[arg(long = "in", value_name = "FILE", default_value = STANDARD_STREAM)]
    input: PathBuf,
    /// The file to write; - is standard output
    #[arg(long = "out", value_name = "FILE", default_value = STANDARD_STREAM)]
    output: PathBuf,
}

pub(super) fn run(arguments: &Arguments) -> Result<()> {
    match arguments.precision {
        PrecisionName::F32 => evaluate::<f32>(arguments),
        PrecisionName::F64 => evaluate::<f64>(arguments),
        PrecisionName::Reference => evaluate::<Df64>(arguments),
    }
}

fn evaluate<R: Precision>(arguments: &Arguments) -> Result<()> {
    let bxdf = arguments.material.checked().build::<R>();
    let mut rows = Rows::open(&arguments.input)?;
    let header: Vec<&str> = COLUMNS.into_iter().chain(RESULTS).collect();
    let mut table = Table::open(&arguments.output, &header)?;
    let mut normalised = 0_u64;
    while let Some(row) = rows.next()? {
        let (wo, wi) = (row.wo.into(), row.wi.into());
        row.texts.iter().try_for_each(|text| table.text(text))?;
        table.numbers(&bxdf.f(wo, wi).to_f64())?;
        table.numbers(&[bxdf.pdf(wo, wi).as_f64()])?;
        table.end_row()?;
        normalised += u64::from(row.was_normalised);
    }
    table.finish()?;
    if normalised > 0 {
        let rows = if normalised == 1 { "row" } else { "rows" };
        say(&format!(
            "{normalised} {rows} with directions that are not of unit length, normalised"
        ));
    }
    Ok(())
}
