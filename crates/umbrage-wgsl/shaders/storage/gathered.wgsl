// Stored depths as numbers, four texels at once. OpenGL and WebGPU's compatibility mode have no such reads.

import package::storage::map::{umbrage_layer, umbrage_map, umbrage_uv};

@group(0) @binding(5) var umbrage_nearest: sampler;

/// The depths that are stored in the four texels around a corner of texels, which lies a texel or more within the tile: lower
/// left, lower right, upper right, upper left.
fn umbrage_stored_around(view_index: u32, corner: vec2f) -> vec4f {
    return textureGather(umbrage_map, umbrage_nearest, umbrage_uv(view_index, corner, 1.0), umbrage_layer(view_index));
}
