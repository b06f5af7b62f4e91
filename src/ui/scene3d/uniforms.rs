//! What the shader is told of a view: where it stands, what it is seen from, and how it is lit.

use bytemuck::{Pod, Zeroable};
use eframe::wgpu;
use egui::Rect;
use glam::Vec3;

use super::camera::Projection as _;
use super::geometry::{Backdrop, Rgba};
use bxdf_study::session::OrbitCamera;
use bxdf_study::session::camera::Basis;

/// Towards the key light: along the camera's right, out of the screen, and up the normal. It goes about with the camera, so
/// that what faces the eye is lit, but always shines from above, so that up and down are told apart.
const KEY: [f32; 3] = [-0.45, 0.35, 0.82];
/// Towards the rim light, in the same way: from behind and the other side.
const RIM: [f32; 3] = [0.75, -0.45, 0.35];

/// Where a view is on screen and how large its target is.
#[derive(Clone, Copy)]
pub(super) struct Placement {
    /// Top-left corner in screen pixels; may be outside the screen.
    origin: [f32; 2],
    /// Size of the view in screen pixels.
    size: [f32; 2],
    /// Size of the target in texels.
    pub texels: [u32; 2],
    pub pixels_per_point: f32,
    /// Width over height.
    pub aspect: f32,
}

impl Placement {
    /// `None` for a view that has no pixels.
    pub fn new(rect: Rect, pixels_per_point: f32, device: &wgpu::Device) -> Option<Self> {
        // Rounded edges, as egui rounds the viewport it sets for the callback.
        let min = (rect.min * pixels_per_point).round();
        let size = (rect.max * pixels_per_point).round() - min;
        if !(size.is_finite() && size.min_elem() >= 1.0 && pixels_per_point > 0.0) {
            return None;
        }
        let limit = device.limits().max_texture_dimension_2d;
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a whole number of at least 1; `as` saturates and the limit follows"
        )]
        let texels = [size.x, size.y].map(|pixels| (pixels as u32).min(limit));
        Some(Self {
            origin: min.into(),
            size: size.into(),
            texels,
            pixels_per_point,
            aspect: rect.aspect_ratio(),
        })
    }
}

/// Mirrors `View` in the shader.
#[derive(Clone, Copy, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub(super) struct Uniforms {
    view_proj: [f32; 16],
    eye: [f32; 3],
    pixels_per_point: f32,
    target_size: [f32; 2],
    screen_origin: [f32; 2],
    texels_per_pixel: [f32; 2],
    padding: [f32; 2],
    /// Towards the two lights; the last number of each is not used.
    key: [f32; 4],
    rim: [f32; 4],
    /// The backdrop, at the edges of the view and in its middle.
    edge: [f32; 4],
    middle: [f32; 4],
}

impl Uniforms {
    pub fn new(camera: &OrbitCamera, backdrop: Backdrop, place: &Placement) -> Self {
        #[expect(
            clippy::cast_precision_loss,
            reason = "texture sizes are far below 2^24"
        )]
        let [width, height] = place.texels.map(|texels| texels as f32);
        let [screen_width, screen_height] = place.size;
        let texels_per_pixel = [width / screen_width, height / screen_height];
        Self {
            view_proj: camera.view_proj(place.aspect).to_cols_array(),
            eye: camera.eye().into(),
            pixels_per_point: place.pixels_per_point,
            target_size: [width, height],
            screen_origin: place.origin,
            texels_per_pixel,
            padding: [0.0; 2],
            key: toward(camera, KEY),
            rim: toward(camera, RIM),
            edge: unit(backdrop.edge),
            middle: unit(backdrop.middle),
        }
    }
}

/// The unit vector with these parts to the right of the screen, out of it, and up the normal.
fn toward(camera: &OrbitCamera, [right, out, up]: [f32; 3]) -> [f32; 4] {
    let axes: Basis = camera.basis();
    let sum = right * axes.right + out * axes.toward_eye + up * Vec3::Z;
    sum.normalize_or(Vec3::Z).extend(0.0).into()
}

/// A colour as the shader takes it.
fn unit(color: Rgba) -> [f32; 4] {
    color.map(|channel| f32::from(channel) / 255.0)
}
