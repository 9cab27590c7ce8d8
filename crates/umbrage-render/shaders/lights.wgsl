// What a light sends to a surface. It needs `scene.wgsl`.

/// Light that arrives somewhere.
struct Arriving {
    /// Unit, to where it comes from.
    direction: vec3f,
    /// What a white surface that faces it sends back, linear RGB.
    colour: vec3f,
}

/// What a light sends to a place where nothing is in its way.
fn arriving_light(light: Light, position: vec3f) -> Arriving {
    if light.place.w == 0.0 {
        return Arriving(light.place.xyz, light.colour);
    }
    let toward = light.place.xyz - position;
    let square = max(dot(toward, toward), 1e-12);
    let direction = toward * inverseSqrt(square);
    // As KHR_lights_punctual has it.
    let reach = square / (light.range * light.range);
    let window = clamp(1.0 - reach * reach, 0.0, 1.0);
    let cone = clamp(dot(light.axis, -direction) * light.cone_scale + light.cone_offset, 0.0, 1.0);
    return Arriving(direction, light.colour * (window * cone * cone / square));
}
