// Umbrage's lookup of a sun, in place of `fetch_directional_shadow` in Bevy's `shadows.wgsl`, at the end of which this text is
// put: names of bindings and types are Bevy's. Bevy's own function stays under the name `stock_directional_shadow`.
//
// A receiver asks the finest cascade that holds the filter's whole footprint, and compares each texel with the depth that its
// own plane has there. Depth is reversed: 1 near the light, 0 far from it.
//
// In front of it stands `const UMBRAGE_BLENDS: bool`, whether cascades fade into each other: a software rasteriser, and a GPU without
// branches that are uniform, would otherwise read two maps where one is asked for.

/// How far from a receiver the filter ends, texels.
const UMBRAGE_REACH: f32 = 2.0;
/// What is compared within so many texels of a receiver counts as its own texel.
const UMBRAGE_OWN_TEXEL: f32 = 0.7;
/// How far a surface is taken to bend toward the light a texel beside its receiver, texels over the cosine.
const UMBRAGE_BEND: f32 = 0.5;
/// The steepest plane, as a tangent, for which the bend grows; and the steepest that a receiver's plane is followed to.
const UMBRAGE_STEEPEST_BEND: f32 = 8.0;
const UMBRAGE_STEEPEST_PLANE: f32 = 200.0;
/// The rasteriser's grid, texels; and how far f32 may round a depth.
const UMBRAGE_RASTER_STEP: f32 = 0.00390625;
const UMBRAGE_ROUNDING: f32 = 4.8e-7;
/// No receiver is nearer than this; casters that were flattened onto the near plane count as before it.
const UMBRAGE_NEAREST: f32 = 0.9999;

/// A place in a cascade's map, and what to compare with what is stored around it.
struct UmbrageLookup {
    cascade: u32,
    /// Texels from the map's upper left corner.
    texel: vec2<f32>,
    /// Depth to compare with at that place; how much it grows from a texel to the next, to the right and downward; and how much
    /// it grows a texel in any direction beyond the receiver's own.
    depth: f32,
    slope: vec2<f32>,
    bend: f32,
}

/// Where a receiver lies in a cascade: texels from the map's upper left corner, and depth.
fn umbrage_place(light_id: u32, cascade: u32, position: vec3<f32>) -> vec3<f32> {
    let size = f32(textureDimensions(view_bindings::directional_shadow_textures).x);
    let clip = view_bindings::lights.directional_lights[light_id].cascades[cascade].clip_from_world * vec4(position, 1.0);
    return vec3((clip.xy * vec2(0.5, -0.5) + 0.5) * size, clip.z);
}

/// The first cascade from `first` on that holds a receiver with the filter's footprint; the number of cascades where none does.
fn umbrage_finest(light_id: u32, first: u32, position: vec3<f32>) -> u32 {
    let count = view_bindings::lights.directional_lights[light_id].num_cascades;
    let high = f32(textureDimensions(view_bindings::directional_shadow_textures).x) - UMBRAGE_REACH;
    var cascade = first;
    for (; cascade < count; cascade += 1u) {
        let place = umbrage_place(light_id, cascade, position);
        if (all(place >= vec3(UMBRAGE_REACH, UMBRAGE_REACH, 0.0)) && all(place <= vec3(high, high, 1.0))) {
            break;
        }
    }
    return cascade;
}

/// Where a receiver looks in a cascade, bias included. `normal` is the geometric one; `cosine` that between it and the light.
fn umbrage_lookup(light_id: u32, cascade: u32, position: vec3<f32>, normal: vec3<f32>, cosine: f32) -> UmbrageLookup {
    let clip_from_world = view_bindings::lights.directional_lights[light_id].cascades[cascade].clip_from_world;
    let half_size = 0.5 * f32(textureDimensions(view_bindings::directional_shadow_textures).x);
    let rows = transpose(clip_from_world);
    // How the place on the map and the stored depth grow a metre.
    let right = rows[0].xyz * half_size;
    let down = rows[1].xyz * -half_size;
    let rise = length(rows[2].xyz);
    let squares = vec2(dot(right, right), dot(down, down));
    let sine = sqrt(max(1.0 - cosine * cosine, 0.0));
    // A plane rises by so many metres a texel.
    let metres = -vec2(dot(normal, right), dot(normal, down)) / squares / max(cosine, sine / UMBRAGE_STEEPEST_PLANE);
    let tangent = min(sine / max(cosine, 1e-6), UMBRAGE_STEEPEST_BEND);
    let texel_metres = inverseSqrt(min(squares.x, squares.y));
    let place = umbrage_place(light_id, cascade, position);
    var found: UmbrageLookup;
    found.cascade = cascade;
    found.texel = place.xy;
    found.slope = metres * rise;
    found.bend = rise * UMBRAGE_BEND * texel_metres * sqrt(1.0 + tangent * tangent);
    let rounded = dot(abs(found.slope), vec2(UMBRAGE_RASTER_STEP)) + UMBRAGE_ROUNDING * (1.0 + abs(rows[2].w));
    found.depth = place.z + UMBRAGE_OWN_TEXEL * found.bend + rounded;
    return found;
}

/// What a row of texels weighs in a bell of 3 bilinear lookups, for a place that lies `share` of a texel beyond its second.
fn umbrage_weights(share: f32) -> vec4<f32> {
    return vec4(1.0 - share, 2.0 - share, 1.0 + share, share);
}

/// What is stored in a texel.
fn umbrage_stored(light_id: u32, cascade: u32, texel: vec2<f32>) -> f32 {
#ifdef NO_ARRAY_TEXTURES_SUPPORT
    return textureLoad(view_bindings::directional_shadow_textures, vec2<i32>(texel), 0);
#else
    let layer = view_bindings::lights.directional_lights[light_id].depth_texture_base_index + cascade;
    return textureLoad(view_bindings::directional_shadow_textures, vec2<i32>(texel), i32(layer), 0);
#endif
}

/// How much light four texels of a row let through: those that begin at the centre `first`.
fn umbrage_row(light_id: u32, found: UmbrageLookup, first: vec2<f32>, weights: vec4<f32>) -> f32 {
    let x = first.x + vec4(0.0, 1.0, 2.0, 3.0);
    let stored = vec4(
        umbrage_stored(light_id, found.cascade, vec2(x.x, first.y)),
        umbrage_stored(light_id, found.cascade, vec2(x.y, first.y)),
        umbrage_stored(light_id, found.cascade, vec2(x.z, first.y)),
        umbrage_stored(light_id, found.cascade, vec2(x.w, first.y)),
    );
    let beside = x - found.texel.x;
    let down = first.y - found.texel.y;
    let bent = found.bend * max(max(abs(beside), vec4(abs(down))) - UMBRAGE_OWN_TEXEL, vec4(0.0));
    let plane = found.depth + found.slope.x * beside + found.slope.y * down;
    let compared = clamp(plane + bent, vec4(0.0), vec4(max(found.depth, UMBRAGE_NEAREST)));
    return dot(select(vec4(0.0), weights, compared >= stored), vec4(1.0));
}

/// How much light a cascade says that a receiver gets: a bell of 3 x 3 bilinear lookups.
fn umbrage_read(light_id: u32, cascade: u32, position: vec3<f32>, normal: vec3<f32>, cosine: f32) -> f32 {
    let found = umbrage_lookup(light_id, cascade, position, normal, cosine);
    let inner = floor(found.texel - 0.5) + 0.5;
    let share = found.texel - inner;
    let columns = umbrage_weights(share.x);
    let rows = umbrage_weights(share.y);
    let first = inner - 1.0;
    var sum = 0.0;
    sum += rows.x * umbrage_row(light_id, found, first, columns);
    sum += rows.y * umbrage_row(light_id, found, first + vec2(0.0, 1.0), columns);
    sum += rows.z * umbrage_row(light_id, found, first + vec2(0.0, 2.0), columns);
    sum += rows.w * umbrage_row(light_id, found, first + vec2(0.0, 3.0), columns);
    return sum / 16.0;
}

/// The unit normal of the surface itself, on the side of the vertices' normal.
fn umbrage_normal(position: vec3<f32>, of_vertices: vec3<f32>) -> vec3<f32> {
#ifdef DEFERRED_LIGHTING_PIPELINE
    // Neighbours on screen may lie on other surfaces.
    return of_vertices;
#else
    let across = cross(dpdx(position), dpdy(position));
    let side = select(-across, across, dot(across, of_vertices) >= 0.0);
    return side * inverseSqrt(max(dot(side, side), 1e-38));
#endif
}

/// How much of a sun reaches a fragment: 1 for all of it. Bevy's material shaders call this.
fn fetch_directional_shadow(
    light_id: u32,
    frag_position: vec4<f32>,
    surface_normal: vec3<f32>,
    view_z: f32,
    frag_coord_xy: vec2<f32>,
) -> f32 {
#ifdef SHADOW_FILTER_METHOD_TEMPORAL
    return stock_directional_shadow(light_id, frag_position, surface_normal, view_z, frag_coord_xy);
#else
    let light = &view_bindings::lights.directional_lights[light_id];
#ifdef PCSS_SAMPLERS_AVAILABLE
    if ((*light).soft_shadow_size > 0.0) {
        return stock_directional_shadow(light_id, frag_position, surface_normal, view_z, frag_coord_xy);
    }
#endif
    let position = frag_position.xyz;
    let normal = umbrage_normal(position, surface_normal);
    let cosine = dot(normal, (*light).direction_to_light);
    let count = (*light).num_cascades;
    if (cosine <= 0.0) {
        return 0.0;
    }
    if (count == 0u || -view_z > (*light).cascades[count - 1u].far_bound) {
        return 1.0;
    }
    let cascade = umbrage_finest(light_id, 0u, position);
    if (cascade >= count) {
        return 1.0;
    }
    let visible = umbrage_read(light_id, cascade, position, normal, cosine);
    let blend = (*light).cascades_overlap_proportion;
    if (!UMBRAGE_BLENDS || blend <= 0.0) {
        return visible;
    }
    // The rim of a map fades into the next that holds the receiver.
    let from_middle = abs(umbrage_place(light_id, cascade, position).xy
        * 2.0 / f32(textureDimensions(view_bindings::directional_shadow_textures).x) - 1.0);
    let share = (1.0 - max(from_middle.x, from_middle.y)) / blend;
    let next = umbrage_finest(light_id, cascade + 1u, position);
    if (share >= 1.0 || next >= count) {
        return visible;
    }
    let other = umbrage_read(light_id, next, position, normal, cosine);
    return mix(other, visible, smoothstep(0.0, 1.0, share));
#endif
}
