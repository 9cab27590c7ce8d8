// What every shader of a frame knows: the views, the lights, and how a receiver finds its view.
// Written once a frame by `Shadows::upload`; laid out as in `gpu_types.rs`, which a test compares.

struct UmbrageView {
    /// World space to the view's own clip space.
    clip_from_world: mat4x4f,
    /// Upper left corner of the tile, texels.
    tile_origin: vec2f,
    /// Side of the tile, texels.
    tile_size: f32,
    /// Array layer.
    layer: i32,
    /// The view depths that it serves, metres; and the farther one as reversed clip depth.
    depth_start: f32,
    depth_end: f32,
    clip_depth_end: f32,
}

struct UmbrageLight {
    /// In world space: the unit direction to a sun, and 0; or the place of a lamp, and 1.
    place: vec4f,
    /// Index of its first view.
    first_view: u32,
    view_count: u32,
    /// 1 where the views are the faces of a cube.
    is_cube: u32,
}

struct UmbrageFrame {
    /// View depth of world point p is dot(depth_row, vec4(p, 1)), metres.
    depth_row: vec4f,
    /// The camera's reversed clip depth is dot(clip_z_row, …) / dot(clip_w_row, …).
    clip_z_row: vec4f,
    clip_w_row: vec4f,
    /// View depth at which shadows end, metres.
    shadow_end: f32,
    light_count: u32,
    /// Size of the maps' texture, texels.
    map_size: vec2f,
    /// Bias toward the light, metres.
    bias_constant: f32,
    /// Bias toward the light, texels times tangent.
    bias_slope: f32,
    bias_slope_limit: f32,
    /// Offset along the normal, in texels: kernel half width · bias.normal.
    bias_normal: f32,
    shadow_colour: vec4f,
    darkness: f32,
    /// How much a stored depth may differ from the one that was drawn.
    depth_step: f32,
    lights: array<UmbrageLight, 16>,
    views: array<UmbrageView>,
}

@group(0) @binding(0) var<storage, read> umbrage_frame: UmbrageFrame;
