//! Render pipelines shared by all 3D views.

use core::mem::size_of;

use eframe::wgpu;

use super::geometry::{Line, Vertex};

/// Format of a view's own target; not sRGB, because colours stay gamma-encoded as in egui.
pub(super) const COLOR_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;
/// Format of a view's depth buffer.
pub(super) const DEPTH_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;
/// Samples per pixel of a view's own target; 4 is the one count every device supports.
pub(super) const SAMPLES: u32 = 4;

/// Moves opaque triangles back by one pixel's worth of their slope, so that a line along a steep
/// surface is not cut by the part of the surface beside it. Unclamped, since WebGL2 has no clamp.
const SURFACE_DEPTH_BIAS: wgpu::DepthBiasState = wgpu::DepthBiasState {
    constant: 0,
    slope_scale: 1.0,
    clamp: 0.0,
};

/// The corners of triangles.
const TRIANGLES: wgpu::VertexBufferLayout<'static> = wgpu::VertexBufferLayout {
    array_stride: size_of::<Vertex>() as u64,
    step_mode: wgpu::VertexStepMode::Vertex,
    attributes: &wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32x3, 2 => Unorm8x4],
};

/// The lines, one instance each.
const LINES: wgpu::VertexBufferLayout<'static> = wgpu::VertexBufferLayout {
    array_stride: size_of::<Line>() as u64,
    step_mode: wgpu::VertexStepMode::Instance,
    attributes: &wgpu::vertex_attr_array![
        0 => Float32x3, 1 => Float32x3, 2 => Unorm8x4, 3 => Float32
    ],
};

/// Pipelines and the layouts of what they read.
pub(super) struct Pipelines {
    /// Uniforms of a view.
    pub view_layout: wgpu::BindGroupLayout,
    /// Finished picture of a view.
    pub picture_layout: wgpu::BindGroupLayout,
    /// What is behind everything.
    pub backdrop: wgpu::RenderPipeline,
    /// Opaque triangles seen from their front, matt.
    pub ground: wgpu::RenderPipeline,
    /// Opaque triangles, matt.
    pub bodies: wgpu::RenderPipeline,
    /// Opaque triangles.
    pub opaque: wgpu::RenderPipeline,
    /// Lines of full alpha, which hide what is behind them.
    pub opaque_lines: wgpu::RenderPipeline,
    /// The outlines of shells behind opaque triangles.
    pub hidden_shells: wgpu::RenderPipeline,
    /// Shells seen from their back.
    pub shells_back: wgpu::RenderPipeline,
    /// Shells seen from their front.
    pub shells_front: wgpu::RenderPipeline,
    /// Translucent triangles seen from their back.
    pub translucent_back: wgpu::RenderPipeline,
    /// Translucent triangles seen from their front.
    pub translucent_front: wgpu::RenderPipeline,
    /// Lines of less than full alpha.
    pub translucent_lines: wgpu::RenderPipeline,
    /// Copy of a finished picture into egui's pass.
    pub copy: wgpu::RenderPipeline,
}

impl Pipelines {
    /// Compiles everything; `screen_format` is the format of egui's target.
    pub fn new(device: &wgpu::Device, screen_format: wgpu::TextureFormat) -> Self {
        let view_layout = layout(
            device,
            wgpu::ShaderStages::VERTEX_FRAGMENT,
            wgpu::BindingType::Buffer {
                ty: wgpu::BufferBindingType::Uniform,
                has_dynamic_offset: false,
                min_binding_size: None,
            },
        );
        let picture_layout = layout(
            device,
            wgpu::ShaderStages::FRAGMENT,
            wgpu::BindingType::Texture {
                sample_type: wgpu::TextureSampleType::Float { filterable: false },
                view_dimension: wgpu::TextureViewDimension::D2,
                multisampled: false,
            },
        );
        let pass = Pass::new(device, &view_layout);
        Self {
            backdrop: pass.backdrop(),
            ground: pass.opaque("fs_ground", Some(wgpu::Face::Back)),
            bodies: pass.opaque("fs_body", None),
            opaque: pass.opaque("fs_opaque", None),
            opaque_lines: pass.lines(true),
            hidden_shells: pass.hidden("fs_hidden_shell"),
            shells_back: pass.translucent("fs_shell", wgpu::Face::Front),
            shells_front: pass.translucent("fs_shell", wgpu::Face::Back),
            translucent_back: pass.translucent("fs_translucent", wgpu::Face::Front),
            translucent_front: pass.translucent("fs_translucent", wgpu::Face::Back),
            translucent_lines: pass.lines(false),
            copy: pass.copy(&[Some(&view_layout), Some(&picture_layout)], screen_format),
            view_layout,
            picture_layout,
        }
    }
}

/// What the pipelines have in common while they are made.
struct Pass<'a> {
    device: &'a wgpu::Device,
    module: wgpu::ShaderModule,
    layout: wgpu::PipelineLayout,
}

/// What distinguishes the pipelines of the offscreen pass.
struct Draw<'a> {
    label: &'a str,
    entry_points: [&'a str; 2],
    vertices: Option<wgpu::VertexBufferLayout<'a>>,
    primitive: wgpu::PrimitiveState,
    /// How depths are compared, and whether they are written.
    depth: (wgpu::CompareFunction, bool),
    bias: wgpu::DepthBiasState,
    blend: Option<wgpu::BlendState>,
}

impl<'a> Draw<'a> {
    /// Triangles that let through what is behind them, without the given face.
    fn blended(shading: &'a str, cull_mode: Option<wgpu::Face>) -> Self {
        Self {
            label: "scene3d surface",
            entry_points: ["vs_surface", shading],
            vertices: Some(TRIANGLES),
            primitive: wgpu::PrimitiveState {
                cull_mode,
                ..Default::default()
            },
            depth: (wgpu::CompareFunction::Less, false),
            bias: wgpu::DepthBiasState::default(),
            blend: Some(wgpu::BlendState::ALPHA_BLENDING),
        }
    }
}

impl<'a> Pass<'a> {
    fn new(device: &'a wgpu::Device, view_layout: &wgpu::BindGroupLayout) -> Self {
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("scene3d"),
            source: wgpu::ShaderSource::Wgsl(include_str!("shader.wgsl").into()),
        });
        let layout = pipeline_layout(device, &[Some(view_layout)]);
        Self {
            device,
            module,
            layout,
        }
    }

    /// The backdrop, which covers the view and has no depth.
    fn backdrop(&self) -> wgpu::RenderPipeline {
        self.draw(Draw {
            label: "scene3d backdrop",
            entry_points: ["vs_copy", "fs_backdrop"],
            vertices: None,
            primitive: wgpu::PrimitiveState::default(),
            depth: (wgpu::CompareFunction::Always, false),
            bias: wgpu::DepthBiasState::default(),
            blend: None,
        })
    }

    /// Triangles that hide what is behind them, without the given face.
    fn opaque(&self, shading: &str, cull_mode: Option<wgpu::Face>) -> wgpu::RenderPipeline {
        self.draw(Draw {
            depth: (wgpu::CompareFunction::Less, true),
            bias: SURFACE_DEPTH_BIAS,
            blend: None,
            ..Draw::blended(shading, cull_mode)
        })
    }

    /// Triangles that are blended over what is there, without the given face.
    fn translucent(&self, shading: &str, cull: wgpu::Face) -> wgpu::RenderPipeline {
        self.draw(Draw::blended(shading, Some(cull)))
    }

    /// Triangles that are blended over what is nearer to the eye than they are.
    fn hidden(&self, shading: &str) -> wgpu::RenderPipeline {
        self.draw(Draw {
            depth: (wgpu::CompareFunction::Greater, false),
            ..Draw::blended(shading, Some(wgpu::Face::Back))
        })
    }

    /// Lines, one instance each. Blended even if opaque, for their soft edges.
    fn lines(&self, writes_depth: bool) -> wgpu::RenderPipeline {
        self.draw(Draw {
            label: "scene3d lines",
            entry_points: ["vs_line", "fs_line"],
            vertices: Some(LINES),
            primitive: wgpu::PrimitiveState {
                topology: wgpu::PrimitiveTopology::TriangleStrip,
                ..Default::default()
            },
            depth: (wgpu::CompareFunction::Less, writes_depth),
            // The shader lifts lines off their surface instead.
            bias: wgpu::DepthBiasState::default(),
            blend: Some(wgpu::BlendState::ALPHA_BLENDING),
        })
    }

    fn draw(&self, draw: Draw<'_>) -> wgpu::RenderPipeline {
        let [vertex, fragment] = draw.entry_points;
        let (depth_compare, writes_depth) = draw.depth;
        let vertices = draw.vertices.map(Some);
        self.device
            .create_render_pipeline(&wgpu::RenderPipelineDescriptor {
                label: Some(draw.label),
                layout: Some(&self.layout),
                vertex: wgpu::VertexState {
                    module: &self.module,
                    entry_point: Some(vertex),
                    compilation_options: wgpu::PipelineCompilationOptions::default(),
                    buffers: vertices.as_slice(),
                },
                primitive: draw.primitive,
                depth_stencil: Some(wgpu::DepthStencilState {
                    format: DEPTH_FORMAT,
                    depth_write_enabled: Some(writes_depth),
                    depth_compare: Some(depth_compare),
                    stencil: wgpu::StencilState::default(),
                    bias: draw.bias,
                }),
                multisample: wgpu::MultisampleState {
                    count: SAMPLES,
                    ..Default::default()
                },
                fragment: Some(wgpu::FragmentState {
                    module: &self.module,
                    entry_point: Some(fragment),
                    compilation_options: wgpu::PipelineCompilationOptions::default(),
                    targets: &[Some(wgpu::ColorTargetState {
                        format: COLOR_FORMAT,
                        blend: draw.blend,
                        write_mask: wgpu::ColorWrites::ALL,
                    })],
                }),
                multiview_mask: None,
                cache: None,
            })
    }

    /// The copy into egui's pass, whose samples and depth eframe leaves at one and none.
    fn copy(
        &self,
        layouts: &[Option<&wgpu::BindGroupLayout>],
        screen_format: wgpu::TextureFormat,
    ) -> wgpu::RenderPipeline {
        let encodes = screen_format.is_srgb();
        self.device
            .create_render_pipeline(&wgpu::RenderPipelineDescriptor {
                label: Some("scene3d copy"),
                layout: Some(&pipeline_layout(self.device, layouts)),
                vertex: wgpu::VertexState {
                    module: &self.module,
                    entry_point: Some("vs_copy"),
                    compilation_options: wgpu::PipelineCompilationOptions::default(),
                    buffers: &[],
                },
                primitive: wgpu::PrimitiveState::default(),
                depth_stencil: None,
                multisample: wgpu::MultisampleState::default(),
                fragment: Some(wgpu::FragmentState {
                    module: &self.module,
                    entry_point: Some(if encodes {
                        "fs_copy_linear"
                    } else {
                        "fs_copy_gamma"
                    }),
                    compilation_options: wgpu::PipelineCompilationOptions::default(),
                    targets: &[Some(screen_format.into())],
                }),
                multiview_mask: None,
                cache: None,
            })
    }
}

/// A bind group layout with one entry, at binding 0.
fn layout(
    device: &wgpu::Device,
    visibility: wgpu::ShaderStages,
    ty: wgpu::BindingType,
) -> wgpu::BindGroupLayout {
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("scene3d"),
        entries: &[wgpu::BindGroupLayoutEntry {
            binding: 0,
            visibility,
            ty,
            count: None,
        }],
    })
}

fn pipeline_layout(
    device: &wgpu::Device,
    layouts: &[Option<&wgpu::BindGroupLayout>],
) -> wgpu::PipelineLayout {
    device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some("scene3d"),
        bind_group_layouts: layouts,
        immediate_size: 0,
    })
}
