//! The lobes as they are drawn: the tips of its radii, and what a ray meets of them.

use std::sync::Arc;

use egui::Color32;
use glam::Vec3;

use crate::scene3d::{Ray, Rgba, Scene, Surface, Vertex};
use crate::theme;
use bxdf_lab::analysis::lobe::Arrow;
use bxdf_lab::analysis::lobe3d::{self, Mesh};
use bxdf_lab::analysis::{Channel, RadialScale};
use bxdf_study::session::{EntryId, LobeSurface, Session};

/// The largest radius of the lobe: a little less than the dome's, or the two surfaces would flicker into each other.
const LARGEST_RADIUS: f64 = 0.96;

/// Width of the line inside the lobe, in points.
const SPINE_WIDTH: f32 = 1.5;

/// Width of the edges of a mesh, in points.
const WIRE_WIDTH: f32 = 1.0;

/// Of several lobes, those that are longer than this share of the longest radius have their name at the tip: the names
/// of the others would hide them.
const SHORTEST_NAMED: f64 = 0.35;

/// Where the light comes from that shades what is drawn unlit, a unit vector.
const LIGHT: Vec3 = Vec3::new(0.36, 0.48, 0.8);

/// A material as the view shows it.
pub(super) struct Part {
    pub(super) material: EntryId,
    pub(super) title: String,
    pub(super) color: Color32,
    pub(super) mesh: Arc<Mesh>,
    pub(super) arrows: Arc<Vec<Arrow>>,
}

/// The lobes of all materials shown.
pub(super) struct Lobes {
    all: Vec<(Part, DrawnLobe)>,
    full: Option<f64>,
}

impl Lobes {
    /// The lobes of `parts` on these scales.
    pub(super) fn of(parts: Vec<Part>, session: &Session, scales: &Scales) -> Self {
        let lobe = |(index, part): (usize, Part)| {
            let full = scales.full_of(index);
            let values = shown_values(&part.mesh, session);
            let radii = values.map(|value| scales.lengths.radius(value, full));
            let lobe = DrawnLobe::of(&part.mesh, radii.collect());
            (part, lobe)
        };
        Self {
            all: parts.into_iter().enumerate().map(lobe).collect(),
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

    /// Adds the lobes as the session has them drawn: one alone in the colours of its values, several in their own.
    pub(super) fn add_to(&self, scene: &mut Scene, session: &Session) {
        let is_overlay = self.all.len() > 1;
        let style = match session.lobe_surface {
            LobeSurface::Automatic if is_overlay => LobeSurface::Translucent,
            // What is drawn inside has to show.
            LobeSurface::Automatic | LobeSurface::Solid if session.show_geometry => {
                LobeSurface::Translucent
            }
            style => style,
        };
        for (part, lobe) in &self.all {
            let color = is_overlay.then(|| theme::rgba(part.color, u8::MAX));
            lobe.add_to(scene, style, color);
        }
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

    pub(super) fn shared(&self) -> Option<f64> {
        match self.full {
            Full::Shared(full) if full > 0.0 => Some(full),
            _ => None,
        }
    }
}

/// A lobe's surface in the scene's coordinates.
struct DrawnLobe {
    /// Relative radii, 0..1, vertex by vertex.
    radii: Vec<f64>,
    tips: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
    /// The corners of the box about the tips.
    bounds: [Vec3; 2],
}

impl DrawnLobe {
    /// `mesh` with these radii, 0..1, vertex by vertex.
    fn of(mesh: &Mesh, radii: Vec<f64>) -> Self {
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
            bounds: [least, most],
        };
        // Triangles that have shrunk into the centre show nothing and would spoil the normals.
        let is_seen =
            |triangle: &[u32; 3]| triangle.iter().any(|index| lobe.tip(*index) != Vec3::ZERO);
        lobe.triangles = mesh.triangles.iter().copied().filter(is_seen).collect();
        lobe
    }

    fn tip(&self, index: u32) -> Vec3 {
        self.tips.get(index as usize).copied().unwrap_or_default()
    }

    /// The colours of the vertices: of their values, or all of one colour.
    fn colors(&self, color: Option<Rgba>) -> impl Iterator<Item = Rgba> {
        let of = move |radius: &f64| color.unwrap_or_else(|| theme::viridis(*radius));
        self.radii.iter().map(of)
    }

    /// Adds the surface, coloured by radius if not all of one `color`.
    fn add_to(&self, scene: &mut Scene, style: LobeSurface, color: Option<Rgba>) {
        match style {
            LobeSurface::Automatic | LobeSurface::Solid => {
                let vertices = self.vertices(self.colors(color));
                self.append(&mut scene.opaque, &vertices);
            }
            LobeSurface::Translucent => {
                let mut vertices = self.vertices(self.colors(color));
                for vertex in &mut vertices {
                    // Translucent surfaces are drawn unlit: of one colour, their shape would not show.
                    if color.is_some() {
                        let light = Vec3::from_array(vertex.normal).dot(LIGHT).abs();
                        vertex.color = theme::shaded(vertex.color, light.min(1.0));
                    }
                    vertex.color[3] = theme::SEE_THROUGH_ALPHA;
                }
                self.append(&mut scene.translucent, &vertices);
            }
            LobeSurface::Wire => self.add_wire(scene, color),
        }
        self.add_spine(scene, color);
    }

    fn append(&self, surface: &mut Surface, vertices: &[Vertex]) {
        surface.append(vertices, self.triangles.iter().copied().flatten());
    }

    /// The vertices, for smooth shading.
    fn vertices(&self, colors: impl Iterator<Item = Rgba>) -> Vec<Vertex> {
        let mut normals = vec![Vec3::ZERO; self.tips.len()];
        for triangle in &self.triangles {
            let [a, b, c] = triangle.map(|index| self.tip(index));
            // Twice the area along the normal: large triangles count for more.
            let normal = (b - a).cross(c - a);
            for index in triangle {
                if let Some(sum) = normals.get_mut(*index as usize) {
                    *sum += normal;
                }
            }
        }
        self.tips
            .iter()
            .zip(&normals)
            .zip(colors)
            .map(|((tip, normal), color)| Vertex {
                position: tip.to_array(),
                normal: normal.normalize_or_zero().to_array(),
                color,
            })
            .collect()
    }

    /// Every edge once: the triangles on its sides run along it in opposite directions.
    fn add_wire(&self, scene: &mut Scene, color: Option<Rgba>) {
        let colors: Vec<Rgba> = self.colors(color).collect();
        for [a, b, c] in &self.triangles {
            for (from, to) in [(a, b), (b, c), (c, a)] {
                if from < to {
                    let color = colors.get(*from as usize).copied().unwrap_or_default();
                    scene.add_line(self.tip(*from), self.tip(*to), color, WIRE_WIDTH);
                }
            }
        }
    }

    /// The longest radius and its tip; `None` for a lobe that is 0 everywhere.
    fn highest(&self) -> Option<(f64, Vec3)> {
        self.radii
            .iter()
            .copied()
            .zip(self.tips.iter().copied())
            .max_by(|a, b| a.0.total_cmp(&b.0))
            .filter(|(radius, _)| *radius > 0.0)
    }

    /// A line to the highest tip: inside a lobe of some width it is hidden, of a lobe thinner than a pixel it is what
    /// remains to be seen.
    fn add_spine(&self, scene: &mut Scene, color: Option<Rgba>) {
        if let Some((radius, tip)) = self.highest() {
            let color = color.unwrap_or_else(|| theme::viridis(radius));
            scene.add_line(Vec3::ZERO, tip, color, SPINE_WIDTH);
        }
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
mod tests {
    use super::*;
    use bxdf_lab::analysis::deltas::Arrows;
    use bxdf_study::answers::Answers;
    use bxdf_study::session::MaterialEntry;
    use bxdf_study::views::lobe3d::Options;

    fn lobes(session: &Session) -> Lobes {
        let mut answers = Answers::at_once();
        let part = |entry: &MaterialEntry| Part {
            material: entry.id(),
            title: entry.title(),
            color: Color32::WHITE,
            mesh: answers.ask(session, entry, Options::default().request(session)),
            arrows: answers.ask(session, entry, Arrows),
        };
        let parts: Vec<Part> = session.materials.shown().map(part).collect();
        let peaks = parts.iter().map(|part| peak(&part.mesh, session));
        let scales = Scales {
            lengths: RadialScale::Linear,
            full: Full::Shared(peaks.fold(0.0, f64::max)),
        };
        Lobes::of(parts, session, &scales)
    }

    #[test]
    fn several_lobes_share_the_scale_and_the_nearest_is_met() {
        let mut session = Session::of("lambertian_reflection".parse().unwrap());
        let dark = "lambertian_reflection:reflectance=0.2".parse().unwrap();
        let dark = session.materials.add(dark).unwrap();
        let lobes = lobes(&session);
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
    fn a_wire_has_every_edge_once() {
        let mut session = Session::of("lambertian_reflection".parse().unwrap());
        session.lobe_surface = LobeSurface::Wire;
        let lobes = lobes(&session);
        let mut scene = Scene::default();
        lobes.add_to(&mut scene, &session);
        assert!(scene.opaque.indices.is_empty() && scene.translucent.indices.is_empty());
        let (_, lobe) = &lobes.all[0];
        let edges = scene.lines.len() - 1;
        // Of a closed surface, three halves of the triangles; here it is open along the horizon.
        let closed = 3 * lobe.triangles.len() / 2;
        assert!(
            edges <= closed + 200 && edges + 200 >= closed,
            "{edges} {closed}"
        );
        let mut ends: Vec<_> = scene.lines.iter().map(|line| (line.a, line.b)).collect();
        ends.sort_by(|a, b| a.partial_cmp(b).unwrap());
        ends.dedup();
        assert_eq!(ends.len(), scene.lines.len());
    }

    #[test]
    fn a_ray_meets_a_lambertian_lobe_where_it_should() {
        let session = Session::of("lambertian_reflection".parse().unwrap());
        let lobes = lobes(&session);
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
