// The light of the sky where there is no environment picture. It needs `scene.wgsl`.

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

/// Light that a surface of some roughness reflects from a direction: the sky there, or for a rough one the sky around there.
fn reflected_light(direction: vec3f, roughness: f32) -> vec3f {
    return mix(sky_light(direction), ambient_light(direction), roughness);
}

/// The colour of haze before what lies in a direction.
fn haze_light(direction: vec3f) -> vec3f {
    return sky_light(direction);
}

/// What the sky shows in a direction: its light, and a glow around the sun.
fn sky_seen(direction: vec3f) -> vec3f {
    let toward = max(dot(direction, scene.direction_to_sun), 0.0);
    let glow = 0.25 * pow(toward, 24.0) + 0.6 * pow(toward, 400.0);
    let disc = 12.0 * smoothstep(0.99994, 0.99998, toward);
    return sky_light(direction) + scene.sun * (glow + disc) * 0.35;
}
