// 3D scene of one view, drawn offscreen, and the copy of the result into egui's pass.
//
// Colours are gamma-encoded sRGB throughout, as in egui, so that a vertex colour, a colour map
// and the panel behind the view look the same in 3D as in 2D.

struct View {
    view_proj: mat4x4<f32>,
    eye: vec3<f32>,
    pixels_per_point: f32,
    // Size of the offscreen target in pixels.
    target_size: vec2<f32>,
    // Top-left corner of the view on screen, in pixels.
    screen_origin: vec2<f32>,
    // Target texels per screen pixel; 1 unless the view is larger than the device's textures.
    texels_per_pixel: vec2<f32>,
    padding: vec2<f32>,
}

@group(0) @binding(0) var<uniform> view: View;
@group(1) @binding(0) var rendered: texture_2d<f32>;

// Share of the light that does not depend on the normal. High, because the colour carries a value.
const AMBIENT: f32 = 0.65;
// How much the outline of an opaque surface darkens, to set it off against what is behind.
const RIM_DARKENING: f32 = 0.12;
// How much denser a translucent surface is where it is seen edge-on, as a shell of glass would be.
const RIM_DENSITY: f32 = 1.6;
// Lines are drawn this fraction of their distance closer, to lie on top of the surface they mark.
const LINE_LIFT: f32 = 0.0015;
// Lines are cut this far in front of the eye, in world units; in front of any near plane.
const MIN_CLIP_W: f32 = 1e-3;

struct SurfaceVarying {
    @builtin(position) clip: vec4<f32>,
    @location(0) world: vec3<f32>,
    @location(1) normal: vec3<f32>,
    @location(2) color: vec4<f32>,
}

@vertex
fn vs_surface(
    @location(0) position: vec3<f32>,
    @location(1) normal: vec3<f32>,
    @location(2) color: vec4<f32>,
) -> SurfaceVarying {
    return SurfaceVarying(view.view_proj * vec4(position, 1.0), position, normal, color);
}

// |cosine| between the surface normal and the direction to the eye.
fn facing(in: SurfaceVarying) -> f32 {
    // Derivatives need uniform control flow, so the flat normal is computed in any case.
    let flat_normal = cross(dpdx(in.world), dpdy(in.world));
    let normal = select(flat_normal, in.normal, dot(in.normal, in.normal) > 1e-8);
    let scale = max(length(normal), 1e-20);
    return abs(dot(normal / scale, normalize(view.eye - in.world)));
}

@fragment
fn fs_opaque(in: SurfaceVarying) -> @location(0) vec4<f32> {
    let cosine = facing(in);
    let light = AMBIENT + (1.0 - AMBIENT) * cosine;
    let rim = 1.0 - RIM_DARKENING * pow(1.0 - cosine, 3.0);
    return vec4(in.color.rgb * light * rim, 1.0);
}

@fragment
fn fs_translucent(in: SurfaceVarying) -> @location(0) vec4<f32> {
    let density = 1.0 + RIM_DENSITY * pow(1.0 - facing(in), 3.0);
    return vec4(in.color.rgb, min(in.color.a * density, 1.0));
}

struct LineVarying {
    @builtin(position) clip: vec4<f32>,
    @location(0) color: vec4<f32>,
    // Signed distance from the centre line in pixels, times w; and w. The quotient is linear on
    // screen, which plain interpolation is not when the ends have different depths.
    @location(1) offset: vec2<f32>,
    @location(2) half_width: f32,
}

fn lifted_clip(position: vec3<f32>) -> vec4<f32> {
    return view.view_proj * vec4(mix(position, view.eye, LINE_LIFT), 1.0);
}

// An end of a line; if it is behind the eye, the point of the line just in front of the eye.
fn clipped_end(end: vec4<f32>, other: vec4<f32>) -> vec4<f32> {
    if end.w >= MIN_CLIP_W || other.w <= MIN_CLIP_W {
        return end;
    }
    return mix(end, other, (MIN_CLIP_W - end.w) / (other.w - end.w));
}

@vertex
fn vs_line(
    @builtin(vertex_index) corner: u32,
    @location(0) a: vec3<f32>,
    @location(1) b: vec3<f32>,
    @location(2) color: vec4<f32>,
    @location(3) width: f32,
) -> LineVarying {
    let unclipped_a = lifted_clip(a);
    let unclipped_b = lifted_clip(b);
    let clip_a = clipped_end(unclipped_a, unclipped_b);
    let clip_b = clipped_end(unclipped_b, unclipped_a);
    let half_size = 0.5 * view.target_size;
    let along = (clip_b.xy / clip_b.w - clip_a.xy / clip_a.w) * half_size;
    let direction = select(vec2(1.0, 0.0), normalize(along), dot(along, along) > 1e-12);

    // A line thinner than a pixel is drawn one pixel wide but fainter, which does not flicker.
    let width_pixels = width * view.pixels_per_point;
    let half_width = 0.5 * max(width_pixels, 1.0);
    let fade = min(width_pixels, 1.0);
    // Half a pixel more on each side for the soft edge.
    let reach = select(-1.0, 1.0, (corner & 1u) == 1u) * (half_width + 0.5);
    let end = select(clip_a, clip_b, corner >= 2u);
    let shift = vec2(-direction.y, direction.x) * reach / half_size;

    var out: LineVarying;
    out.clip = vec4(end.xy + shift * end.w, end.zw);
    out.color = vec4(color.rgb, color.a * fade);
    out.offset = vec2(reach, 1.0) * end.w;
    out.half_width = half_width;
    return out;
}

@fragment
fn fs_line(in: LineVarying) -> @location(0) vec4<f32> {
    let coverage = clamp(in.half_width + 0.5 - abs(in.offset.x / in.offset.y), 0.0, 1.0);
    return vec4(in.color.rgb, in.color.a * coverage);
}

// One triangle that covers the viewport.
@vertex
fn vs_copy(@builtin(vertex_index) corner: u32) -> @builtin(position) vec4<f32> {
    let x = select(-1.0, 3.0, corner == 1u);
    let y = select(-1.0, 3.0, corner == 2u);
    return vec4(x, y, 0.0, 1.0);
}

// Fetches by screen position instead of filtering: the copy is exact, also where egui clips the
// view at the edge of the screen.
fn rendered_at(screen: vec4<f32>) -> vec3<f32> {
    let texel = vec2<i32>(floor((screen.xy - view.screen_origin) * view.texels_per_pixel));
    let last = vec2<i32>(textureDimensions(rendered)) - vec2(1, 1);
    return textureLoad(rendered, clamp(texel, vec2(0, 0), last), 0).rgb;
}

@fragment
fn fs_copy_gamma(@builtin(position) screen: vec4<f32>) -> @location(0) vec4<f32> {
    return vec4(rendered_at(screen), 1.0);
}

// For a target that encodes sRGB on writing, which would otherwise happen twice.
@fragment
fn fs_copy_linear(@builtin(position) screen: vec4<f32>) -> @location(0) vec4<f32> {
    let gamma = rendered_at(screen);
    let high = pow((gamma + vec3(0.055)) / 1.055, vec3(2.4));
    return vec4(select(high, gamma / 12.92, gamma < vec3(0.04045)), 1.0);
}
