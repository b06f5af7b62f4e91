//! Ways to choose the directions of an estimate.

use super::sequence::Numbers;
use crate::bxdf::Bxdf;
use crate::bxdf::batch::{Job, Path};
use crate::bxdf::math::{Vec3, warp};
use crate::bxdf::optics::spectrum::luminance;

/// The surface whose reflectance is estimated, with the direction of view held.
#[derive(Clone, Copy)]
pub struct Surface<'a> {
    /// The surface.
    pub bxdf: &'a dyn Bxdf<f64>,
    /// The direction of view, a unit vector.
    pub wo: Vec3<f64>,
    /// Whether light comes from the side of `wo`, and whether from the other.
    pub sides: [bool; 2],
}

/// How the directions of an estimate of the integral of f |cos(theta_i)| are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Uniformly over the hemisphere, or the sphere.
    Uniform,
    /// In proportion to the cosine.
    Cosine,
    /// By the model's own sampler.
    Importance,
    /// As many by the cosine as by the model's own sampler, weighted by the balance heuristic (`veach1997`).
    Combined,
}

/// Arrays of a batch.
#[derive(Default)]
struct Drawn {
    wi: [Vec<f64>; 3],
    f: [Vec<f64>; 3],
    pdf: Vec<f64>,
    delta: Vec<f64>,
}

impl Drawn {
    fn new(n: usize) -> Self {
        let numbers = || vec![0.0; n];
        let three = || [numbers(), numbers(), numbers()];
        Self {
            wi: three(),
            f: three(),
            pdf: numbers(),
            delta: numbers(),
        }
    }

    /// The luminance of f |cos| over each element of `densities`; 0 where that is 0 and for deltas.
    fn over<'a>(
        &'a self,
        densities: impl Iterator<Item = f64> + 'a,
    ) -> impl Iterator<Item = f64> + 'a {
        let [r, g, b] = &self.f;
        let f = r
            .iter()
            .zip(g)
            .zip(b)
            .map(|((r, g), b)| luminance([*r, *g, *b]));
        let cosines = self.wi[2].iter().zip(&self.delta);
        let terms = f.zip(cosines).zip(densities);
        terms.map(|((f, (z, delta)), density)| {
            if density > 0.0 && *delta == 0.0 {
                f * z.abs() / density
            } else {
                0.0
            }
        })
    }
}

impl Method {
    /// All of them.
    pub const ALL: [Self; 4] = [
        Self::Uniform,
        Self::Cosine,
        Self::Importance,
        Self::Combined,
    ];

    /// Its name in choices.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Uniform => "uniform",
            Self::Cosine => "cosine",
            Self::Importance => "importance",
            Self::Combined => "cosine + importance",
        }
    }

    /// How many samples make one term of the estimate's mean.
    #[must_use]
    pub const fn samples_of_a_term(self) -> u32 {
        match self {
            Self::Combined => 2,
            _ => 1,
        }
    }

    /// The terms whose mean is the estimate, Dirac deltas left out: one for each of `numbers`; `others`: as many
    /// independent numbers for the second kind of samples.
    #[must_use]
    pub fn terms(self, surface: &Surface<'_>, numbers: &Numbers, others: &Numbers) -> Vec<f64> {
        let over_hemispheres = |density: fn(f64) -> f64, warp: fn([f64; 2]) -> Vec3<f64>| {
            let drawn = surface.by_warp(numbers, warp, false);
            let densities = drawn.wi[2].iter().map(|z| surface.spread(density(z.abs())));
            drawn.over(densities).collect()
        };
        match self {
            Self::Uniform => {
                over_hemispheres(|_| warp::uniform_hemisphere_pdf(), warp::uniform_hemisphere)
            }
            Self::Cosine => over_hemispheres(warp::cosine_hemisphere_pdf, warp::cosine_hemisphere),
            Self::Importance => {
                let drawn = surface.by_sampler(numbers);
                drawn.over(drawn.pdf.iter().copied()).collect()
            }
            Self::Combined => {
                let cosine = surface.by_warp(numbers, warp::cosine_hemisphere, true);
                let own = surface.by_sampler(others);
                let both = |drawn: &Drawn| {
                    let cosines = drawn.wi[2].iter().zip(&drawn.pdf);
                    let [own_side, other_side] = surface.sides;
                    let densities = cosines.map(|(z, pdf)| {
                        let is_crossing = (*z > 0.0) != (surface.wo.z > 0.0);
                        if if is_crossing { other_side } else { own_side } {
                            pdf + surface.spread(warp::cosine_hemisphere_pdf(z.abs()))
                        } else {
                            *pdf
                        }
                    });
                    drawn.over(densities).collect::<Vec<_>>()
                };
                let (cosine, own) = (both(&cosine), both(&own));
                cosine.into_iter().zip(own).map(|(a, b)| a + b).collect()
            }
        }
    }
}

impl Surface<'_> {
    /// A density over one hemisphere as one over the sides that light comes from.
    fn spread(&self, density: f64) -> f64 {
        if self.sides == [true; 2] {
            0.5 * density
        } else {
            density
        }
    }

    /// Directions by `warp`, with f, and with the sampler's density if `with_pdf`.
    fn by_warp(&self, numbers: &Numbers, warp: fn([f64; 2]) -> Vec3<f64>, with_pdf: bool) -> Drawn {
        let n = numbers.uc.len();
        let mut drawn = Drawn::new(n);
        let [x, y, z] = &mut drawn.wi;
        let components = x.iter_mut().zip(y).zip(z);
        let [u, v] = &numbers.u;
        let numbers = numbers.uc.iter().zip(u).zip(v);
        for (((x, y), z), ((uc, u), v)) in components.zip(numbers) {
            let w = warp([*u, *v]);
            let is_own_side = match self.sides {
                [true, true] => *uc < 0.5,
                [own, _] => own,
            };
            let sign = if is_own_side == (self.wo.z > 0.0) {
                1.0
            } else {
                -1.0
            };
            (*x, *y, *z) = (w.x, w.y, sign * w.z);
        }
        let held = self.held(n);
        let wo = held.each_ref().map(Vec::as_slice);
        let wi = drawn.wi.each_ref().map(Vec::as_slice);
        let f = drawn.f.each_mut().map(Vec::as_mut_slice);
        let job = if with_pdf {
            Job::FPdf {
                wo,
                wi,
                f,
                pdf: &mut drawn.pdf,
            }
        } else {
            Job::F { wo, wi, f }
        };
        self.bxdf.batch(Path::Dispatched, job);
        drawn
    }

    /// Samples of the surface's own.
    fn by_sampler(&self, numbers: &Numbers) -> Drawn {
        let n = numbers.uc.len();
        let mut drawn = Drawn::new(n);
        let held = self.held(n);
        let [u, v] = &numbers.u;
        let job = Job::Sample {
            wo: held.each_ref().map(Vec::as_slice),
            uc: &numbers.uc,
            u: [u, v],
            wi: drawn.wi.each_mut().map(Vec::as_mut_slice),
            f: drawn.f.each_mut().map(Vec::as_mut_slice),
            pdf: &mut drawn.pdf,
            delta: &mut drawn.delta,
        };
        self.bxdf.batch(Path::Dispatched, job);
        drawn
    }

    fn held(&self, n: usize) -> [Vec<f64>; 3] {
        [self.wo.x, self.wo.y, self.wo.z].map(|x| vec![x; n])
    }

    /// f |cos| at the directions `wi`, as luminance.
    #[must_use]
    pub fn values(&self, wi: &[Vec<f64>; 3]) -> Vec<f64> {
        let mut drawn = Drawn::new(wi[0].len());
        drawn.wi.clone_from(wi);
        let held = self.held(wi[0].len());
        let job = Job::F {
            wo: held.each_ref().map(Vec::as_slice),
            wi: wi.each_ref().map(Vec::as_slice),
            f: drawn.f.each_mut().map(Vec::as_mut_slice),
        };
        self.bxdf.batch(Path::Dispatched, job);
        drawn.over(std::iter::repeat(1.0)).collect()
    }
}
