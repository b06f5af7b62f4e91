//! How fast the models are: nanoseconds per evaluation of whole batches, measured on this machine.

use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::{Rng as _, SeedableRng as _};
use rayon::prelude::*;
use serde::Serialize;

use super::control::{Control, Controls, time};
use super::timing::Timing;
use bxdf::batch::{Columns, Job, Path};
use bxdf::math::Real;
use bxdf::{Material, Precision, Scatterer};

/// Pairs of directions of a batch: their arrays are beyond every cache, as a renderer's are.
pub const PAIRS: usize = 1 << 20;

/// Pairs that one task of a parallel run takes.
const CHUNK: usize = 1 << 14;

/// Timed repetitions of each measurement.
const REPETITIONS: usize = 11;

/// Seed of the directions.
const SEED: u64 = 0x5eed;

/// The directions and random numbers of a benchmark, component by component.
#[derive(Clone, Debug)]
pub struct Pairs<R> {
    wo: Columns<R, 3>,
    wi: Columns<R, 3>,
    /// uc, then the two of u.
    numbers: Columns<R, 3>,
}

impl<R: Real> Pairs<R> {
    /// `n` pairs: wo uniform over the upper hemisphere, wi over the upper one, or over the sphere where `is_crossing`.
    #[must_use]
    pub fn random(n: usize, is_crossing: bool) -> Self {
        let mut generator = Pcg64Mcg::seed_from_u64(SEED);
        let mut unit = || (generator.next_u64() >> 11) as f64 * (0.5 * f64::EPSILON);
        let mut directions = |lowest: f64| {
            Columns::from_rows((0..n).map(|_| {
                let z = lowest + (1.0 - lowest) * unit();
                let (sin, cos) = (std::f64::consts::TAU * unit()).sin_cos();
                let radius = ((1.0 - z) * (1.0 + z)).sqrt();
                [radius * cos, radius * sin, z].map(R::of)
            }))
        };
        let wo = directions(0.0);
        let wi = directions(if is_crossing { -1.0 } else { 0.0 });
        let numbers = (0..n).map(|_| [(); 3].map(|()| R::of(unit()).min(below_one())));
        Self {
            wo,
            wi,
            numbers: Columns::from_rows(numbers),
        }
    }

    /// Pairs from the nine arrays wo, wi, uc, u, each of `values.len() / 9` numbers, one after the other.
    #[must_use]
    pub fn from_arrays(values: &[f64]) -> Self {
        let n = values.len() / 9;
        let number = |index: usize| R::of(values.get(index).copied().unwrap_or_default());
        let columns = |first: usize| {
            let row = |index: usize| [0, 1, 2].map(|axis| number((first + axis) * n + index));
            Columns::from_rows((0..n).map(row))
        };
        Self {
            wo: columns(0),
            wi: columns(3),
            numbers: columns(6),
        }
    }

    /// How many they are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.wo.len()
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

fn below_one<R: Real>() -> R {
    R::one() - R::of(R::UNIT_ROUNDOFF)
}

/// What is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Operation {
    /// The value.
    F,
    /// The density.
    Pdf,
    /// Both.
    FPdf,
    /// A sample with its value and density.
    SampleF,
}

impl Operation {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::F, Self::Pdf, Self::FPdf, Self::SampleF];

    /// How many numbers an evaluation reads and writes.
    const fn numbers(self) -> usize {
        let (wo, wi, channels) = (3, 3, 3);
        match self {
            Self::F => wo + wi + channels,
            Self::Pdf => wo + wi + 1,
            Self::FPdf => wo + wi + channels + 1,
            // The three numbers it is drawn by; density and delta.
            Self::SampleF => wo + 3 + wi + channels + 2,
        }
    }
}

/// How the batch is run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Mode {
    /// One thread, for the instruction set every machine of its kind has.
    Plain,
    /// One thread, for the best this machine has.
    Dispatched,
    /// The same on all threads of the pool.
    Parallel,
}

impl Mode {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Plain, Self::Dispatched, Self::Parallel];

    /// Its name, as in [`Row`]'s JSON.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Plain => "plain",
            Self::Dispatched => "dispatched",
            Self::Parallel => "parallel",
        }
    }
}

/// One measurement.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Row {
    /// The material, as text.
    pub material: String,
    /// The name of the precision.
    pub precision: &'static str,
    /// How it was run.
    pub path: Mode,
    /// What was run.
    pub operation: Operation,
    /// Bytes that an evaluation reads and writes: what the memory has to bring and take.
    pub bytes: usize,
    /// Nanoseconds per evaluation, the median of the repetitions.
    pub ns: f64,
    /// The first and the third quartile.
    pub spread: [f64; 2],
    /// What threads brought plain arithmetic meanwhile, where this ran on all of them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub control: Option<Control>,
}

/// Measures `operation` of `material` on `pairs`, run in each of `modes`.
///
/// The modes take turns, so that what the machine does besides slows all of them alike: their ratios hold where their
/// times do not. Plain arithmetic on one thread and on all takes its turns with them, for comparison.
#[must_use]
pub fn measure<R: Precision>(
    material: &Material,
    pairs: &Pairs<R>,
    operation: Operation,
    modes: &[Mode],
) -> Vec<Row> {
    let bxdf = material.build::<R>();
    let mut out = Columns::filled(R::zero(), pairs.len());
    let mut times = vec![Vec::with_capacity(REPETITIONS); modes.len()];
    let mut controls = Controls::default();
    for round in 0..=REPETITIONS {
        for (mode, times) in modes.iter().zip(&mut times) {
            let work = || run(&*bxdf, pairs, operation, *mode, &mut out);
            time(round, pairs.len(), times, work);
        }
        if modes.len() > 1 {
            controls.time(round);
        }
    }
    // Of a single mode the rounds follow one another, so that they find the caches as they left them.
    if modes.len() == 1 {
        (0..=REPETITIONS).for_each(|round| controls.time(round));
    }
    let control = controls.medians();
    let row = |(mode, times): (&Mode, Vec<f64>)| {
        let Timing { ns, spread } = Timing::of(times);
        Row {
            material: material.to_string(),
            precision: R::NAME,
            path: *mode,
            operation,
            bytes: operation.numbers() * size_of::<R>(),
            ns,
            spread,
            control: (*mode == Mode::Parallel).then(|| control.clone()),
        }
    };
    modes.iter().zip(times).map(row).collect()
}

/// Arrays that a job writes at most.
const OUTPUTS: usize = 8;

fn run<R: Precision>(
    bxdf: &dyn Scatterer<R>,
    pairs: &Pairs<R>,
    operation: Operation,
    mode: Mode,
    out: &mut Columns<R, OUTPUTS>,
) {
    let whole = Part::of(pairs, out);
    match mode {
        Mode::Plain => whole.run(bxdf, operation, Path::Plain),
        Mode::Dispatched => whole.run(bxdf, operation, Path::Dispatched),
        Mode::Parallel => whole
            .split(CHUNK)
            .into_par_iter()
            .for_each(|part| part.run(bxdf, operation, Path::Dispatched)),
    }
}

/// A stretch of the pairs and of the outputs.
struct Part<'a, R> {
    given: [&'a [R]; 9],
    out: [&'a mut [R]; OUTPUTS],
}

impl<'a, R: Precision> Part<'a, R> {
    fn of(pairs: &'a Pairs<R>, out: &'a mut Columns<R, OUTPUTS>) -> Self {
        let [wo, wi, numbers] = [&pairs.wo, &pairs.wi, &pairs.numbers].map(Columns::slices);
        let ([ox, oy, oz], [ix, iy, iz], [uc, u, v]) = (wo, wi, numbers);
        Self {
            given: [ox, oy, oz, ix, iy, iz, uc, u, v],
            out: out.slices_mut(),
        }
    }

    /// Parts of `length` pairs each, the last shorter.
    fn split(self, length: usize) -> Vec<Self> {
        let n = self.given.iter().map(|axis| axis.len()).min().unwrap_or(0);
        let mut rest = self.out;
        (0..n)
            .step_by(length)
            .map(|start| {
                let end = (start + length).min(n);
                let given = self
                    .given
                    .map(|axis| axis.get(start..end).unwrap_or_default());
                let (first, others) = split_all(std::mem::take(&mut rest), end - start);
                rest = others;
                Self { given, out: first }
            })
            .collect()
    }

    fn run(self, bxdf: &dyn Scatterer<R>, operation: Operation, path: Path) {
        let [ox, oy, oz, ix, iy, iz, uc, u, v] = self.given;
        let (wo, wi) = ([ox, oy, oz], [ix, iy, iz]);
        let [r, g, b, pdf, x, y, z, delta] = self.out;
        let f = [r, g, b];
        let job = match operation {
            Operation::F => Job::F { wo, wi, f },
            Operation::Pdf => Job::Pdf { wo, wi, pdf },
            Operation::FPdf => Job::FPdf { wo, wi, f, pdf },
            Operation::SampleF => Job::Sample {
                wo,
                uc,
                u: [u, v],
                wi: [x, y, z],
                f,
                pdf,
                delta,
            },
        };
        bxdf.batch(path, job);
    }
}

type Slices<'a, R> = [&'a mut [R]; OUTPUTS];

fn split_all<R>(slices: Slices<'_, R>, at: usize) -> (Slices<'_, R>, Slices<'_, R>) {
    let mut rest: Slices<'_, R> = Default::default();
    let mut index = 0;
    let first = slices.map(|slice| {
        let (head, tail) = slice.split_at_mut_checked(at).unwrap_or_default();
        if let Some(slot) = rest.get_mut(index) {
            *slot = tail;
        }
        index += 1;
        head
    });
    (first, rest)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_mode_fills_the_same_outputs() {
        let material: Material = "rough_dielectric".parse().unwrap();
        let bxdf = material.build::<f32>();
        let pairs = Pairs::<f32>::random(CHUNK + 777, true);
        for operation in Operation::ALL {
            let results = Mode::ALL.map(|mode| {
                let mut out = Columns::filled(0.0_f32, pairs.len());
                run(&*bxdf, &pairs, operation, mode, &mut out);
                out.rows().collect::<Vec<_>>()
            });
            assert!(results[0] == results[1] && results[1] == results[2]);
            let last_pdf = results[0].last().map_or(0.0, |row| row[3]);
            assert!(operation == Operation::F || last_pdf.is_finite());
        }
    }

    #[test]
    fn a_measurement_names_what_was_measured() {
        let material: Material = "lambertian_reflection".parse().unwrap();
        let pairs = Pairs::<f64>::from_arrays(&vec![0.5; 9 * 640]);
        assert!(pairs.len() == 640 && !pairs.is_empty());
        let rows = measure(&material, &pairs, Operation::Pdf, &Mode::ALL);
        assert!(rows.iter().map(|row| row.path).eq(Mode::ALL));
        for row in rows {
            assert_eq!(row.control.is_some(), row.path == Mode::Parallel);
            assert!(row.ns > 0.0 && row.spread[0] <= row.ns && row.ns <= row.spread[1]);
            assert_eq!(
                (row.precision, row.material.as_str()),
                ("f64", "lambertian_reflection")
            );
        }
    }
}
