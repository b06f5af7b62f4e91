//! `bench`: nanoseconds per evaluation of the models, on this machine.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use serde::Serialize;

use super::args::{self, Given, PrecisionName};
use super::{check, input, output};
use bxdf::Catalogue;
use bxdf::error::{self, Error, Result, shown};
use bxdf::{Material, Precision, Side, batch};
use bxdf_lab::control::Control;
use bxdf_lab::speed::{Mode, Operation, PAIRS, Pairs, Row, measure};
use bxdf_study::files;

#[derive(clap::Args)]
pub(super) struct Arguments {
    /// The materials: id, id:name=value,name=value, a material file or a file of data; every model if none is named
    #[arg(value_parser = args::material())]
    materials: Vec<Given>,
    /// A file of nine arrays of little-endian f32, one after the other: wo_x, wo_y, wo_z, wi_x, wi_y, wi_z, uc, u0, u1
    #[arg(long)]
    pairs: Option<PathBuf>,
    /// Threads of the parallel rows; all by default
    #[arg(long, value_parser = threads)]
    threads: Option<usize>,
    /// Measure only this precision, f32 or f64; both by default
    #[arg(long, value_parser = args::native_precision)]
    precision: Option<PrecisionName>,
    /// Measure only this way to run: plain, dispatched or parallel; all by default
    #[arg(long, value_parser = mode)]
    path: Option<Mode>,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

impl Arguments {
    /// The threads that are asked for.
    pub(super) fn threads(&self) -> Option<usize> {
        self.threads
    }
}

/// What is printed.
#[derive(Serialize)]
struct Report {
    machine: String,
    instruction_set: String,
    threads: usize,
    pairs: usize,
    /// The median of those of the rows, where all threads are measured.
    #[serde(skip_serializing_if = "Option::is_none")]
    control: Option<Control>,
    #[serde(skip)]
    modes: Vec<Mode>,
    rows: Vec<Row>,
}

/// Measures and prints.
///
/// # Errors
/// Where the file of pairs cannot be read or holds no nine arrays, and where standard output cannot be written.
pub(super) fn run(arguments: &Arguments) -> Result<()> {
    let file = arguments.pairs.as_deref().map(read).transpose()?;
    let materials: Vec<(&str, Material)> = if arguments.materials.is_empty() {
        let models = Catalogue::current().models().iter().copied();
        models
            .map(|model| (model.id, Material::of(model)))
            .collect()
    } else {
        let given = arguments.materials.iter();
        given
            .map(|given| (given.text(), given.checked().clone()))
            .collect()
    };
    let is_wanted = |precision| arguments.precision.is_none_or(|only| only == precision);
    let modes = arguments.path.map_or(Mode::ALL.to_vec(), |only| vec![only]);
    let mut rows = Vec::new();
    for (text, material) in materials {
        if is_wanted(PrecisionName::F32) {
            rows.extend(rows_of::<f32>(text, &material, &modes, file.as_deref()));
        }
        if is_wanted(PrecisionName::F64) {
            rows.extend(rows_of::<f64>(text, &material, &modes, file.as_deref()));
        }
    }
    let controls: Vec<Control> = rows.iter().filter_map(|row| row.control.clone()).collect();
    let report = Report {
        control: Control::median_of(&controls),
        machine: check::machine(),
        instruction_set: batch::instruction_set(),
        threads: rayon::current_num_threads(),
        pairs: file.map_or(PAIRS, |values| values.len() / ARRAYS),
        modes,
        rows,
    };
    if arguments.json {
        output::print_json(&report)
    } else {
        output::print(&report.table())
    }
}

fn rows_of<R: Precision>(
    text: &str,
    material: &Material,
    modes: &[Mode],
    file: Option<&[f64]>,
) -> Vec<Row> {
    let pairs: Pairs<R> = file.map_or_else(
        || Pairs::random(PAIRS, material.has_side(Side::Transmission)),
        Pairs::from_arrays,
    );
    let mut rows = Vec::new();
    for operation in Operation::ALL {
        let measured = measure(material, &pairs, operation, modes);
        rows.extend(measured.into_iter().map(|row| Row {
            material: text.to_owned(),
            ..row
        }));
    }
    rows
}

/// Reads a number of threads.
fn threads(text: &str) -> Result<usize> {
    let wanted = || format!("expected a whole number from 1 to {MAX_THREADS}");
    text.parse()
        .ok()
        .filter(|threads| (1..=MAX_THREADS).contains(threads))
        .ok_or_else(|| Error::parse(format!("--threads '{}'", shown(text)), wanted()))
}

/// Reads the name of a way to run.
fn mode(text: &str) -> Result<Mode> {
    args::choice("path", text, &Mode::ALL.map(|mode| (mode.name(), mode)))
}

/// The most threads that are started: what the largest machines run at once.
const MAX_THREADS: usize = 1024;

/// Arrays in a file of pairs.
const ARRAYS: usize = 9;

/// Those of them that are components of directions, and what they are called.
const DIRECTIONS: [(&str, [usize; 3]); 2] = [("wo", [0, 1, 2]), ("wi", [3, 4, 5])];

/// The others, which are numbers of a sampler, in [0, 1).
const NUMBERS: [(&str, usize); 3] = [("uc", 6), ("u0", 7), ("u1", 8)];

/// The most pairs that are read: four times as many as are measured by default, which no cache holds.
const MAX_PAIRS: u64 = 4 * PAIRS as u64;

/// The numbers of a file of pairs; directions that are not of unit length are normalised, and counted on standard error.
fn read(path: &Path) -> Result<Vec<f64>> {
    let failed = |error| Error::io(path, error);
    let file = std::fs::File::open(path).map_err(failed)?;
    let limit = MAX_PAIRS * (ARRAYS * size_of::<f32>()) as u64;
    let bytes = files::read_bytes(file, limit).map_err(failed)?;
    let (numbers, rest) = bytes.as_chunks::<4>();
    if numbers.is_empty() || numbers.len() % ARRAYS != 0 || !rest.is_empty() {
        let problem = format!(
            "{} bytes are not nine arrays of 32-bit numbers of one length",
            bytes.len()
        );
        return Err(Error::parse(path.display().to_string(), problem));
    }
    let number = |bytes: &[u8; 4]| f64::from(f32::from_le_bytes(*bytes));
    let mut numbers: Vec<f64> = numbers.iter().map(number).collect();
    let count = numbers.len() / ARRAYS;
    let mut normalised = 0_u64;
    for pair in 0..count {
        let was_normalised = make_valid(&mut numbers, count, pair)
            .map_err(|problem| Error::parse(format!("{}: pair {pair}", path.display()), problem))?;
        normalised += u64::from(was_normalised);
    }
    input::say_normalised(normalised, ["pair", "pairs"]);
    Ok(numbers)
}

/// Makes the directions of a pair unit vectors, among `count`, in the arrays `numbers`. Returns whether they were not.
///
/// # Errors
/// What is no direction, and no number of a sampler.
fn make_valid(numbers: &mut [f64], count: usize, pair: usize) -> std::result::Result<bool, String> {
    let mut was_normalised = false;
    for (name, arrays) in DIRECTIONS {
        let places = arrays.map(|array| array * count + pair);
        let found = places.map(|place| numbers.get(place).copied().unwrap_or(f64::NAN));
        if found.iter().any(|x| !x.is_finite()) {
            let [x, y, z] = found;
            return Err(format!("{name} = {x},{y},{z} is not finite"));
        }
        let (unit, was_unit) = input::unit(name, found.into())?;
        was_normalised |= !was_unit;
        for (place, x) in places.into_iter().zip(unit.to_array()) {
            if let Some(number) = numbers.get_mut(place) {
                *number = x;
            }
        }
    }
    for (name, array) in NUMBERS {
        let found = numbers.get(array * count + pair).copied();
        if let Some(u) = found.filter(|u| !(0.0..1.0).contains(u)) {
            return Err(format!("{name} = {u}: expected 0 or more, and less than 1"));
        }
    }
    Ok(was_normalised)
}

impl Report {
    fn table(&self) -> String {
        let mut text = format!(
            "{}, {}, {} pairs; nanoseconds per evaluation, median [quartiles]\n",
            self.machine, self.instruction_set, self.pairs
        );
        // Writing to a string cannot fail.
        if let Some(control) = &self.control {
            let _ = writeln!(
                text,
                "plain arithmetic, for comparison: {:.2} on one thread, {:.2} on {}",
                control.one_thread_ns, control.all_threads_ns, self.threads
            );
        }
        let _ = write!(text, "{:<40} {:<4} {:<8}", "material", "", "");
        for mode in &self.modes {
            let _ = write!(text, " {:>22}", mode.name());
        }
        text.push('\n');
        for modes in self.rows.chunks(self.modes.len()) {
            let Some(first) = modes.first() else { continue };
            let operation = format!("{:?}", first.operation).to_lowercase();
            let _ = write!(
                text,
                "{:<40} {:<4} {operation:<8}",
                error::line(&first.material),
                first.precision
            );
            for row in modes {
                let [low, high] = row.spread;
                let cell = format!("{:.2} [{low:.2} {high:.2}]", row.ns);
                let _ = write!(text, " {cell:>22}");
            }
            text.push('\n');
        }
        text
    }
}
