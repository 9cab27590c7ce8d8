// The second surface that the light meets: what does not lie behind the first is left out (depth peeling, Everitt 2001).

@group(0) @binding(2) var umbrage_first: texture_depth_2d_array;

@fragment
fn peel(@builtin(position) position: vec4f) {
    let layer = umbrage_frame.views[umbrage_peeled_view.x].layer;
    let first = textureLoad(umbrage_first, vec2i(position.xy), layer, 0);
    // The same surface, drawn again, may round otherwise.
    if position.z <= first + 2.0 * umbrage_frame.depth_step {
        discard;
    }
}

@group(0) @binding(1) var<uniform> umbrage_peeled_view: vec4u;
