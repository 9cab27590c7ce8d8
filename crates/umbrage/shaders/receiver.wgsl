// What a receiver's fragment shader needs: how much of a light reaches a point, 1 for all and 0 for none.
//
// `umbrage_select` comes from a file of `select/`, `umbrage_gradient` from one of `reference/`, `umbrage_filter` from one
// of `filter/`, `umbrage_shade` from one of `shade/`.

@group(0) @binding(1) var umbrage_map: texture_depth_2d_array;
@group(0) @binding(2) var umbrage_compare: sampler_comparison;

/// No view serves the receiver.
const UMBRAGE_NO_VIEW: u32 = 0xffffffffu;

/// A place in a shadow map, and what to compare with what is stored there.
struct UmbrageLookup {
    /// In texels from the tile's upper left corner.
    texel: vec2f,
    /// Depth of the receiver in the view, before bias.
    depth: f32,
    /// Depth to compare with: lit where it is not greater than the stored one.
    reference: f32,
    /// How much the depth to compare with grows from a texel to the next, to the right and downward.
    gradient: vec2f,
}

/// View depth of a point, metres from the eye.
fn umbrage_view_depth(world_position: vec3f) -> f32 {
    return dot(umbrage_frame.depth_row, vec4f(world_position, 1.0));
}

/// Where a receiver looks in a view, bias included. `world_normal` is the unit geometric normal.
fn umbrage_lookup(view_index: u32, light: u32, world_position: vec3f, world_normal: vec3f) -> UmbrageLookup {
    let to_light = umbrage_frame.lights[light].direction_to_light;
    let texel_metres = umbrage_frame.views[view_index].texel_metres;
    let cosine = clamp(dot(world_normal, to_light), 0.0, 1.0);
    let sine = sqrt(max(1.0 - cosine * cosine, 0.0));
    let tangent = min(sine / max(cosine, 1e-6), umbrage_frame.bias_slope_limit);
    let receiver = world_position + world_normal * (umbrage_frame.bias_normal * texel_metres * sine);
    let clip = umbrage_frame.views[view_index].clip_from_world * vec4f(receiver, 1.0);
    let ndc = clip.xyz / clip.w;
    let toward_light = umbrage_frame.bias_constant + umbrage_frame.bias_slope * texel_metres * tangent;
    let tile_size = umbrage_frame.views[view_index].tile_size;
    var lookup: UmbrageLookup;
    lookup.texel = (ndc.xy * vec2f(0.5, -0.5) + 0.5) * tile_size;
    lookup.depth = ndc.z;
    lookup.reference = ndc.z - toward_light / umbrage_frame.views[view_index].depth_metres - umbrage_frame.depth_step;
    lookup.gradient = umbrage_gradient(view_index, world_normal, cosine);
    return lookup;
}

/// Texture coordinates of a place in a tile, given in texels; places outside are moved to the outermost texels.
fn umbrage_uv(view_index: u32, texel: vec2f) -> vec2f {
    let tile_size = umbrage_frame.views[view_index].tile_size;
    let inside = clamp(texel, vec2f(0.5), vec2f(tile_size - 0.5));
    return (umbrage_frame.views[view_index].tile_origin + inside) / umbrage_frame.map_size;
}

/// Whether the texel around `centre` leaves a receiver at `texel` lit: 1 or 0. `reference` is the depth to compare with
/// at `texel`, and nothing that is stored lies beyond 1.
fn umbrage_lit(view_index: u32, centre: vec2f, texel: vec2f, reference: f32, gradient: vec2f) -> f32 {
    let tile_size = umbrage_frame.views[view_index].tile_size;
    let inside = clamp(centre, vec2f(0.5), vec2f(tile_size - 0.5));
    let reference_there = min(reference + dot(gradient, inside - texel), 1.0);
    // The texel's centre: samplers round coordinates to fewer bits than f32 has. Not a load, which GL has not for depth.
    let uv = umbrage_uv(view_index, inside);
    let layer = umbrage_frame.views[view_index].layer;
    return textureSampleCompareLevel(umbrage_map, umbrage_compare, uv, layer, reference_there);
}

/// Index of the view that serves a receiver, or UMBRAGE_NO_VIEW.
fn umbrage_view_of(light: u32, world_position: vec3f, world_normal: vec3f) -> u32 {
    if light >= umbrage_frame.light_count {
        return UMBRAGE_NO_VIEW;
    }
    let depth = umbrage_view_depth(world_position);
    if depth > umbrage_frame.split_ends[umbrage_frame.split_count - 1u] {
        return UMBRAGE_NO_VIEW;
    }
    return umbrage_select(light, depth, world_position, world_normal);
}

/// How much of one light reaches a world-space point. Points outside every map are lit, and so is everything by a light
/// that the plan does not have. `pixel` is the fragment's
/// position on screen.
fn umbrage_light_visibility(light: u32, world_position: vec3f, world_normal: vec3f, pixel: vec2f) -> f32 {
    let view_index = umbrage_view_of(light, world_position, world_normal);
    if view_index == UMBRAGE_NO_VIEW {
        return 1.0;
    }
    let lookup = umbrage_lookup(view_index, light, world_position, world_normal);
    let tile_size = umbrage_frame.views[view_index].tile_size;
    let outside = any(lookup.texel < vec2f(0.0)) || any(lookup.texel > vec2f(tile_size)) || lookup.depth > 1.0;
    if outside {
        return 1.0;
    }
    return umbrage_filter(view_index, lookup.texel, lookup.reference, lookup.gradient, pixel);
}

/// How much of the first light reaches a world-space point.
fn umbrage_visibility(world_position: vec3f, world_normal: vec3f, pixel: vec2f) -> f32 {
    return umbrage_light_visibility(0u, world_position, world_normal, pixel);
}
