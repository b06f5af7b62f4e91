//! Small 3D views inside egui: a scene of triangles and lines, seen by an orbit camera.
//!
//! A caller builds a [`Scene`] with the builders in it, keeps an [`OrbitCamera`](bxdf_study::session::camera::OrbitCamera), and adds
//! [`shape`] to an egui painter each frame. [`init`] must have run once at start-up.
//!
//! ```text
//! Scene (plain data) --version--> GPU buffers \
//! OrbitCamera -----------------> uniform ------> own 4x multisampled target -> copy into egui
//! ```
//!
//! Each view is drawn into a target of its own, because egui's render pass has no depth buffer
//! and, in tests, one sample. Only what changed is done again: see [`SceneView`].

mod buffers;
mod camera;
mod geometry;
mod pipelines;
mod ray;
mod renderer;
mod shapes;
mod solids;
mod uniforms;

pub use camera::Projection;
pub use geometry::{Backdrop, Line, Rgba, Scene, Surface, Vertex};
pub use ray::Ray;
pub use renderer::{SceneView, init, shape};
