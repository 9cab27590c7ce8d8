// A matte surface in the light of all lights and of the sky: Lambert's law and nothing else, for scenes in which nothing
// shines or reflects. It needs `scene.wgsl`, `receiver.wgsl`, `lights.wgsl`, a sky, `haze.wgsl`, `tone.wgsl`, umbrage's receiver
// text, and a file of `visibility/`.

/// What the screen shows of a surface of a base colour. `facing` is its geometric normal, turned to the eye.
fn seen_surface(base: vec3f, receiver: Receiver, facing: vec3f) -> vec4f {
    let normal = smooth_normal(receiver, facing);
    var shading = umbrage_shading(base * ambient_light(normal));
    for (var i = 0u; i < scene.light_count; i++) {
        let arriving = arriving_light(scene.lights[i], scene.eye + receiver.from_eye);
        let lit = base * arriving.colour * max(dot(normal, arriving.direction), 0.0);
        if any(lit > vec3f(0.0)) {
            shading = umbrage_add_light(shading, lit, visibility_at(i, receiver, facing));
        }
    }
    return vec4f(tone_mapped(through_haze(umbrage_shaded(shading), receiver.from_eye)), 1.0);
}
