// Whom to ask what lets light through: the maps, and where they say that some does, the camera's depth.

fn seen_visibility(lamp: u32, position: vec3f, normal: vec3f, pixel: vec2f) -> f32 {
    let by_maps = umbrage_light_visibility(lamp, position, normal, pixel);
    if by_maps == 0.0 {
        return 0.0;
    }
    return min(by_maps, umbrage_contact(lamp, position, normal, pixel));
}
