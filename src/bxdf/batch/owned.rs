//! Whole batches whose results are returned: what most ask of a surface, without arrays of their own.

use super::{Columns, Job, Path, Scatterer};
use crate::math::Real;

/// Each of these computes on the widest registers there are, and as many elements as the shorter of its arguments has.
impl<R: Real> dyn Scatterer<R> + '_ {
    /// f in 1/sr of each pair of directions.
    ///
    /// ```
    /// use bxdf::Material;
    /// use bxdf::batch::Columns;
    ///
    /// # fn main() -> bxdf::Result<()> {
    /// let gold = Material::open("gold")?.build::<f32>();
    /// let wo = Columns::repeated([0.0, 0.0, 1.0], 1000);
    /// let wi = Columns::from_rows((0..1000).map(|i| {
    ///     let (sin, cos) = (i as f32 * 1e-3).sin_cos();
    ///     [sin, 0.0, cos]
    /// }));
    /// let f = gold.values(&wo, &wi);
    /// let [red, ..] = f.slices();
    /// assert!(red[0] > red[999]);
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn values(&self, wo: &Columns<R, 3>, wi: &Columns<R, 3>) -> Columns<R, 3> {
        let mut values = Columns::filled(R::zero(), wo.len().min(wi.len()));
        let (wo, wi, f) = (wo.slices(), wi.slices(), values.slices_mut());
        self.batch(Path::Dispatched, Job::F { wo, wi, f });
        values
    }

    /// The density in 1/sr of each pair of directions.
    #[must_use]
    pub fn densities(&self, wo: &Columns<R, 3>, wi: &Columns<R, 3>) -> Vec<R> {
        let mut densities = vec![R::zero(); wo.len().min(wi.len())];
        let (wo, wi, pdf) = (wo.slices(), wi.slices(), &mut densities[..]);
        self.batch(Path::Dispatched, Job::Pdf { wo, wi, pdf });
        densities
    }

    /// f and the density in 1/sr of each pair of directions: R, G, B, pdf.
    #[must_use]
    pub fn values_and_densities(&self, wo: &Columns<R, 3>, wi: &Columns<R, 3>) -> Columns<R, 4> {
        let mut both = Columns::filled(R::zero(), wo.len().min(wi.len()));
        let (wo, wi) = (wo.slices(), wi.slices());
        let [r, g, b, pdf] = both.slices_mut();
        let f = [r, g, b];
        self.batch(Path::Dispatched, Job::FPdf { wo, wi, f, pdf });
        both
    }

    /// The sample of each direction `wo` with its `numbers` in [0, 1), of which the first chooses among lobes: the direction
    /// drawn, R, G, B of f, the density, and 1 for a Dirac delta; see [`Job::Sample`].
    #[must_use]
    pub fn samples(&self, wo: &Columns<R, 3>, numbers: &Columns<R, 3>) -> Columns<R, 8> {
        let mut drawn = Columns::filled(R::zero(), wo.len().min(numbers.len()));
        let [uc, u, v] = numbers.slices();
        let [x, y, z, r, g, b, pdf, delta] = drawn.slices_mut();
        let job = Job::Sample {
            wo: wo.slices(),
            uc,
            u: [u, v],
            wi: [x, y, z],
            f: [r, g, b],
            pdf,
            delta,
        };
        self.batch(Path::Dispatched, job);
        drawn
    }
}

#[cfg(test)]
mod tests {
    use crate::batch::Columns;
    use crate::{Material, Vec3};

    #[test]
    fn what_is_returned_is_what_single_calls_say() {
        let bxdf = "plastic".parse::<Material>().unwrap().build::<f64>();
        let held = Vec3::new(0.6, 0.0, 0.8);
        let wo = Columns::repeated([held.x, held.y, held.z], 9);
        let numbers = Columns::from_rows((0..7).map(|i| [0.13 * f64::from(i), 0.3, 0.7]));
        let drawn = bxdf.samples(&wo, &numbers);
        let wi = Columns::from_rows(drawn.rows().map(|[x, y, z, ..]| [x, y, z]));
        assert_eq!(drawn.len(), 7);
        let (values, densities) = (bxdf.values(&wo, &wi), bxdf.densities(&wo, &wi));
        let both = bxdf.values_and_densities(&wo, &wi);
        for (index, row) in drawn.rows().enumerate() {
            let [uc, u, v] = numbers.rows().nth(index).unwrap();
            let sample = bxdf.sample_f(held, uc, [u, v]).unwrap();
            let [r, g, b] = sample.f.0;
            let delta = f64::from(u8::from(sample.is_delta));
            let wi = sample.wi;
            assert_eq!(row, [wi.x, wi.y, wi.z, r, g, b, sample.pdf, delta]);
            let (f, pdf) = bxdf.f_pdf(held, wi);
            assert_eq!(values.rows().nth(index).unwrap(), f.0);
            assert_eq!(densities[index], pdf);
            let [r, g, b] = f.0;
            assert_eq!(both.rows().nth(index).unwrap(), [r, g, b, pdf]);
        }
    }
}
