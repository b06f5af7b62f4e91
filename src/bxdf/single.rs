//! Models in f32: evaluated in [`Fast`] numbers, given and taken as plain ones.

use super::batch::{Job, Path};
use super::math::{Fast, Real, Vec3};
use super::optics::Spectrum;
use super::{Bxdf, Delta, Deltas, Lobe, Microfacet, Sample};

/// A model of [`Fast`] numbers as one of `f32`. Batches go to it as they are.
pub struct Single(pub Box<dyn Bxdf<Fast<f32>>>);

/// The number of type `S` stored as `R` is.
#[inline(always)]
fn number<R: Real, S: Real<Stored = R::Stored>>(x: R) -> S {
    S::load(x.store())
}

#[inline(always)]
fn vector<R: Real, S: Real<Stored = R::Stored>>(v: Vec3<R>) -> Vec3<S> {
    Vec3::new(number(v.x), number(v.y), number(v.z))
}

#[inline(always)]
fn spectrum<R: Real, S: Real<Stored = R::Stored>>(s: Spectrum<R>) -> Spectrum<S> {
    Spectrum(s.0.map(number))
}

impl Bxdf<f32> for Single {
    fn f(&self, wo: Vec3<f32>, wi: Vec3<f32>) -> Spectrum<f32> {
        spectrum(self.0.f(vector(wo), vector(wi)))
    }

    fn pdf(&self, wo: Vec3<f32>, wi: Vec3<f32>) -> f32 {
        number(self.0.pdf(vector(wo), vector(wi)))
    }

    fn sample_f(&self, wo: Vec3<f32>, uc: f32, u: [f32; 2]) -> Option<Sample<f32>> {
        let sample = self.0.sample_f(vector(wo), Fast(uc), u.map(Fast))?;
        Some(Sample {
            wi: vector(sample.wi),
            f: spectrum(sample.f),
            pdf: number(sample.pdf),
            is_delta: sample.is_delta,
        })
    }

    fn lobes(&self) -> &[Lobe] {
        self.0.lobes()
    }

    fn lobe_f(&self, index: usize, wo: Vec3<f32>, wi: Vec3<f32>) -> Spectrum<f32> {
        spectrum(self.0.lobe_f(index, vector(wo), vector(wi)))
    }

    fn lobe_pdf(&self, index: usize, wo: Vec3<f32>, wi: Vec3<f32>) -> f32 {
        number(self.0.lobe_pdf(index, vector(wo), vector(wi)))
    }

    fn sample_lobe(&self, index: usize, wo: Vec3<f32>, u: [f32; 2]) -> Option<Vec3<f32>> {
        Some(vector(self.0.sample_lobe(
            index,
            vector(wo),
            u.map(Fast),
        )?))
    }

    fn microfacet(&self, wo: Vec3<f32>, wi: Vec3<f32>) -> Option<Microfacet<f32>> {
        let factors = self.0.microfacet(vector(wo), vector(wi))?;
        Some(Microfacet {
            d: number(factors.d),
            g: number(factors.g),
            fresnel: spectrum(factors.fresnel),
        })
    }

    fn batch(&self, path: Path, job: Job<'_, f32>) {
        self.0.batch(path, job);
    }

    fn deltas(&self, w: Vec3<f32>) -> Deltas<f32> {
        let as_plain = |delta: Delta<Fast<f32>>| Delta {
            direction: vector(delta.direction),
            flux: spectrum(delta.flux),
            weight: spectrum(delta.weight),
            probability: number(delta.probability),
            side: delta.side,
        };
        self.0.deltas(vector(w)).map(|delta| delta.map(as_plain))
    }
}
