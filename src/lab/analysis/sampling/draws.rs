//! The draws of a sampler: the one place where random numbers become samples, in any precision.

use crate::analysis::statistics::Random;
use bxdf::Scatterer;
use bxdf::batch::Columns;
use bxdf::math::{Real, Vec3};

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
    /// uc, u0, u1.
    numbers: Columns<R, 3>,
    /// The components of wi, the channels of f, pdf, and whether it is a delta.
    drawn: Columns<R, 8>,
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
    pub fn new(bxdf: &dyn Scatterer<R>, wo: Vec3<R>, seed: u64, first: u64, count: usize) -> Self {
        let mut random = Random::new(seed).after(NUMBERS * u128::from(first));
        let numbers = (0..count).map(|_| {
            let [u, v, uc] = [(); 3].map(|()| random.number::<R>());
            [uc, u, v]
        });
        let numbers = Columns::from_rows(numbers);
        let wo = Columns::repeated([wo.x, wo.y, wo.z], count);
        let drawn = bxdf.samples(&wo, &numbers);
        Self { numbers, drawn }
    }

    /// Them, one by one, lost ones included.
    pub fn iter(&self) -> impl Iterator<Item = Draw<R>> + '_ {
        self.numbers
            .rows()
            .zip(self.drawn.rows())
            .map(|(numbers, drawn)| {
                let [uc, u, v] = numbers;
                let [x, y, z, r, g, b, pdf, delta] = drawn;
                Draw {
                    u: [u, v],
                    uc,
                    wi: Vec3::new(x, y, z),
                    f: [r, g, b],
                    pdf,
                    is_delta: delta > R::zero(),
                }
            })
    }
}
