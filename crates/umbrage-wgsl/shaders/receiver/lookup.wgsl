// Where a receiver looks in a view, and what it compares there: bias included.

import constants::UMBRAGE_RASTER_STEP;
import chosen::{umbrage_gradient, umbrage_normal_offset, umbrage_offset_reach};
import package::frame::umbrage_frame;
import package::light::{umbrage_depth_rounding, umbrage_direction_to_light};
import package::receiver::texel_basis::{umbrage_slope, umbrage_texel_basis};
import package::storage::map::{umbrage_caster_error, umbrage_clip_from_local, umbrage_local, umbrage_tile_size};

/// A point that asks for visibility.
struct UmbrageReceiver {
    /// In world space, metres.
    position: vec3f,
    /// Unit geometric normal, in world space.
    normal: vec3f,
    /// Its fragment's position on screen, pixels.
    pixel: vec2f,
    /// Its view depth, metres.
    depth: f32,
}

/// A place in a shadow map, and what to compare with what is stored there.
struct UmbrageLookup {
    view_index: u32,
    light: u32,
    /// In texels from the tile's upper left corner; outside of it where the receiver is behind the light.
    texel: vec2f,
    /// Depth to compare with: lit where it is not less than the stored one.
    compare_depth: f32,
    /// How much of that depth is bias, which the receiver's own plane lies behind.
    bias: f32,
    /// How much the depth to compare with grows from a texel to the next, to the right and downward.
    gradient: vec2f,
    /// How much it also grows a texel in any direction, where the surface may bend, beyond UMBRAGE_OWN_TEXEL.
    bend: f32,
    /// Sides of a texel there across the light, to the right and downward, metres.
    texel_metres: vec2f,
}

/// What is compared within so many texels of a receiver counts as its own texel, which stores what lies half a diagonal from its
/// centre.
const UMBRAGE_OWN_TEXEL: f32 = 0.7;

/// Where a receiver looks in a view, bias included. `world_normal` is the unit geometric normal.
fn umbrage_lookup(view_index: u32, light: u32, world_position: vec3f, world_normal: vec3f) -> UmbrageLookup {
    let clip_from_local = umbrage_clip_from_local(view_index);
    let tile_size = umbrage_tile_size(view_index);
    let local = umbrage_local(view_index, world_position);
    let clip_unbiased = clip_from_local * vec4f(local, 1.0);
    if clip_unbiased.w <= 0.0 {
        return UmbrageLookup(view_index, light, vec2f(-1.0), -1.0, 0.0, vec2f(0.0), 0.0, vec2f(1.0));
    }
    let texel_basis = umbrage_texel_basis(view_index, clip_unbiased);
    let to_light = umbrage_direction_to_light(light, world_position);
    let cosine = clamp(dot(world_normal, to_light), 0.0, 1.0);
    let sine = sqrt(max(1.0 - cosine * cosine, 0.0));
    let tangent = min(sine / max(cosine, 1e-6), umbrage_frame.bias_slope_limit);
    let texel_metres = max(length(texel_basis.right), length(texel_basis.down));
    let texels = umbrage_frame.bias_normal * umbrage_offset_reach(texel_metres);
    let normal_offset = texels * umbrage_normal_offset(texel_basis, world_normal, to_light);
    let clip = clip_from_local * vec4f(local + world_normal * normal_offset, 1.0);
    // Toward the light: the place on the map stays.
    let rise = dot(texel_basis.depth_gradient, to_light);
    let along_light = sqrt(1.0 + tangent * tangent);
    let bend = rise * umbrage_frame.bias_bend * texel_metres * along_light;
    let toward_light = umbrage_frame.bias_constant + umbrage_frame.bias_slope * texel_metres * tangent;
    let own_bend = vec2f(UMBRAGE_OWN_TEXEL * bend, rise * umbrage_caster_error(view_index) * along_light);
    let nearer = rise * toward_light + length(own_bend);
    // Rasterisers round corners, so what is stored may be the depth of a place beside.
    let slope = umbrage_slope(texel_basis, world_normal, cosine);
    let depth = clip.z / clip.w;
    let rounded = dot(abs(slope), vec2f(UMBRAGE_RASTER_STEP)) + umbrage_depth_rounding(view_index, depth);
    var lookup: UmbrageLookup;
    lookup.view_index = view_index;
    lookup.light = light;
    lookup.texel_metres = vec2f(length(texel_basis.right), length(texel_basis.down));
    lookup.texel = (clip.xy / clip.w * vec2f(0.5, -0.5) + 0.5) * tile_size;
    lookup.compare_depth = depth + nearer + rounded;
    lookup.bias = nearer;
    lookup.bend = bend;
    lookup.gradient = umbrage_gradient(texel_basis, slope, to_light);
    return lookup;
}
