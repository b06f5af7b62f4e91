//! How the lobes look: bodies, shells or edges, and the lines on them.

use glam::Vec3;

use super::isolines::{self, Isoline};
use super::level;
use super::shadow::Shadow;
use super::surface::{DrawnLobe, Lobes, Part};
use crate::scene3d::{Rgba, Scene, Vertex};
use crate::theme::{self, Palette};
use bxdf_study::session::{LobeSurface, Session};

/// Width of the line inside a lobe, in points.
const SPINE_WIDTH: f32 = 1.5;

/// A lobe has a line inside where its outer half is thinner than this, in world units: two pixels of a dome that fills a
/// window.
const NEEDLE: f32 = 0.008;

/// Width of the edges of a mesh, in points.
const WIRE_WIDTH: f32 = 1.0;

/// Width of lines of equal value, in points, and of those between: finer than a pixel, they are fainter.
const ISOLINE_WIDTH: f32 = 1.1;
const MINOR_WIDTH: f32 = 0.5;

/// Width of the curve that the section cuts out of a lobe, in points.
const CUT_WIDTH: f32 = 2.0;

/// Width of the halo that keeps it apart from what is behind it, in points.
const HALO_WIDTH: f32 = 4.5;

/// How a lobe is drawn.
#[derive(Clone, Copy, PartialEq)]
enum Look {
    /// As a body that hides what is behind it.
    Body,
    /// As a skin of this alpha with an outline.
    Shell(u8),
    /// As the edges of its mesh.
    Wire,
}

impl Lobes {
    /// Every lobe, with how the session has it drawn: by itself the selected one as a body and the others as shells about it.
    fn looks(&self, session: &Session) -> impl Iterator<Item = (&Part, &DrawnLobe, Look)> {
        let selected = session.materials.selected().id();
        let is_overlay = self.all.len() > 1;
        let see_through = Look::Shell(theme::SEE_THROUGH_ALPHA);
        let look = move |part: &Part| match session.lobe_surface {
            LobeSurface::Wire => Look::Wire,
            LobeSurface::Translucent => see_through,
            LobeSurface::Automatic if is_overlay && part.material != selected => {
                Look::Shell(theme::SHELL_ALPHA)
            }
            // What is drawn inside has to show.
            _ if session.show_geometry => see_through,
            LobeSurface::Automatic | LobeSurface::Solid => Look::Body,
        };
        self.all
            .iter()
            .map(move |(part, lobe)| (part, lobe, look(part)))
    }

    /// The lobe that is explained in detail: the selected one, or the only one.
    fn main(&self, session: &Session) -> Option<&(Part, DrawnLobe)> {
        let selected = session.materials.selected().id();
        let is_selected = |(part, _): &&(Part, DrawnLobe)| part.material == selected;
        let found = self.all.iter().find(is_selected);
        found.or_else(|| self.all.first().filter(|_| self.all.len() == 1))
    }

    /// The tip of the longest radius of the main lobe.
    pub(super) fn axis(&self, session: &Session) -> Option<Vec3> {
        let (_, lobe) = self.main(session)?;
        lobe.highest().map(|(_, tip)| tip)
    }

    /// Adds the lobes as the session has them drawn.
    pub(super) fn add_to(&self, scene: &mut Scene, session: &Session) {
        for (part, lobe, look) in self.looks(session) {
            lobe.add_to(scene, look, theme::rgba(part.color, u8::MAX));
        }
    }

    /// The shadow of the bodies.
    pub(super) fn shadow(&self, session: &Session) -> Shadow {
        let bodies = self
            .looks(session)
            .filter(|(_, _, look)| *look == Look::Body);
        Shadow::of(bodies.flat_map(|(_, lobe, _)| {
            let corners = |triangle: &[u32; 3]| triangle.map(|index| lobe.tip(index));
            lobe.triangles.iter().map(corners)
        }))
    }

    /// Adds the lines of equal value of the main lobe, and returns them.
    pub(super) fn add_isolines(
        &self,
        scene: &mut Scene,
        session: &Session,
        palette: &Palette,
    ) -> Vec<Isoline> {
        let Some((_, lobe)) = self.main(session) else {
            return Vec::new();
        };
        if session.lobe_surface == LobeSurface::Wire {
            return Vec::new();
        }
        let lines = isolines::of(lobe, self.lengths, lobe.full);
        for line in &lines {
            let width = if line.is_minor {
                MINOR_WIDTH
            } else {
                ISOLINE_WIDTH
            };
            for piece in &line.pieces {
                scene.add_polyline(piece, palette.isoline, width);
            }
        }
        lines
    }

    /// Adds the curve that the session's section cuts out of the main lobe: the curve of the polar plot.
    pub(super) fn add_cut(&self, scene: &mut Scene, session: &Session, palette: &Palette) {
        if let Some((part, lobe)) = self.main(session) {
            for line in cut(part, lobe, session) {
                let [core, halo] = palette.cut;
                scene.add_polyline(&line, core, CUT_WIDTH);
                scene.add_polyline(&line, halo, HALO_WIDTH);
            }
        }
    }
}

/// Where the session's section meets the surface of a lobe.
fn cut(part: &Part, lobe: &DrawnLobe, session: &Session) -> Vec<Vec<Vec3>> {
    let (sin, cos) = session.section().phi().sin_cos();
    let beside = part.mesh.vertices.iter().map(|vertex| {
        let w = vertex.direction;
        let distance = w.y * cos - w.x * sin;
        // On which side a corner of the plane itself lies is not for rounding to say.
        if distance.abs() < 1e-12 {
            0.0
        } else {
            distance
        }
    });
    let beside: Vec<f64> = beside.collect();
    level::lines(&lobe.triangles, &beside, 0.0, |edge, part| {
        lobe.on_edge(edge, part)
    })
}

impl DrawnLobe {
    fn add_to(&self, scene: &mut Scene, look: Look, color: Rgba) {
        match look {
            Look::Body => {
                let vertices = self.vertices(color);
                scene.bodies.append(&vertices, self.indices());
            }
            Look::Shell(alpha) => {
                let [r, g, b, _] = color;
                let vertices = self.vertices([r, g, b, alpha]);
                scene.shells.append(&vertices, self.indices());
            }
            Look::Wire => self.add_wire(scene, color),
        }
        self.add_spine(scene, color);
    }

    fn indices(&self) -> impl Iterator<Item = u32> {
        self.triangles.iter().copied().flatten()
    }

    /// The vertices, for smooth shading.
    fn vertices(&self, color: Rgba) -> Vec<Vertex> {
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
            .map(|(tip, normal)| Vertex {
                position: tip.to_array(),
                normal: normal.normalize_or_zero().to_array(),
                color,
            })
            .collect()
    }

    /// Every edge once: the triangles on its sides run along it in opposite directions.
    fn add_wire(&self, scene: &mut Scene, color: Rgba) {
        for [a, b, c] in &self.triangles {
            for (from, to) in [(a, b), (b, c), (c, a)] {
                if from < to {
                    scene.add_line(self.tip(*from), self.tip(*to), color, WIRE_WIDTH);
                }
            }
        }
    }

    /// A line to the highest tip of a lobe that is about as thin as a pixel: it is what remains to be seen.
    fn add_spine(&self, scene: &mut Scene, color: Rgba) {
        let Some((_, tip)) = self.highest() else {
            return;
        };
        let axis = tip.normalize_or_zero();
        let is_outer = |point: &&Vec3| point.dot(axis) > 0.5 * tip.length();
        let aside = |point: &Vec3| point.reject_from_normalized(axis).length();
        let width = self
            .tips
            .iter()
            .filter(is_outer)
            .map(aside)
            .fold(0.0, f32::max);
        if width < NEEDLE {
            scene.add_line(Vec3::ZERO, tip, color, SPINE_WIDTH);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::surface::LARGEST_RADIUS;
    use super::*;
    use bxdf_lab::analysis::{Channel, RadialScale, polar};
    use bxdf_study::answers::Answers;
    use bxdf_study::views;

    fn session(material: &str) -> Session {
        Session::of(material.parse().unwrap())
    }

    #[test]
    fn a_wire_has_every_edge_once() {
        let mut session = Session::of("lambertian_reflection".parse().unwrap());
        session.lobe_surface = LobeSurface::Wire;
        let lobes = Lobes::of_session(&session, RadialScale::Linear);
        let mut scene = Scene::default();
        lobes.add_to(&mut scene, &session);
        assert!(scene.bodies.indices.is_empty() && scene.shells.indices.is_empty());
        let (_, lobe) = &lobes.all[0];
        let edges = scene.lines.len();
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

    /// How far `point` is from the nearest of these lines.
    fn distance(point: Vec3, lines: &[Vec<Vec3>]) -> f32 {
        let of_piece = |pair: &[Vec3]| {
            let (from, along) = (pair[0], pair[1] - pair[0]);
            let part = (point - from).dot(along) / along.length_squared().max(1e-20);
            point.distance(from + along * part.clamp(0.0, 1.0))
        };
        let pieces = lines.iter().flat_map(|line| line.windows(2).map(of_piece));
        pieces.fold(f32::INFINITY, f32::min)
    }

    #[test]
    fn the_cut_is_the_curve_of_the_polar_plot() {
        let decades = RadialScale::Logarithmic { decades: 4.0 };
        for material in [
            "rough_conductor:alpha_x=0.1,alpha_y=0.4",
            "plastic",
            "lambertian_reflection",
        ] {
            for (section_phi_deg, scale, with_cosine) in [
                (None, RadialScale::Linear, false),
                (Some(25.0), decades, false),
                (None, RadialScale::Linear, true),
            ] {
                let session = Session {
                    section_phi_deg,
                    with_cosine,
                    ..session(material)
                };
                let lobes = Lobes::of_session(&session, scale);
                let (part, lobe) = lobes.main(&session).unwrap();
                let lines = cut(part, lobe, &session);
                let request = views::polar::Options {
                    scale: views::Scale::of(scale),
                    ..views::polar::Options::default()
                }
                .request(&session);
                let entry = session.materials.selected();
                let section = Answers::at_once().ask(&session, entry, request);
                let mut seen = 0;
                for point in &section.upper {
                    let value = Channel::Luminance.of(point.value);
                    let radius = LARGEST_RADIUS * scale.radius(value, lobe.full);
                    let tip = (polar::direction(point.angle, request.phi) * radius).as_vec3();
                    let off = distance(tip, &lines);
                    // The surface may leave the lobe by some thousandths.
                    assert!(off < 0.01, "{material} {scale:?}: {off} at {}", point.angle);
                    seen += usize::from(radius > 0.1);
                }
                assert!(seen > 3, "{material} {scale:?}");
            }
        }
    }

    #[test]
    fn of_several_the_selected_one_is_a_body() {
        let mut session = session("lambertian_reflection");
        let added = session
            .materials
            .add("rough_conductor".parse().unwrap())
            .unwrap();
        for (surface, bodies, shells) in [
            (LobeSurface::Automatic, 1, 1),
            (LobeSurface::Solid, 2, 0),
            (LobeSurface::Translucent, 0, 2),
            (LobeSurface::Wire, 0, 0),
        ] {
            session.lobe_surface = surface;
            let lobes = Lobes::of_session(&session, RadialScale::Linear);
            let looks: Vec<_> = lobes
                .looks(&session)
                .map(|(part, _, look)| (part.material, look))
                .collect();
            let count = |is: fn(&Look) -> bool| looks.iter().filter(|(_, look)| is(look)).count();
            assert_eq!(count(|look| *look == Look::Body), bodies, "{surface:?}");
            assert_eq!(
                count(|look| matches!(look, Look::Shell(_))),
                shells,
                "{surface:?}"
            );
        }
        session.lobe_surface = LobeSurface::Automatic;
        let lobes = Lobes::of_session(&session, RadialScale::Linear);
        let body = lobes
            .looks(&session)
            .find(|(_, _, look)| *look == Look::Body);
        assert_eq!(
            body.unwrap().0.material,
            added,
            "which was selected by being added"
        );
    }

    #[test]
    fn only_a_needle_has_a_line_inside() {
        for (material, lines) in [
            ("rough_conductor:alpha=0.001", 1),
            ("rough_conductor:alpha=0.2", 0),
        ] {
            let session = session(material);
            let mut scene = Scene::default();
            Lobes::of_session(&session, RadialScale::Linear).add_to(&mut scene, &session);
            assert_eq!(scene.lines.len(), lines, "{material}");
        }
    }
}
