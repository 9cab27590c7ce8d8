// The vertex shader of receivers whose vertices have colours. It needs `receiver.wgsl`.

struct ColouredReceiver {
    @builtin(position) @invariant clip: vec4f,
    @location(0) from_eye: vec3f,
    @location(1) normal: vec3f,
    @location(2) uv: vec2f,
    @location(3) colour: vec4f,
}

@vertex
fn coloured_receiver(
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
    @location(2) uv: vec2f,
    @location(3) instance: u32,
    @location(4) colour: vec4f,
) -> ColouredReceiver {
    let placed = placed_receiver(position, normal, uv, instance);
    return ColouredReceiver(placed.clip, placed.from_eye, placed.normal, placed.uv, colour);
}
