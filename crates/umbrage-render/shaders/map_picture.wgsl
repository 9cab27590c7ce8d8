// A shadow view's tile as a grey picture. In front of it goes umbrage's text for looking into maps.

struct Look {
    view: u32,
    /// Side of the picture, pixels.
    side: u32,
    /// 1 where near is light.
    invert: u32,
    /// 1 where grey goes from the nearest depth that was drawn to the farthest.
    stretch: u32,
    /// 1 where grey is even in metres.
    even: u32,
    /// Greys of the nearest and of the farthest depth that was drawn, where grey is stretched, 0 to 1.
    nearest: f32,
    farthest: f32,
}

@group(0) @binding(1) var maps: texture_depth_2d_array;
@group(0) @binding(2) var<uniform> look: Look;
/// The nearest and the farthest depth that was drawn, as bits: those of positive floats are in the floats' order.
@group(0) @binding(3) var<storage, read_write> drawn: array<atomic<u32>, 2>;
@group(0) @binding(4) var picture: texture_storage_2d<rgba8unorm, write>;

/// The depth at a texel of the tile, 0 near to 1 far or empty: what is stored is reversed.
fn depth_at(texel: vec2u) -> f32 {
    let view = umbrage_frame.views[look.view];
    let stored = textureLoad(maps, vec2u(view.tile.xy) + texel, i32(view.tile.w), 0);
    if look.even == 1u && stored > 0.0 {
        return clamp(umbrage_linear_depth(look.view, vec2f(texel) + 0.5, stored), 0.0, 1.0);
    }
    return 1.0 - stored;
}

@compute @workgroup_size(8, 8)
fn find_range(@builtin(global_invocation_id) id: vec3u) {
    if all(vec2f(id.xy) < vec2f(umbrage_frame.views[look.view].tile.z)) {
        let depth = depth_at(id.xy);
        if depth < 1.0 {
            atomicMin(&drawn[0], bitcast<u32>(depth));
            atomicMax(&drawn[1], bitcast<u32>(depth));
        }
    }
}

@compute @workgroup_size(8, 8)
fn paint(@builtin(global_invocation_id) id: vec3u) {
    if any(id.xy >= vec2u(look.side)) {
        return;
    }
    let place = (vec2f(id.xy) + 0.5) / f32(look.side) * umbrage_frame.views[look.view].tile.z;
    var grey = depth_at(vec2u(place));
    let nearest = atomicLoad(&drawn[0]);
    let farthest = atomicLoad(&drawn[1]);
    // What is empty is far, an empty map all over.
    if look.stretch == 1u && grey < 1.0 {
        let range = max(bitcast<f32>(farthest) - bitcast<f32>(nearest), 1e-9);
        grey = mix(look.nearest, look.farthest, clamp((grey - bitcast<f32>(nearest)) / range, 0.0, 1.0));
    }
    textureStore(picture, id.xy, vec4f(vec3f(select(grey, 1.0 - grey, look.invert == 1u)), 1.0));
}
