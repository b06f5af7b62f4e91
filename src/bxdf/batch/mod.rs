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

use job::pairs;

use crate::lobes::Lobes;
use crate::math::Real;

mod columns;
mod job;
mod kernels;
mod owned;

pub use columns::Columns;
pub use job::{Directions, Job, Path, TripleMut};

/// A scattering model as views and instruments use it: with its lobes, and whole arrays of directions at once.
///
/// A model of one's own has a loop of calls, which is what the default is:
///
/// ```
/// # use bxdf::{Bxdf, Lobe, Lobes, Real, Sample, Scatterer, Spectrum, Vec3};
/// # struct Mine;
/// # impl<R: Real> Bxdf<R> for Mine {
/// #     fn f(&self, _: Vec3<R>, _: Vec3<R>) -> Spectrum<R> { Spectrum::black() }
/// #     fn pdf(&self, _: Vec3<R>, _: Vec3<R>) -> R { R::zero() }
/// #     fn sample_f(&self, _: Vec3<R>, _: R, _: [R; 2]) -> Option<Sample<R>> { None }
/// # }
/// # impl<R: Real> Lobes<R> for Mine {}
/// impl<R: Real> Scatterer<R> for Mine {}
/// # let _: Box<dyn Scatterer<f64>> = Box::new(Mine);
/// ```
pub trait Scatterer<R: Real>: Lobes<R> {
    /// Computes `job` for a whole batch: the same results, element by element, in one call.
    fn batch(&self, _path: Path, job: Job<'_, R>) {
        plain(self, job);
    }
}

/// The name of the instruction set that [`Path::Dispatched`] uses on this machine.
#[must_use]
pub fn instruction_set() -> String {
    let level = format!("{:?}", Level::new());
    let name = level.split('(').next().unwrap_or(&level);
    name.to_lowercase()
}

/// Computes `job` element by element, each by a call of its own: one loop for all models. For deltas, and for precisions that
/// only measure.
pub(crate) fn one_by_one<R: Real>(bxdf: &dyn Lobes<R>, job: Job<'_, R>) {
    plain(bxdf, job);
}

/// Computes `job` as every machine of its kind can.
pub(crate) fn plain<R: Real, B: Lobes<R> + ?Sized>(bxdf: &B, job: Job<'_, R>) {
    if let Some(job) = work(bxdf, job) {
        work_on_lobe(bxdf, job);
    }
}

/// The method `batch` of a model: loops of its own, for the widest registers too where `$is_wide`, a constant, says so. Rare
/// choices, and some formulas whose functions stay calls, gain nothing by these, but by a plain one: what a lobe's value
/// shares with its density is computed once (Cook-Torrance's reflectance takes 1.7 times as long by calls). A precision that
/// only measures has [`one_by_one`].
///
/// The loops stand in the module of the model, in which this is expanded: a change of one model compiles its own alone, and
/// the models' are compiled side by side. Of the instruction sets of a processor's kind only the widest two are worth loops
/// of their own.
macro_rules! loops {
    ($real:ident, if $is_wide:expr) => {
        fn batch(&self, path: $crate::batch::Path, job: $crate::batch::Job<'_, $real>) {
            use $crate::batch::{self, Job};
            use $crate::math::Real;

            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            #[fearless_simd_macros::simd]
            fn wide<S: fearless_simd::Simd, R: Real, B: $crate::Lobes<R>>(
                _: S,
                bxdf: &B,
                job: Job<'_, R>,
            ) {
                batch::own(bxdf, job);
            }

            #[inline(never)]
            fn plain<R: Real, B: $crate::Lobes<R>>(bxdf: &B, job: Job<'_, R>) {
                batch::own(bxdf, job);
            }

            // Constants: what they exclude is not compiled.
            if $real::VECTORISES {
                #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
                if $is_wide {
                    let level = fearless_simd::Level::new();
                    match (path, level.as_avx512(), level.as_avx2()) {
                        (batch::Path::Dispatched, Some(avx512), _) => {
                            return wide(avx512, self, job);
                        }
                        (batch::Path::Dispatched, None, Some(avx2)) => {
                            return wide(avx2, self, job);
                        }
                        _ => {}
                    }
                }
                let _ = path;
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
pub(crate) fn own<R: Real, B: Lobes<R>>(bxdf: &B, job: Job<'_, R>) {
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
fn work<'a, R: Real, B: Lobes<R> + ?Sized>(bxdf: &B, job: Job<'a, R>) -> Option<Job<'a, R>> {
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
fn work_on_lobe<R: Real, B: Lobes<R> + ?Sized>(bxdf: &B, job: Job<'_, R>) {
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
    B: Lobes<R> + ?Sized,
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
