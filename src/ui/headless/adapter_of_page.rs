//! What pictures are drawn by on a page: the device of the page itself, for browsers give a canvas no other one. What it has
//! drawn has to be waited for.

use std::cell::RefCell;
use std::iter::once;
use std::sync::{Arc, mpsc};

use eframe::egui_wgpu::{RenderState, Renderer, RendererOptions, ScreenDescriptor, wgpu};
use egui::mutex::RwLock;
use egui::{Context, FullOutput, TexturesDelta};
use egui_kittest::{HarnessBuilder, TestRenderer};
use image::RgbaImage;
use wasm_bindgen_futures::JsFuture;

use crate::app::App;
use bxdf::error::{Error, Result};

thread_local! {
    /// The device of the page; a page has one thread.
    static DEVICE: RefCell<Option<RenderState>> = const { RefCell::new(None) };
    /// What was drawn last, until it is read.
    static DRAWN: RefCell<Option<Drawn>> = const { RefCell::new(None) };
}

/// How pixels of pictures are kept.
const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;

/// How long it is waited before it is looked again whether pixels have come, in milliseconds.
const MOMENT: i32 = 4;

/// How often it is looked: for ten seconds.
const MOST_LOOKS: u32 = 2500;

/// Draws pictures with the device of the page from here on.
pub fn draw_with(render_state: &RenderState) {
    DEVICE.set(Some(render_state.clone()));
}

/// `builder`, which can draw.
///
/// # Errors
/// [`Error::Platform`] before the page has a device.
pub(super) fn drawing(builder: HarnessBuilder<App>) -> Result<HarnessBuilder<App>> {
    let device = DEVICE.with_borrow(Clone::clone);
    let mut state = device.ok_or_else(|| Error::Platform {
        problem: "the page draws nothing yet".to_owned(),
        remedy: "try again in a moment".to_owned(),
    })?;
    // Textures and scenes of its own: those of the page stay as they are.
    let renderer = Renderer::new(&state.device, FORMAT, RendererOptions::PREDICTABLE);
    state.renderer = Arc::new(RwLock::new(renderer));
    state.target_format = FORMAT;
    Ok(builder.renderer(OffScreen { state }))
}

/// What was drawn, on its way from the graphics processor.
struct Drawn {
    device: wgpu::Device,
    pixels: wgpu::Buffer,
    /// Width and height in pixels, and the bytes of a row with what fills it up.
    size: [u32; 2],
    row: u32,
}

struct OffScreen {
    state: RenderState,
}

impl TestRenderer for OffScreen {
    fn setup_eframe(&self, cc: &mut eframe::CreationContext<'_>, _: &mut eframe::Frame) {
        cc.wgpu_render_state = Some(self.state.clone());
    }

    fn handle_delta(&mut self, delta: &mut TexturesDelta) {
        let RenderState { device, queue, .. } = &self.state;
        let mut renderer = self.state.renderer.write();
        for (id, images) in delta.set.drain() {
            for image in images {
                renderer.update_texture(device, queue, id, &image);
            }
        }
        for id in delta.free.drain() {
            renderer.free_texture(&id);
        }
    }

    /// Draws it; the pixels are to be had from [`read`].
    fn render(&mut self, ctx: &Context, output: &FullOutput) -> Result<RgbaImage, String> {
        let RenderState { device, queue, .. } = &self.state;
        let mut renderer = self.state.renderer.write();
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        let size = ctx.content_rect().size() * ctx.pixels_per_point();
        let size = [size.x, size.y].map(|side| side.round().max(1.0) as u32);
        let screen = ScreenDescriptor {
            size_in_pixels: size,
            pixels_per_point: ctx.pixels_per_point(),
        };
        let shapes = ctx.tessellate(output.shapes.clone(), ctx.pixels_per_point());
        let commands = renderer.update_buffers(device, queue, &mut encoder, &shapes, &screen);
        let extent = wgpu::Extent3d {
            width: size[0],
            height: size[1],
            depth_or_array_layers: 1,
        };
        let texture = device.create_texture(&wgpu::TextureDescriptor {
            label: Some("picture"),
            size: extent,
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: FORMAT,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
            view_formats: &[],
        });
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        let pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("picture"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &view,
                resolve_target: None,
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT),
                    store: wgpu::StoreOp::Store,
                },
                depth_slice: None,
            })],
            ..Default::default()
        });
        renderer.render(&mut pass.forget_lifetime(), &shapes, &screen);
        let row = (4 * size[0]).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
        let pixels = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("picture"),
            size: u64::from(row) * u64::from(size[1]),
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let layout = wgpu::TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: Some(row),
            rows_per_image: None,
        };
        let buffer = wgpu::TexelCopyBufferInfo {
            buffer: &pixels,
            layout,
        };
        encoder.copy_texture_to_buffer(texture.as_image_copy(), buffer, extent);
        queue.submit(commands.into_iter().chain(once(encoder.finish())));
        DRAWN.set(Some(Drawn {
            device: device.clone(),
            pixels,
            size,
            row,
        }));
        Ok(RgbaImage::new(1, 1))
    }
}

/// The pixels of what was rendered last.
pub(super) async fn read(rendered: Result<RgbaImage, String>) -> Result<RgbaImage, String> {
    rendered?;
    let drawn = DRAWN.take().ok_or("nothing was drawn")?;
    let (sender, come) = mpsc::channel();
    drawn
        .pixels
        .map_async(wgpu::MapMode::Read, .., move |mapped| {
            // Nobody listens any more after ten seconds.
            let _ = sender.send(mapped);
        });
    for _ in 0..MOST_LOOKS {
        // By WebGL nothing comes unless it is looked for.
        drawn
            .device
            .poll(wgpu::PollType::Poll)
            .map_err(|error| error.to_string())?;
        if let Ok(mapped) = come.try_recv() {
            mapped.map_err(|error| error.to_string())?;
            return image_of(&drawn);
        }
        a_moment().await;
    }
    Err("the graphics processor does not answer".to_owned())
}

/// Lets the browser do what it has to.
async fn a_moment() {
    let promise = js_sys::Promise::new(&mut |done, _| {
        let window = web_sys::window();
        // Without one there is nothing to wait for.
        let _ = window.map(|window| {
            window.set_timeout_with_callback_and_timeout_and_arguments_0(&done, MOMENT)
        });
    });
    // It is never refused.
    let _ = JsFuture::from(promise).await;
}

fn image_of(drawn: &Drawn) -> Result<RgbaImage, String> {
    let [width, height] = drawn.size;
    let mapped = drawn.pixels.get_mapped_range(..);
    let mapped = mapped.map_err(|error| error.to_string())?;
    let rows = mapped.chunks_exact(drawn.row as usize);
    let pixels: Vec<u8> = rows
        .flat_map(|row| row.iter().take(4 * width as usize).copied())
        .collect();
    RgbaImage::from_raw(width, height, pixels).ok_or_else(|| "pixels are missing".to_owned())
}
