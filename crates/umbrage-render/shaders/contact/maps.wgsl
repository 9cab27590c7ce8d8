// Whom to ask what lets light through: the maps alone.

fn seen_visibility(lamp: u32, position: vec3f, normal: vec3f, pixel: vec2f) -> f32 {
    return umbrage_light_visibility(lamp, position, normal, pixel);
}
