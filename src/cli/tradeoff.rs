//! `tradeoff`: what accuracy costs for a material on this machine, and the cheapest that is good enough.

use std::fmt::Write as _;
use std::io::{self, IsTerminal as _, Write as _};

use serde::Serialize;

use super::args::{self, Given};
use super::{check, output};
use bxdf::batch;
use bxdf::error::{self, Error, Result, shown};
use bxdf_lab::timing::Stopwatch;
use bxdf_lab::tradeoff::table::{COLUMNS, rows};
use bxdf_lab::tradeoff::{
    self, Advice, DEFAULT_TOLERANCES, FAMILIES, Family, FamilyReport, Point, Study, advise, measure,
};

#[derive(clap::Args)]
pub(super) struct Arguments {
    /// The material: id of a model or named material, id:name=value,name=value, a material file or a file of data
    #[arg(value_parser = args::material())]
    material: Given,
    /// Measure only this family; all by default
    #[arg(long, value_parser = family)]
    family: Option<&'static str>,
    /// The largest relative error (root mean square) that is good enough; several by default
    #[arg(long, value_parser = tolerance)]
    tolerance: Option<f64>,
    /// Print JSON
    #[arg(long, conflicts_with = "csv")]
    json: bool,
    /// Print the points as CSV
    #[arg(long)]
    csv: bool,
}

/// What is printed, named as in the contract.
#[derive(Serialize)]
struct Report {
    material: String,
    machine: String,
    instruction_set: String,
    families: Vec<FamilyReport>,
    advice: Vec<Advice>,
}

/// Measures and prints.
///
/// # Errors
/// Where standard output cannot be written.
pub(super) fn run(arguments: &Arguments) -> Result<()> {
    let material = arguments.material.checked();
    let is_wanted = |family: &&dyn Family| arguments.family.is_none_or(|only| only == family.id());
    let families: Vec<&dyn Family> = FAMILIES.into_iter().filter(is_wanted).collect();
    let study = Study::new(material, None);
    let mut progress = Progress::new();
    let measured = measure(
        &study,
        &families,
        Stopwatch::WallClock,
        &|| true,
        &mut |report, share| {
            let family = report.families.last().map_or("", |family| family.title);
            progress.show(family, share);
        },
    );
    progress.end();
    let Some(measured) = measured else {
        // Nobody can call it off here.
        return Ok(());
    };
    if arguments.csv {
        return output::print(&csv(&measured)?);
    }
    let tolerances = arguments
        .tolerance
        .map_or(DEFAULT_TOLERANCES.to_vec(), |only| vec![only]);
    let advice = tolerances
        .into_iter()
        .flat_map(|tolerance| advise(&measured, tolerance));
    let report = Report {
        material: material.to_string(),
        machine: check::machine(),
        instruction_set: batch::instruction_set(),
        advice: advice.collect(),
        families: measured.families,
    };
    if arguments.json {
        output::print_json(&report)
    } else {
        output::print(&report.table())
    }
}

/// Reads the id of a family.
fn family(text: &str) -> Result<&'static str> {
    args::choice(
        "family",
        text,
        &FAMILIES.map(|family| (family.id(), family.id())),
    )
}

/// Reads a tolerance.
fn tolerance(text: &str) -> Result<f64> {
    let number = text
        .parse::<f64>()
        .ok()
        .filter(|x| *x >= 0.0 && x.is_finite());
    number.ok_or_else(|| {
        let place = format!("tolerance '{}'", shown(text));
        Error::parse(place, "expected a number, 0 or more")
    })
}

/// One line on a terminal's standard error that says how far it is.
struct Progress {
    begin: std::time::Instant,
    is_shown: bool,
}

impl Progress {
    fn new() -> Self {
        Self {
            begin: std::time::Instant::now(),
            is_shown: io::stderr().is_terminal(),
        }
    }

    fn show(&mut self, family: &str, share: f64) {
        if self.is_shown {
            let rest = self.begin.elapsed().as_secs_f64() * (1.0 / share.max(1e-3) - 1.0);
            // Where standard error is closed, there is nobody to tell.
            let _ = write!(
                io::stderr(),
                "\r{:3.0} %  {family:<32} about {rest:3.0} s left ",
                100.0 * share
            );
        }
    }

    fn end(&self) {
        if self.is_shown {
            let _ = write!(io::stderr(), "\r{:70}\r", "");
        }
    }
}

impl Report {
    fn table(&self) -> String {
        let mut text = format!(
            "{}\n{}, {}\n",
            error::line(&self.material),
            self.machine,
            self.instruction_set
        );
        // Writing to a string cannot fail.
        for family in &self.families {
            let _ = writeln!(
                text,
                "\n{} ({}; against: {})",
                family.title, family.id, family.reference
            );
            if let Some(reason) = &family.not_applicable {
                let _ = writeln!(text, "  not applicable: {reason}");
                continue;
            }
            let _ = writeln!(
                text,
                "  {:<58} {:>12} [quartiles] {:>17} {:>9} {:>9} {:>9} {:>7}",
                "* nothing beats it",
                format!("ns/{}", family.cost_unit.name()),
                "error rms",
                "largest",
                "albedo",
                "delta E",
                ""
            );
            for point in &family.points {
                let _ = writeln!(text, "{}", line(point));
            }
            for (choice, slope) in &family.slopes {
                if let Some(slope) = slope {
                    let _ = writeln!(text, "  slope of {choice}: {slope:.2}");
                }
            }
        }
        let mut last = None;
        for advice in &self.advice {
            if last != Some(advice.tolerance) {
                last = Some(advice.tolerance);
                let _ = writeln!(
                    text,
                    "\ncheapest within {:e} (root mean square):",
                    advice.tolerance
                );
            }
            let n = advice.n.map_or(String::new(), |n| format!(", {n}"));
            let met = if advice.met {
                ""
            } else {
                "nothing meets it; closest: "
            };
            let lost = advice
                .lost
                .as_ref()
                .map_or(String::new(), |lost| format!("; lost: {lost}"));
            let _ = writeln!(
                text,
                "  {:<11} {met}{}{n}: {:.4} ns, error {:.1e}{lost}",
                advice.family, advice.choice, advice.cost_ns, advice.error_rms
            );
        }
        text
    }
}

fn line(point: &Point) -> String {
    let [low, high] = point.cost_spread_ns;
    let number = |x: Option<f64>| x.map_or("-".to_owned(), |x| format!("{x:.1e}"));
    format!(
        "  {} {:<56} {:>12.2} [{low:.1} {high:.1}] {:>12.1e} {:>9} {:>9} {:>7}",
        if point.pareto { '*' } else { ' ' },
        point.name(),
        point.cost_ns,
        point.error_rms,
        number(point.error_max),
        number(point.albedo_error),
        number(point.delta_e),
    )
}

/// The points as CSV.
///
/// # Errors
/// Where they cannot be written.
fn csv(report: &tradeoff::Report) -> Result<String> {
    let failed = |error: csv::Error| Error::parse("csv", error.to_string());
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(COLUMNS).map_err(failed)?;
    for row in rows(report) {
        writer.write_record(row).map_err(failed)?;
    }
    let bytes = writer.into_inner().unwrap_or_default();
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}
