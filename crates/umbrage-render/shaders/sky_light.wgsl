// The light of the sky. It needs `scene.wgsl`.

/// Light of the sky from a direction: pale at the horizon, blue above, ground below.
fn sky_light(direction: vec3f) -> vec3f {
    let zenith = vec3f(0.16, 0.33, 0.66);
    let horizon = vec3f(0.62, 0.70, 0.80);
    let ground = vec3f(0.20, 0.18, 0.15);
    let up = clamp(direction.y, 0.0, 1.0);
    let above = mix(horizon, zenith, 1.0 - pow(1.0 - up, 3.0));
    return mix(above, ground, smoothstep(0.0, 0.25, -direction.y)) * scene.daylight;
}

/// Light that reaches a surface from the whole sky and the ground, for a unit normal: a hemisphere each.
fn ambient_light(normal: vec3f) -> vec3f {
    let sky = vec3f(0.30, 0.38, 0.52);
    let ground = vec3f(0.16, 0.14, 0.11);
    return mix(ground, sky, 0.5 + 0.5 * normal.y) * scene.daylight;
}
