// Visibility is asked for in the middle of the samples that a fragment covers. A pixel's centre may lie beside the triangle that
// covers a part of it, and below the neighbour, which a ray from there would meet. Interpolation at the centroid says the same,
// and is wrong on llvmpipe.

/// Which of the pixel's four samples the triangle covers, a bit each.
struct Samples {
    @builtin(sample_mask) mask: u32,
}

/// Where the four samples of a pixel are, from its centre: the same on all devices.
const SAMPLE_PLACES = array<vec2f, 4>(
    vec2f(-0.125, -0.375), vec2f(0.375, -0.125), vec2f(-0.375, 0.125), vec2f(0.125, 0.375));

/// Where visibility is asked for, from the eye.
fn place_of(from_eye: vec3f, samples: Samples) -> vec3f {
    var sum = vec2f(0.0);
    var count = 0.0;
    for (var i = 0u; i < 4u; i++) {
        let covers = f32((samples.mask >> i) & 1u);
        sum += covers * SAMPLE_PLACES[i];
        count += covers;
    }
    let middle = sum / max(count, 1.0);
    return from_eye + dpdx(from_eye) * middle.x + dpdy(from_eye) * middle.y;
}
