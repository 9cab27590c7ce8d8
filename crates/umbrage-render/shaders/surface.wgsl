// What the screen shows of a surface in the world's light. It needs `matte.wgsl` or `glossy.wgsl`, and `painted`, which says
// what is drawn onto surfaces.

fn shown(base: vec3f, receiver: Receiver, facing: vec3f) -> vec4f {
    return seen_surface(painted(base, receiver, facing), receiver, facing);
}
