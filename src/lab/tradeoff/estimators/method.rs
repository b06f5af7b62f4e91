//! Ways to choose the directions of an estimate.

use super::sequence::Numbers;
use bxdf::Scatterer;
use bxdf::batch::{Columns, Job, Path};
use bxdf::math::Vec3;
use bxdf::math::warp;
use bxdf::optics::spectrum::luminance;

/// The surface whose reflectance is estimated, with the direction of view held.
#[derive(Clone, Copy)]
pub struct Surface<'a> {
    /// The surface.
    pub bxdf: &'a dyn Scatterer<f64>,
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

/// What is drawn: the three components of wi, the three channels of f, the density, and whether it is a delta.
struct Drawn(Columns<f64, 8>);

impl Drawn {
    fn new(n: usize) -> Self {
        Self(Columns::filled(0.0, n))
    }

    /// The cosines of the directions drawn, with their densities.
    fn cosines_and_densities(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        self.0.rows().map(|[_, _, z, .., pdf, _]| (z, pdf))
    }

    /// The luminance of f |cos| over each element of `densities`; 0 where that is 0 and for deltas.
    fn over<'a>(
        &'a self,
        densities: impl Iterator<Item = f64> + 'a,
    ) -> impl Iterator<Item = f64> + 'a {
        let terms = self.0.rows().zip(densities);
        terms.map(|([_, _, z, r, g, b, _, delta], density)| {
            if density > 0.0 && delta == 0.0 {
                luminance([r, g, b]) * z.abs() / density
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
            let cosines = drawn.cosines_and_densities();
            let densities = cosines.map(|(z, _)| surface.spread(density(z.abs())));
            drawn.over(densities).collect()
        };
        match self {
            Self::Uniform => {
                over_hemispheres(|_| warp::uniform_hemisphere_pdf(), warp::uniform_hemisphere)
            }
            Self::Cosine => over_hemispheres(warp::cosine_hemisphere_pdf, warp::cosine_hemisphere),
            Self::Importance => {
                let drawn = surface.by_sampler(numbers);
                let densities = drawn.cosines_and_densities().map(|(_, pdf)| pdf);
                drawn.over(densities).collect()
            }
            Self::Combined => {
                let cosine = surface.by_warp(numbers, warp::cosine_hemisphere, true);
                let own = surface.by_sampler(others);
                let both = |drawn: &Drawn| {
                    let [own_side, other_side] = surface.sides;
                    let densities = drawn.cosines_and_densities().map(|(z, pdf)| {
                        let is_crossing = (z > 0.0) != (surface.wo.z > 0.0);
                        if if is_crossing { other_side } else { own_side } {
                            pdf + surface.spread(warp::cosine_hemisphere_pdf(z.abs()))
                        } else {
                            pdf
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
        let held = self.held(numbers.len());
        let mut drawn = Drawn::new(numbers.len());
        let [x, y, z, r, g, b, pdf, _] = drawn.0.slices_mut();
        let components = x.iter_mut().zip(&mut *y).zip(&mut *z);
        for (((x, y), z), [uc, u, v]) in components.zip(numbers.rows()) {
            let w = warp([u, v]);
            let is_own_side = match self.sides {
                [true, true] => uc < 0.5,
                [own, _] => own,
            };
            let sign = if is_own_side == (self.wo.z > 0.0) {
                1.0
            } else {
                -1.0
            };
            (*x, *y, *z) = (w.x, w.y, sign * w.z);
        }
        let (wo, wi, f) = (held.slices(), [&*x, &*y, &*z], [r, g, b]);
        let job = if with_pdf {
            Job::FPdf { wo, wi, f, pdf }
        } else {
            Job::F { wo, wi, f }
        };
        self.bxdf.batch(Path::Dispatched, job);
        drawn
    }

    /// Samples of the surface's own.
    fn by_sampler(&self, numbers: &Numbers) -> Drawn {
        let held = self.held(numbers.len());
        Drawn(self.bxdf.samples(&held, numbers))
    }

    fn held(&self, n: usize) -> Columns<f64, 3> {
        Columns::repeated([self.wo.x, self.wo.y, self.wo.z], n)
    }

    /// f |cos| at the directions `wi`, as luminance.
    #[must_use]
    pub fn values(&self, wi: &Columns<f64, 3>) -> Vec<f64> {
        let values = self.bxdf.values(&self.held(wi.len()), wi);
        let values = values.rows().zip(wi.rows());
        values
            .map(|(f, [_, _, z])| luminance(f) * z.abs())
            .collect()
    }
}
