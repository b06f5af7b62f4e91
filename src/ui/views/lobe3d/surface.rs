//! The lobes as they are drawn: the tips of its radii, and what a ray meets of them.

use std::sync::Arc;

use egui::Color32;
use glam::Vec3;

use crate::scene3d::Ray;
use bxdf_lab::analysis::lobe::Arrow;
use bxdf_lab::analysis::lobe3d::{self, Mesh};
use bxdf_lab::analysis::{Channel, RadialScale};
use bxdf_study::session::{EntryId, Session};

/// The largest radius of the lobe: a little less than the dome's, or the two surfaces would flicker into each other.
pub(super) const LARGEST_RADIUS: f64 = 0.96;

/// Of several lobes, those that are longer than this share of the longest radius have their name at the tip: the names
/// of the others would hide them.
const SHORTEST_NAMED: f64 = 0.35;

/// A material as the view shows it.
pub(super) struct Part {
    pub(super) material: EntryId,
    pub(super) title: String,
    pub(super) color: Color32,
    pub(super) mesh: Arc<Mesh>,
    pub(super) arrows: Arc<Vec<Arrow>>,
}

/// The lobes of all materials shown.
#[derive(Default)]
pub(super) struct Lobes {
    pub(super) all: Vec<(Part, DrawnLobe)>,
    /// In proportion, or by decades.
    pub(super) lengths: RadialScale,
    /// The value of the full radius, where all share it.
    full: Option<f64>,
}

impl Lobes {
    /// The lobes of `parts` on these scales.
    pub(super) fn of(parts: Vec<Part>, session: &Session, scales: &Scales) -> Self {
        let lobe = |(index, part): (usize, Part)| {
            let full = scales.full_of(index);
            let values = shown_values(&part.mesh, session);
            let radii = values.map(|value| scales.lengths.radius(value, full));
            let lobe = DrawnLobe::of(&part.mesh, radii.collect(), full);
            (part, lobe)
        };
        Self {
            all: parts.into_iter().enumerate().map(lobe).collect(),
            lengths: scales.lengths,
            full: scales.shared(),
        }
    }

    /// The luminance (times the cosine, if shown so) of the full radius, in 1/sr, where all lobes share it.
    pub(super) fn full(&self) -> Option<f64> {
        self.full
    }

    /// The longest radius of each lobe.
    pub(super) fn radii(&self) -> impl Iterator<Item = (EntryId, f64)> {
        self.all.iter().map(|(part, lobe)| {
            let highest = lobe.highest().map_or(0.0, |(radius, _)| radius);
            (part.material, highest)
        })
    }

    /// Every delta with the colour of its material.
    pub(super) fn arrows(&self) -> impl Iterator<Item = (Color32, &Arrow)> {
        let of = |part: &'_ Part| part.color;
        self.all
            .iter()
            .flat_map(move |(part, _)| part.arrows.iter().map(move |arrow| (of(part), arrow)))
    }

    /// The tips of the longer lobes where there are several, with their names.
    pub(super) fn names(&self) -> impl Iterator<Item = (&str, Color32, Vec3)> {
        let is_overlay = self.all.len() > 1;
        self.all
            .iter()
            .filter(move |_| is_overlay)
            .filter_map(|(part, lobe)| {
                let (_, tip) = lobe
                    .highest()
                    .filter(|(radius, _)| *radius > SHORTEST_NAMED)?;
                Some((part.title.as_str(), part.color, tip))
            })
    }

    /// How far along `ray`, in units of its direction, the first lobe is met, and whose it is.
    pub(super) fn hit(&self, ray: &Ray) -> Option<(f32, EntryId)> {
        self.all
            .iter()
            .filter_map(|(part, lobe)| Some((lobe.hit(ray)?, part.material)))
            .min_by(|a, b| a.0.total_cmp(&b.0))
    }
}

/// What the radii of a mesh stand for, vertex by vertex.
fn shown_values<'a>(mesh: &'a Mesh, session: &Session) -> impl Iterator<Item = f64> + use<'a> {
    let with_cosine = session.with_cosine;
    let shown = move |vertex: &lobe3d::Vertex| {
        let cosine = if with_cosine {
            vertex.direction.z.abs()
        } else {
            1.0
        };
        Channel::Luminance.of(vertex.value) * cosine
    };
    mesh.vertices.iter().map(shown)
}

/// The largest value of a mesh.
pub(super) fn peak(mesh: &Mesh, session: &Session) -> f64 {
    shown_values(mesh, session).fold(0.0, f64::max)
}

/// Which value has the full radius.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Scales {
    /// In proportion, or by decades.
    pub(super) lengths: RadialScale,
    /// The value: one for all lobes, or one for each.
    pub(super) full: Full,
}

/// The value at the full radius.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Full {
    /// That of all lobes; 0 where all are 0.
    Shared(f64),
    /// Those of the lobes, in their order.
    Each(Vec<f64>),
}

impl Scales {
    fn full_of(&self, lobe: usize) -> f64 {
        match &self.full {
            Full::Shared(full) => *full,
            Full::Each(all) => all.get(lobe).copied().unwrap_or(0.0),
        }
    }

    /// Those of one of the lobes, by itself.
    pub(super) fn of_one(&self, lobe: usize) -> Self {
        let full = match self.full {
            Full::Shared(full) => Full::Shared(full),
            Full::Each(_) => Full::Each(vec![self.full_of(lobe)]),
        };
        Self { full, ..*self }
    }

    /// The value at the full radius of one of the lobes, where that is its own.
    pub(super) fn own_of(&self, lobe: usize) -> Option<f64> {
        matches!(self.full, Full::Each(_)).then(|| self.full_of(lobe))
    }

    pub(super) fn shared(&self) -> Option<f64> {
        match self.full {
            Full::Shared(full) if full > 0.0 => Some(full),
            _ => None,
        }
    }
}

/// A lobe's surface in the scene's coordinates.
pub(super) struct DrawnLobe {
    /// Relative radii, 0..1, vertex by vertex.
    pub(super) radii: Vec<f64>,
    pub(super) tips: Vec<Vec3>,
    pub(super) triangles: Vec<[u32; 3]>,
    /// The value of the full radius.
    pub(super) full: f64,
    /// The corners of the box about the tips.
    bounds: [Vec3; 2],
}

impl DrawnLobe {
    /// `mesh` with these radii, 0..1, vertex by vertex, 1 where the value is `full`.
    fn of(mesh: &Mesh, radii: Vec<f64>, full: f64) -> Self {
        let tips: Vec<Vec3> = mesh
            .vertices
            .iter()
            .zip(&radii)
            .map(|(vertex, radius)| (vertex.direction * (LARGEST_RADIUS * radius)).as_vec3())
            .collect();
        let least = tips.iter().copied().fold(Vec3::ZERO, Vec3::min);
        let most = tips.iter().copied().fold(Vec3::ZERO, Vec3::max);
        let mut lobe = Self {
            radii,
            tips,
            triangles: Vec::new(),
            full,
            bounds: [least, most],
        };
        // Triangles that have shrunk into the centre show nothing and would spoil the normals.
        let is_seen =
            |triangle: &[u32; 3]| triangle.iter().any(|index| lobe.tip(*index) != Vec3::ZERO);
        lobe.triangles = mesh.triangles.iter().copied().filter(is_seen).collect();
        lobe
    }

    pub(super) fn tip(&self, index: u32) -> Vec3 {
        self.tips.get(index as usize).copied().unwrap_or_default()
    }

    /// The place on the edge between two corners, this part of the way from the first to the second.
    pub(super) fn on_edge(&self, [a, b]: [u32; 2], part: f32) -> Vec3 {
        self.tip(a).lerp(self.tip(b), part)
    }

    /// The longest radius and its tip; `None` for a lobe that is 0 everywhere.
    pub(super) fn highest(&self) -> Option<(f64, Vec3)> {
        self.radii
            .iter()
            .copied()
            .zip(self.tips.iter().copied())
            .max_by(|a, b| a.0.total_cmp(&b.0))
            .filter(|(radius, _)| *radius > 0.0)
    }

    /// How far along `ray`, in units of its direction, the surface is first met (Moeller & Trumbore 1997).
    pub(super) fn hit(&self, ray: &Ray) -> Option<f32> {
        if !ray.meets_box(self.bounds) {
            return None;
        }
        let distance = |triangle: &[u32; 3]| {
            let [a, b, c] = triangle.map(|index| self.tip(index));
            let (ab, ac) = (b - a, c - a);
            let p = ray.direction.cross(ac);
            let determinant = ab.dot(p);
            let from_a = ray.origin - a;
            let q = from_a.cross(ab);
            let (u, v) = (
                from_a.dot(p) / determinant,
                ray.direction.dot(q) / determinant,
            );
            let t = ac.dot(q) / determinant;
            // A triangle seen edge-on divides by 0; NaN fails every comparison.
            (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0).then_some(t)
        };
        self.triangles
            .iter()
            .filter_map(distance)
            .min_by(f32::total_cmp)
    }
}

#[cfg(test)]
impl Lobes {
    /// The lobes that `session` shows, with these lengths.
    pub(super) fn of_session(session: &Session, lengths: RadialScale) -> Self {
        let mut answers = bxdf_study::answers::Answers::at_once();
        let options = bxdf_study::views::lobe3d::Options {
            scale: bxdf_study::views::Scale::of(lengths),
            ..Default::default()
        };
        let part = |entry: &bxdf_study::session::MaterialEntry| Part {
            material: entry.id(),
            title: entry.title(),
            color: Color32::WHITE,
            mesh: answers.ask(session, entry, options.request(session)),
            arrows: answers.ask(session, entry, bxdf_lab::analysis::deltas::Arrows),
        };
        let parts: Vec<Part> = session.materials.shown().map(part).collect();
        let peaks = parts.iter().map(|part| peak(&part.mesh, session));
        let full = Full::Shared(peaks.fold(0.0, f64::max));
        Self::of(parts, session, &Scales { lengths, full })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn several_lobes_share_the_scale_and_the_nearest_is_met() {
        let mut session = Session::of("lambertian_reflection".parse().unwrap());
        let dark = "lambertian_reflection:reflectance=0.2".parse().unwrap();
        let dark = session.materials.add(dark).unwrap();
        let lobes = Lobes::of_session(&session, RadialScale::Linear);
        let outer = session.materials.iter().next().unwrap().id();
        let up = Ray {
            origin: Vec3::new(0.1, 0.05, -1.0),
            direction: Vec3::Z,
        };
        let inward = Ray {
            origin: Vec3::new(0.1, 0.05, 0.5),
            direction: Vec3::NEG_Z,
        };
        assert!((lobes.full().unwrap() - 0.8 / std::f64::consts::PI).abs() < 1e-12);
        assert_eq!(lobes.hit(&inward).unwrap().1, dark, "a quarter as long");
        let down = Ray {
            origin: Vec3::new(0.1, 0.05, 3.0),
            direction: Vec3::NEG_Z,
        };
        assert_eq!(lobes.hit(&down).unwrap().1, outer);
        assert!(lobes.hit(&up).is_some());
        let names: Vec<&str> = lobes.names().map(|(name, ..)| name).collect();
        assert_eq!(names, ["Lambertian reflection"], "the other one is short");
    }

    #[test]
    fn a_ray_meets_a_lambertian_lobe_where_it_should() {
        let session = Session::of("lambertian_reflection".parse().unwrap());
        let lobes = Lobes::of_session(&session, RadialScale::Linear);
        assert!((lobes.full().unwrap() - 0.8 / std::f64::consts::PI).abs() < 1e-12);
        let down = Ray {
            origin: Vec3::new(0.1, 0.05, 3.0),
            direction: Vec3::NEG_Z,
        };
        // The half sphere of radius .96, less the sagitta of a triangle of 5.6 degrees.
        let expected = 3.0 - (0.96_f32 * 0.96 - 0.0125).sqrt();
        assert!((lobes.hit(&down).unwrap().0 - expected).abs() < 3e-3);
        let beside = Ray {
            origin: Vec3::new(2.0, 0.0, 3.0),
            direction: Vec3::NEG_Z,
        };
        assert!(lobes.hit(&beside).is_none());
    }
}
