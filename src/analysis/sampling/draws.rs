//! The draws of a sampler: the one place where random numbers become samples, in any precision.

use crate::analysis::statistics::Random;
use crate::bxdf::Bxdf;
use crate::bxdf::batch::{Job, Path};
use crate::bxdf::math::{Real, Vec3};

/// Draws that are made together: enough for a batch, few enough to be given up in time.
pub const CHUNK: usize = 2048;

/// The seed where none is chosen.
pub const FIRST_SEED: u32 = 0;

/// Random numbers that a draw takes.
const NUMBERS: u128 = 3;

/// Some draws of a seed, as structures of arrays.
///
/// A seed has one stream of numbers, of which each draw takes three: u0, u1, uc. So the first draws are the same however many
/// there are, and in whatever parts they are made.
#[derive(Clone, Debug)]
pub struct Draws<R: Real> {
    u: [Vec<R::Stored>; 2],
    uc: Vec<R::Stored>,
    wi: [Vec<R::Stored>; 3],
    f: [Vec<R::Stored>; 3],
    pdf: Vec<R::Stored>,
    delta: Vec<R::Stored>,
}

/// A draw.
#[derive(Clone, Copy, Debug)]
pub struct Draw<R> {
    /// The numbers that chose the direction, in [0, 1).
    pub u: [R; 2],
    /// The number that chose the lobe, in [0, 1).
    pub uc: R,
    /// The direction drawn, a unit vector; 0 where there is none.
    pub wi: Vec3<R>,
    /// In 1/sr; for a delta its weight over |cos(theta_i)|.
    pub f: [R; 3],
    /// In 1/sr, or the probability of a delta; 0 where there is no sample.
    pub pdf: R,
    /// Whether it comes from a Dirac delta.
    pub is_delta: bool,
}

impl<R: Real> Draw<R> {
    /// Whether the draw gave no sample.
    #[must_use]
    pub fn is_lost(&self) -> bool {
        self.pdf <= R::zero()
    }
}

impl<R: Real> Draws<R> {
    /// The draws number `first` and following, `count` of them, of the generator `seed` for the direction `wo`.
    #[must_use]
    pub fn new(bxdf: &dyn Bxdf<R>, wo: Vec3<R>, seed: u64, first: u64, count: usize) -> Self {
        let mut random = Random::new(seed).after(NUMBERS * u128::from(first));
        let zeros = vec![R::zero().store(); count];
        let mut draws = Self {
            u: [(); 2].map(|()| Vec::with_capacity(count)),
            uc: Vec::with_capacity(count),
            wi: [(); 3].map(|()| zeros.clone()),
            f: [(); 3].map(|()| zeros.clone()),
            pdf: zeros.clone(),
            delta: zeros,
        };
        for _ in 0..count {
            for axis in &mut draws.u {
                axis.push(random.number::<R>().store());
            }
            draws.uc.push(random.number::<R>().store());
        }
        let wo = [wo.x, wo.y, wo.z].map(|x| vec![x.store(); count]);
        let job = Job::Sample {
            wo: wo.each_ref().map(Vec::as_slice),
            uc: &draws.uc,
            u: draws.u.each_ref().map(Vec::as_slice),
            wi: draws.wi.each_mut().map(Vec::as_mut_slice),
            f: draws.f.each_mut().map(Vec::as_mut_slice),
            pdf: &mut draws.pdf,
            delta: &mut draws.delta,
        };
        bxdf.batch(Path::Dispatched, job);
        draws
    }

    /// Them, one by one, lost ones included.
    pub fn iter(&self) -> impl Iterator<Item = Draw<R>> + '_ {
        let at = |values: &Vec<R::Stored>, index: usize| {
            values.get(index).map_or(R::zero(), |x| R::load(*x))
        };
        (0..self.uc.len()).map(move |index| {
            let [x, y, z] = self.wi.each_ref().map(|axis| at(axis, index));
            Draw {
                u: self.u.each_ref().map(|axis| at(axis, index)),
                uc: at(&self.uc, index),
                wi: Vec3::new(x, y, z),
                f: self.f.each_ref().map(|channel| at(channel, index)),
                pdf: at(&self.pdf, index),
                is_delta: at(&self.delta, index) > R::zero(),
            }
        })
    }
}
