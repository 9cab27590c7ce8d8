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
    /// From its near plane to its far one along the light's axis, and from the tip of a lamp to its near plane, metres.
    depth_metres: f32,
    near_metres: f32,
    /// 1 where its rays spread from a tip.
    spreads: u32,
    /// What a warp divides stored depth by at x, y of NDC is the inverse of dot(this, (x, y, 1)).
    inverse_weight: vec3f,
}

struct UmbrageLight {
    /// In world space: the unit direction to a sun, and 0; or the place of a lamp, and 1.
    place: vec4f,
    /// Index of its first view.
    first_view: u32,
    view_count: u32,
    /// 1 where the views are the faces of a cube.
    is_cube: u32,
    /// How large it is: the tangent of half the angle that a sun is seen under, or the radius of a lamp, metres.
    size: f32,
}

struct UmbrageFrame {
    /// View depth of world point p is dot(depth_row, vec4(p, 1)), metres.
    depth_row: vec4f,
    /// The camera's NDC x is dot(clip_x_row, …) / dot(clip_w_row, …), and so are y and its reversed depth.
    clip_x_row: vec4f,
    clip_y_row: vec4f,
    clip_z_row: vec4f,
    clip_w_row: vec4f,
    /// View depth at which shadows end, metres.
    shadow_end: f32,
    light_count: u32,
    /// Size of the maps' texture, texels.
    map_size: vec2f,
    /// Size of the camera's picture, pixels.
    picture_size: vec2f,
    /// Bias toward the light, metres.
    bias_constant: f32,
    /// Bias toward the light, texels times tangent.
    bias_slope: f32,
    bias_slope_limit: f32,
    /// Offset along the normal, in reaches of the filter.
    bias_normal: f32,
    /// Cosine of the angle between normal and light up to which light fades in.
    terminator: f32,
    shadow_colour: vec4f,
    darkness: f32,
    /// How much a stored depth may differ from the one that was drawn.
    depth_step: f32,
    lights: array<UmbrageLight, 16>,
    views: array<UmbrageView>,
}

@group(0) @binding(0) var<storage, read> umbrage_frame: UmbrageFrame;
