// All triangles are solid.

/// How much of its place a triangle covers.
fn umbrage_covered(triangle: vec4u, weights: vec3f) -> f32 {
    return 1.0;
}
