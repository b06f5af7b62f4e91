//! Builders for the shapes that scenes are made of.

use core::f32::consts::{FRAC_PI_2, TAU};

use glam::Vec3;

use super::geometry::{Line, Rgba, Scene, Vertex};

/// Azimuth steps of round shapes; a circle of 300 pixels is then true to 0.1 pixels.
pub(super) const ROUND_STEPS: u16 = 128;
/// Polar steps of a dome, from the pole to the horizon.
const DOME_STEPS: u16 = 24;
/// Sides of an arrow head.
const HEAD_SIDES: u16 = 24;
/// Length of an arrow head in world units, per point of line width.
const HEAD_LENGTH_PER_POINT: f32 = 0.045;
/// Base radius of an arrow head over its length.
const HEAD_SLENDERNESS: f32 = 0.3;
/// Largest part of an arrow that its head may take, so that a short arrow keeps a shaft.
const HEAD_MAX_FRACTION: f32 = 0.5;
/// Angle per segment of an arc, in radians.
const ARC_STEP: f32 = TAU / 128.0;
/// Length of a dash in world units, before fitting to the line.
const DASH: f32 = 0.045;
/// Gap between dashes in world units, before fitting to the line.
const GAP: f32 = 0.03;
/// Bound on the dashes of one line, however long it is.
const MAX_DASHES: u16 = 256;

impl Scene {
    /// Adds a straight line from `a` to `b`; `width` is in points.
    pub fn add_line(&mut self, a: Vec3, b: Vec3, color: Rgba, width: f32) {
        self.lines.push(Line {
            a: a.into(),
            b: b.into(),
            color,
            width,
        });
    }

    /// Adds the lines that join consecutive points; `width` is in points.
    pub fn add_polyline(&mut self, points: &[Vec3], color: Rgba, width: f32) {
        for pair in points.windows(2) {
            if let &[a, b] = pair {
                self.add_line(a, b, color, width);
            }
        }
    }

    /// Adds an arrow whose tip is at `to`: a line of `width` points and a cone.
    ///
    /// The cone grows with the width but takes at most half of the arrow. An arrow without
    /// length adds nothing.
    pub fn add_arrow(&mut self, from: Vec3, to: Vec3, color: Rgba, width: f32) {
        let Some(direction) = (to - from).try_normalize() else {
            return;
        };
        let length = (HEAD_LENGTH_PER_POINT * width).min(HEAD_MAX_FRACTION * from.distance(to));
        let base = to - length * direction;
        self.add_line(from, base, color, width);
        self.add_cone(base, to, HEAD_SLENDERNESS * length, color);
    }

    /// Adds an arc about `center` from the direction `from_dir` to `to_dir`, the shorter way.
    ///
    /// The directions need no particular length; an arc between parallel ones adds nothing.
    pub fn add_arc(
        &mut self,
        center: Vec3,
        from_dir: Vec3,
        to_dir: Vec3,
        radius: f32,
        color: Rgba,
        width: f32,
    ) {
        let (Some(from), Some(to)) = (from_dir.try_normalize(), to_dir.try_normalize()) else {
            return;
        };
        let angle = from.angle_between(to);
        if angle > 0.0 {
            let steps = steps_for(angle / ARC_STEP, ROUND_STEPS);
            let points: Vec<Vec3> = fractions(steps)
                .map(|f| center + radius * from.slerp(to, f))
                .collect();
            self.add_polyline(&points, color, width);
        }
    }

    /// Adds a dashed line that begins and ends with a dash; `width` is in points.
    pub fn add_dashed(&mut self, a: Vec3, b: Vec3, color: Rgba, width: f32) {
        let gaps = f32::from(steps_for(a.distance(b) / (DASH + GAP), MAX_DASHES)) - 1.0;
        // In units of one period, the line is `gaps` whole periods and one last dash.
        let dash = DASH / (DASH + GAP);
        let periods = gaps + dash;
        let mut start = 0.0;
        while start < periods {
            let end = start + dash;
            self.add_line(
                a.lerp(b, start / periods),
                a.lerp(b, end / periods),
                color,
                width,
            );
            start += 1.0;
        }
    }

    /// Adds the translucent unit dome above (`upper`) or below the surface.
    pub fn add_hemisphere(&mut self, upper: bool, color: Rgba) {
        let sign = if upper { 1.0 } else { -1.0 };
        let mut vertices = Vec::new();
        for polar in fractions(DOME_STEPS) {
            for azimuth in fractions(ROUND_STEPS) {
                let point = on_sphere(polar * FRAC_PI_2, azimuth * TAU, sign);
                vertices.push(Vertex {
                    position: point.into(),
                    normal: point.into(),
                    color,
                });
            }
        }
        let indices = grid(u32::from(DOME_STEPS), upper);
        self.translucent.append(&vertices, indices);
    }

    /// Adds rings of equal polar angle and spokes of equal azimuth on a unit dome.
    ///
    /// Steps are in degrees; a step that is not above 0 leaves that family out. `width` is in
    /// points. The horizon belongs to the upper dome, so that a grid on both draws it once.
    pub fn add_degree_grid(
        &mut self,
        upper: bool,
        ring_step_deg: f32,
        spoke_step_deg: f32,
        color: Rgba,
        width: f32,
    ) {
        let sign = if upper { 1.0 } else { -1.0 };
        let mut first_ring = 0.0;
        for polar in multiples_below(ring_step_deg, 89.9) {
            let polar = polar.to_radians();
            first_ring = if first_ring > 0.0 { first_ring } else { polar };
            self.add_ring(polar, sign, color, width);
        }
        if upper {
            self.add_ring(FRAC_PI_2, sign, color, width);
        }
        let spokes = core::iter::once(0.0).chain(multiples_below(spoke_step_deg, 359.9));
        for azimuth in spokes.filter(|_| spoke_step_deg > 0.0) {
            // Only the axis planes reach the pole; all spokes together would clot there.
            let on_axis = (azimuth / 90.0 - (azimuth / 90.0).round()).abs() < 1e-3;
            let start = if on_axis { 0.0 } else { first_ring };
            let steps = steps_for((FRAC_PI_2 - start) / ARC_STEP, ROUND_STEPS);
            let points: Vec<Vec3> = fractions(steps)
                .map(|f| start + f * (FRAC_PI_2 - start))
                .map(|polar| on_sphere(polar, azimuth.to_radians(), sign))
                .collect();
            self.add_polyline(&points, color, width);
        }
    }

    /// Adds a closed cone; it is blended if the colour is.
    fn add_cone(&mut self, base: Vec3, tip: Vec3, radius: f32, color: Rgba) {
        let axis = (tip - base).normalize_or_zero();
        let (u, v) = axis.any_orthonormal_pair();
        let vertex = |p: Vec3, n: Vec3| Vertex {
            position: p.into(),
            normal: n.into(),
            color,
        };
        let mut vertices = Vec::new();
        for fraction in fractions(HEAD_SIDES) {
            let (sin, cos) = (fraction * TAU).sin_cos();
            let out = cos * u + sin * v;
            let rim = base + radius * out;
            let slope = out * base.distance(tip) + axis * radius;
            // The rim twice, because the side and the cap have different normals.
            vertices.extend([vertex(tip, slope), vertex(rim, slope), vertex(rim, -axis)]);
        }
        vertices.push(vertex(base, -axis));
        let center = 3 * (u32::from(HEAD_SIDES) + 1);
        let indices = (0..u32::from(HEAD_SIDES)).flat_map(|side| {
            let i = 3 * side;
            [i, i + 1, i + 4, center, i + 5, i + 2]
        });
        let [.., alpha] = color;
        let surface = if alpha == u8::MAX {
            &mut self.opaque
        } else {
            &mut self.translucent
        };
        surface.append(&vertices, indices);
    }

    fn add_ring(&mut self, polar: f32, sign: f32, color: Rgba, width: f32) {
        let points: Vec<Vec3> = fractions(ROUND_STEPS)
            .map(|f| on_sphere(polar, f * TAU, sign))
            .collect();
        self.add_polyline(&points, color, width);
    }
}

/// Point of the unit sphere; `side` -1 mirrors it below the surface. The horizon is exactly z = 0.
pub(super) fn on_sphere(polar: f32, azimuth: f32, side: f32) -> Vec3 {
    let (sin_polar, cos_polar) = polar.sin_cos();
    let z = if polar < FRAC_PI_2 {
        side * cos_polar
    } else {
        0.0
    };
    // A full turn must meet its start exactly, or a blended outline shows the seam.
    let (sin, cos) = if azimuth < TAU {
        azimuth.sin_cos()
    } else {
        (0.0, 1.0)
    };
    Vec3::new(sin_polar * cos, sin_polar * sin, z)
}

/// The triangles of `rows` bands between rings of [`ROUND_STEPS`] steps, the first ring the inner or upper one:
/// counter-clockwise seen from above or outside, so that culling tells the near wall from the far, or else from the
/// other side.
pub(super) fn grid(rows: u32, from_outside: bool) -> Vec<u32> {
    let columns = u32::from(ROUND_STEPS) + 1;
    let mut indices = Vec::new();
    for row in 0..rows {
        for column in 0..u32::from(ROUND_STEPS) {
            let corner = row * columns + column;
            let (next, below) = (corner + 1, corner + columns);
            indices.extend(if from_outside {
                [corner, below, next, next, below, below + 1]
            } else {
                [corner, next, below, next, below + 1, below]
            });
        }
    }
    indices
}

/// `steps + 1` evenly spaced numbers from 0 to 1.
pub(super) fn fractions(steps: u16) -> impl Iterator<Item = f32> {
    (0..=steps).map(move |i| f32::from(i) / f32::from(steps.max(1)))
}

/// The multiples of `step`, from `step` itself, that are below `end`; none for a step not above 0.
fn multiples_below(step: f32, end: f32) -> impl Iterator<Item = f32> {
    // Steps under a tenth of a degree would only fill the dome with ink.
    (1..=3600_u16)
        .map(move |i| f32::from(i) * step)
        .take_while(move |value| step > 0.0 && *value < end)
}

/// `count` rounded up to at least 1 and at most `max`.
fn steps_for(count: f32, max: u16) -> u16 {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "the value was clamped to the range of u16; NaN becomes 0, then 1"
    )]
    let steps = count.ceil().clamp(1.0, f32::from(max)) as u16;
    steps.max(1)
}

#[cfg(test)]
mod tests {
    use super::*;

    const INK: Rgba = [200, 100, 50, 255];

    fn positions(scene: &Scene) -> impl Iterator<Item = Vec3> {
        let surfaces = [&scene.opaque, &scene.translucent];
        let triangles = surfaces.into_iter().flat_map(|s| &s.vertices);
        let ends = scene.lines.iter().flat_map(|line| [line.a, line.b]);
        triangles.map(|v| v.position).chain(ends).map(Vec3::from)
    }

    #[test]
    fn arrow_stays_between_its_ends_at_any_length() {
        for length in [1e-4, 0.05, 1.0, 50.0] {
            let mut scene = Scene::default();
            let direction = Vec3::new(0.3, -0.5, 0.8).normalize_or_zero();
            scene.add_arrow(Vec3::ZERO, length * direction, INK, 3.0);
            assert_eq!(scene.lines.len(), 1);
            for p in positions(&scene) {
                let along = p.dot(direction) / length;
                assert!((-1e-4..=1.0001).contains(&along), "{length}: {along}");
            }
            let shaft = scene.lines.first().expect("one line");
            assert!(Vec3::from(shaft.b).length() >= 0.499 * length);
        }
        let mut scene = Scene::default();
        scene.add_arrow(Vec3::X, Vec3::X, INK, 3.0);
        assert_eq!(scene, Scene::default());
    }

    #[test]
    fn triangles_of_closed_shapes_face_outward() {
        for upper in [true, false] {
            let mut scene = Scene::default();
            scene.add_hemisphere(upper, INK);
            scene.add_arrow(Vec3::ZERO, Vec3::Y, INK, 3.0);
            for surface in [&scene.opaque, &scene.translucent] {
                for triangle in surface.indices.chunks_exact(3) {
                    let corner = |i: usize| surface.vertices[triangle[i] as usize];
                    let [a, b, c] = [0, 1, 2].map(|i| Vec3::from(corner(i).position));
                    let facing = (b - a).cross(c - a).dot(Vec3::from(corner(1).normal));
                    assert!(facing >= -1e-7, "{facing}");
                }
            }
        }
    }

    #[test]
    fn domes_and_grids_stay_on_their_side_of_the_surface() {
        for (upper, sign) in [(true, 1.0), (false, -1.0)] {
            let mut scene = Scene::default();
            scene.add_hemisphere(upper, INK);
            scene.add_degree_grid(upper, 15.0, 30.0, INK, 1.0);
            for p in positions(&scene) {
                assert!((p.length() - 1.0).abs() < 1e-5 && sign * p.z >= 0.0, "{p}");
            }
        }
    }

    #[test]
    fn degree_grid_counts() {
        let ring = usize::from(ROUND_STEPS);
        for (upper, rings) in [(true, 3), (false, 2)] {
            let mut scene = Scene::default();
            scene.add_degree_grid(upper, 30.0, 0.0, INK, 1.0);
            assert_eq!(scene.lines.len(), rings * ring);
        }
    }

    #[test]
    fn dashes_begin_and_end_the_line() {
        for length in [0.01, 0.2, 1.0, 1000.0] {
            let mut scene = Scene::default();
            scene.add_dashed(Vec3::ZERO, length * Vec3::X, INK, 1.0);
            assert!(scene.lines.len() <= usize::from(MAX_DASHES));
            let last = scene.lines.last().expect("a dash");
            assert!((last.b[0] - length).abs() < 1e-4 * length);
        }
    }

    #[test]
    fn arc_keeps_its_radius_and_ends() {
        for to in [Vec3::Z, -Vec3::X] {
            let mut scene = Scene::default();
            scene.add_arc(Vec3::ONE, Vec3::X, to, 0.5, INK, 1.0);
            assert!(positions(&scene).all(|p| (p.distance(Vec3::ONE) - 0.5).abs() < 1e-5));
            let end = Vec3::from(scene.lines.last().expect("a segment").b);
            assert!(end.distance(Vec3::ONE + 0.5 * to) < 1e-4);
        }
    }
}
