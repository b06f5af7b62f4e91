//! Whole batches of directions, as structures of arrays: one virtual call, then the model's own code in a plain loop,
//! compiled for the instruction sets a machine may have and chosen when it runs; or, where that brings nothing, a loop of
//! calls that all models share.
//!
//! Nothing here is written for vectors: the loops have a fixed length, no aliases and no calls, and the compiler does
//! the rest. What keeps a loop from it is a call that stays one, so everything in a model's `f`, `pdf` and `sample_f` is
//! `#[inline(always)]`, and takes `Option`s apart with `let else`: a combinator with a large closure stays a call.

use fearless_simd::Level;

use kernels::{
    BLOCK, Block, Densities, Kernel, LobeSamples, LobeValues, Samples, Values, ValuesAndDensities,
};

use super::Bxdf;
use super::math::Real;

mod columns;
mod kernels;

pub use columns::Columns;

/// Many directions: their components along s, t and n. The slices are of one length.
pub type Directions<'a, R> = [&'a [R]; 3];

/// Three slices to be written: the components of directions, or the channels of spectra.
pub type TripleMut<'a, R> = [&'a mut [R]; 3];

/// What to compute for each element of a batch.
///
/// ```
/// use bxdf::Material;
/// use bxdf::batch::{Columns, Job, Path};
///
/// # fn main() -> bxdf::Result<()> {
/// let gold = Material::open("gold")?.build::<f32>();
/// let wo = Columns::repeated([0.0, 0.0, 1.0], 1000);
/// let wi = Columns::from_rows((0..1000).map(|i| {
///     let (sin, cos) = (i as f32 * 1e-3).sin_cos();
///     [sin, 0.0, cos]
/// }));
/// let mut f = Columns::filled(0.0, 1000);
/// gold.batch(Path::Dispatched, Job::F { wo: wo.slices(), wi: wi.slices(), f: f.slices_mut() });
/// let [red, ..] = f.slices();
/// assert!(red[0] > red[999]);
/// # Ok(())
/// # }
/// ```
///
/// All slices of a job are of one length; the shortest decides.
#[derive(Debug)]
pub enum Job<'a, R> {
    /// The value f.
    F {
        /// The outgoing directions.
        wo: Directions<'a, R>,
        /// The incident directions.
        wi: Directions<'a, R>,
        /// In 1/sr.
        f: TripleMut<'a, R>,
    },
    /// The density.
    Pdf {
        /// The outgoing directions.
        wo: Directions<'a, R>,
        /// The incident directions.
        wi: Directions<'a, R>,
        /// In 1/sr.
        pdf: &'a mut [R],
    },
    /// Both.
    FPdf {
        /// The outgoing directions.
        wo: Directions<'a, R>,
        /// The incident directions.
        wi: Directions<'a, R>,
        /// In 1/sr.
        f: TripleMut<'a, R>,
        /// In 1/sr.
        pdf: &'a mut [R],
    },
    /// The value of one lobe alone: [`Bxdf::lobe_f`].
    LobeF {
        /// The lobe: an index of [`Bxdf::lobes`].
        index: usize,
        /// The outgoing directions.
        wo: Directions<'a, R>,
        /// The incident directions.
        wi: Directions<'a, R>,
        /// In 1/sr.
        f: TripleMut<'a, R>,
    },
    /// Samples, as [`Bxdf::sample_f`] draws them.
    Sample {
        /// The outgoing directions.
        wo: Directions<'a, R>,
        /// The numbers that choose among lobes, in [0, 1).
        uc: &'a [R],
        /// The numbers that choose a direction, in [0, 1).
        u: [&'a [R]; 2],
        /// The directions drawn; 0 where there is none.
        wi: TripleMut<'a, R>,
        /// In 1/sr; for a delta its weight over |cos(theta_i)|.
        f: TripleMut<'a, R>,
        /// In 1/sr, or the probability of a delta; 0 where there is no sample.
        pdf: &'a mut [R],
        /// 1 where the direction is that of a Dirac delta, else 0.
        delta: &'a mut [R],
    },
    /// Directions of one lobe alone, as [`Bxdf::sample_lobe`] draws them, and what an integral over the lobe sums there.
    Lobe {
        /// The lobe: an index of [`Bxdf::lobes`].
        index: usize,
        /// Whether the directions held are those of incidence; the lobe is drawn for them in the place of `wo`.
        is_incident: bool,
        /// The directions held.
        held: Directions<'a, R>,
        /// The numbers that choose a direction, in [0, 1).
        u: [&'a [R]; 2],
        /// The directions drawn; 0 where there is none.
        free: TripleMut<'a, R>,
        /// The lobe's f |cos(theta)| / pdf, theta being that of the direction drawn; 0 where there is none.
        weight: TripleMut<'a, R>,
    },
}

impl<R> Job<'_, R> {
    /// The number of elements: the length of the shortest slice.
    #[must_use]
    pub fn len(&self) -> usize {
        let shortest = |given: &[&[R]], out: &[&mut [R]]| {
            let given = given.iter().map(|slice| slice.len());
            let lengths = given.chain(out.iter().map(|slice| slice.len()));
            lengths.min().unwrap_or(0)
        };
        match self {
            Self::F { wo, wi, f } | Self::LobeF { wo, wi, f, .. } => shortest(&pairs(*wo, *wi), f),
            Self::Pdf { wo, wi, pdf } => shortest(&pairs(*wo, *wi), &[]).min(pdf.len()),
            Self::FPdf { wo, wi, f, pdf } => shortest(&pairs(*wo, *wi), f).min(pdf.len()),
            Self::Sample {
                wo: [x, y, z],
                uc,
                u: [u, v],
                wi,
                f,
                pdf,
                delta,
            } => {
                let written = shortest(&[], wi).min(shortest(&[], f));
                let numbers = shortest(&[x, y, z, uc, u, v], &[]);
                written.min(numbers).min(pdf.len()).min(delta.len())
            }
            Self::Lobe {
                held: [x, y, z],
                u: [u, v],
                free,
                weight,
                ..
            } => shortest(&[x, y, z, u, v], free).min(shortest(&[], weight)),
        }
    }

    /// Whether there is nothing to compute.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// For which instruction set a batch is compiled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Path {
    /// The one every machine of its kind has.
    Plain,
    /// The best this machine has.
    Dispatched,
}

/// The name of the instruction set that [`Path::Dispatched`] uses on this machine.
#[must_use]
pub fn instruction_set() -> String {
    let level = format!("{:?}", Level::new());
    let name = level.split('(').next().unwrap_or(&level);
    name.to_lowercase()
}

/// Computes `job` element by element, each by a call of its own: one loop for all models. For those whose own would not be
/// faster: rare choices, precisions without wide registers, and formulas with functions that stay calls.
pub(crate) fn one_by_one<R: Real>(bxdf: &dyn Bxdf<R>, job: Job<'_, R>) {
    plain(bxdf, job);
}

/// Computes `job` as every machine of its kind can.
pub(crate) fn plain<R: Real, B: Bxdf<R> + ?Sized>(bxdf: &B, job: Job<'_, R>) {
    if let Some(job) = work(bxdf, job) {
        work_on_lobe(bxdf, job);
    }
}

/// The method `batch` of a model: loops of its own for the widest registers where `$is_wide`, a constant, says so, and else
/// [`one_by_one`].
///
/// The loops stand in the module of the model, in which this is expanded: a change of one model compiles its own alone, and
/// the models' are compiled side by side. Of the instruction sets of a processor's kind only the widest two are worth loops
/// of their own.
macro_rules! loops {
    ($real:ident, if $is_wide:expr) => {
        fn batch(&self, path: $crate::batch::Path, job: $crate::batch::Job<'_, $real>) {
            use $crate::batch::{self, Job, Path};
            use $crate::math::Real;

            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            #[fearless_simd_macros::simd]
            fn wide<S: fearless_simd::Simd, R: Real, B: $crate::Bxdf<R>>(
                _: S,
                bxdf: &B,
                job: Job<'_, R>,
            ) {
                batch::own(bxdf, job);
            }

            #[inline(never)]
            fn plain<R: Real, B: $crate::Bxdf<R>>(bxdf: &B, job: Job<'_, R>) {
                batch::own(bxdf, job);
            }

            // Constants: of the two branches one alone is compiled.
            if $real::VECTORISES && $is_wide {
                #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
                if path == Path::Dispatched {
                    let level = fearless_simd::Level::new();
                    if let Some(avx512) = level.as_avx512() {
                        return wide(avx512, self, job);
                    }
                    if let Some(avx2) = level.as_avx2() {
                        return wide(avx2, self, job);
                    }
                }
                plain(self, job);
            } else {
                batch::one_by_one(self, job);
            }
        }
    };
}

pub(crate) use loops;

/// What the loops of a model do themselves.
#[inline(always)]
pub(crate) fn own<R: Real, B: Bxdf<R>>(bxdf: &B, job: Job<'_, R>) {
    if let Some(job) = work(bxdf, job) {
        if R::LOBES_VECTORISE {
            work_on_lobe(bxdf, job);
        } else {
            one_by_one(bxdf, job);
        }
    }
}

/// Does what is asked of the whole, and returns what is asked of one lobe.
#[inline(always)]
fn work<'a, R: Real, B: Bxdf<R> + ?Sized>(bxdf: &B, job: Job<'a, R>) -> Option<Job<'a, R>> {
    match job {
        Job::F { wo, wi, f } => in_blocks(&Values, bxdf, pairs(wo, wi), f),
        Job::Pdf { wo, wi, pdf } => in_blocks(&Densities, bxdf, pairs(wo, wi), [pdf]),
        Job::FPdf { wo, wi, f, pdf } => {
            let [r, g, b] = f;
            let kernel = ValuesAndDensities;
            in_blocks(&kernel, bxdf, pairs(wo, wi), [r, g, b, pdf]);
        }
        Job::Sample {
            wo,
            uc,
            u,
            wi,
            f,
            pdf,
            delta,
        } => {
            let ([x, y, z], [u, v]) = (wo, u);
            let ([ix, iy, iz], [r, g, b]) = (wi, f);
            let out = [ix, iy, iz, r, g, b, pdf, delta];
            in_blocks(&Samples, bxdf, [x, y, z, uc, u, v], out);
        }
        job @ (Job::LobeF { .. } | Job::Lobe { .. }) => return Some(job),
    }
    None
}

/// Does what is asked of one lobe.
#[inline(always)]
fn work_on_lobe<R: Real, B: Bxdf<R> + ?Sized>(bxdf: &B, job: Job<'_, R>) {
    match job {
        Job::LobeF { index, wo, wi, f } => in_blocks(&LobeValues(index), bxdf, pairs(wo, wi), f),
        Job::Lobe {
            index,
            is_incident,
            held,
            u,
            free,
            weight,
        } => {
            let ([x, y, z], [u, v]) = (held, u);
            let ([fx, fy, fz], [r, g, b]) = (free, weight);
            let kernel = LobeSamples { index, is_incident };
            in_blocks(&kernel, bxdf, [x, y, z, u, v], [fx, fy, fz, r, g, b]);
        }
        Job::F { .. } | Job::Pdf { .. } | Job::FPdf { .. } | Job::Sample { .. } => {}
    }
}

fn pairs<'a, R>([ox, oy, oz]: Directions<'a, R>, [ix, iy, iz]: Directions<'a, R>) -> [&'a [R]; 6] {
    [ox, oy, oz, ix, iy, iz]
}

/// Applies `kernel` for `bxdf` to `M` slices, block by block, and hands its results to the slices `out`.
#[inline(always)]
fn in_blocks<K, R, B, const M: usize, const N: usize>(
    kernel: &K,
    bxdf: &B,
    given: [&[R]; M],
    mut out: [&mut [R]; N],
) where
    K: Kernel<R, M, N>,
    R: Real,
    B: Bxdf<R> + ?Sized,
{
    let longest = given.iter().map(|slice| slice.len()).min().unwrap_or(0);
    let length = out
        .iter()
        .map(|slice| slice.len())
        .fold(longest, usize::min);
    let last = length - length % BLOCK;
    // What lies beyond the end of a slice: any direction and any numbers, whose results nobody reads.
    let filler = [R::of(0.5); BLOCK];
    let (mut tails, mut unread) = ([filler; M], [filler; N]);
    for (tail, slice) in tails.iter_mut().zip(given) {
        let rest = slice.get(last..length).unwrap_or_default();
        tail.iter_mut().zip(rest).for_each(|(to, from)| *to = *from);
    }
    let from = given.map(|slice| slice.get(..last).unwrap_or_default().as_chunks().0);
    let mut to = out
        .each_mut()
        .map(|slice| slice.get_mut(..last).unwrap_or_default().as_chunks_mut().0);
    for index in 0..length.div_ceil(BLOCK) {
        let mut blocks: [&Block<R>; M] = tails.each_ref();
        for (block, whole) in blocks.iter_mut().zip(from) {
            if let Some(whole) = whole.get(index) {
                *block = whole;
            }
        }
        let mut results: [&mut Block<R>; N] = unread.each_mut();
        for (block, whole) in results.iter_mut().zip(&mut to) {
            if let Some(whole) = whole.get_mut(index) {
                *block = whole;
            }
        }
        kernel.block(bxdf, blocks, results);
    }
    // The last block, where it is not whole, was written beside the slices.
    for (slice, block) in out.iter_mut().zip(&unread) {
        let rest = slice.get_mut(last..length).unwrap_or_default();
        rest.iter_mut()
            .zip(block)
            .for_each(|(to, from)| *to = *from);
    }
}
