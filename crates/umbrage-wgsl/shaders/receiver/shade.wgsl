// What a shadow does to the picture.

import package::frame::umbrage_frame;

/// A shadow is absence of light: the light adds less.
const UMBRAGE_SHADE_ABSENCE: u32 = 0u;
/// A shadow is a colour laid over the lit picture (Ferko 2010, listing 4.9): alpha 0 has no effect, 1 replaces. Of several
/// lights, all are added before any is laid over them, so that their order does not matter.
const UMBRAGE_SHADE_COLOUR: u32 = 1u;

/// The light of several lights, being added.
struct UmbrageShading {
    /// What arrives so far, linear RGB.
    light: vec3f,
    /// The share of it that no shadow's colour replaces, 0 to 1.
    kept: f32,
}

/// Begins with what arrives without any of the lights.
fn umbrage_shading(ambient: vec3f) -> UmbrageShading {
    return UmbrageShading(ambient, 1.0);
}

/// Adds a light, of which a share `visibility` arrives; `lit` is what it adds where all of it does.
fn umbrage_add_light(shading: UmbrageShading, lit: vec3f, visibility: f32) -> UmbrageShading {
    let shadow = umbrage_frame.darkness * (1.0 - visibility);
    if umbrage_frame.shade == UMBRAGE_SHADE_COLOUR {
        return UmbrageShading(shading.light + lit, shading.kept * (1.0 - umbrage_frame.shadow_colour.a * shadow));
    }
    return UmbrageShading(shading.light + lit * (1.0 - shadow), shading.kept);
}

/// The light that all of them come to.
fn umbrage_shaded(shading: UmbrageShading) -> vec3f {
    return mix(umbrage_frame.shadow_colour.rgb, shading.light, shading.kept);
}

/// The light of a single light of which a share `visibility` arrives. `ambient` is what arrives without it, `lit` what it adds.
fn umbrage_shade(ambient: vec3f, lit: vec3f, visibility: f32) -> vec3f {
    return umbrage_shaded(umbrage_add_light(umbrage_shading(ambient), lit, visibility));
}
