//! The construction of one hemisphere's mesh.

use glam::DVec3;
use rustc_hash::{FxHashMap, FxHashSet};

use super::surface::{Request, Vertex};
use crate::analysis::lobe::{HeldLobe, Seeds};
use crate::analysis::{Detail, IsWanted};

/// Halvings of the octahedron's edges before the lobe is looked at: edges of 5.6 degrees.
pub(super) const UNIFORM_LEVELS: u32 = 4;

/// A triangle is divided while it holds at least this many of the lobe's samples.
const SEEDS_TO_SPLIT: usize = 4;

/// The middle of an edge may leave its chord by this much of the largest radius.
const CHORD_TOLERANCE: f64 = 4e-3;

/// The integral over an edge's surroundings may be off by this much of the whole.
const INTEGRAL_TOLERANCE: f64 = 5e-5;

/// Edges shorter than this (in radians) are not halved: a thousand times finer than the narrowest lobe.
const SHORTEST: f64 = 1e-7;

/// No round of halving begins beyond this many triangles (one may quadruple them); a lobe needs some thousands.
const MAX_TRIANGLES: usize = 30_000;

/// The same of a coarse mesh: some milliseconds' worth.
const MAX_COARSE_TRIANGLES: usize = 2_000;

/// At most this many rounds of halving; the narrowest lobe takes about 20.
const MAX_ROUNDS: u32 = 32;

/// A triangle under construction: its corners, and the samples of the lobe inside it.
pub(super) struct Triangle {
    pub(super) corners: [u32; 3],
    seeds: Vec<DVec3>,
    /// Whether its edges have not been looked at yet.
    is_new: bool,
}

/// What is known of an edge.
#[derive(Clone, Copy)]
struct Edge {
    middle: Vertex,
    /// Its index once the edge is halved.
    index: Option<u32>,
}

/// The mesh of one hemisphere under construction.
pub(super) struct Builder<'a> {
    lobe: &'a HeldLobe<'a>,
    request: Request,
    is_upper: bool,
    /// About the integral of f |cos(theta)| over the sphere.
    total: f64,
    pub(super) peak: f64,
    pub(super) vertices: Vec<Vertex>,
    pub(super) triangles: Vec<Triangle>,
    edges: FxHashMap<[u32; 2], Edge>,
}

impl<'a> Builder<'a> {
    /// The mesh after `levels` halvings of all edges.
    pub(super) fn new(
        lobe: &'a HeldLobe<'a>,
        request: Request,
        is_upper: bool,
        seeds: &Seeds,
        levels: u32,
    ) -> Self {
        let mut builder = Self {
            lobe,
            request,
            is_upper,
            total: seeds.integral,
            peak: 0.0,
            vertices: Vec::new(),
            triangles: Vec::new(),
            edges: FxHashMap::default(),
        };
        let pole = if is_upper { DVec3::Z } else { DVec3::NEG_Z };
        let ring = [DVec3::X, DVec3::Y, DVec3::NEG_X, DVec3::NEG_Y];
        let corners: Vec<DVec3> = [pole].into_iter().chain(ring).collect();
        builder.vertices = builder.look(&corners);
        let mine = || {
            seeds
                .directions
                .iter()
                .copied()
                .filter(|w| if is_upper { w.z > 0.0 } else { w.z < 0.0 })
        };
        let quarters: [[u32; 2]; 4] = [[1, 2], [2, 3], [3, 4], [4, 1]];
        for [a, b] in quarters {
            let corners = if is_upper { [0, a, b] } else { [0, b, a] };
            let seeds = mine()
                .filter(|w| builder.insideness(corners, *w) >= 0.0)
                .collect();
            builder.triangles.push(Triangle {
                corners,
                seeds,
                is_new: true,
            });
        }
        for _ in 0..levels {
            builder.halve_edges_where(|_, _, _| true);
            builder.divide_triangles();
        }
        let seen = builder.look(&mine().collect::<Vec<_>>());
        let seen = seen.iter().chain(&builder.vertices);
        builder.peak = seen.map(|v| builder.shown(v)).fold(0.0, f64::max);
        builder
    }

    /// The lobe's values at `directions`.
    fn look(&self, directions: &[DVec3]) -> Vec<Vertex> {
        let values = self.lobe.values_or_limits(directions, self.is_upper);
        let vertices = directions.iter().zip(values);
        vertices
            .map(|(direction, value)| Vertex {
                direction: *direction,
                value,
            })
            .collect()
    }

    /// Whether the lobe is 0 in this hemisphere.
    pub(super) fn is_empty(&self) -> bool {
        self.peak == 0.0
    }

    /// The number whose radius is drawn, largest channel.
    fn shown(&self, vertex: &Vertex) -> f64 {
        let cosine = if self.request.with_cosine {
            vertex.direction.z.abs()
        } else {
            1.0
        };
        largest(vertex.value) * cosine
    }

    /// Halves edges until the mesh follows the lobe. `None` as soon as `is_wanted` says no.
    pub(super) fn refine(&mut self, detail: Detail, is_wanted: IsWanted<'_>) -> Option<()> {
        let most = match detail {
            Detail::Coarse => MAX_COARSE_TRIANGLES,
            Detail::Full => MAX_TRIANGLES,
        };
        for _ in 0..MAX_ROUNDS {
            if !is_wanted() {
                return None;
            }
            self.peak = self
                .vertices
                .iter()
                .map(|v| self.shown(v))
                .fold(self.peak, f64::max);
            self.halve_crowded_triangles();
            self.halve_edges_where(Self::is_coarse);
            self.close_over_longest_edges();
            if !self.divide_triangles() || self.triangles.len() > most {
                break;
            }
        }
        self.peak = self
            .vertices
            .iter()
            .map(|v| self.shown(v))
            .fold(0.0, f64::max);
        Some(())
    }

    /// Whether the chord of the edge is too far from the lobe's surface, or its trapezoid from the integral.
    fn is_coarse(&self, ends: [Vertex; 2], middle: &Vertex) -> bool {
        let [a, b] = ends;
        let tip = |v: &Vertex| v.direction * self.request.scale.radius(self.shown(v), self.peak);
        let gap = (tip(middle) - (tip(&a) + tip(&b)) * 0.5).length();
        let flux = |v: &Vertex| largest(v.value) * v.direction.z.abs();
        let area = (a.direction - b.direction).length_squared();
        let missing = (flux(middle) - f64::midpoint(flux(&a), flux(&b))).abs() * area;
        gap > CHORD_TOLERANCE || missing > INTEGRAL_TOLERANCE * self.total
    }

    fn get(&self, index: u32) -> Vertex {
        self.vertices
            .get(index as usize)
            .copied()
            .unwrap_or(Vertex {
                direction: DVec3::ZERO,
                value: [0.0; 3],
            })
    }

    /// Looks at every edge not looked at before, and halves those for which `is_wanted`.
    fn halve_edges_where(&mut self, is_wanted: impl Fn(&Self, [Vertex; 2], &Vertex) -> bool) {
        let mut keys = Vec::new();
        for triangle in self.triangles.iter_mut().filter(|triangle| triangle.is_new) {
            triangle.is_new = false;
            keys.extend(sides(triangle.corners));
        }
        for (key, ends) in self.look_at_edges(keys) {
            let is_long =
                (ends[0].direction - ends[1].direction).length_squared() > SHORTEST * SHORTEST;
            let middle = self.edges.get(&key).map(|edge| edge.middle);
            if is_long && middle.is_some_and(|middle| is_wanted(self, ends, &middle)) {
                self.halve(key);
            }
        }
    }

    /// Adds those edges of `keys` that are not there yet, each with the value at its middle; returns them and their ends.
    fn look_at_edges(&mut self, mut keys: Vec<[u32; 2]>) -> Vec<([u32; 2], [Vertex; 2])> {
        let mut is_first = FxHashSet::default();
        keys.retain(|key| !self.edges.contains_key(key) && is_first.insert(*key));
        let edges = keys
            .into_iter()
            .map(|key| (key, key.map(|index| self.get(index))));
        let edges: Vec<_> = edges.collect();
        let middles = edges.iter().map(|(_, [a, b])| {
            let sum = a.direction + b.direction;
            sum.try_normalize().unwrap_or(a.direction)
        });
        let middles = self.look(&middles.collect::<Vec<_>>());
        for ((key, _), middle) in edges.iter().zip(middles) {
            let edge = Edge {
                middle,
                index: None,
            };
            self.edges.insert(*key, edge);
        }
        edges
    }

    fn halve_all(&mut self, keys: Vec<[u32; 2]>) {
        self.look_at_edges(keys.clone());
        for key in keys {
            self.halve(key);
        }
    }

    /// Halves an edge that has been looked at.
    fn halve(&mut self, key: [u32; 2]) {
        if let Some(edge) = self.edges.get_mut(&key)
            && edge.index.is_none()
        {
            edge.index = Some(self.vertices.len() as u32);
            self.vertices.push(edge.middle);
        }
    }

    fn middle_of(&self, key: [u32; 2]) -> Option<u32> {
        self.edges.get(&key).and_then(|edge| edge.index)
    }

    fn longest_side(&self, corners: [u32; 3]) -> ([u32; 2], f64) {
        let length2 =
            |[a, b]: [u32; 2]| (self.get(a).direction - self.get(b).direction).length_squared();
        let [first, rest @ ..] = sides(corners);
        rest.into_iter()
            .fold((first, length2(first)), |(best, longest), side| {
                let length2 = length2(side);
                if length2 > longest {
                    (side, length2)
                } else {
                    (best, longest)
                }
            })
    }

    fn halve_crowded_triangles(&mut self) {
        let crowded: Vec<[u32; 2]> = self
            .triangles
            .iter()
            .filter(|t| {
                t.seeds.len() >= SEEDS_TO_SPLIT
                    && self.longest_side(t.corners).1 > SHORTEST * SHORTEST
            })
            .flat_map(|t| sides(t.corners))
            .collect();
        self.halve_all(crowded);
    }

    /// Halves the longest edge of every triangle that has a halved edge, so that no triangle becomes a sliver.
    fn close_over_longest_edges(&mut self) {
        loop {
            let open: Vec<[u32; 2]> = self
                .triangles
                .iter()
                .filter(|t| {
                    sides(t.corners)
                        .into_iter()
                        .any(|key| self.middle_of(key).is_some())
                })
                .map(|t| self.longest_side(t.corners).0)
                .filter(|key| self.middle_of(*key).is_none())
                .collect();
            if open.is_empty() {
                return;
            }
            self.halve_all(open);
        }
    }

    /// Divides each triangle by its halved edges. Returns whether there was any.
    fn divide_triangles(&mut self) -> bool {
        let old = std::mem::take(&mut self.triangles);
        let before = old.len();
        let mut divided = Vec::with_capacity(2 * before);
        for triangle in old {
            let [a, b, c] = triangle.corners;
            let middles = [[a, b], [b, c], [c, a]].map(|ends| self.middle_of(key_of(ends)));
            let parts = divide([a, b, c], middles, self.longest_side(triangle.corners).0);
            if let [whole] = parts[..] {
                divided.push(Triangle {
                    corners: whole,
                    ..triangle
                });
                continue;
            }
            let start = divided.len();
            divided.extend(parts.iter().map(|corners| Triangle {
                corners: *corners,
                seeds: Vec::new(),
                is_new: true,
            }));
            for seed in triangle.seeds {
                let best = divided.iter_mut().skip(start).max_by(|x, y| {
                    self.insideness(x.corners, seed)
                        .total_cmp(&self.insideness(y.corners, seed))
                });
                if let Some(part) = best {
                    part.seeds.push(seed);
                }
            }
        }
        self.triangles = divided;
        self.triangles.len() > before
    }

    /// Positive where `w` lies inside the triangle, negative outside: the smallest of the distances from its sides.
    fn insideness(&self, [a, b, c]: [u32; 3], w: DVec3) -> f64 {
        let [a, b, c] = [a, b, c].map(|index| self.get(index).direction);
        // Each side's plane contains the origin; differences keep the digits of tiny triangles.
        let beyond = |p: DVec3, q: DVec3| {
            let normal = p.cross(q - p);
            (w - p).dot(normal) / normal.length().max(f64::MIN_POSITIVE)
        };
        beyond(a, b).min(beyond(b, c)).min(beyond(c, a))
    }
}

fn largest(value: [f64; 3]) -> f64 {
    value.into_iter().fold(0.0, f64::max)
}

/// The key of the edge between two vertices, whichever way it is walked.
pub(super) fn key_of([a, b]: [u32; 2]) -> [u32; 2] {
    if a < b { [a, b] } else { [b, a] }
}

fn sides([a, b, c]: [u32; 3]) -> [[u32; 2]; 3] {
    [key_of([a, b]), key_of([b, c]), key_of([c, a])]
}

/// The parts of triangle `[a, b, c]` whose edges ab, bc, ca have these middles; with two middles the quadrilateral is
/// cut from the middle of the `longest` edge.
fn divide([a, b, c]: [u32; 3], middles: [Option<u32>; 3], longest: [u32; 2]) -> Vec<[u32; 3]> {
    match middles {
        [None, None, None] => vec![[a, b, c]],
        [Some(ab), Some(bc), Some(ca)] => vec![[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]],
        [Some(m), None, None] => vec![[a, m, c], [m, b, c]],
        [Some(first), Some(second), None] => {
            if longest == key_of([a, b]) {
                vec![[first, b, second], [first, second, c], [first, c, a]]
            } else {
                vec![[first, b, second], [second, c, a], [second, a, first]]
            }
        }
        // The same triangle, named from another corner.
        [first, second, third] => divide([b, c, a], [second, third, first], longest),
    }
}
