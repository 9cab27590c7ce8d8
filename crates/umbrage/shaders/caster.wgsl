// What a caster's vertex shader needs: where a point of the world lies in the view that is being drawn.

/// Index of the view that this pass draws.
@group(0) @binding(1) var<uniform> umbrage_caster_view: vec4u;

/// The rasteriser rounds corners to this share of a texel (8 bits of sub-texel precision).
const UMBRAGE_SUB_TEXELS: f32 = 256.0;

/// Clip position of a world-space point in the current shadow view.
///
/// Parallel views round it to the rasteriser's grid before the translation is added. Under `fit = "stable"` the
/// translation is a whole number of texels, so for resolutions that are powers of two the sum is exact, and what was
/// rounded does not depend on where the
/// camera is: edges stay where they are, to the last bit.
fn umbrage_caster_position(world_position: vec3f) -> vec4f {
    let m = umbrage_frame.views[umbrage_caster_view.x].clip_from_world;
    let turned = m[0] * world_position.x + m[1] * world_position.y + m[2] * world_position.z;
    let clip = turned + m[3];
    if clip.w != 1.0 {
        return clip;
    }
    let grid = 0.5 * UMBRAGE_SUB_TEXELS * umbrage_frame.views[umbrage_caster_view.x].tile_size;
    return vec4f(round(turned.xy * grid) / grid + m[3].xy, clip.zw);
}
