// Where receivers' matrices, tiles and texels come from, and which way depth grows: all address arithmetic of the lookup. The
// technique above asks in texels of a tile, counted from its upper left corner, and in depths from 1 near the light to 0 far. A
// host that keeps its maps otherwise replaces this file.

import package::frame::umbrage_frame;

@group(0) @binding(1) var umbrage_map: texture_depth_2d_array;

/// From the local space of a view to its clip space: x, y in −1…1 over its tile, depth 1 near the light to 0 far.
fn umbrage_clip_from_local(view_index: u32) -> mat4x4f {
    return umbrage_frame.views[view_index].clip_from_local;
}

/// A world-space position in the local space of a view, which begins at the apex of a punctual light: what is subtracted is
/// as large as the position, so that no matrix has to hold it.
fn umbrage_local(view_index: u32, world_position: vec3f) -> vec3f {
    return world_position - umbrage_frame.views[view_index].local_origin;
}

/// Whether a view's map may hold a place of its local space with a filter's whole footprint: `false` is certain, where the bias
/// moves no lookup aside. It reads less than a lookup does.
fn umbrage_may_hold(view_index: u32, local: vec3f) -> bool {
    let point = vec4f(local, 1.0);
    let x = dot(umbrage_frame.views[view_index].held_x, point);
    let y = dot(umbrage_frame.views[view_index].held_y, point);
    return max(abs(x), abs(y)) <= dot(umbrage_frame.views[view_index].held_w, point);
}

/// Upper left corner of a view's tile and its side, texels; and the array layer that holds it.
fn umbrage_tile(view_index: u32) -> vec4f {
    return umbrage_frame.views[view_index].tile;
}

/// Side of a view's tile, texels.
fn umbrage_tile_size(view_index: u32) -> f32 {
    return umbrage_tile(view_index).z;
}

/// How far a view's casters may lie from those that are meant, metres.
fn umbrage_caster_error(view_index: u32) -> f32 {
    return umbrage_frame.views[view_index].caster_error;
}

/// The array layer that holds a view's tile.
fn umbrage_layer(view_index: u32) -> i32 {
    return i32(umbrage_tile(view_index).w);
}

/// A place of a tile, moved to the centres of the outermost texels where it lies beyond them.
fn umbrage_inside(view_index: u32, texel: vec2f) -> vec2f {
    return clamp(texel, vec2f(0.5), vec2f(umbrage_tile_size(view_index) - 0.5));
}

/// Texture coordinates of a place of a tile; places nearer to the tile's border than `inset` texels are moved inward.
fn umbrage_uv(view_index: u32, texel: vec2f, inset: f32) -> vec2f {
    let inside = clamp(texel, vec2f(inset), vec2f(umbrage_tile_size(view_index) - inset));
    return (umbrage_tile(view_index).xy + inside) / umbrage_frame.map_size;
}

/// The place of a tile that has these texture coordinates.
fn umbrage_texel_of_uv(view_index: u32, uv: vec2f) -> vec2f {
    return uv * umbrage_frame.map_size - umbrage_tile(view_index).xy;
}

/// A step of texels as a step of texture coordinates.
fn umbrage_uv_step(texels: vec2f) -> vec2f {
    return texels / umbrage_frame.map_size;
}

/// Where the texture holds a texel of a tile.
fn umbrage_address(view_index: u32, texel: vec2i) -> vec2i {
    return vec2i(umbrage_tile(view_index).xy) + texel;
}

/// Where the texture holds the texel around a place of a tile.
fn umbrage_address_around(view_index: u32, texel: vec2f) -> vec2i {
    return vec2i(umbrage_tile(view_index).xy + texel);
}
