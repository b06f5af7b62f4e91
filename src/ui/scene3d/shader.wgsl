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
    // Towards the key and the rim light, unit vectors.
    key: vec4<f32>,
    rim: vec4<f32>,
    // The backdrop at the edges of the view and in its middle.
    edge: vec4<f32>,
    middle: vec4<f32>,
}

@group(0) @binding(0) var<uniform> view: View;
@group(1) @binding(0) var rendered: texture_2d<f32>;

// Of small marks, the share of the light that does not depend on the normal: they are known by their colour.
const MARK_AMBIENT: f32 = 0.65;
// Matt surfaces: the light from everywhere, the key light's and the rim light's.
const AMBIENT: f32 = 0.5;
const KEY: f32 = 0.56;
const RIM: f32 = 0.3;
// Near the centre, where all lobes begin, and near the surface, less light arrives: that is left there, and how far it
// reaches, in world units.
const AT_CENTRE: f32 = 0.5;
const CENTRE_REACH: f32 = 0.35;
const AT_SURFACE: f32 = 0.8;
const SURFACE_REACH: f32 = 0.16;
// Strength of the grain of the ground, and the size of a grain in world units: three pixels of a picture of 600.
const GRAIN: f32 = 0.02;
const GRAIN_SIZE: f32 = 0.011;
// Where the backdrop has the colour of the edges, in half narrow sides from the middle.
const BACKDROP_REACH: f32 = 1.1;
// Width of a shell's outline in points, and how much of it is seen where something is in front of it.
const OUTLINE_WIDTH: f32 = 1.6;
const OUTLINE_HIDDEN: f32 = 0.35;
// How much denser a translucent surface is where it is seen edge-on, as a shell of glass would be.
const RIM_DENSITY: f32 = 1.6;
// Lines are drawn this fraction of their distance closer, to lie on top of the surface they mark; those that are blended a
// little less, so that an opaque one lies on its own halo.
const LINE_LIFT: f32 = 0.0015;
const BLENDED_LIFT: f32 = 0.0012;
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

// The surface normal, a unit vector on the side of the eye.
fn normal_to_eye(in: SurfaceVarying, to_eye: vec3<f32>) -> vec3<f32> {
    // Derivatives need uniform control flow, so the flat normal is computed in any case.
    let flat_normal = cross(dpdx(in.world), dpdy(in.world));
    let normal = select(flat_normal, in.normal, dot(in.normal, in.normal) > 1e-8);
    let unit = normal / max(length(normal), 1e-20);
    return select(-unit, unit, dot(unit, to_eye) >= 0.0);
}

// |cosine| between the surface normal and the direction to the eye.
fn facing(in: SurfaceVarying) -> f32 {
    let to_eye = normalize(view.eye - in.world);
    return dot(normal_to_eye(in, to_eye), to_eye);
}

@fragment
fn fs_opaque(in: SurfaceVarying) -> @location(0) vec4<f32> {
    return vec4(in.color.rgb * mix(MARK_AMBIENT, 1.0, facing(in)), 1.0);
}

// What a matt surface of this colour looks like where this share of the light from everywhere arrives.
fn matt(color: vec3<f32>, normal: vec3<f32>, to_eye: vec3<f32>, open: f32) -> vec3<f32> {
    // The key light wraps around, as that of a large lamp does.
    let key = 0.5 + 0.5 * dot(normal, view.key.xyz);
    let edge = pow(1.0 - max(dot(normal, to_eye), 0.0), 3.0);
    let rim = edge * max(dot(normal, view.rim.xyz), 0.0);
    return color * (AMBIENT + KEY * key * key) * open + vec3(RIM * rim * open);
}

@fragment
fn fs_body(in: SurfaceVarying) -> @location(0) vec4<f32> {
    let to_eye = normalize(view.eye - in.world);
    let normal = normal_to_eye(in, to_eye);
    let at_centre = mix(AT_CENTRE, 1.0, smoothstep(0.0, CENTRE_REACH, length(in.world)));
    let at_surface = mix(AT_SURFACE, 1.0, smoothstep(0.0, SURFACE_REACH, abs(in.world.z)));
    return vec4(matt(in.color.rgb, normal, to_eye, at_centre * at_surface), 1.0);
}

// A number without order for each cell of a grid, 0 to 1 (Hoskins' hash without sine).
fn hash(cell: vec2<f32>) -> f32 {
    var p = fract(vec3(cell.xyx) * 0.1031);
    p += dot(p, p.yzx + 33.33);
    return fract((p.x + p.y) * p.z);
}

// A smooth height over the plane, 0 to 1, with bumps of one unit.
fn bumps(place: vec2<f32>) -> f32 {
    let cell = floor(place);
    let part = smoothstep(vec2(0.0), vec2(1.0), place - cell);
    let low = mix(hash(cell), hash(cell + vec2(1.0, 0.0)), part.x);
    let high = mix(hash(cell + vec2(0.0, 1.0)), hash(cell + vec2(1.0, 1.0)), part.x);
    return mix(low, high, part.y);
}

@fragment
fn fs_ground(in: SurfaceVarying) -> @location(0) vec4<f32> {
    let to_eye = normalize(view.eye - in.world);
    let normal = normal_to_eye(in, to_eye);
    let lit = matt(in.color.rgb, normal, to_eye, 1.0);
    // On the side, the grain of the top would be streaks.
    let strength = GRAIN * smoothstep(0.5, 1.0, normal.z);
    if view.eye.z < 0.0 {
        discard;
    }
    let grain = 1.0 + strength * (2.0 * bumps(in.world.xy / GRAIN_SIZE) - 1.0);
    return vec4(lit * grain, 1.0);
}

// How much of a pixel of a shell is outline: the place where it is seen edge-on is found by how fast it turns away.
fn outline(cosine: f32) -> f32 {
    let pixels = cosine / max(fwidth(cosine), 1e-6);
    let width = max(OUTLINE_WIDTH * view.pixels_per_point, 1.0);
    return 1.0 - smoothstep(0.5 * width, 1.5 * width, pixels);
}

@fragment
fn fs_shell(in: SurfaceVarying) -> @location(0) vec4<f32> {
    let cosine = facing(in);
    let skin = in.color.a * (1.0 + RIM_DENSITY * pow(1.0 - cosine, 3.0));
    return vec4(in.color.rgb, min(max(skin, outline(cosine)), 1.0));
}

@fragment
fn fs_hidden_shell(in: SurfaceVarying) -> @location(0) vec4<f32> {
    return vec4(in.color.rgb, OUTLINE_HIDDEN * outline(facing(in)));
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

fn lifted_clip(position: vec3<f32>, lift: f32) -> vec4<f32> {
    return view.view_proj * vec4(mix(position, view.eye, lift), 1.0);
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
    let lift = select(BLENDED_LIFT, LINE_LIFT, color.a == 1.0);
    let unclipped_a = lifted_clip(a, lift);
    let unclipped_b = lifted_clip(b, lift);
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

@fragment
fn fs_backdrop(@builtin(position) place: vec4<f32>) -> @location(0) vec4<f32> {
    let narrow = 0.5 * min(view.target_size.x, view.target_size.y);
    let distance = length(place.xy - 0.5 * view.target_size) / narrow;
    let lift = 1.0 - smoothstep(0.0, BACKDROP_REACH, distance);
    return vec4(mix(view.edge.rgb, view.middle.rgb, lift), 1.0);
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
