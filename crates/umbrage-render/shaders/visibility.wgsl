// How much of one light reaches receivers, as grey. It needs `scene.wgsl`, `receiver.wgsl` and a file of `visibility/`.

fn shown(base: vec3f, receiver: Receiver, facing: vec3f) -> vec4f {
    return vec4f(vec3f(visibility_at(scene.shown_light, receiver, facing)), 1.0);
}
