// What a receiver's fragment shader needs: how much of a light reaches a point, 1 for all and 0 for none.
//
// `umbrage_texel_basis` comes from `texel_basis.wgsl`, `umbrage_select` from a file of `select/`, `umbrage_gradient` and
// `umbrage_normal_offset` from one of `reference/`, `umbrage_offset_reach` from one of `reach/`, `umbrage_filter` from one of
// `filter/`, `umbrage_blend` from one of `blend/`, `umbrage_shade` from one of `shade/`.

@group(0) @binding(1) var umbrage_map: texture_depth_2d_array;
@group(0) @binding(2) var umbrage_compare: sampler_comparison;

/// No view serves the receiver.
const UMBRAGE_NO_VIEW: u32 = 0xffffffffu;

/// Who asks.
struct UmbrageReceiver {
    /// World space, metres.
    position: vec3f,
    /// Unit geometric normal.
    normal: vec3f,
    /// Its fragment's position on screen.
    pixel: vec2f,
    /// From the eye, metres.
    depth: f32,
}

/// A place in a shadow map, and what to compare with what is stored there.
struct UmbrageLookup {
    view_index: u32,
    light: u32,
    /// In texels from the tile's upper left corner; outside of it where the receiver is behind the light.
    texel: vec2f,
    /// Depth to compare with: lit where it is not greater than the stored one.
    reference: f32,
    /// How much the depth to compare with grows from a texel to the next, to the right and downward.
    gradient: vec2f,
    /// Sides of a texel there across the light, to the right and downward, metres.
    texel_metres: vec2f,
}

/// View depth of a point, metres from the eye.
fn umbrage_view_depth(world_position: vec3f) -> f32 {
    return dot(umbrage_frame.depth_row, vec4f(world_position, 1.0));
}

/// Unit direction from a world-space point to a light.
fn umbrage_direction_to_light(light: u32, world_position: vec3f) -> vec3f {
    let place = umbrage_frame.lights[light].place;
    let toward = place.xyz - world_position * place.w;
    return select(place.xyz, toward * inverseSqrt(max(dot(toward, toward), 1e-30)), place.w > 0.0);
}

/// Where a receiver looks in a view, bias included. `world_normal` is the unit geometric normal.
fn umbrage_lookup(view_index: u32, light: u32, world_position: vec3f, world_normal: vec3f) -> UmbrageLookup {
    let clip_from_world = umbrage_frame.views[view_index].clip_from_world;
    let tile_size = umbrage_frame.views[view_index].tile_size;
    let clip_unbiased = clip_from_world * vec4f(world_position, 1.0);
    if clip_unbiased.w <= 0.0 {
        return UmbrageLookup(view_index, light, vec2f(-1.0), 2.0, vec2f(0.0), vec2f(1.0));
    }
    let texel_basis = umbrage_texel_basis(view_index, clip_unbiased);
    let to_light = umbrage_direction_to_light(light, world_position);
    let cosine = clamp(dot(world_normal, to_light), 0.0, 1.0);
    let sine = sqrt(max(1.0 - cosine * cosine, 0.0));
    let tangent = min(sine / max(cosine, 1e-6), umbrage_frame.bias_slope_limit);
    let texel_metres = max(length(texel_basis.right), length(texel_basis.down));
    let texels = umbrage_frame.bias_normal * umbrage_offset_reach(texel_metres);
    let normal_offset = texels * umbrage_normal_offset(texel_basis, world_normal, to_light);
    let receiver = world_position + world_normal * normal_offset;
    let clip = clip_from_world * vec4f(receiver, 1.0);
    // Toward the light: the place on the map stays.
    let toward_light = umbrage_frame.bias_constant + umbrage_frame.bias_slope * texel_metres * tangent;
    let nearer = dot(texel_basis.depth_gradient, to_light) * toward_light;
    // Rasterisers round corners, so what is stored may be the depth of a place beside.
    let slope = umbrage_slope(texel_basis, world_normal, cosine);
    let rounded = dot(abs(slope), vec2f(UMBRAGE_RASTER_STEP)) + umbrage_frame.depth_step;
    var lookup: UmbrageLookup;
    lookup.view_index = view_index;
    lookup.light = light;
    lookup.texel_metres = vec2f(length(texel_basis.right), length(texel_basis.down));
    lookup.texel = (clip.xy / clip.w * vec2f(0.5, -0.5) + 0.5) * tile_size;
    lookup.reference = clip.z / clip.w + nearer - rounded;
    lookup.gradient = umbrage_gradient(texel_basis, world_normal, to_light);
    return lookup;
}

/// Texture coordinates of a place in a tile, given in texels; places outside are moved to the outermost texels.
fn umbrage_uv(view_index: u32, texel: vec2f) -> vec2f {
    let tile_size = umbrage_frame.views[view_index].tile_size;
    let inside = clamp(texel, vec2f(0.5), vec2f(tile_size - 0.5));
    return (umbrage_frame.views[view_index].tile_origin + inside) / umbrage_frame.map_size;
}

/// The depth to compare with at a place of the tile, given in texels: that of the lookup's plane there. Nothing that is
/// stored lies beyond 1.
fn umbrage_compare_depth(lookup: UmbrageLookup, texel: vec2f) -> f32 {
    return min(lookup.reference + dot(lookup.gradient, texel - lookup.texel), 1.0);
}

/// Whether the texel around `centre` leaves a receiver lit: 1 or 0. It is compared with the depth at its centre.
fn umbrage_lit(lookup: UmbrageLookup, centre: vec2f) -> f32 {
    let tile_size = umbrage_frame.views[lookup.view_index].tile_size;
    let inside = clamp(centre, vec2f(0.5), vec2f(tile_size - 0.5));
    // The texel's centre: samplers round coordinates to fewer bits than f32 has. Not a load, which GL has not for depth.
    let uv = umbrage_uv(lookup.view_index, inside);
    let layer = umbrage_frame.views[lookup.view_index].layer;
    return textureSampleCompareLevel(umbrage_map, umbrage_compare, uv, layer, umbrage_compare_depth(lookup, inside));
}

/// The face of a cube around a lamp that a world-space point is seen through: that of the largest part of its direction.
fn umbrage_face(light: u32, world_position: vec3f) -> u32 {
    let from_light = world_position - umbrage_frame.lights[light].place.xyz;
    let size = abs(from_light);
    let is_x = size.x >= size.y && size.x >= size.z;
    let is_y = !is_x && size.y >= size.z;
    let part = select(select(from_light.z, from_light.y, is_y), from_light.x, is_x);
    return select(select(4u, 2u, is_y), 0u, is_x) + select(0u, 1u, part < 0.0);
}

/// Index of the view that serves a receiver, or UMBRAGE_NO_VIEW.
fn umbrage_view_of(light: u32, world_position: vec3f, world_normal: vec3f) -> u32 {
    if light >= umbrage_frame.light_count {
        return UMBRAGE_NO_VIEW;
    }
    let depth = umbrage_view_depth(world_position);
    if depth > umbrage_frame.shadow_end {
        return UMBRAGE_NO_VIEW;
    }
    if umbrage_frame.lights[light].is_cube == 1u {
        return umbrage_frame.lights[light].first_view + umbrage_face(light, world_position);
    }
    return umbrage_select(light, depth, world_position, world_normal);
}

/// What a view says of a receiver. Points outside the map are lit.
fn umbrage_read(lookup: UmbrageLookup, receiver: UmbrageReceiver) -> f32 {
    let tile_size = umbrage_frame.views[lookup.view_index].tile_size;
    let outside =
        any(lookup.texel < vec2f(0.0)) || any(lookup.texel > vec2f(tile_size)) || lookup.reference > 1.0;
    if outside {
        return 1.0;
    }
    return umbrage_filter(lookup, receiver);
}

fn umbrage_visibility_in(view_index: u32, light: u32, receiver: UmbrageReceiver) -> f32 {
    return umbrage_read(umbrage_lookup(view_index, light, receiver.position, receiver.normal), receiver);
}

/// How much of one light reaches a world-space point. Points outside every map are lit, and so is everything by a light
/// that the plan does not have; surfaces that are turned away from it are dark. What lies outside of a spot's cone may be
/// either: its shading leaves that dark. `world_normal` is the surface's own, on the side that is seen, and `pixel` the
/// fragment's position on screen.
fn umbrage_light_visibility(light: u32, world_position: vec3f, world_normal: vec3f, pixel: vec2f) -> f32 {
    if light >= umbrage_frame.light_count {
        return 1.0;
    }
    let cosine = dot(world_normal, umbrage_direction_to_light(light, world_position));
    if cosine <= 0.0 {
        return 0.0;
    }
    let view_index = umbrage_view_of(light, world_position, world_normal);
    var visible = 1.0;
    if view_index != UMBRAGE_NO_VIEW {
        let depth = umbrage_view_depth(world_position);
        let receiver = UmbrageReceiver(world_position, world_normal, pixel, depth);
        let lookup = umbrage_lookup(view_index, light, world_position, world_normal);
        let own = umbrage_read(lookup, receiver);
        visible = umbrage_blend(view_index, light, lookup, own, receiver);
    }
    return visible * smoothstep(0.0, 1.0, cosine / max(umbrage_frame.terminator, 1e-30));
}

/// How much of the first light reaches a world-space point.
fn umbrage_visibility(world_position: vec3f, world_normal: vec3f, pixel: vec2f) -> f32 {
    return umbrage_light_visibility(0u, world_position, world_normal, pixel);
}
