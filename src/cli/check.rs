//! `check`: the laws of the contract, for a material or for every model.

use std::fmt::Write as _;

use serde::Serialize;

use super::args::{self, Given};
use super::output;
use crate::bxdf::models::MODELS;
use crate::error::Result;
use crate::lab::contract::{Effort, LawReport, check_all, check_material};

#[derive(clap::Args)]
pub(super) struct Arguments {
    /// The material: id of a model or named material, id:name=value,name=value, or a .toml file
    #[arg(value_parser = args::material, required_unless_present = "all", conflicts_with = "all")]
    material: Option<Given>,
    /// Check every model over a sweep of its parameters
    #[arg(long)]
    all: bool,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

/// What is printed, named as in the contract.
#[derive(Serialize)]
struct Report {
    machine: String,
    models: Vec<Model>,
    summary: Summary,
}

/// The laws of one model, or of one material under its text.
#[derive(Serialize)]
struct Model {
    id: String,
    laws: Vec<LawReport>,
}

/// How many laws came out how.
#[derive(Default, Serialize)]
struct Summary {
    ok: usize,
    declared: usize,
    violated: usize,
    misdeclared: usize,
}

/// Prints the reports. Returns whether every law holds or is rightly declared.
///
/// # Errors
/// Where standard output cannot be written.
pub(super) fn run(arguments: &Arguments) -> Result<bool> {
    let models = match &arguments.material {
        Some(given) => {
            let material = given.checked();
            vec![Model {
                id: material.to_string(),
                laws: check_material(material, Effort::Thorough),
            }]
        }
        None => MODELS
            .into_iter()
            .zip(check_all(&MODELS, Effort::Quick))
            .map(|(model, laws)| Model {
                id: model.id.to_owned(),
                laws,
            })
            .collect(),
    };
    let report = Report {
        machine: machine(),
        summary: Summary::of(&models),
        models,
    };
    if arguments.json {
        output::print_json(&report)?;
    } else {
        output::print(&report.table())?;
    }
    Ok(report.summary.violated + report.summary.misdeclared == 0)
}

/// The kind of machine the check ran on; the results do not depend on it, the time does.
pub(super) fn machine() -> String {
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    format!(
        "{} {}, {threads} threads",
        std::env::consts::OS,
        std::env::consts::ARCH
    )
}

impl Summary {
    fn of(models: &[Model]) -> Self {
        let mut summary = Self::default();
        for law in models.iter().flat_map(|model| &model.laws) {
            let count = match law.status.id() {
                "ok" => &mut summary.ok,
                "declared" => &mut summary.declared,
                "misdeclared" => &mut summary.misdeclared,
                _ => &mut summary.violated,
            };
            *count += 1;
        }
        summary
    }
}

impl Report {
    fn table(&self) -> String {
        let mut text = String::new();
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "{:<26} {:<14} {:<12} {:>10} {:>10} {:>9}",
            "model", "law", "status", "worst", "allowed", "n"
        );
        for model in &self.models {
            for law in &model.laws {
                let (id, status) = (law.law.id(), law.status.id());
                let _ = writeln!(
                    text,
                    "{:<26} {id:<14} {status:<12} {:>10.2e} {:>10.2e} {:>9}",
                    model.id, law.worst, law.error, law.n
                );
                if !law.status.is_pass() {
                    let _ = writeln!(text, "    {} at {}", law.law.measure(), law.witness);
                }
            }
        }
        let Summary {
            ok,
            declared,
            violated,
            misdeclared,
        } = self.summary;
        let _ = writeln!(
            text,
            "{ok} ok, {declared} declared, {violated} violated, {misdeclared} misdeclared"
        );
        text
    }
}
