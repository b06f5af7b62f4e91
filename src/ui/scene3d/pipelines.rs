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

/// Pipelines and the layouts of what they read.
pub(super) struct Pipelines {
    /// Uniforms of a view.
    pub view_layout: wgpu::BindGroupLayout,
    /// Finished picture of a view.
    pub picture_layout: wgpu::BindGroupLayout,
    /// Opaque triangles.
    pub opaque: wgpu::RenderPipeline,
    /// Lines of full alpha, which hide what is behind them.
    pub opaque_lines: wgpu::RenderPipeline,
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
            opaque: pass.surface(None),
            opaque_lines: pass.lines(true),
            translucent_back: pass.surface(Some(wgpu::Face::Front)),
            translucent_front: pass.surface(Some(wgpu::Face::Back)),
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
    vertices: wgpu::VertexBufferLayout<'a>,
    primitive: wgpu::PrimitiveState,
    writes_depth: bool,
    bias: wgpu::DepthBiasState,
    blend: Option<wgpu::BlendState>,
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

    /// Opaque triangles, or translucent ones without the given face.
    fn surface(&self, translucent_cull: Option<wgpu::Face>) -> wgpu::RenderPipeline {
        let opaque = translucent_cull.is_none();
        self.draw(Draw {
            label: "scene3d surface",
            entry_points: [
                "vs_surface",
                if opaque {
                    "fs_opaque"
                } else {
                    "fs_translucent"
                },
            ],
            vertices: wgpu::VertexBufferLayout {
                array_stride: size_of::<Vertex>() as u64,
                step_mode: wgpu::VertexStepMode::Vertex,
                attributes: &wgpu::vertex_attr_array![
                    0 => Float32x3, 1 => Float32x3, 2 => Unorm8x4
                ],
            },
            primitive: wgpu::PrimitiveState {
                cull_mode: translucent_cull,
                ..Default::default()
            },
            writes_depth: opaque,
            bias: if opaque {
                SURFACE_DEPTH_BIAS
            } else {
                wgpu::DepthBiasState::default()
            },
            blend: (!opaque).then_some(wgpu::BlendState::ALPHA_BLENDING),
        })
    }

    /// Lines, one instance each. Blended even if opaque, for their soft edges.
    fn lines(&self, writes_depth: bool) -> wgpu::RenderPipeline {
        self.draw(Draw {
            label: "scene3d lines",
            entry_points: ["vs_line", "fs_line"],
            vertices: wgpu::VertexBufferLayout {
                array_stride: size_of::<Line>() as u64,
                step_mode: wgpu::VertexStepMode::Instance,
                attributes: &wgpu::vertex_attr_array![
                    0 => Float32x3, 1 => Float32x3, 2 => Unorm8x4, 3 => Float32
                ],
            },
            primitive: wgpu::PrimitiveState {
                topology: wgpu::PrimitiveTopology::TriangleStrip,
                ..Default::default()
            },
            writes_depth,
            // The shader lifts lines off their surface instead.
            bias: wgpu::DepthBiasState::default(),
            blend: Some(wgpu::BlendState::ALPHA_BLENDING),
        })
    }

    fn draw(&self, draw: Draw<'_>) -> wgpu::RenderPipeline {
        let [vertex, fragment] = draw.entry_points;
        self.device
            .create_render_pipeline(&wgpu::RenderPipelineDescriptor {
                label: Some(draw.label),
                layout: Some(&self.layout),
                vertex: wgpu::VertexState {
                    module: &self.module,
                    entry_point: Some(vertex),
                    compilation_options: wgpu::PipelineCompilationOptions::default(),
                    buffers: &[Some(draw.vertices)],
                },
                primitive: draw.primitive,
                depth_stencil: Some(wgpu::DepthStencilState {
                    format: DEPTH_FORMAT,
                    depth_write_enabled: Some(draw.writes_depth),
                    depth_compare: Some(wgpu::CompareFunction::Less),
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
