// How far the texels of the first light's maps reach, as a colour without light; dark where no map serves. It needs
// `footprint.wgsl`.

/// How many pixels a texel reaches over where it reaches farthest: the inverse of the least that a pixel does.
fn texel_extent(footprint: mat2x2f) -> f32 {
    let half_square = 0.5 * (dot(footprint[0], footprint[0]) + dot(footprint[1], footprint[1]));
    let area = determinant(footprint);
    let largest = half_square + sqrt(max(half_square * half_square - area * area, 0.0));
    // The smaller singular value is the area over the larger one.
    return sqrt(largest) / max(abs(area), 1e-30);
}

/// White where a texel is a pixel long, orange where longer, blue where shorter; full from eight times on. As light, for
/// the bytes that `umbrage-lab` has for the same.
fn extent_colour(pixels: f32) -> vec3f {
    let stops = clamp(log2(pixels) / 3.0, -1.0, 1.0);
    let end = select(vec3f(0.0, 90.0, 200.0), vec3f(230.0, 120.0, 0.0), stops > 0.0) / 255.0;
    return pow(mix(vec3f(1.0), end, abs(stops)), vec3f(2.2));
}

fn shown(base: vec3f, receiver: Receiver, facing: vec3f) -> vec4f {
    let view = umbrage_view_of(0u, scene.eye + receiver.from_eye, facing);
    if view == UMBRAGE_NO_VIEW {
        return vec4f(vec3f(0.009), 1.0);
    }
    return vec4f(extent_colour(texel_extent(footprint_of(view, receiver, facing))), 1.0);
}
