// What a shadow does to the picture.

import package::frame::umbrage_frame;

/// A shadow is absence of light: the light adds less.
const UMBRAGE_SHADE_ABSENCE: u32 = 0u;
/// A shadow is a colour laid over the lit picture (Ferko 2010, listing 4.9): alpha 0 has no effect, 1 replaces. Of several
/// lights, each lays its own over what came before.
const UMBRAGE_SHADE_COLOUR: u32 = 1u;

/// The picture's light where a share `visibility` of one light reaches it. `ambient` is what arrives without the light, `lit`
/// what the light adds.
fn umbrage_shade(ambient: vec3f, lit: vec3f, visibility: f32) -> vec3f {
    if umbrage_frame.shade == UMBRAGE_SHADE_COLOUR {
        let colour = umbrage_frame.shadow_colour;
        return mix(ambient + lit, colour.rgb, colour.a * umbrage_frame.darkness * (1.0 - visibility));
    }
    return ambient + lit * (1.0 - umbrage_frame.darkness * (1.0 - visibility));
}
