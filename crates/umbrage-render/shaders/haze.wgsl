// Haze before what is far. It needs `picture.wgsl` and a sky.

/// Light from a place relative to the eye, after haze has taken its share of it and added its own.
fn through_haze(light: vec3f, from_eye: vec3f) -> vec3f {
    let distance = length(from_eye);
    let horizontal = normalize(vec3f(from_eye.x, 0.12 * distance, from_eye.z));
    return mix(haze_light(horizontal), light, exp2(-distance * picture.haze));
}
