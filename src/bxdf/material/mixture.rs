//! The weighted sum of models, evaluated, drawn and integrated as one.

use super::component::{Component, MAX_COMPONENTS};
use crate::batch::Scatterer;
use crate::lobe::{Lobe, Side};
use crate::lobes::Lobes;
use crate::math::{Real, Vec3};
use crate::optics::Spectrum;
use crate::sample::{Delta, Deltas, Sample};
use crate::scattering::Bxdf;

/// Polar angles of the table of contributions: every 7.5 degrees from n to -n.
const ELEVATIONS: usize = 25;

/// Samples for each entry of the table, along each side of the square. The table steers the choice among components and
/// nothing else; a contribution is known to some percent.
const PER_SIDE: u32 = 6;

/// The least probability of a component whose weight is not 0: where the table misses a contribution, samples still find
/// it, with weights up to this many times less than one.
const LEAST_SHARE: f64 = 1e-3;

/// A model with its weight, and which of all lobes are its own.
pub(super) struct Part<R> {
    pub(super) weight: R,
    pub(super) bxdf: Box<dyn Scatterer<R>>,
    /// Its contribution to the radiance leaving along `wo` under uniform light, by the angle of `wo` from n.
    contributions: [f64; ELEVATIONS],
}

/// The sum of the values of several models, each times its weight.
///
/// A sample comes from one component, chosen by how much it is expected to contribute; `pdf` is that of the mixture.
/// Deltas of the components that point the same way are one delta.
pub(super) struct Mixture<R> {
    parts: Vec<Part<R>>,
    lobes: Vec<Lobe>,
    /// For each of `lobes`: the component, and the index among that component's lobes.
    owners: Vec<(usize, usize)>,
}

impl<R: Real> Mixture<R> {
    /// The sum of `components`, each made by `build`.
    pub(super) fn new(
        components: &[Component],
        build: impl Fn(&Component) -> Box<dyn Scatterer<R>>,
    ) -> Self {
        let mut mixture = Self {
            parts: Vec::new(),
            lobes: Vec::new(),
            owners: Vec::new(),
        };
        for component in components {
            let bxdf = build(component);
            for (index, lobe) in bxdf.lobes().iter().enumerate() {
                let name = if lobe.name.is_empty() {
                    component.model().title
                } else {
                    lobe.name
                };
                mixture.lobes.push(lobe.named(name));
                mixture.owners.push((mixture.parts.len(), index));
            }
            mixture.parts.push(Part {
                weight: R::of(component.weight()),
                bxdf,
                contributions: contributions(component),
            });
        }
        mixture
    }
}

/// The mean weight of samples at each angle of the table, times the component's weight, largest channel.
fn contributions(component: &Component) -> [f64; ELEVATIONS] {
    let bxdf = component.build::<f64>();
    let centre = |index: u32, of: u32| (f64::from(index) + 0.5) / f64::from(of);
    std::array::from_fn(|row| {
        let theta = std::f64::consts::PI * row as f64 / (ELEVATIONS - 1) as f64;
        // At the horizon itself nothing is drawn: the last look at what is beside it.
        let (sin, cos) = theta.clamp(0.01, std::f64::consts::PI - 0.01).sin_cos();
        let cos = if cos.abs() < 0.01 { 0.01 } else { cos };
        let wo = Vec3::new(sin, 0.0, cos);
        let mut sum = Spectrum::black();
        for index in 0..PER_SIDE * PER_SIDE {
            let u = [
                centre(index % PER_SIDE, PER_SIDE),
                centre(index / PER_SIDE, PER_SIDE),
            ];
            // Every component of the choice in turn, in each part of the square: the golden ratio's multiples.
            let uc = (f64::from(index) * 0.618_033_988_749_895).fract();
            if let Some(sample) = bxdf.sample_f(wo, uc, u) {
                sum = sum + sample.weight();
            }
        }
        component.weight() * sum.max_channel() / f64::from(PER_SIDE * PER_SIDE)
    })
}

impl<R: Real> Mixture<R> {
    /// The components.
    pub(super) fn parts(&self) -> &[Part<R>] {
        &self.parts
    }

    /// The probability of each component at `wo`, in their order; 0 behind the last.
    pub(super) fn shares(&self, wo: Vec3<R>) -> [R; MAX_COMPONENTS] {
        let place = wo.z.as_f64().clamp(-1.0, 1.0);
        let angle = place.atan2(wo.x.as_f64().hypot(wo.y.as_f64()));
        let x = (0.5 - angle / std::f64::consts::PI) * (ELEVATIONS - 1) as f64;
        let row = (x as usize).min(ELEVATIONS - 2);
        let between = x - row as f64;
        let contribution = |part: &Part<R>| {
            let [a, b] =
                [row, row + 1].map(|row| part.contributions.get(row).copied().unwrap_or(0.0));
            a * (1.0 - between) + b * between
        };
        let all: f64 = self.parts.iter().map(contribution).sum();
        let floor = |part: &Part<R>| {
            if part.weight > R::zero() {
                LEAST_SHARE * all.max(f64::MIN_POSITIVE)
            } else {
                0.0
            }
        };
        let mut chances = [0.0; MAX_COMPONENTS];
        for (chance, part) in chances.iter_mut().zip(&self.parts) {
            *chance = contribution(part).max(floor(part));
        }
        let sum: f64 = chances.iter().sum();
        chances.map(|chance| R::of(if sum > 0.0 { chance / sum } else { 0.0 }))
    }

    /// The component that `uc` chooses at `wo`, and the number, uniform in [0, 1), that is left of it.
    pub(super) fn choose(&self, wo: Vec3<R>, uc: R) -> Option<(usize, R)> {
        let mut rest = uc;
        let shares = self.shares(wo);
        let last = shares.iter().rposition(|share| *share > R::zero())?;
        for (index, share) in shares.into_iter().enumerate() {
            if rest < share || index == last {
                let below_one = R::one() - R::of(R::UNIT_ROUNDOFF);
                return Some((index, (rest / share).min(below_one)));
            }
            rest = rest - share;
        }
        None
    }

    /// The component whose inner lobe is the mixture's at `index`, and that lobe's index there.
    pub(super) fn lobe(&self, index: usize) -> Option<(&Part<R>, usize)> {
        let (part, inner) = *self.owners.get(index)?;
        Some((self.parts.get(part)?, inner))
    }
}

impl<R: Real> Bxdf<R> for Mixture<R> {
    fn f(&self, wo: Vec3<R>, wi: Vec3<R>) -> Spectrum<R> {
        self.parts
            .iter()
            .fold(Spectrum::black(), |sum, part| {
                sum + part.bxdf.f(wo, wi) * part.weight
            })
            .map(Real::saturated)
    }

    fn pdf(&self, wo: Vec3<R>, wi: Vec3<R>) -> R {
        self.parts
            .iter()
            .zip(self.shares(wo))
            .fold(R::zero(), |sum, (part, share)| {
                sum + weighed(share, part.bxdf.pdf(wo, wi))
            })
            .saturated()
    }

    fn sample_f(&self, wo: Vec3<R>, uc: R, u: [R; 2]) -> Option<Sample<R>> {
        let (index, rest) = self.choose(wo, uc)?;
        let sample = self.parts.get(index)?.bxdf.sample_f(wo, rest, u)?;
        if sample.is_delta {
            let mut deltas = self.deltas(wo).into_iter().flatten();
            let side = Side::between(wo, sample.wi);
            return deltas
                .find(|delta| delta.side == side)
                .map(|delta| delta.sample());
        }
        let sample = Sample {
            f: self.f(wo, sample.wi),
            pdf: self.pdf(wo, sample.wi),
            ..sample
        };
        sample.with_density()
    }

    fn deltas(&self, w: Vec3<R>) -> Deltas<R> {
        let mut merged: Deltas<R> = [None, None];
        for (part, share) in self.parts.iter().zip(self.shares(w)) {
            for delta in part.bxdf.deltas(w).into_iter().flatten() {
                let [reflected, transmitted] = &mut merged;
                let slot = match delta.side {
                    Side::Reflection => reflected,
                    Side::Transmission => transmitted,
                };
                let scaled = Delta {
                    flux: delta.flux * part.weight,
                    weight: delta.weight * part.weight,
                    probability: delta.probability * share,
                    ..delta
                };
                // One index below the surface: all deltas to a side point the same way.
                *slot = Some(slot.map_or(scaled, |sum| Delta {
                    flux: sum.flux + scaled.flux,
                    weight: sum.weight + scaled.weight,
                    probability: sum.probability + scaled.probability,
                    ..sum
                }));
            }
        }
        merged
    }
}

impl<R: Real> Lobes<R> for Mixture<R> {
    fn lobes(&self) -> &[Lobe] {
        &self.lobes
    }

    fn lobe_f(&self, index: usize, wo: Vec3<R>, wi: Vec3<R>) -> Spectrum<R> {
        self.lobe(index).map_or(Spectrum::black(), |(part, inner)| {
            part.bxdf.lobe_f(inner, wo, wi) * part.weight
        })
    }

    fn lobe_pdf(&self, index: usize, wo: Vec3<R>, wi: Vec3<R>) -> R {
        self.lobe(index)
            .map_or(R::zero(), |(part, inner)| part.bxdf.lobe_pdf(inner, wo, wi))
    }

    fn sample_lobe(&self, index: usize, wo: Vec3<R>, u: [R; 2]) -> Option<Vec3<R>> {
        let (part, inner) = self.lobe(index)?;
        part.bxdf.sample_lobe(inner, wo, u)
    }
}

/// `share` times `density`. A component that is never chosen may have an infinite density: 0 times it is no number.
#[inline(always)]
pub(super) fn weighed<R: Real>(share: R, density: R) -> R {
    if share > R::zero() {
        share * density
    } else {
        R::zero()
    }
}

#[cfg(test)]
mod tests {
    use super::super::Material;
    use super::*;

    fn mixture(parts: &[(f64, &str)]) -> Material {
        let component = |(weight, text): &(f64, &str)| {
            let mut component: Component = text.parse().unwrap();
            component.set_weight(*weight).unwrap();
            component
        };
        Material::new(parts.iter().map(component).collect()).unwrap()
    }

    #[test]
    fn values_add_and_deltas_merge() {
        let glossy = mixture(&[
            (0.5, "specular_reflection"),
            (0.25, "lambertian_reflection:reflectance=.8"),
            (0.25, "specular_reflection:reflectance=.4"),
        ]);
        let bxdf = glossy.build::<f64>();
        let up = Vec3::new(0.0, 0.0, 1.0);
        assert!((bxdf.f(up, up).0[0] - 0.2 / std::f64::consts::PI).abs() < 1e-16);
        let [Some(delta), None] = bxdf.deltas(up) else {
            panic!("one delta, reflected");
        };
        assert!((delta.flux.0[0] - 0.6).abs() < 1e-15);
        // .6 of the light in the mirror direction, .2 all around: the shares of the samples.
        assert!((delta.probability - 0.75).abs() < 1e-3, "{delta:?}");
        let sample = bxdf.sample_f(up, 0.1, [0.5; 2]).unwrap();
        assert!(sample.is_delta && (sample.weight().0[0] - 0.8).abs() < 1e-3);
    }

    #[test]
    fn a_component_of_weight_zero_is_never_drawn() {
        let bxdf = mixture(&[(0.0, "phong"), (1.0, "lambertian_reflection")]).build::<f64>();
        let wo = Vec3::new(0.6, 0.0, 0.8);
        assert!((bxdf.pdf(wo, wo) - 0.8 / std::f64::consts::PI).abs() < 1e-15);
        assert!(bxdf.sample_f(wo, 0.0, [0.5; 2]).is_some());
        let dark = mixture(&[(0.0, "phong"), (0.0, "oren_nayar")]).build::<f64>();
        assert!(dark.sample_f(wo, 0.5, [0.5; 2]).is_none() && dark.pdf(wo, wo) == 0.0);
    }
    /// Whatever weights are allowed: values and densities are numbers in every precision, on both sides, and samples too.
    #[test]
    fn the_largest_weights_keep_values_and_densities() {
        let [low, high] = super::super::WEIGHT.hard;
        let mut one: Component = "phong".parse().unwrap();
        for refused in [4e38, 1e308, high * (1.0 + 1e-15), f64::INFINITY, -1e-300] {
            assert!(one.set_weight(refused).is_err(), "{refused}");
        }
        let both = "rough_dielectric:alpha=.001";
        let parts = [both, "lambertian_reflection", "specular_transmission", both];
        let parts = [parts, parts].concat();
        let bright: Vec<_> = parts.iter().map(|part| (high, *part)).collect();
        let mut faint = bright.clone();
        faint[0].0 = f64::MIN_POSITIVE;
        faint[1].0 = low;
        for weights in [bright, faint] {
            let material = mixture(&weights);
            let (single, double) = (material.build::<f32>(), material.build::<f64>());
            for z in [0.8, -0.8] {
                let wo = Vec3::new(0.6, 0.0, z);
                let narrow = Vec3::new(wo.x as f32, 0.0, wo.z as f32);
                for wi in [0.8, -0.8].map(|z| Vec3::new(-0.6, 0.0, z)) {
                    let f = double.f(wo, wi).0[0];
                    assert!(f.is_finite() && f > 0.0 || z < 0.0, "{f}");
                    let wi = Vec3::new(wi.x as f32, 0.0, wi.z as f32);
                    let [f, pdf] = [single.f(narrow, wi).0[0], single.pdf(narrow, wi)];
                    assert!(f.is_finite() && pdf.is_finite(), "{f} {pdf}");
                    assert!(f == 0.0 || pdf > 0.0, "{f} {pdf}");
                }
                let sample = single.sample_f(narrow, 0.1, [0.3, 0.6]).unwrap();
                assert!(sample.weight().0[0].is_finite(), "{sample:?}");
            }
        }
    }
}
