//! GPU copies of a scene.

use core::ops::Range;

use bytemuck::NoUninit;
use eframe::wgpu;

use super::geometry::{Line, Scene, Surface};
use super::pipelines::Pipelines;

/// GPU copy of one scene.
pub(super) struct SceneBuffers {
    /// Version of the scene in the buffers; `None` before the first upload.
    version: Option<u64>,
    ground: SurfaceBuffers,
    bodies: SurfaceBuffers,
    opaque: SurfaceBuffers,
    shells: SurfaceBuffers,
    translucent: SurfaceBuffers,
    /// First the opaque lines, then the translucent ones.
    lines: GrowingBuffer,
    opaque_lines: u32,
}

impl SceneBuffers {
    pub fn new() -> Self {
        Self {
            version: None,
            ground: SurfaceBuffers::new(),
            bodies: SurfaceBuffers::new(),
            opaque: SurfaceBuffers::new(),
            shells: SurfaceBuffers::new(),
            translucent: SurfaceBuffers::new(),
            lines: GrowingBuffer::new(wgpu::BufferUsages::VERTEX),
            opaque_lines: 0,
        }
    }

    /// Copies the scene unless this version is already there.
    pub fn upload(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        scene: &Scene,
        version: u64,
    ) {
        if self.version == Some(version) {
            return;
        }
        for (buffers, surface) in [
            (&mut self.ground, &scene.ground),
            (&mut self.bodies, &scene.bodies),
            (&mut self.opaque, &scene.opaque),
            (&mut self.shells, &scene.shells),
            (&mut self.translucent, &scene.translucent),
        ] {
            buffers.upload(device, queue, surface);
        }
        let (mut lines, blended): (Vec<Line>, Vec<Line>) = scene
            .lines
            .iter()
            .partition(|line| line.color[3] == u8::MAX);
        let opaque_lines = lines.len();
        lines.extend(blended);
        self.lines.upload(device, queue, &lines);
        self.opaque_lines = u32::try_from(opaque_lines)
            .unwrap_or(u32::MAX)
            .min(self.lines.len);
        self.version = Some(version);
    }

    /// Draws everything, in the order that makes blending right.
    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>, pipelines: &Pipelines) {
        pass.set_pipeline(&pipelines.backdrop);
        pass.draw(0..3, 0..1);
        self.ground.draw(pass, &pipelines.ground);
        self.bodies.draw(pass, &pipelines.bodies);
        self.opaque.draw(pass, &pipelines.opaque);
        self.draw_lines(pass, &pipelines.opaque_lines, 0..self.opaque_lines);
        self.shells.draw(pass, &pipelines.hidden_shells);
        self.shells.draw(pass, &pipelines.shells_back);
        self.shells.draw(pass, &pipelines.shells_front);
        // The far walls of convex shells first. This is exact for the domes, which is what
        // translucent surfaces are used for; no sorting, so a camera move uploads nothing.
        self.translucent.draw(pass, &pipelines.translucent_back);
        self.translucent.draw(pass, &pipelines.translucent_front);
        // Last, because the shells would otherwise wash them out.
        self.draw_lines(
            pass,
            &pipelines.translucent_lines,
            self.opaque_lines..self.lines.len,
        );
    }

    fn draw_lines(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        pipeline: &wgpu::RenderPipeline,
        range: Range<u32>,
    ) {
        if let Some(lines) = self.lines.filled()
            && !range.is_empty()
        {
            pass.set_pipeline(pipeline);
            pass.set_vertex_buffer(0, lines);
            pass.draw(0..4, range);
        }
    }
}

struct SurfaceBuffers {
    vertices: GrowingBuffer,
    indices: GrowingBuffer,
}

impl SurfaceBuffers {
    fn new() -> Self {
        Self {
            vertices: GrowingBuffer::new(wgpu::BufferUsages::VERTEX),
            indices: GrowingBuffer::new(wgpu::BufferUsages::INDEX),
        }
    }

    fn upload(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, surface: &Surface) {
        self.vertices.upload(device, queue, &surface.vertices);
        self.indices.upload(device, queue, &surface.indices);
    }

    fn draw(&self, pass: &mut wgpu::RenderPass<'_>, pipeline: &wgpu::RenderPipeline) {
        if let (Some(vertices), Some(indices)) = (self.vertices.filled(), self.indices.filled()) {
            pass.set_pipeline(pipeline);
            pass.set_vertex_buffer(0, vertices);
            pass.set_index_buffer(indices, wgpu::IndexFormat::Uint32);
            pass.draw_indexed(0..self.indices.len, 0, 0..1);
        }
    }
}

/// A buffer that is reused as long as the data fits, since a dragged handle changes the scene in
/// every frame.
struct GrowingBuffer {
    usage: wgpu::BufferUsages,
    buffer: Option<wgpu::Buffer>,
    /// Bytes in use.
    size: u64,
    /// Elements in use.
    len: u32,
}

impl GrowingBuffer {
    const fn new(usage: wgpu::BufferUsages) -> Self {
        Self {
            usage,
            buffer: None,
            size: 0,
            len: 0,
        }
    }

    /// Replaces the content. Data beyond what the device can hold leaves the buffer empty.
    fn upload<T: NoUninit>(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, data: &[T]) {
        let bytes: &[u8] = bytemuck::cast_slice(data);
        let size = bytes.len() as u64;
        let limit = device.limits().max_buffer_size;
        (self.size, self.len) = match u32::try_from(data.len()) {
            Ok(len) if size <= limit => (size, len),
            _ => (0, 0),
        };
        if self.size == 0 {
            return;
        }
        let fitting = self.buffer.take().filter(|buffer| buffer.size() >= size);
        let buffer = fitting.unwrap_or_else(|| {
            device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("scene3d geometry"),
                size: size.next_power_of_two().min(limit),
                usage: self.usage | wgpu::BufferUsages::COPY_DST,
                mapped_at_creation: false,
            })
        });
        queue.write_buffer(&buffer, 0, bytes);
        self.buffer = Some(buffer);
    }

    /// The part in use; `None` if there is nothing to draw.
    fn filled(&self) -> Option<wgpu::BufferSlice<'_>> {
        let buffer = self.buffer.as_ref().filter(|_| self.len > 0)?;
        Some(buffer.slice(..self.size))
    }
}
