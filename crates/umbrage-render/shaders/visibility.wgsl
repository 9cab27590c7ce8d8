// How much of one light reaches receivers, as grey. It needs `scene.wgsl`, `receiver.wgsl` and a file of `visibility/`.

@fragment
fn shade(receiver: Receiver) -> @location(0) vec4f {
    return vec4f(vec3f(visibility_at(scene.shown_light, receiver, geometric_normal(receiver.from_eye))), 1.0);
}
