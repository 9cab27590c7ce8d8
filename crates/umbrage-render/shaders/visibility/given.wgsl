// How much of a light reaches a fragment: a number that was given, as group 3.

/// Visibility of every pixel for the first light, then for the next.
@group(3) @binding(0) var<storage, read> given: array<f32>;

fn visibility_at(light: u32, receiver: Receiver, facing: vec3f) -> f32 {
    let pixel = vec2u(receiver.clip.xy);
    return given[(light * scene.size.y + pixel.y) * scene.size.x + pixel.x];
}
