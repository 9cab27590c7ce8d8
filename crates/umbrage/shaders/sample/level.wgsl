// Moments at their full size, weighted bilinearly by the sampler.

@group(0) @binding(3) var umbrage_moments: texture_2d_array<f32>;
@group(0) @binding(4) var umbrage_smooth: sampler;

fn umbrage_moments_at(lookup: UmbrageLookup, receiver: UmbrageReceiver) -> vec4f {
    let uv = umbrage_moments_uv(lookup);
    let layer = umbrage_frame.views[lookup.view_index].layer;
    return textureSampleLevel(umbrage_moments, umbrage_smooth, uv, layer, 0.0);
}
