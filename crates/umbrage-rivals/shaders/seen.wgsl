// What shadow volumes make of what the camera sees. It needs `shot.wgsl`, `whole_picture.wgsl` and `receivers.wgsl`.

/// How many volumes each pixel is in.
@group(0) @binding(2) var counts: texture_2d<f32>;

/// The depth of a pixel as if the far plane were infinitely far: so nothing is ever behind it. Parallel rays
/// have no such depth, and theirs is as it was.
@fragment
fn infinite_depth(covering: Covering) -> @builtin(frag_depth) f32 {
    let depth = seen_depth(covering.clip);
    if depth == 0.0 || shot.is_parallel == 1u {
        return depth;
    }
    return shot.near / view_depth(depth);
}

/// Shadows a pixel that is in a volume, where it shows something at which the light shines.
@fragment
fn shadowed(covering: Covering) -> @location(0) f32 {
    let depth = seen_depth(covering.clip);
    let is_lit = textureLoad(counts, vec2i(covering.clip.xy), 0).r == 0.0;
    if is_lit || depth == 0.0 || !is_reached(from_eye(covering.point, view_depth(depth))) {
        discard;
    }
    return 0.0;
}
