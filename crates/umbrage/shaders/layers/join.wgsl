// From the first two surfaces that the light meets to the one depth that is stored. Where there is no second one, it is taken to
// lie twice the limit behind the first. Casters before the near plane are flattened onto it, both surfaces at once, and then
// the second is not theirs: all that the view shows is in their shadow.

@group(0) @binding(1) var<uniform> umbrage_joined_view: vec4u;
@group(0) @binding(2) var umbrage_first: texture_depth_2d_array;
@group(0) @binding(3) var umbrage_second: texture_depth_2d_array;

/// A triangle over the whole tile.
@vertex
fn everywhere(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return vec4f(vec2f(f32(index & 1u), f32(index >> 1u)) * 4.0 - 1.0, 0.0, 1.0);
}

/// How much stored depth grows a metre along the light, at a depth that is stored: the inverse of how even depth grows.
fn umbrage_steepness(texel: vec2f, stored: f32) -> f32 {
    let view_index = umbrage_joined_view.x;
    let deep = umbrage_frame.views[view_index].depth_metres;
    let ndc = texel / umbrage_frame.views[view_index].tile_size * vec2f(2.0, -2.0) + vec2f(-1.0, 1.0);
    let weight = dot(umbrage_frame.views[view_index].inverse_weight, vec3f(ndc, 1.0));
    if umbrage_frame.views[view_index].spreads == 0u {
        return weight / deep;
    }
    // Stored depth is (1 / near − 1 / d) / (1 / near − 1 / far).
    let near = umbrage_frame.views[view_index].near_metres;
    let metres = near + umbrage_linear_depth(view_index, texel, stored) * deep;
    return weight * near * (near + deep) / (deep * metres * metres);
}

@fragment
fn join(@builtin(position) position: vec4f) -> @builtin(frag_depth) f32 {
    let view_index = umbrage_joined_view.x;
    let layer = umbrage_frame.views[view_index].layer;
    let first = textureLoad(umbrage_first, vec2i(position.xy), layer, 0);
    // Nothing is there, or a caster before the near plane.
    if first >= 1.0 || first <= 0.0 {
        return first;
    }
    let second = textureLoad(umbrage_second, vec2i(position.xy), layer, 0);
    let texel = position.xy - umbrage_frame.views[view_index].tile_origin;
    let limit = UMBRAGE_DEPTH_LAYER_LIMIT * umbrage_steepness(texel, first);
    return min(umbrage_joined(first, select(second, first + 2.0 * limit, second >= 1.0), limit), 1.0);
}
