//! What a mesh shows, and what it is made of.

use glam::DVec3;

use crate::analysis::scale::RadialScale;

/// What a mesh shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Request {
    /// The radial scale for which the mesh is fine enough.
    pub scale: RadialScale,
    /// Whether the radius carries |cos(theta)| of the free direction.
    pub with_cosine: bool,
}

/// A vertex of the mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vertex {
    /// The free direction, a unit vector.
    pub direction: DVec3,
    /// f in 1/sr, per channel, without the cosine; in the horizon plane its limit from the mesh's side.
    pub value: [f64; 3],
}

/// The lobe over one hemisphere or both.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// The vertices; those in the horizon plane appear once for either side.
    pub vertices: Vec<Vertex>,
    /// Three indices into `vertices` each, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// The largest value of any channel (times the cosine, if asked for).
    pub peak: f64,
}

impl Mesh {
    /// The integral of f |cos(theta)| over solid angle, per channel: over each triangle the mean of its corners times
    /// its solid angle.
    #[must_use]
    pub fn integral(&self) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for corners in self
            .triangles
            .iter()
            .filter_map(|triangle| self.corners(*triangle))
        {
            let weight = solid_angle(corners.map(|v| v.direction)) / 3.0;
            for vertex in corners {
                let scale = weight * vertex.direction.z.abs();
                sum.iter_mut()
                    .zip(vertex.value)
                    .for_each(|(sum, f)| *sum += f * scale);
            }
        }
        sum
    }

    pub(super) fn corners(&self, [a, b, c]: [u32; 3]) -> Option<[Vertex; 3]> {
        let vertex = |index: u32| self.vertices.get(index as usize).copied();
        Some([vertex(a)?, vertex(b)?, vertex(c)?])
    }
}

/// The solid angle of a spherical triangle (Van Oosterom & Strackee 1983), accurate for tiny ones: the triple product
/// is taken of differences.
pub(super) fn solid_angle([a, b, c]: [DVec3; 3]) -> f64 {
    let triple = a.dot((b - a).cross(c - a)).abs();
    2.0 * triple.atan2(1.0 + a.dot(b) + b.dot(c) + c.dot(a))
}
