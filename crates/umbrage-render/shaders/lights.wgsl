// What a light adds to a surface. It needs `scene.wgsl`.

/// What a light adds to a surface with a unit normal where nothing is in its way.
fn light_of(light: Light, position: vec3f, normal: vec3f) -> vec3f {
    if light.place.w == 0.0 {
        return light.colour * max(dot(normal, light.place.xyz), 0.0);
    }
    let toward = light.place.xyz - position;
    let square = max(dot(toward, toward), 1e-6);
    let direction = toward * inverseSqrt(square);
    // As KHR_lights_punctual has it.
    let reach = square / (light.range * light.range);
    let window = clamp(1.0 - reach * reach, 0.0, 1.0);
    let cone = clamp(dot(light.axis, -direction) * light.cone_scale + light.cone_offset, 0.0, 1.0);
    return light.colour * (max(dot(normal, direction), 0.0) * window * cone * cone / square);
}
