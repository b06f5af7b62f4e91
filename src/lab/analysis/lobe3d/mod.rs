//! The 3D lobe's data: a triangle mesh over the sphere of directions that adapts to the lobe.
//!
//! The mesh starts as a subdivided octahedron, so that the horizon is made of edges and no triangle crosses it. Edges
//! are then halved where the lobe asks for it, and triangles divided by which of their edges are halved. Whether an
//! edge is halved depends on the edge alone, so neighbours agree and the surface has no cracks.

use super::lobe::{HeldLobe, Seeds};
use super::scale::RadialScale;
use super::{Detail, IsWanted, Pace, Query, Subject};
use builder::{Builder, UNIFORM_LEVELS};

mod builder;
mod surface;

pub use surface::{Mesh, Request, Vertex};

impl Query for Request {
    type Answer = Mesh;

    const PACE: Pace = Pace::CoarseFirst;

    fn answer(
        &self,
        subject: &Subject<'_>,
        detail: Detail,
        is_wanted: IsWanted<'_>,
    ) -> Option<Mesh> {
        mesh_while(&subject.lobe, self, detail, is_wanted)
    }
}

/// The mesh of `lobe` that `request` asks for: the hemispheres in which it is not 0.
#[must_use]
pub fn mesh(lobe: &HeldLobe<'_>, request: &Request) -> Mesh {
    mesh_while(lobe, request, Detail::Full, &|| true).unwrap_or_default()
}

/// [`mesh`] in this detail; `None` as soon as `is_wanted` says no.
#[must_use]
pub fn mesh_while(
    lobe: &HeldLobe<'_>,
    request: &Request,
    detail: Detail,
    is_wanted: IsWanted<'_>,
) -> Option<Mesh> {
    let refine = |builder: &mut Builder<'_>| builder.refine(detail, is_wanted);
    hemispheres(lobe, request, &lobe.seeds(), UNIFORM_LEVELS, refine)
}

/// The mesh whose edges are all halved `levels` times, wherever the lobe is: an edge is 90 degrees over 2^`levels` long.
#[must_use]
pub fn uniform(lobe: &HeldLobe<'_>, levels: u32) -> Mesh {
    let request = Request {
        scale: RadialScale::Linear,
        with_cosine: false,
    };
    let nowhere = Seeds {
        directions: Vec::new(),
        integral: 0.0,
    };
    hemispheres(lobe, &request, &nowhere, levels, |_| Some(())).unwrap_or_default()
}

/// The meshes of the hemispheres in which the lobe is not 0, as one, after `levels` halvings and what `refine` does then.
fn hemispheres(
    lobe: &HeldLobe<'_>,
    request: &Request,
    seeds: &Seeds,
    levels: u32,
    refine: impl Fn(&mut Builder<'_>) -> Option<()>,
) -> Option<Mesh> {
    let mut whole = Mesh::default();
    for is_upper in [true, false] {
        let mut builder = Builder::new(lobe, *request, is_upper, seeds, levels);
        if builder.is_empty() {
            continue;
        }
        refine(&mut builder)?;
        let first = whole.vertices.len() as u32;
        whole.peak = whole.peak.max(builder.peak);
        whole.vertices.extend(builder.vertices);
        whole.triangles.extend(
            builder
                .triangles
                .iter()
                .map(|t| t.corners.map(|index| index + first)),
        );
    }
    Some(whole)
}

#[cfg(test)]
mod tests {
    use std::collections::HashMap;

    use glam::DVec3;

    use super::builder::key_of;
    use super::surface::solid_angle;
    use super::*;
    use crate::analysis::reflectance::directional_hemispherical;
    use crate::analysis::{Hold, RadialScale};
    use bxdf::math::frame::direction_from_degrees;
    use bxdf::{Material, Scatterer};

    const REQUEST: Request = Request {
        scale: RadialScale::Linear,
        with_cosine: false,
    };

    fn built(material: &str) -> Box<dyn Scatterer<f64>> {
        material.parse::<Material>().unwrap().build()
    }

    #[test]
    fn the_mesh_integrates_to_the_reflectance_within_a_percent() {
        let cases = [
            ("rough_conductor:alpha=0.3", 30.0),
            ("rough_conductor:alpha=0.001", 60.0),
            ("rough_conductor:alpha=0.0001", 85.0),
            ("rough_conductor:alpha=0.0001", 0.0),
            ("rough_conductor:alpha_x=0.01,alpha_y=0.5", 45.0),
            ("retro_reflector:alpha=0.001", 60.0),
            ("retro_reflector:alpha=0.0001", 85.0),
            ("oren_nayar", 80.0),
            ("lambertian_reflection", 10.0),
            ("lambertian_transmission", 85.0),
        ];
        for (material, theta) in cases {
            let model = built(material);
            let held = direction_from_degrees(theta, 25.0);
            let mesh = mesh(&HeldLobe::new(&*model, Hold::Light, held), &REQUEST);
            let exact = directional_hemispherical(&*model, held, 1e-9);
            let exact = exact.reflection[0] + exact.transmission[0];
            let ratio = mesh.integral()[0] / exact;
            assert!(
                (ratio - 1.0).abs() < 0.01,
                "{material} {theta}: {ratio}, {} triangles",
                mesh.triangles.len()
            );
            assert!(
                mesh.triangles.len() < 60_000,
                "{material} {theta}: {} triangles",
                mesh.triangles.len()
            );
        }
    }

    #[test]
    fn the_mesh_has_no_cracks_and_no_vertex_twice() {
        let model = built("rough_conductor:alpha_x=0.01,alpha_y=0.2");
        let mesh = mesh(
            &HeldLobe::new(&*model, Hold::Light, direction_from_degrees(70.0, 25.0)),
            &REQUEST,
        );
        let mut uses: HashMap<[u32; 2], i32> = HashMap::new();
        for [a, b, c] in &mesh.triangles {
            for [from, to] in [[*a, *b], [*b, *c], [*c, *a]] {
                *uses.entry(key_of([from, to])).or_default() += if from < to { 1 } else { -1 };
            }
        }
        // Each inner edge is walked once either way; the edges walked once only are the horizon's.
        let horizon = |index: u32| mesh.vertices[index as usize].direction.z == 0.0;
        for ([a, b], balance) in uses {
            assert!(
                balance == 0 || (horizon(a) && horizon(b)),
                "edge {a} {b} is open"
            );
        }
        for vertex in &mesh.vertices {
            assert!((vertex.direction.length() - 1.0).abs() < 1e-12 && vertex.direction.z >= 0.0);
        }
    }

    #[test]
    fn the_plotted_maximum_is_the_true_one_within_a_percent() {
        for (alpha, theta) in [("0.001", 60.0), ("0.0001", 85.0), ("0.05", 20.0)] {
            let model = built(&format!("rough_conductor:alpha={alpha}"));
            let lobe = HeldLobe::new(&*model, Hold::Light, direction_from_degrees(theta, 0.0));
            let request = crate::analysis::polar::Request {
                phi: 0.0,
                with_cosine: false,
                scale: RadialScale::Linear,
            };
            // The lobe is symmetric about the plane of incidence, and the section's maximum has its own test.
            let section = crate::analysis::polar::section(&lobe, &request);
            let ratio = mesh(&lobe, &REQUEST).peak / section.peak;
            assert!((ratio - 1.0).abs() < 0.01, "{alpha} {theta}: {ratio}");
        }
    }

    #[test]
    fn each_half_measures_two_pi_and_faces_outwards() {
        for (material, is_upper) in [
            ("lambertian_reflection", true),
            ("lambertian_transmission", false),
        ] {
            let model = built(material);
            let mesh = mesh(&HeldLobe::new(&*model, Hold::Light, DVec3::Z), &REQUEST);
            let corners = |t: &[u32; 3]| mesh.corners(*t).unwrap().map(|v| v.direction);
            let area: f64 = mesh.triangles.iter().map(|t| solid_angle(corners(t))).sum();
            assert!(
                (area - 2.0 * std::f64::consts::PI).abs() < 1e-10,
                "{material}: {area}"
            );
            assert!(mesh.vertices.iter().all(|v| if is_upper {
                v.direction.z >= 0.0
            } else {
                v.direction.z <= 0.0
            }));
            for [a, b, c] in mesh.triangles.iter().map(corners) {
                assert!((b - a).cross(c - a).dot(a) > 0.0, "{material}");
            }
        }
    }
}
