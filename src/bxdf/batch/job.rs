//! What is asked of a batch.

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
    /// The value of one lobe alone: [`Lobes::lobe_f`](crate::Lobes::lobe_f).
    LobeF {
        /// The lobe: an index of [`Lobes::lobes`](crate::Lobes::lobes).
        index: usize,
        /// The outgoing directions.
        wo: Directions<'a, R>,
        /// The incident directions.
        wi: Directions<'a, R>,
        /// In 1/sr.
        f: TripleMut<'a, R>,
    },
    /// Samples, as [`Bxdf::sample_f`](crate::Bxdf::sample_f) draws them.
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
    /// Directions of one lobe alone, as [`Lobes::sample_lobe`](crate::Lobes::sample_lobe) draws them, and what an integral over the lobe sums there.
    Lobe {
        /// The lobe: an index of [`Lobes::lobes`](crate::Lobes::lobes).
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

/// The components of both directions of a pair.
pub(super) fn pairs<'a, R>(
    [ox, oy, oz]: Directions<'a, R>,
    [ix, iy, iz]: Directions<'a, R>,
) -> [&'a [R]; 6] {
    [ox, oy, oz, ix, iy, iz]
}
