// The next smaller size of a map of moments.

import chosen::{umbrage_moments_add, umbrage_moments_none, umbrage_stored};

@group(0) @binding(2) var umbrage_larger: texture_2d<f32>;
@group(0) @binding(3) var umbrage_smaller: texture_storage_2d<UMBRAGE_FORMAT, write>;

@compute @workgroup_size(8, 8)
fn halve(@builtin(global_invocation_id) id: vec3u) {
    if any(id.xy >= textureDimensions(umbrage_smaller)) {
        return;
    }
    var sum = umbrage_moments_none();
    for (var i = 0u; i < 4u; i++) {
        let texel = min(id.xy * 2u + vec2u(i & 1u, i >> 1u), textureDimensions(umbrage_larger) - 1u);
        sum = umbrage_moments_add(sum, textureLoad(umbrage_larger, texel, 0), 0.25);
    }
    textureStore(umbrage_smaller, id.xy, umbrage_stored(sum));
}
