// A surface in the light of all lights and of the sky, seen through haze. It needs `scene.wgsl`, `receiver.wgsl`,
// `lights.wgsl`, `sky_light.wgsl`, `tone.wgsl`, umbrage's receiver text, and a file of `visibility/`.

/// Distance after which haze takes half of a surface's colour, metres.
const HAZE_HALVES_AT: f32 = 2500.0;

/// What the screen shows of a surface of a base colour. `facing` is its geometric normal, turned to the eye.
fn seen_surface(base: vec3f, receiver: Receiver, facing: vec3f) -> vec4f {
    let smooth_normal = receiver.normal * inverseSqrt(max(dot(receiver.normal, receiver.normal), 1e-30));
    let normal = select(-smooth_normal, smooth_normal, dot(smooth_normal, facing) >= 0.0);
    var light = base * ambient_light(normal);
    for (var i = 0u; i < scene.light_count; i++) {
        let lit = base * light_of(scene.lights[i], scene.eye + receiver.from_eye, normal);
        if any(lit > vec3f(0.0)) {
            light = umbrage_shade(light, lit, visibility_at(i, receiver, facing));
        }
    }
    let distance = length(receiver.from_eye);
    let horizontal = normalize(vec3f(receiver.from_eye.x, 0.12 * distance, receiver.from_eye.z));
    light = mix(sky_light(horizontal), light, exp2(-distance / HAZE_HALVES_AT));
    return vec4f(tone_mapped(light), 1.0);
}
