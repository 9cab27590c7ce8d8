// What a caster's vertex shader needs: where a point of the world lies in the view that is being drawn.

import package::current_view::umbrage_current_view;
import package::frame::umbrage_frame;

/// The rasteriser rounds corners to this share of a texel (8 bits of sub-texel precision).
const UMBRAGE_SUB_TEXELS: f32 = 256.0;

/// Clip position of a world-space point in the current shadow view.
///
/// In parallel views it is rounded to the rasteriser's grid here, and not by the rasteriser after it has added where the tile
/// lies: so what is drawn does not depend on the tile. It is rounded before the translation is added. Under
/// `fit = "stable"` the translation changes by whole numbers of texels, so for resolutions that are powers of two what was
/// rounded does not depend on where the camera is: edges stay where they are, to the last bit.
///
/// Other views leave it to the rasteriser, which clips first: a step of the grid at a corner that is kilometres away, or
/// behind the lamp, would tilt a large triangle by centimetres.
fn umbrage_caster_position(world_position: vec3f) -> vec4f {
    let m = umbrage_frame.views[umbrage_current_view.x].clip_from_local;
    let local = world_position - umbrage_frame.views[umbrage_current_view.x].local_origin;
    let turned = m[0] * local.x + m[1] * local.y + m[2] * local.z;
    let clip = turned + m[3];
    if any(vec3f(m[0].w, m[1].w, m[2].w) != vec3f(0.0)) {
        return clip;
    }
    let grid = 0.5 * UMBRAGE_SUB_TEXELS * umbrage_frame.views[umbrage_current_view.x].tile.z;
    return vec4f(round(turned.xy * grid) / grid + m[3].xy, clip.zw);
}
