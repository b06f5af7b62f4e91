//! Whole batches of directions, as structures of arrays: one virtual call, then the model's own code in a plain loop,
//! compiled for the instruction sets a machine may have and chosen when it runs.
//!
//! Nothing here is written for vectors: the loops have a fixed length, no aliases and no calls, and the compiler does
//! the rest. What keeps a loop from it is a call that stays one, so everything in a model's `f`, `pdf` and `sample_f` is
//! `#[inline(always)]`, and takes `Option`s apart with `let else`: a combinator with a large closure stays a call.

use fearless_simd::{Level, Simd};
use fearless_simd_macros::simd;

use super::Bxdf;
use super::math::{Real, Vec3};
use super::optics::Spectrum;

/// Many directions: their components along s, t and n. The slices are of one length.
pub type Directions<'a, R> = [&'a [R]; 3];

/// Three slices to be written: the components of directions, or the channels of spectra.
pub type TripleMut<'a, R> = [&'a mut [R]; 3];

/// What to compute for each element of a batch. All slices of a job are of one length; the shortest decides.
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
}

/// For which instruction set a batch is compiled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Path {
    /// The one every machine of its kind has.
    Plain,
    /// The best this machine has.
    Dispatched,
}

/// Runs `job` on `bxdf`.
pub(super) fn run<R: Real, B: Bxdf<R> + ?Sized>(bxdf: &B, path: Path, job: Job<'_, R>) {
    // A sample's loop does not vectorise (its sines are calls): wider instructions would only cost compile time.
    if R::VECTORISES && path == Path::Dispatched && !matches!(job, Job::Sample { .. }) {
        values_dispatched(bxdf, job);
    } else {
        work(bxdf, job);
    }
}

/// Values and densities for the best instruction set: of those of a processor's kind, only the widest two are worth a
/// loop of their own.
fn values_dispatched<R: Real, B: Bxdf<R> + ?Sized>(bxdf: &B, job: Job<'_, R>) {
    let level = Level::new();
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    {
        if let Some(avx512) = level.as_avx512() {
            return values_with(avx512, bxdf, job);
        }
        if let Some(avx2) = level.as_avx2() {
            return values_with(avx2, bxdf, job);
        }
    }
    let _ = level;
    values(bxdf, job);
}

/// The name of the instruction set that [`Path::Dispatched`] uses on this machine.
#[must_use]
pub fn instruction_set() -> String {
    let level = format!("{:?}", Level::new());
    let name = level.split('(').next().unwrap_or(&level);
    name.to_lowercase()
}

#[simd]
fn values_with<S: Simd, R: Real, B: Bxdf<R> + ?Sized>(_: S, bxdf: &B, job: Job<'_, R>) {
    values(bxdf, job);
}

/// Elements that are worked on at a time: the results stay in the fastest cache.
const BLOCK: usize = 64;

/// A block of one component.
type Block<R> = [R; BLOCK];

/// What a block's numbers are turned into. A type rather than a closure: the call of its function is always inlined.
trait Kernel<R, const M: usize, const N: usize> {
    fn block<B: Bxdf<R> + ?Sized>(bxdf: &B, given: [&Block<R>; M]) -> [Block<R>; N]
    where
        R: Real;
}

fn work<R: Real, B: Bxdf<R> + ?Sized>(bxdf: &B, job: Job<'_, R>) {
    match job {
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
            in_blocks::<Samples, _, _, 6, 8>(bxdf, [x, y, z, uc, u, v], out);
        }
        other => values(bxdf, other),
    }
}

#[inline(always)]
fn values<R: Real, B: Bxdf<R> + ?Sized>(bxdf: &B, job: Job<'_, R>) {
    match job {
        Job::F { wo, wi, f } => in_blocks::<Values, _, _, 6, 3>(bxdf, pairs(wo, wi), f),
        Job::Pdf { wo, wi, pdf } => {
            in_blocks::<Densities, _, _, 6, 1>(bxdf, pairs(wo, wi), [pdf]);
        }
        // One after the other: each loop is short enough to vectorise.
        Job::FPdf { wo, wi, f, pdf } => {
            in_blocks::<Values, _, _, 6, 3>(bxdf, pairs(wo, wi), f);
            in_blocks::<Densities, _, _, 6, 1>(bxdf, pairs(wo, wi), [pdf]);
        }
        Job::Sample { .. } => {}
    }
}

fn pairs<'a, R>([ox, oy, oz]: Directions<'a, R>, [ix, iy, iz]: Directions<'a, R>) -> [&'a [R]; 6] {
    [ox, oy, oz, ix, iy, iz]
}

/// Applies the kernel `K` for `bxdf` to `M` slices, block by block, and hands its results to the slices `out`.
#[inline(always)]
fn in_blocks<K, R, B, const M: usize, const N: usize>(
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
    // What lies beyond the end of a slice: any direction and any numbers, whose results nobody reads.
    let filler = [R::of(0.5); BLOCK];
    let mut tails = [filler; M];
    let mut start = 0;
    while start < length {
        for (tail, slice) in tails.iter_mut().zip(given) {
            let rest = slice.get(start..).unwrap_or_default();
            if rest.len() < BLOCK {
                tail.iter_mut().zip(rest).for_each(|(to, from)| *to = *from);
            }
        }
        let mut blocks: [&Block<R>; M] = tails.each_ref();
        for (block, slice) in blocks.iter_mut().zip(given) {
            if let Some(whole) = slice.get(start..).and_then(|rest| rest.first_chunk()) {
                *block = whole;
            }
        }
        let results = K::block(bxdf, blocks);
        for (out, result) in out.iter_mut().zip(&results) {
            let rest = out.get_mut(start..length).unwrap_or_default();
            match rest.first_chunk_mut() {
                Some(whole) => *whole = *result,
                None => rest
                    .iter_mut()
                    .zip(result)
                    .for_each(|(to, from)| *to = *from),
            }
        }
        start += BLOCK;
    }
}

/// The value of each pair.
struct Values;

impl<R: Real> Kernel<R, 6, 3> for Values {
    #[inline(always)]
    fn block<B: Bxdf<R> + ?Sized>(
        bxdf: &B,
        [ox, oy, oz, ix, iy, iz]: [&Block<R>; 6],
    ) -> [Block<R>; 3] {
        let [mut r, mut g, mut b] = [[R::zero(); BLOCK]; 3];
        let wo = ox.iter().zip(oy).zip(oz);
        let wi = ix.iter().zip(iy).zip(iz);
        let out = r.iter_mut().zip(&mut g).zip(&mut b);
        for ((((ox, oy), oz), ((ix, iy), iz)), ((r, g), b)) in wo.zip(wi).zip(out) {
            let (wo, wi) = (Vec3::new(*ox, *oy, *oz), Vec3::new(*ix, *iy, *iz));
            Spectrum([*r, *g, *b]) = bxdf.f(wo, wi);
        }
        [r, g, b]
    }
}

/// The density of each pair.
struct Densities;

impl<R: Real> Kernel<R, 6, 1> for Densities {
    #[inline(always)]
    fn block<B: Bxdf<R> + ?Sized>(
        bxdf: &B,
        [ox, oy, oz, ix, iy, iz]: [&Block<R>; 6],
    ) -> [Block<R>; 1] {
        let mut pdf = [R::zero(); BLOCK];
        let wo = ox.iter().zip(oy).zip(oz);
        let wi = ix.iter().zip(iy).zip(iz);
        for ((((ox, oy), oz), ((ix, iy), iz)), pdf) in wo.zip(wi).zip(&mut pdf) {
            let (wo, wi) = (Vec3::new(*ox, *oy, *oz), Vec3::new(*ix, *iy, *iz));
            *pdf = bxdf.pdf(wo, wi);
        }
        [pdf]
    }
}

/// A sample for each direction.
struct Samples;

impl<R: Real> Kernel<R, 6, 8> for Samples {
    #[inline(always)]
    fn block<B: Bxdf<R> + ?Sized>(
        bxdf: &B,
        [ox, oy, oz, uc, u, v]: [&Block<R>; 6],
    ) -> [Block<R>; 8] {
        let [mut x, mut y, mut z] = [[R::zero(); BLOCK]; 3];
        let [mut r, mut g, mut b] = [[R::zero(); BLOCK]; 3];
        let [mut pdf, mut delta] = [[R::zero(); BLOCK]; 2];
        let wo = ox.iter().zip(oy).zip(oz);
        let numbers = uc.iter().zip(u).zip(v);
        let directions = x.iter_mut().zip(&mut y).zip(&mut z);
        let values = r.iter_mut().zip(&mut g).zip(&mut b);
        let out = directions.zip(values).zip(pdf.iter_mut().zip(&mut delta));
        for ((((ox, oy), oz), ((uc, u), v)), out) in wo.zip(numbers).zip(out) {
            let ((((x, y), z), ((r, g), b)), (pdf, delta)) = out;
            if let Some(sample) = bxdf.sample_f(Vec3::new(*ox, *oy, *oz), *uc, [*u, *v]) {
                (*x, *y, *z) = (sample.wi.x, sample.wi.y, sample.wi.z);
                Spectrum([*r, *g, *b]) = sample.f;
                *pdf = sample.pdf;
                *delta = if sample.is_delta { R::one() } else { R::zero() };
            }
        }
        [x, y, z, r, g, b, pdf, delta]
    }
}
