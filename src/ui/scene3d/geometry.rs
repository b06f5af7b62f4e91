//! Scene contents as plain data: triangles and lines.
//!
//! World axes: x = s, y = t, z = n; lengths are in units of the unit dome.

use bytemuck::{Pod, Zeroable};
/// Unmultiplied sRGB colour with alpha, 0 to 255 each.
pub type Rgba = [u8; 4];

/// A corner of a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Vertex {
    /// World position.
    pub position: [f32; 3],
    /// Surface normal, of any length and either side; zero asks for flat shading.
    pub normal: [f32; 3],
    /// Colour; alpha counts only in [`Scene::shells`] and [`Scene::translucent`].
    pub color: Rgba,
}

/// A straight line of constant width on screen.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Line {
    /// One end, in world units.
    pub a: [f32; 3],
    /// Other end, in world units.
    pub b: [f32; 3],
    /// Colour; below full alpha the line is blended and hides nothing.
    pub color: Rgba,
    /// Width in egui points, above 0.
    pub width: f32,
}

/// What is behind a scene: one colour at the edges of the view, and another in its middle, which it passes into softly. Their
/// alpha is ignored.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Backdrop {
    /// At the edges.
    pub edge: Rgba,
    /// In the middle.
    pub middle: Rgba,
}

/// Indexed triangles; either side of a triangle is visible.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Surface {
    /// Corners.
    pub vertices: Vec<Vertex>,
    /// Three indices into `vertices` for each triangle.
    pub indices: Vec<u32>,
}

impl Surface {
    /// Appends a mesh; `indices` count from its own first vertex.
    ///
    /// Appends nothing if the surface would outgrow 32-bit indices.
    pub fn append(&mut self, vertices: &[Vertex], indices: impl IntoIterator<Item = u32>) {
        let base = u32::try_from(self.vertices.len());
        let end = u32::try_from(self.vertices.len() + vertices.len());
        if let (Ok(base), Ok(_)) = (base, end) {
            self.vertices.extend_from_slice(vertices);
            self.indices
                .extend(indices.into_iter().map(|index| base + index));
        }
    }
}

/// Everything one 3D view draws.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Scene {
    /// What the rest stands on: matt, and hides what is behind it; it is not there for who looks from below.
    pub ground: Surface,
    /// Matt bodies that hide what is behind them, under a key and a rim light, and darker towards the origin and the
    /// plane z = 0, from which they rise.
    pub bodies: Surface,
    /// Small solid marks, as the heads of arrows, that hide what is behind them.
    pub opaque: Surface,
    /// Skins one sees through, with a line along their outline; where an opaque triangle hides one, its outline shows
    /// through it, faintly. Their vertices need normals.
    pub shells: Surface,
    /// Unlit triangles blended over the rest by their vertex alpha.
    pub translucent: Surface,
    /// Lines, hidden by opaque triangles in front of them.
    pub lines: Vec<Line>,
}
