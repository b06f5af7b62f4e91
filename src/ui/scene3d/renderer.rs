//! Draws 3D views through egui's wgpu callbacks.

use core::mem::size_of;
use std::collections::HashMap;
use std::sync::Arc;

use bytemuck::Zeroable as _;
use eframe::egui_wgpu::{self, CallbackResources, CallbackTrait, RenderState, ScreenDescriptor};
use eframe::wgpu;
use egui::{PaintCallbackInfo, Rect};

use super::buffers::SceneBuffers;
use super::geometry::{Backdrop, Scene};
use super::pipelines::{COLOR_FORMAT, DEPTH_FORMAT, Pipelines, SAMPLES};
use super::uniforms::{Placement, Uniforms};
use bxdf_study::session::OrbitCamera;

/// One 3D view in one frame.
///
/// Buffers are uploaded when `version` changes, the target is remade when the size in pixels
/// changes, and the picture is redrawn when anything in here but the position changes.
#[derive(Clone, Debug)]
pub struct SceneView {
    /// Which view this is: the same in every frame, and different for views shown together.
    pub id: u64,
    /// What to draw.
    pub scene: Arc<Scene>,
    /// Changes whenever the content of `scene` does; the content itself is not compared.
    pub version: u64,
    /// Where to see it from.
    pub camera: OrbitCamera,
    /// What is behind the scene; the view covers what is under it.
    pub backdrop: Backdrop,
}

/// Prepares the drawing of 3D views; call it once when the app starts.
///
/// Without it, views stay empty, because a callback cannot know the format of the screen. Egui's
/// own pass must have one sample and no depth buffer, which is eframe's default.
pub fn init(render_state: &RenderState) {
    let views = Views {
        pipelines: Pipelines::new(&render_state.device, render_state.target_format),
        by_id: HashMap::new(),
        drawn: 0,
    };
    render_state
        .renderer
        .write()
        .callback_resources
        .insert(views);
}

/// The shape that shows a view in `rect`, in points. Add it to a painter in every frame.
#[must_use]
pub fn shape(rect: Rect, view: SceneView) -> egui::epaint::PaintCallback {
    egui_wgpu::Callback::new_paint_callback(rect, SceneCallback { rect, view })
}

/// Entry in egui's map of callback resources.
struct Views {
    pipelines: Pipelines,
    by_id: HashMap<u64, ViewState>,
    /// How many views were drawn so far, in all frames.
    drawn: u64,
}

/// A view is forgotten when another one is new and so many were drawn since: more than stand in two frames.
const FORGOTTEN_AFTER: u64 = 100;

impl Views {
    /// Brings the picture of a view up to date.
    fn update(
        &mut self,
        (device, queue): (&wgpu::Device, &wgpu::Queue),
        encoder: &mut wgpu::CommandEncoder,
        view: &SceneView,
        place: &Placement,
    ) {
        let Self {
            pipelines,
            by_id,
            drawn,
        } = self;
        *drawn += 1;
        if !by_id.contains_key(&view.id) {
            by_id.retain(|_, state| state.last_drawn + FORGOTTEN_AFTER > *drawn);
        }
        let state = by_id
            .entry(view.id)
            .or_insert_with(|| ViewState::new(device, pipelines));
        state.last_drawn = *drawn;
        let gpu = Gpu {
            device,
            queue,
            pipelines,
        };
        state.update(&gpu, encoder, view, place);
    }
}

struct SceneCallback {
    rect: Rect,
    view: SceneView,
}

impl CallbackTrait for SceneCallback {
    fn prepare(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        screen: &ScreenDescriptor,
        encoder: &mut wgpu::CommandEncoder,
        resources: &mut CallbackResources,
    ) -> Vec<wgpu::CommandBuffer> {
        if let Some(views) = resources.get_mut::<Views>()
            && let Some(place) = Placement::new(self.rect, screen.pixels_per_point, device)
        {
            views.update((device, queue), encoder, &self.view, &place);
        }
        Vec::new()
    }

    fn paint(
        &self,
        _info: PaintCallbackInfo,
        pass: &mut wgpu::RenderPass<'static>,
        resources: &CallbackResources,
    ) {
        if let Some(Views {
            pipelines, by_id, ..
        }) = resources.get()
            && let Some(state) = by_id.get(&self.view.id)
            && let Some(target) = &state.target
        {
            pass.set_pipeline(&pipelines.copy);
            pass.set_bind_group(0, &state.uniform_group, &[]);
            pass.set_bind_group(1, &target.picture_group, &[]);
            pass.draw(0..3, 0..1);
        }
    }
}

/// All that a picture depends on; an equal key means an equal picture.
#[derive(Clone, PartialEq)]
struct PictureKey {
    camera: OrbitCamera,
    version: u64,
    backdrop: Backdrop,
    texels: [u32; 2],
    aspect: f32,
    pixels_per_point: f32,
}

struct Gpu<'a> {
    device: &'a wgpu::Device,
    queue: &'a wgpu::Queue,
    pipelines: &'a Pipelines,
}

/// What one view keeps on the GPU from frame to frame.
struct ViewState {
    uniforms: Uniforms,
    uniform_buffer: wgpu::Buffer,
    uniform_group: wgpu::BindGroup,
    buffers: SceneBuffers,
    target: Option<Target>,
    drawn: Option<PictureKey>,
    /// How many views had been drawn when it was drawn last.
    last_drawn: u64,
}

impl ViewState {
    fn new(device: &wgpu::Device, pipelines: &Pipelines) -> Self {
        let uniform_buffer = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("scene3d uniforms"),
            size: size_of::<Uniforms>() as u64,
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let uniform_group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("scene3d uniforms"),
            layout: &pipelines.view_layout,
            entries: &[wgpu::BindGroupEntry {
                binding: 0,
                resource: uniform_buffer.as_entire_binding(),
            }],
        });
        Self {
            // wgpu zeroes new buffers, so this is what the buffer holds.
            uniforms: Uniforms::zeroed(),
            uniform_buffer,
            uniform_group,
            buffers: SceneBuffers::new(),
            target: None,
            drawn: None,
            last_drawn: 0,
        }
    }

    /// Brings the picture up to date, recording a pass into `encoder` if it has to be redrawn.
    fn update(
        &mut self,
        gpu: &Gpu<'_>,
        encoder: &mut wgpu::CommandEncoder,
        view: &SceneView,
        place: &Placement,
    ) {
        let uniforms = Uniforms::new(&view.camera, view.backdrop, place);
        if self.uniforms != uniforms {
            gpu.queue
                .write_buffer(&self.uniform_buffer, 0, bytemuck::bytes_of(&uniforms));
            self.uniforms = uniforms;
        }
        let key = PictureKey {
            camera: view.camera.clone(),
            version: view.version,
            backdrop: view.backdrop,
            texels: place.texels,
            aspect: place.aspect,
            pixels_per_point: place.pixels_per_point,
        };
        if self.drawn.as_ref() == Some(&key) {
            return;
        }
        self.buffers
            .upload(gpu.device, gpu.queue, &view.scene, view.version);
        let old = self
            .target
            .take()
            .filter(|target| target.texels == place.texels);
        let target = old.unwrap_or_else(|| Target::new(gpu, place.texels));
        let mut pass = target.begin_pass(encoder, view.backdrop);
        pass.set_bind_group(0, &self.uniform_group, &[]);
        self.buffers.draw(&mut pass, gpu.pipelines);
        drop(pass);
        self.target = Some(target);
        self.drawn = Some(key);
    }
}

/// The textures a view is drawn into.
struct Target {
    texels: [u32; 2],
    color: wgpu::TextureView,
    depth: wgpu::TextureView,
    picture: wgpu::TextureView,
    picture_group: wgpu::BindGroup,
}

impl Target {
    fn new(gpu: &Gpu<'_>, texels: [u32; 2]) -> Self {
        let [width, height] = texels;
        let attachment = |format, sample_count, more_usage| {
            let texture = gpu.device.create_texture(&wgpu::TextureDescriptor {
                label: Some("scene3d target"),
                size: wgpu::Extent3d {
                    width,
                    height,
                    depth_or_array_layers: 1,
                },
                mip_level_count: 1,
                sample_count,
                dimension: wgpu::TextureDimension::D2,
                format,
                usage: wgpu::TextureUsages::RENDER_ATTACHMENT | more_usage,
                view_formats: &[],
            });
            texture.create_view(&wgpu::TextureViewDescriptor::default())
        };
        let none = wgpu::TextureUsages::empty();
        let picture = attachment(COLOR_FORMAT, 1, wgpu::TextureUsages::TEXTURE_BINDING);
        let picture_group = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("scene3d picture"),
            layout: &gpu.pipelines.picture_layout,
            entries: &[wgpu::BindGroupEntry {
                binding: 0,
                resource: wgpu::BindingResource::TextureView(&picture),
            }],
        });
        Self {
            texels,
            color: attachment(COLOR_FORMAT, SAMPLES, none),
            depth: attachment(DEPTH_FORMAT, SAMPLES, none),
            picture,
            picture_group,
        }
    }

    fn begin_pass<'a>(
        &self,
        encoder: &'a mut wgpu::CommandEncoder,
        backdrop: Backdrop,
    ) -> wgpu::RenderPass<'a> {
        let [r, g, b, _] = backdrop.edge.map(|channel| f64::from(channel) / 255.0);
        encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("scene3d"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &self.color,
                depth_slice: None,
                resolve_target: Some(&self.picture),
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color { r, g, b, a: 1.0 }),
                    // Only the resolved picture is read again.
                    store: wgpu::StoreOp::Discard,
                },
            })],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &self.depth,
                depth_ops: Some(wgpu::Operations {
                    load: wgpu::LoadOp::Clear(1.0),
                    store: wgpu::StoreOp::Discard,
                }),
                stencil_ops: None,
            }),
            ..Default::default()
        })
    }
}
