// How much of its place a triangle covers: a mask all or nothing, glass a share. Alpha is read as a texture that repeats would
// be, bilinearly and at its full size.

/// Eight words a surface: what alpha does (0 nothing, 1 cuts, 2 blends), the cut-off, the share of light that goes through, a
/// factor of alpha, where its picture begins, the picture's width and height (0 for none), and what to add to three times a
/// corner. Corners' words are u, v and alpha; pictures hold four pixels a word.
@group(0) @binding(10) var<storage, read> umbrage_coverage: array<u32>;

/// Where on their picture a corner is, and its alpha.
fn umbrage_corner_coverage(base: u32, corner: u32) -> vec3f {
    let at = base + 3u * corner;
    return bitcast<vec3f>(vec3u(umbrage_coverage[at], umbrage_coverage[at + 1u], umbrage_coverage[at + 2u]));
}

/// The alpha of a pixel, 0 to 1.
fn umbrage_pixel(first: u32, index: u32) -> f32 {
    let word = umbrage_coverage[first + index / 4u];
    return f32((word >> (8u * (index & 3u))) & 0xffu) / 255.0;
}

/// The alpha of a picture at a place, 0 to 1.
fn umbrage_picture(first: u32, size: vec2u, uv: vec2f) -> f32 {
    let place = fract(uv) * vec2f(size) - 0.5;
    let share = place - floor(place);
    let low = vec2u(vec2i(floor(place)) + vec2i(size)) % size;
    let high = (low + 1u) % size;
    let upper = mix(umbrage_pixel(first, low.y * size.x + low.x), umbrage_pixel(first, low.y * size.x + high.x), share.x);
    let lower = mix(umbrage_pixel(first, high.y * size.x + low.x), umbrage_pixel(first, high.y * size.x + high.x), share.x);
    return mix(upper, lower, share.y);
}

/// How much of its place a triangle covers where its corners count so much.
fn umbrage_covered(triangle: vec4u, weights: vec3f) -> f32 {
    if triangle.w == 0u {
        return 1.0;
    }
    let surface = 8u * (triangle.w - 1u);
    let base = umbrage_coverage[surface + 7u];
    let place = mat3x3f(
        umbrage_corner_coverage(base, triangle.x),
        umbrage_corner_coverage(base, triangle.y),
        umbrage_corner_coverage(base, triangle.z)) * weights;
    let size = vec2u(umbrage_coverage[surface + 5u], umbrage_coverage[surface + 6u]);
    var alpha = bitcast<f32>(umbrage_coverage[surface + 3u]) * place.z;
    if size.x > 0u {
        alpha *= umbrage_picture(umbrage_coverage[surface + 4u], size, place.xy);
    }
    let cutoff = bitcast<f32>(umbrage_coverage[surface + 1u]);
    let cut = select(0.0, 1.0, alpha >= cutoff);
    let mode = umbrage_coverage[surface];
    let covered = select(select(clamp(alpha, 0.0, 1.0), cut, mode == 1u), 1.0, mode == 0u);
    return covered * (1.0 - clamp(bitcast<f32>(umbrage_coverage[surface + 2u]), 0.0, 1.0));
}
