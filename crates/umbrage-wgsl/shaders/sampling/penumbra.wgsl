// How wide a penumbra is, on the map.

import constants::UMBRAGE_MAX_TEXELS;
import package::light::umbrage_penumbra_metres;
import package::receiver::lookup::UmbrageLookup;

/// The disc on the map through which a light is seen past a blocker, texels to the right and downward: at least half a texel, and
/// at most as far as maps have room. Depths are linear.
fn umbrage_penumbra_texels(lookup: UmbrageLookup, receiver: f32, blocker: f32) -> vec2f {
    let metres = umbrage_penumbra_metres(lookup.light, lookup.view_index, receiver, blocker);
    return clamp(metres / max(lookup.texel_metres, vec2f(1.1754944e-38)), vec2f(0.5), vec2f(UMBRAGE_MAX_TEXELS));
}
