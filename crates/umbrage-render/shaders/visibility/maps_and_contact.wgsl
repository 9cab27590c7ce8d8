// How much of a light reaches a fragment: what the shadow maps say, and where they say that some does, the camera's depth.
// It needs umbrage's receiver and contact texts.

fn visibility_at(light: u32, receiver: Receiver, facing: vec3f) -> f32 {
    let position = scene.eye + receiver.from_eye;
    let by_maps = umbrage_light_visibility(light, scene.eye + asked_from_eye, facing, receiver.clip.xy);
    if by_maps == 0.0 {
        return 0.0;
    }
    return min(by_maps, umbrage_contact(light, position, facing, receiver.clip.xy));
}
