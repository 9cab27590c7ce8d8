// How much of a light reaches a fragment: what the shadow maps say. It needs umbrage's receiver text.

fn visibility_at(light: u32, receiver: Receiver, facing: vec3f) -> f32 {
    return umbrage_light_visibility(light, scene.eye + asked_from_eye, facing, receiver.clip.xy);
}
