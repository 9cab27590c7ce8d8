// Moments over the footprint that the pixel has on the map: the sampler chooses sizes, and how many lookups a long one needs.

@group(0) @binding(3) var umbrage_moments: texture_2d_array<f32>;
@group(0) @binding(4) var umbrage_smooth: sampler;

fn umbrage_moments_at(lookup: UmbrageLookup, receiver: UmbrageReceiver) -> vec4f {
    let uv = umbrage_moments_uv(lookup);
    let layer = umbrage_frame.views[lookup.view_index].layer;
    let footprint = umbrage_footprint(lookup, receiver);
    let size = umbrage_frame.map_size;
    return textureSampleGrad(umbrage_moments, umbrage_smooth, uv, layer, footprint[0] / size, footprint[1] / size);
}
