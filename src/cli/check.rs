//! `check`: the laws of the contract, and the extremes, for a material or for every model.

use std::fmt::Write as _;

use serde::Serialize;

use super::args::{self, Given};
use super::output;
use bxdf::Catalogue;
use bxdf::error::{Result, shown};
use bxdf_lab::contract::{Effort, LawReport, check_all, check_material};
use bxdf_lab::stability::{Extent, Extreme, examine_all, examine_material, table};

#[derive(clap::Args)]
#[expect(clippy::struct_excessive_bools, reason = "flags of the command line")]
pub(super) struct Arguments {
    /// The material: id of a model or named material, id:name=value,name=value, a material file or a file of data
    #[arg(value_parser = args::material(), required_unless_present = "all", conflicts_with = "all")]
    material: Option<Given>,
    /// Check every model over a sweep of its parameters
    #[arg(long)]
    all: bool,
    /// Only go to the extremes: where floating point gives out
    #[arg(long)]
    extremes: bool,
    /// So many more random points of all models together, in f32 and in f64 alone
    #[arg(
        long,
        value_name = "N",
        value_parser = args::count,
        default_value_t = Extent::FULL.random_points,
        conflicts_with = "material"
    )]
    points: u64,
    /// Print the worst of each model as the table of the documentation
    #[arg(long, conflicts_with_all = ["material", "json"])]
    markdown: bool,
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
    extremes: Vec<Extreme>,
}

/// How many laws came out how.
#[derive(Default, Serialize)]
struct Summary {
    ok: usize,
    declared: usize,
    violated: usize,
    misdeclared: usize,
    /// Extremes where a result is not finite, negative or misplaced, or an error exceeds its bound.
    unstable: usize,
}

/// Prints the reports. Returns whether every law holds or is rightly declared.
///
/// # Errors
/// Where standard output cannot be written.
pub(super) fn run(arguments: &Arguments) -> Result<bool> {
    let laws_too = !arguments.extremes;
    let models = match &arguments.material {
        Some(given) => {
            let material = given.checked();
            let laws = laws_too.then(|| check_material(material, Effort::Thorough));
            vec![Model {
                id: material.to_string(),
                laws: laws.unwrap_or_default(),
                extremes: examine_material(material),
            }]
        }
        None => every_model(laws_too, arguments.points),
    };
    let report = Report {
        machine: machine(),
        summary: Summary::of(&models),
        models,
    };
    if arguments.markdown {
        output::print(&report.worst_of_models())?;
    } else if arguments.json {
        output::print_json(&report)?;
    } else {
        output::print(&report.table())?;
    }
    Ok(report.summary.is_pass())
}

fn every_model(laws_too: bool, points: u64) -> Vec<Model> {
    let extent = Extent {
        random_points: points,
        ..Extent::FULL
    };
    let models = Catalogue::current().models();
    let check = || check_all(models, Effort::Quick);
    // Together: where the laws of the last models leave processors idle, the extremes have them.
    let (laws, extremes) = rayon::join(|| laws_too.then(check), || examine_all(models, extent));
    let laws = laws.unwrap_or_else(|| vec![Vec::new(); models.len()]);
    let found = laws.into_iter().zip(extremes);
    let named = models.iter().copied().zip(found);
    named
        .map(|(model, (laws, extremes))| Model {
            id: model.id.to_owned(),
            laws,
            extremes,
        })
        .collect()
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
        let extremes = models.iter().flat_map(|model| &model.extremes);
        summary.unstable = extremes.filter(|extreme| !extreme.is_stable()).count();
        summary
    }

    fn is_pass(&self) -> bool {
        self.violated + self.misdeclared + self.unstable == 0
    }
}

impl Report {
    fn table(&self) -> String {
        // Writing to a string cannot fail.
        let mut text = String::new();
        if self.models.iter().any(|model| !model.laws.is_empty()) {
            self.write_laws(&mut text);
        }
        self.write_extremes(&mut text);
        let Summary {
            ok,
            declared,
            violated,
            misdeclared,
            unstable,
        } = self.summary;
        let _ = writeln!(
            text,
            "{ok} ok, {declared} declared, {violated} violated, {misdeclared} misdeclared; {unstable} extremes unstable"
        );
        text
    }

    /// The table of the documentation: every model is there.
    fn worst_of_models(&self) -> String {
        let found = self.models.iter().map(|model| &model.extremes[..]);
        let models = Catalogue::current().models().iter().copied();
        let models: Vec<_> = models.zip(found).collect();
        table::table(&models)
    }

    fn write_laws(&self, text: &mut String) {
        let _ = writeln!(
            text,
            "{:<26} {:<14} {:<12} {:>10} {:>10} {:>9}",
            "model", "law", "status", "worst", "allowed", "n"
        );
        for model in &self.models {
            for law in &model.laws {
                let id = law.law.id();
                // A law that has nothing to compare in a material says nothing of it.
                let status = if law.n == 0 { "-" } else { law.status.id() };
                let _ = writeln!(
                    text,
                    "{:<26} {id:<14} {status:<12} {:>10.2e} {:>10.2e} {:>9}",
                    shown(&model.id),
                    law.worst,
                    law.error,
                    law.n
                );
                if !law.status.is_pass() || !law.reason.is_empty() {
                    let _ = writeln!(text, "    {} at {}", law.law.measure(), law.witness);
                }
                if let Some(sentence) = law.sentence().filter(|_| !law.reason.is_empty()) {
                    let _ = writeln!(text, "    {sentence}");
                }
            }
        }
    }

    fn write_extremes(&self, text: &mut String) {
        let _ = writeln!(
            text,
            "{:<26} {:<15} {:<9} {:>9} {:>10} {:>9} {:>9}",
            "model", "extreme", "precision", "n", "error", "of bound", "faults"
        );
        for model in &self.models {
            for extreme in &model.extremes {
                let _ = writeln!(
                    text,
                    "{:<26} {:<15} {:<9} {:>9} {:>10.2e} {:>9.3} {:>9}",
                    shown(&model.id),
                    extreme.case.id(),
                    extreme.precision,
                    extreme.n,
                    extreme.max_rel_error,
                    extreme.max_bound_ratio,
                    extreme.faults()
                );
                if let Some(worst) = extreme.worst.as_ref().filter(|_| !extreme.is_stable()) {
                    let _ = writeln!(
                        text,
                        "    {} at {}: wo {:?} wi {:?}",
                        worst.what,
                        worst.params,
                        worst.wo.to_array(),
                        worst.wi.to_array()
                    );
                }
            }
        }
    }
}
