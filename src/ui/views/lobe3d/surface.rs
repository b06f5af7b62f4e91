//! The lobe as it is drawn: the tips of its radii, and what a ray meets of it.

use glam::{DVec3, Vec3};

use crate::analysis::Channel;
use crate::analysis::lobe3d::Mesh;
use crate::ui::scene3d::{Ray, Rgba, Scene, Vertex};
use crate::ui::session::Session;
use crate::ui::theme;

/// The largest radius of the lobe: a little less than the dome's, or the two surfaces would flicker into each other.
const LARGEST_RADIUS: f64 = 0.96;

/// Width of the line inside the lobe, in points.
const SPINE_WIDTH: f32 = 1.5;

/// The lobe's surface in the scene's coordinates.
#[derive(Default)]
pub(super) struct DrawnLobe {
    /// The luminance (times the cosine, if shown so) of the largest radius, in 1/sr.
    pub(super) peak: f64,
    /// Relative radii, 0..1, vertex by vertex.
    radii: Vec<f64>,
    tips: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
}

impl DrawnLobe {
    /// `mesh` on the session's scale.
    pub(super) fn of(mesh: &Mesh, session: &Session) -> Self {
        let shown = |direction: DVec3, value: [f64; 3]| {
            let cosine = if session.with_cosine {
                direction.z.abs()
            } else {
                1.0
            };
            Channel::Luminance.of(value) * cosine
        };
        let values: Vec<f64> = mesh
            .vertices
            .iter()
            .map(|v| shown(v.direction, v.value))
            .collect();
        let peak = values.iter().copied().fold(0.0, f64::max);
        let radii: Vec<f64> = values
            .iter()
            .map(|value| session.scale.radius(*value, peak))
            .collect();
        let tips: Vec<Vec3> = mesh
            .vertices
            .iter()
            .zip(&radii)
            .map(|(vertex, radius)| (vertex.direction * (LARGEST_RADIUS * radius)).as_vec3())
            .collect();
        let mut lobe = Self {
            peak,
            radii,
            tips,
            triangles: Vec::new(),
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

    /// Adds the surface, smoothly shaded and coloured by radius; `is_see_through`: so that what is inside shows.
    pub(super) fn add_to(&self, scene: &mut Scene, is_see_through: bool) {
        let alpha = if is_see_through {
            theme::SEE_THROUGH_ALPHA
        } else {
            u8::MAX
        };
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
        let vertices: Vec<Vertex> = self
            .tips
            .iter()
            .zip(&normals)
            .zip(&self.radii)
            .map(|((tip, normal), radius)| Vertex {
                position: tip.to_array(),
                normal: normal.normalize_or_zero().to_array(),
                color: with_alpha(theme::viridis(*radius), alpha),
            })
            .collect();
        let surface = if is_see_through {
            &mut scene.translucent
        } else {
            &mut scene.opaque
        };
        surface.append(&vertices, self.triangles.iter().copied().flatten());
        self.add_spine(scene);
    }

    /// A line to the highest tip: inside a lobe of some width it is hidden, of a lobe thinner than a pixel it is what
    /// remains to be seen.
    fn add_spine(&self, scene: &mut Scene) {
        let highest = self
            .radii
            .iter()
            .zip(&self.tips)
            .max_by(|a, b| a.0.total_cmp(b.0));
        if let Some((radius, tip)) = highest.filter(|(radius, _)| **radius > 0.0) {
            scene.add_line(Vec3::ZERO, *tip, theme::viridis(*radius), SPINE_WIDTH);
        }
    }

    /// How far along `ray`, in units of its direction, the surface is first met (Moeller & Trumbore 1997).
    pub(super) fn hit(&self, ray: &Ray) -> Option<f32> {
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

fn with_alpha([r, g, b, _]: Rgba, alpha: u8) -> Rgba {
    [r, g, b, alpha]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ui::data::Data;

    #[test]
    fn a_ray_meets_a_lambertian_lobe_where_it_should() {
        let session = Session {
            material: "lambertian_reflection".parse().unwrap(),
            ..Session::default()
        };
        let lobe = DrawnLobe::of(&Data::new(None).mesh(&session), &session);
        assert!((lobe.peak - 0.8 / std::f64::consts::PI).abs() < 1e-12);
        let down = Ray {
            origin: Vec3::new(0.1, 0.05, 3.0),
            direction: Vec3::NEG_Z,
        };
        // The half sphere of radius .96, less the sagitta of a triangle of 5.6 degrees.
        let expected = 3.0 - (0.96_f32 * 0.96 - 0.0125).sqrt();
        assert!((lobe.hit(&down).unwrap() - expected).abs() < 3e-3);
        let beside = Ray {
            origin: Vec3::new(2.0, 0.0, 3.0),
            direction: Vec3::NEG_Z,
        };
        assert!(lobe.hit(&beside).is_none());
    }
}
