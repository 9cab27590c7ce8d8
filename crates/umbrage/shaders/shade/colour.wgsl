// A shadow is a colour laid over the lit picture (Ferko 2010, listing 4.9): alpha 0 has no effect, 1 replaces.
// Of several lights, each lays its own over what came before.

fn umbrage_shade(ambient: vec3f, lit: vec3f, visibility: f32) -> vec3f {
    let colour = umbrage_frame.shadow_colour;
    return mix(ambient + lit, colour.rgb, colour.a * umbrage_frame.darkness * (1.0 - visibility));
}
