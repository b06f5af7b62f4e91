//! `eval`: f and pdf for rows of directions.

use std::borrow::Cow;
use std::path::PathBuf;

use xprec::Df64;

use super::args::{self, Given, PrecisionName, STANDARD_STREAM};
use super::input::{self, COLUMNS, Row, Rows};
use super::output::Table;
use bxdf::batch::{Columns, Job, Path};
use bxdf::error::Result;
use bxdf::math::Real;
use bxdf::{Precision, Scatterer};

/// The columns added to those read.
const RESULTS: [&str; 4] = ["f_r", "f_g", "f_b", "pdf"];

/// Rows that are evaluated together.
const ROWS: usize = 1024;

#[derive(clap::Args)]
pub(super) struct Arguments {
    /// The material: id of a model or named material, id:name=value,name=value, a material file or a file of data
    #[arg(value_parser = args::material())]
    material: Given,
    /// The precision of the arithmetic: f32, f64 or reference
    #[arg(long, value_parser = args::precision, default_value = <f64 as Real>::NAME)]
    precision: PrecisionName,
    /// The rows to read, with columns wo_x,wo_y,wo_z,wi_x,wi_y,wi_z, separated by commas, semicolons or tabs; - is standard input
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
    let mut chunk = Chunk::<R>::default();
    while let Some(row) = rows.next_row()? {
        normalised += u64::from(row.was_normalised);
        chunk.push(&row);
        if chunk.texts.len() == ROWS {
            chunk.write(&*bxdf, &mut table)?;
        }
    }
    chunk.write(&*bxdf, &mut table)?;
    table.finish()?;
    input::say_normalised(normalised, ["row", "rows"]);
    Ok(())
}

/// Rows that wait to be evaluated.
struct Chunk<R: Real> {
    texts: Vec<[String; COLUMNS.len()]>,
    /// The components of wo, then those of wi.
    pairs: Vec<[R; COLUMNS.len()]>,
}

impl<R: Real> Default for Chunk<R> {
    fn default() -> Self {
        Self {
            texts: Vec::new(),
            pairs: Vec::new(),
        }
    }
}

impl<R: Real> Chunk<R> {
    fn push(&mut self, row: &Row<'_>) {
        self.texts.push(row.texts.clone().map(Cow::into_owned));
        let (wo, wi) = (row.wo, row.wi);
        let components = [wo.x, wo.y, wo.z, wi.x, wi.y, wi.z];
        self.pairs.push(components.map(|x| R::of(x)));
    }

    /// Writes the rows with their results, and forgets them.
    fn write(&mut self, bxdf: &dyn Scatterer<R>, table: &mut Table) -> Result<()> {
        let pairs = Columns::from_rows(self.pairs.drain(..));
        let [ox, oy, oz, ix, iy, iz] = pairs.slices();
        let mut results = Columns::filled(R::zero(), pairs.len());
        let [r, g, b, pdf] = results.slices_mut();
        let job = Job::FPdf {
            wo: [ox, oy, oz],
            wi: [ix, iy, iz],
            f: [r, g, b],
            pdf,
        };
        bxdf.batch(Path::Dispatched, job);
        for (texts, results) in self.texts.drain(..).zip(results.rows()) {
            texts.iter().try_for_each(|text| table.text(text))?;
            table.numbers(&results.map(R::as_f64))?;
            table.end_row()?;
        }
        Ok(())
    }
}
