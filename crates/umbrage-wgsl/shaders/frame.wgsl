// What every shader of a frame knows: the camera, the biases, the lights and their views. `src/frame.rs` writes it, and a test
// holds that both lay it out alike.
//
// World-space positions are relative to the frame's origin: the world's own, or one near the eye that the host has chosen
// so that f32 holds what lies around it.

struct UmbrageView {
    /// The view's local space to its own clip space, with reversed depth: 1 near the light, 0 far from it.
    clip_from_local: mat4x4f,
    /// Upper left corner of the tile and its side, texels; and the array layer that holds it.
    tile: vec4f,
    /// The view depths that the view serves, metres; and the farther one as reversed clip depth.
    depth_start: f32,
    depth_end: f32,
    clip_depth_end: f32,
    /// From the view's near plane to its far one along the light's axis, and from a punctual light's apex to the near plane,
    /// metres.
    depth_metres: f32,
    near_metres: f32,
    /// The kind of the view's light: a constant of `light.wgsl`.
    light_kind: u32,
    /// A warp scales stored depth by a factor that is constant along each light ray: dot(this, (x, y, 1)) at x, y of NDC.
    depth_scale: vec3f,
    /// How far the view's casters may lie from those that are meant, metres.
    caster_error: f32,
    /// Where local space begins: at the apex of a punctual light, and at the origin for a sun. Its axes are the world's.
    local_origin: vec3f,
    /// Where the tile's upper left texel lies in the lattice of the light's own texels, which no camera moves where the fit
    /// moves the map by whole texels.
    lattice: vec2u,
    /// How much rounding may make of a stored depth and of the one that it is compared with: x, and y times the stored depth.
    depth_rounding: vec2f,
    /// A place of local space p may be held by the view's map, with a filter's whole footprint, where neither
    /// dot(held_x, (p, 1)) nor dot(held_y, (p, 1)) is farther from 0 than dot(held_w, (p, 1)).
    held_x: vec4f,
    held_y: vec4f,
    held_w: vec4f,
}

struct UmbrageLight {
    /// The unit direction to a sun, or the position of a punctual light, in world space.
    place: vec3f,
    /// The light's kind: a constant of `light.wgsl`.
    kind: u32,
    /// Index of the light's first view.
    first_view: u32,
    /// Number of the light's views.
    view_count: u32,
    /// The tangent of half the angle that a sun is seen under, or the radius of a punctual light, metres.
    size: f32,
    /// Nothing casts nearer to a punctual light than this, metres along the axis of its views.
    near: f32,
    /// The unit direction in which a spot shines; 0 for other lights.
    axis: vec3f,
    /// How far the light shines, metres.
    range: f32,
    /// The cosine of the angle from a spot's axis to its rim; below −1 for other lights.
    cos_rim: f32,
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
    /// How far a receiver's plane is taken to bend toward the light a texel beside it, texels over the cosine.
    bias_bend: f32,
    /// Offset along the normal, in reaches of the filter.
    bias_normal: f32,
    /// Cosine of the angle between normal and light up to which light fades in.
    terminator: f32,
    /// How far behind the first surface the stored depth may lie at most, where two surfaces are drawn, metres.
    depth_layer_limit: f32,
    /// The share of a slice's depth, or of a map's half width, over which views blend into each other.
    blend: f32,
    /// How casters are drawn that cover in part: a constant of `caster/covers.wgsl`.
    transparent_casters: u32,
    /// What a shadow does to the picture: a constant of `receiver/shade.wgsl`.
    shade: u32,
    /// How much of that a full shadow does, 0 to 1.
    darkness: f32,
    /// The colour that a shadow lays over the picture, and how much of the picture it covers.
    shadow_colour: vec4f,
    /// In which order texels of 32² are drawn as coverage grows: 8 bits each, row by row.
    levels: array<array<vec4u, 2>, 32>,
    lights: array<UmbrageLight, 16>,
    views: array<UmbrageView>,
}

@group(0) @binding(0) var<storage, read> umbrage_frame: UmbrageFrame;
