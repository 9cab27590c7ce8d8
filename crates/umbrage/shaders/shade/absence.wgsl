// A shadow is absence of light: the light adds less. `ambient` is what arrives without the light, `lit` what the light
// adds.

fn umbrage_shade(ambient: vec3f, lit: vec3f, visibility: f32) -> vec3f {
    return ambient + lit * (1.0 - umbrage_frame.darkness * (1.0 - visibility));
}
