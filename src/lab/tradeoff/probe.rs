//! The pairs of directions at which choices are held against each other.

use std::f64::consts::PI;

use glam::DVec3;
use sobol_burley::sample;

use crate::analysis::sphere::pair_at;
use bxdf::batch::Columns;
use bxdf::math::warp;
use bxdf::{Material, Scatterer, Side};

/// Held directions over the hemisphere, beside the normal.
const HELD: usize = 64;

/// Free directions of each.
const FREE: u32 = 256;

/// Free directions where the held one is the normal: the reflectance there is compared to three digits.
const FREE_AT_NORMAL: u32 = 2048;

/// Pixels across the lit sphere.
const SPHERE: usize = 32;

/// Where the light of the lit sphere stands: to the upper left before it.
pub const LIGHT: DVec3 = DVec3::new(-0.48, 0.60, 0.64);

/// The golden ratio's fractional part: its multiples spread evenly over [0, 1).
const GOLDEN: f64 = 0.618_033_988_749_895;

/// Some free directions to one held: a stretch of the pairs of a [`Probe`].
#[derive(Clone, Copy, Debug)]
pub struct Group {
    start: usize,
    end: usize,
    /// The solid angle times cosine that the held direction stands for, over the whole hemisphere pi; 0 for the normal,
    /// which is looked at for its own sake.
    held_weight: f64,
}

impl Group {
    /// Its part of what belongs to all pairs.
    pub fn of<'a, T>(&self, all: &'a [T]) -> &'a [T] {
        all.get(self.start..self.end).unwrap_or_default()
    }
}

/// Pairs of directions that are where the light of one material is, with their weights in integrals.
///
/// `wo` is held: directions spread by their cosine over the hemisphere, or over both for a surface that light crosses, and
/// the normal. To each belong directions `wi`, half of them by the cosine and half by the material's own sampler, weighted by
/// the balance heuristic (`veach1997`): lobes of every width are met where they are. All components are numbers of `f32`, so
/// that every precision is given the same directions.
pub struct Probe {
    /// (wo, wi); those of the lit sphere after those of the groups.
    pub pairs: Vec<(DVec3, DVec3)>,
    /// |cos(theta_i)| over the density, over the number of the group: sums of f with it are reflectances.
    free_weights: Vec<f64>,
    groups: Vec<Group>,
    sphere: Group,
}

impl Probe {
    /// The pairs for `bxdf`, which is `material`.
    #[must_use]
    pub fn new(material: &Material, bxdf: &dyn Scatterer<f64>) -> Self {
        let sides = Sides::of(material);
        let mut probe = Self {
            pairs: Vec::new(),
            free_weights: Vec::new(),
            groups: Vec::new(),
            sphere: Group {
                start: 0,
                end: 0,
                held_weight: 0.0,
            },
        };
        probe.hold(bxdf, sides, DVec3::Z, FREE_AT_NORMAL, 0.0);
        for index in 0..HELD {
            let row = (index as f64 + 0.5) / HELD as f64;
            let column = (index as f64 * GOLDEN).fract();
            let mut wo: DVec3 = warp::cosine_hemisphere([row, column]).into();
            if sides.transmits && index % 2 == 1 {
                wo = -wo;
            }
            probe.hold(bxdf, sides, wo, FREE, PI / HELD as f64);
        }
        let start = probe.pairs.len();
        probe.pairs.extend(sphere_pairs());
        probe.sphere.start = start;
        probe.sphere.end = probe.pairs.len();
        probe
    }

    /// Adds a group of about `count` directions to `wo`.
    fn hold(
        &mut self,
        bxdf: &dyn Scatterer<f64>,
        sides: Sides,
        wo: DVec3,
        count: u32,
        held_weight: f64,
    ) {
        let wo = in_single(wo);
        let start = self.pairs.len();
        let seed = self.groups.len() as u32;
        let number = |index, axis| f64::from(sample(index, axis, seed));
        let by_cosine = (0..count / 2).map(|index| {
            let w = warp::cosine_hemisphere([number(index, 1), number(index, 2)]);
            sides.place(w.into(), wo, number(index, 0))
        });
        let drawn = (count / 2..count).filter_map(|index| {
            let u = [number(index, 1), number(index, 2)];
            let sample = bxdf.sample_f(wo.into(), number(index, 0), u)?;
            (!sample.is_delta).then(|| DVec3::from(sample.wi))
        });
        let free: Vec<DVec3> = by_cosine.chain(drawn).map(in_single).collect();
        let densities = densities(bxdf, wo, &free);
        for (wi, own) in free.into_iter().zip(densities) {
            let cosine = sides.density(wo, wi);
            let density = 0.5 * (own + cosine);
            if density > 0.0 {
                self.pairs.push((wo, wi));
                self.free_weights
                    .push(wi.z.abs() / (density * f64::from(count)));
            }
        }
        self.groups.push(Group {
            start,
            end: self.pairs.len(),
            held_weight,
        });
    }

    /// The groups, the normal's first.
    #[must_use]
    pub fn groups(&self) -> &[Group] {
        &self.groups
    }

    /// The pairs of the lit sphere's pixels.
    #[must_use]
    pub fn sphere(&self) -> Group {
        self.sphere
    }

    /// The integral over both directions of `integrand`, which gives its value for the index of a pair, times both cosines.
    #[must_use]
    pub fn integral(&self, integrand: impl Fn(usize) -> f64) -> f64 {
        let over_group = |group: &Group| {
            let weights = group.of(&self.free_weights).iter();
            let indices = group.start..group.end;
            let sum: f64 = indices
                .zip(weights)
                .map(|(i, weight)| integrand(i) * weight)
                .sum();
            sum * group.held_weight
        };
        self.groups.iter().map(over_group).sum()
    }

    /// What `values`, one for each pair, times |cos(theta_i)| integrate to over the sphere, for the pairs of `group`.
    #[must_use]
    pub fn reflectance(&self, group: &Group, values: &[[f64; 3]]) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for (value, weight) in group.of(values).iter().zip(group.of(&self.free_weights)) {
            sum.iter_mut()
                .zip(value)
                .for_each(|(sum, f)| *sum += f * weight);
        }
        sum
    }
}

/// To which sides a material sends light.
#[derive(Clone, Copy)]
struct Sides {
    reflects: bool,
    transmits: bool,
}

impl Sides {
    fn of(material: &Material) -> Self {
        Self {
            reflects: material.has_side(Side::Reflection),
            transmits: material.has_side(Side::Transmission),
        }
    }

    /// `w` of the upper hemisphere brought to a side of `wo` where light goes, chosen by `uc` where it is both.
    fn place(self, w: DVec3, wo: DVec3, uc: f64) -> DVec3 {
        let is_same = if self.reflects && self.transmits {
            uc < 0.5
        } else {
            self.reflects
        };
        if is_same == (wo.z > 0.0) { w } else { -w }
    }

    /// The density of [`Self::place`] for directions by the cosine.
    fn density(self, wo: DVec3, wi: DVec3) -> f64 {
        let cosine = warp::cosine_hemisphere_pdf(wi.z.abs());
        let is_same = (wo.z > 0.0) == (wi.z > 0.0);
        match (self.reflects, self.transmits) {
            (true, true) => 0.5 * cosine,
            (reflects, _) if reflects == is_same => cosine,
            _ => 0.0,
        }
    }
}

/// The pdf of `bxdf` at `wo` and each of `wi`.
fn densities(bxdf: &dyn Scatterer<f64>, wo: DVec3, wi: &[DVec3]) -> Vec<f64> {
    let held = Columns::repeated(wo.to_array(), wi.len());
    bxdf.densities(&held, &Columns::directions(wi.iter().copied()))
}

/// `w` with its components rounded to `f32`.
fn in_single(w: DVec3) -> DVec3 {
    w.as_vec3().into()
}

/// The pairs that the pixels of the lit sphere show, where light falls on them.
fn sphere_pairs() -> impl Iterator<Item = (DVec3, DVec3)> {
    let place = |index: usize| 2.0 * (index as f64 + 0.5) / SPHERE as f64 - 1.0;
    (0..SPHERE * SPHERE)
        .filter_map(move |index| pair_at(LIGHT, [place(index % SPHERE), -place(index / SPHERE)]))
        .filter(|(_, wi)| wi.z > 0.0)
        .map(|(wo, wi)| (in_single(wo), in_single(wi)))
}
