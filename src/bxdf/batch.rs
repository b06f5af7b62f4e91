//! Whole batches of directions, as structures of arrays: one virtual call, then the model's own code in a plain loop,
//! compiled for the instruction sets a machine may have and chosen when it runs.
//!
//! Nothing here is written for vectors: the loops have a fixed length, no aliases and no calls, and the compiler does
//! the rest. What keeps a loop from it is a call that stays one, so everything in a model's `f`, `pdf` and `sample_f` is
//! `#[inline(always)]`, and takes `Option`s apart with `let else`: a combinator with a large closure stays a call.

use fearless_simd::{Level, Simd};
use fearless_simd_macros::simd;

use super::math::{Real, Vec3};
use super::optics::Spectrum;
use super::{Bxdf, Sample};

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
pub(in crate::bxdf) fn run<R: Real, B: Bxdf<R> + ?Sized>(
    bxdf: &B,
    path: Path,
    job: Job<'_, R::Stored>,
) {
    let vectorises = match job {
        Job::Sample { .. } => R::FUNCTIONS_VECTORISE,
        _ => R::VECTORISES,
    };
    if vectorises && path == Path::Dispatched {
        dispatch(bxdf, job);
    } else {
        work(bxdf, job);
    }
}

/// Works for the best instruction set: of those of a processor's kind, only the widest two are worth loops of their own.
fn dispatch<R: Real, B: Bxdf<R> + ?Sized>(bxdf: &B, job: Job<'_, R::Stored>) {
    let level = Level::new();
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    {
        if let Some(avx512) = level.as_avx512() {
            return work_with(avx512, bxdf, job);
        }
        if let Some(avx2) = level.as_avx2() {
            return work_with(avx2, bxdf, job);
        }
    }
    let _ = level;
    work(bxdf, job);
}

/// The name of the instruction set that [`Path::Dispatched`] uses on this machine.
#[must_use]
pub fn instruction_set() -> String {
    let level = format!("{:?}", Level::new());
    let name = level.split('(').next().unwrap_or(&level);
    name.to_lowercase()
}

#[simd]
fn work_with<S: Simd, R: Real, B: Bxdf<R> + ?Sized>(_: S, bxdf: &B, job: Job<'_, R::Stored>) {
    work(bxdf, job);
}

/// Elements that are worked on at a time: the results stay in the fastest cache.
const BLOCK: usize = 64;

/// A block of one component.
type Block<R> = [R; BLOCK];

/// What a block's numbers are turned into. A type rather than a closure: the call of its function is always inlined.
trait Kernel<R: Real, const M: usize, const N: usize> {
    fn block<B: Bxdf<R> + ?Sized>(
        bxdf: &B,
        given: [&Block<R::Stored>; M],
        out: [&mut Block<R::Stored>; N],
    );
}

#[inline(always)]
fn work<R: Real, B: Bxdf<R> + ?Sized>(bxdf: &B, job: Job<'_, R::Stored>) {
    match job {
        Job::F { wo, wi, f } => in_blocks::<Values, R, _, 6, 3>(bxdf, pairs(wo, wi), f),
        Job::Pdf { wo, wi, pdf } => {
            in_blocks::<Densities, R, _, 6, 1>(bxdf, pairs(wo, wi), [pdf]);
        }
        // One after the other: each loop is short enough to vectorise.
        Job::FPdf { wo, wi, f, pdf } => {
            in_blocks::<Values, R, _, 6, 3>(bxdf, pairs(wo, wi), f);
            in_blocks::<Densities, R, _, 6, 1>(bxdf, pairs(wo, wi), [pdf]);
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
            in_blocks::<Samples, R, _, 6, 8>(bxdf, [x, y, z, uc, u, v], out);
        }
    }
}

fn pairs<'a, R>([ox, oy, oz]: Directions<'a, R>, [ix, iy, iz]: Directions<'a, R>) -> [&'a [R]; 6] {
    [ox, oy, oz, ix, iy, iz]
}

/// Applies the kernel `K` for `bxdf` to `M` slices, block by block, and hands its results to the slices `out`.
#[inline(always)]
fn in_blocks<K, R, B, const M: usize, const N: usize>(
    bxdf: &B,
    given: [&[R::Stored]; M],
    mut out: [&mut [R::Stored]; N],
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
    let filler = [R::of(0.5).store(); BLOCK];
    let (mut tails, mut unread) = ([filler; M], [filler; N]);
    let mut start = 0;
    while start < length {
        for (tail, slice) in tails.iter_mut().zip(given) {
            let rest = slice.get(start..).unwrap_or_default();
            if rest.len() < BLOCK {
                tail.iter_mut().zip(rest).for_each(|(to, from)| *to = *from);
            }
        }
        let mut blocks: [&Block<R::Stored>; M] = tails.each_ref();
        for (block, slice) in blocks.iter_mut().zip(given) {
            if let Some(whole) = slice.get(start..).and_then(|rest| rest.first_chunk()) {
                *block = whole;
            }
        }
        let mut results: [&mut Block<R::Stored>; N] = unread.each_mut();
        for (block, slice) in results.iter_mut().zip(&mut out) {
            let rest = slice.get_mut(start..length).unwrap_or_default();
            if let Some(whole) = rest.first_chunk_mut() {
                *block = whole;
            }
        }
        K::block(bxdf, blocks, results);
        start += BLOCK;
    }
    // The last block, where it is not whole, was written beside the slices.
    let last = length - length % BLOCK;
    for (slice, block) in out.iter_mut().zip(&unread) {
        let rest = slice.get_mut(last..length).unwrap_or_default();
        rest.iter_mut()
            .zip(block)
            .for_each(|(to, from)| *to = *from);
    }
}

/// The value of each pair.
struct Values;

impl<R: Real> Kernel<R, 6, 3> for Values {
    #[inline(always)]
    fn block<B: Bxdf<R> + ?Sized>(
        bxdf: &B,
        [ox, oy, oz, ix, iy, iz]: [&Block<R::Stored>; 6],
        [r, g, b]: [&mut Block<R::Stored>; 3],
    ) {
        values(bxdf, [ox, oy, oz], [ix, iy, iz], r, g, b);
    }
}

/// Each block that is written is an argument of its own: so the compiler knows that no two of them overlap.
#[inline(always)]
fn values<R: Real, B: Bxdf<R> + ?Sized>(
    bxdf: &B,
    wo: [&Block<R::Stored>; 3],
    wi: [&Block<R::Stored>; 3],
    r: &mut Block<R::Stored>,
    g: &mut Block<R::Stored>,
    b: &mut Block<R::Stored>,
) {
    let out = r.iter_mut().zip(g).zip(b);
    for ((wo, wi), ((r, g), b)) in directions(wo).zip(directions(wi)).zip(out) {
        let Spectrum(f) = bxdf.f(wo, wi);
        [*r, *g, *b] = f.map(R::store);
    }
}

/// The density of each pair.
struct Densities;

impl<R: Real> Kernel<R, 6, 1> for Densities {
    #[inline(always)]
    fn block<B: Bxdf<R> + ?Sized>(
        bxdf: &B,
        [ox, oy, oz, ix, iy, iz]: [&Block<R::Stored>; 6],
        [pdf]: [&mut Block<R::Stored>; 1],
    ) {
        let (wo, wi) = (directions([ox, oy, oz]), directions([ix, iy, iz]));
        for ((wo, wi), pdf) in wo.zip(wi).zip(pdf) {
            *pdf = bxdf.pdf(wo, wi).store();
        }
    }
}

/// A sample for each direction.
struct Samples;

impl<R: Real> Kernel<R, 6, 8> for Samples {
    #[inline(always)]
    fn block<B: Bxdf<R> + ?Sized>(
        bxdf: &B,
        [ox, oy, oz, uc, u, v]: [&Block<R::Stored>; 6],
        [x, y, z, r, g, b, pdf, delta]: [&mut Block<R::Stored>; 8],
    ) {
        samples(bxdf, [ox, oy, oz], [uc, u, v], x, y, z, r, g, b, pdf, delta);
    }
}

/// As for [`values`].
#[allow(clippy::too_many_arguments)]
#[inline(always)]
fn samples<R: Real, B: Bxdf<R> + ?Sized>(
    bxdf: &B,
    wo: [&Block<R::Stored>; 3],
    [uc, u, v]: [&Block<R::Stored>; 3],
    x: &mut Block<R::Stored>,
    y: &mut Block<R::Stored>,
    z: &mut Block<R::Stored>,
    r: &mut Block<R::Stored>,
    g: &mut Block<R::Stored>,
    b: &mut Block<R::Stored>,
    pdf: &mut Block<R::Stored>,
    delta: &mut Block<R::Stored>,
) {
    let numbers = uc.iter().zip(u).zip(v);
    let values = r.iter_mut().zip(g).zip(b);
    let out = x
        .iter_mut()
        .zip(y)
        .zip(z)
        .zip(values)
        .zip(pdf.iter_mut().zip(delta));
    for ((wo, ((uc, u), v)), out) in directions::<R>(wo).zip(numbers).zip(out) {
        let ((((x, y), z), ((r, g), b)), (pdf, delta)) = out;
        let zero = R::zero();
        // No sample is a sample of nothing: every element is written, whatever was drawn.
        let sample = match bxdf.sample_f(wo, R::load(*uc), [R::load(*u), R::load(*v)]) {
            Some(sample) => sample,
            None => Sample {
                wi: Vec3::new(zero, zero, zero),
                f: Spectrum::black(),
                pdf: zero,
                is_delta: false,
            },
        };
        (*x, *y, *z) = (
            sample.wi.x.store(),
            sample.wi.y.store(),
            sample.wi.z.store(),
        );
        [*r, *g, *b] = sample.f.0.map(R::store);
        *pdf = sample.pdf.store();
        *delta = if sample.is_delta { R::one() } else { zero }.store();
    }
}

/// The directions of a block.
#[inline(always)]
fn directions<R: Real>([x, y, z]: [&Block<R::Stored>; 3]) -> impl Iterator<Item = Vec3<R>> {
    x.iter()
        .zip(y)
        .zip(z)
        .map(|((x, y), z)| Vec3::new(R::load(*x), R::load(*y), R::load(*z)))
}
