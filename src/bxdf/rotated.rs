//! A surface turned about its normal.

use super::batch::{Columns, Directions, Job, Path, Scatterer};
use super::lobe::Lobe;
use super::lobes::{Lobes, Microfacet};
use super::math::{Real, Vec3};
use super::optics::Spectrum;
use super::sample::{Delta, Deltas, Sample};
use super::scattering::Bxdf;

/// `inner` on a surface whose s axis points to azimuth `angle`: the same model with all directions turned.
pub struct Rotated<R: Real> {
    inner: Box<dyn Scatterer<R>>,
    cos: R,
    sin: R,
}

impl<R: Real> Rotated<R> {
    /// `inner` turned by `cos_sin`, the cosine and sine of the angle from the fixed s axis to the surface's own.
    #[must_use]
    pub fn new(inner: Box<dyn Scatterer<R>>, cos_sin: (R, R)) -> Self {
        Self {
            inner,
            cos: cos_sin.0,
            sin: cos_sin.1,
        }
    }

    #[inline]
    fn local_from_fixed(&self, w: Vec3<R>) -> Vec3<R> {
        Vec3::new(
            self.cos * w.x + self.sin * w.y,
            self.cos * w.y - self.sin * w.x,
            w.z,
        )
    }

    /// [`Self::local_from_fixed`] of many: their components along s and t, that along n staying as it is.
    fn all_local<'a>(&self, [x, y, z]: Directions<'a, R>) -> Local<'a, R> {
        let given = x.iter().zip(y);
        let turned = given.map(|(x, y)| {
            let w = self.local_from_fixed(Vec3::new(*x, *y, R::zero()));
            [w.x, w.y]
        });
        Local {
            turned: Columns::from_rows(turned),
            z,
        }
    }

    /// [`Self::fixed_from_local`] of the first `n`, in their place.
    fn turn_back(&self, n: usize, x: &mut [R], y: &mut [R]) {
        for (x, y) in x.iter_mut().zip(y).take(n) {
            let w = self.fixed_from_local(Vec3::new(*x, *y, R::zero()));
            (*x, *y) = (w.x, w.y);
        }
    }

    #[inline]
    fn fixed_from_local(&self, w: Vec3<R>) -> Vec3<R> {
        Vec3::new(
            self.cos * w.x - self.sin * w.y,
            self.cos * w.y + self.sin * w.x,
            w.z,
        )
    }
}

/// Directions in the surface's own frame.
struct Local<'a, R: Real> {
    /// Their components along s and t.
    turned: Columns<R, 2>,
    z: &'a [R],
}

impl<R: Real> Local<'_, R> {
    fn directions(&self) -> Directions<'_, R> {
        let [x, y] = self.turned.slices();
        [x, y, self.z]
    }
}

impl<R: Real> Bxdf<R> for Rotated<R> {
    fn f(&self, wo: Vec3<R>, wi: Vec3<R>) -> Spectrum<R> {
        self.inner
            .f(self.local_from_fixed(wo), self.local_from_fixed(wi))
    }

    fn pdf(&self, wo: Vec3<R>, wi: Vec3<R>) -> R {
        self.inner
            .pdf(self.local_from_fixed(wo), self.local_from_fixed(wi))
    }

    fn sample_f(&self, wo: Vec3<R>, uc: R, u: [R; 2]) -> Option<Sample<R>> {
        let sample = self.inner.sample_f(self.local_from_fixed(wo), uc, u)?;
        Some(Sample {
            wi: self.fixed_from_local(sample.wi),
            ..sample
        })
    }

    fn deltas(&self, w: Vec3<R>) -> Deltas<R> {
        let turned = |delta: Delta<R>| Delta {
            direction: self.fixed_from_local(delta.direction),
            ..delta
        };
        self.inner
            .deltas(self.local_from_fixed(w))
            .map(|delta| delta.map(turned))
    }
}

impl<R: Real> Lobes<R> for Rotated<R> {
    fn lobes(&self) -> &[Lobe] {
        self.inner.lobes()
    }

    fn lobe_pdf(&self, index: usize, wo: Vec3<R>, wi: Vec3<R>) -> R {
        self.inner
            .lobe_pdf(index, self.local_from_fixed(wo), self.local_from_fixed(wi))
    }

    fn sample_lobe(&self, index: usize, wo: Vec3<R>, u: [R; 2]) -> Option<Vec3<R>> {
        let wi = self
            .inner
            .sample_lobe(index, self.local_from_fixed(wo), u)?;
        Some(self.fixed_from_local(wi))
    }

    fn lobe_f(&self, index: usize, wo: Vec3<R>, wi: Vec3<R>) -> Spectrum<R> {
        self.inner
            .lobe_f(index, self.local_from_fixed(wo), self.local_from_fixed(wi))
    }

    fn microfacet(&self, wo: Vec3<R>, wi: Vec3<R>) -> Option<Microfacet<R>> {
        self.inner
            .microfacet(self.local_from_fixed(wo), self.local_from_fixed(wi))
    }
}

impl<R: Real> Scatterer<R> for Rotated<R> {
    fn batch(&self, path: Path, job: Job<'_, R>) {
        let n = job.len();
        match job {
            Job::F { wo, wi, f } => {
                let (wo, wi) = (self.all_local(wo), self.all_local(wi));
                let (wo, wi) = (wo.directions(), wi.directions());
                self.inner.batch(path, Job::F { wo, wi, f });
            }
            Job::Pdf { wo, wi, pdf } => {
                let (wo, wi) = (self.all_local(wo), self.all_local(wi));
                let (wo, wi) = (wo.directions(), wi.directions());
                self.inner.batch(path, Job::Pdf { wo, wi, pdf });
            }
            Job::FPdf { wo, wi, f, pdf } => {
                let (wo, wi) = (self.all_local(wo), self.all_local(wi));
                let (wo, wi) = (wo.directions(), wi.directions());
                self.inner.batch(path, Job::FPdf { wo, wi, f, pdf });
            }
            Job::LobeF { index, wo, wi, f } => {
                let (wo, wi) = (self.all_local(wo), self.all_local(wi));
                let (wo, wi) = (wo.directions(), wi.directions());
                self.inner.batch(path, Job::LobeF { index, wo, wi, f });
            }
            Job::Sample {
                wo,
                uc,
                u,
                wi: [x, y, z],
                f,
                pdf,
                delta,
            } => {
                let wo = self.all_local(wo);
                let turned = Job::Sample {
                    wo: wo.directions(),
                    uc,
                    u,
                    wi: [&mut *x, &mut *y, z],
                    f,
                    pdf,
                    delta,
                };
                self.inner.batch(path, turned);
                self.turn_back(n, x, y);
            }
            Job::Lobe {
                index,
                is_incident,
                held,
                u,
                free: [x, y, z],
                weight,
            } => {
                let held = self.all_local(held);
                let turned = Job::Lobe {
                    index,
                    is_incident,
                    held: held.directions(),
                    u,
                    free: [&mut *x, &mut *y, z],
                    weight,
                };
                self.inner.batch(path, turned);
                self.turn_back(n, x, y);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Material;
    use crate::math::frame::{cos_sin_deg, direction_from_degrees};

    #[test]
    fn turning_the_surface_is_turning_the_directions_back() {
        let material: Material = "rough_conductor:alpha_x=0.1,alpha_y=0.5".parse().unwrap();
        let turned = Rotated::new(material.build::<f64>(), cos_sin_deg(30.0));
        let f = |model: &dyn Scatterer<f64>, azimuth: f64| {
            let wo = direction_from_degrees(40.0, azimuth).into();
            let wi = direction_from_degrees(30.0, azimuth + 150.0).into();
            model.f(wo, wi).0[0]
        };
        let expected = f(&*material.build(), -30.0);
        assert!((f(&turned, 0.0) / expected - 1.0).abs() < 1e-12);
        assert!(
            (f(&turned, 0.0) / f(&*material.build(), 0.0) - 1.0).abs() > 0.1,
            "the lobe is anisotropic"
        );
        let wo = direction_from_degrees(40.0, 0.0).into();
        let sample = turned.sample_f(wo, 0.5, [0.3, 0.6]).unwrap();
        assert!((turned.f(wo, sample.wi).0[0] / sample.f.0[0] - 1.0).abs() < 1e-10);
        assert!((turned.pdf(wo, sample.wi) / sample.pdf - 1.0).abs() < 1e-10);
    }
}
