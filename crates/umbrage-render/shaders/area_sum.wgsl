// Adds a picture of visibility to sums, one a pixel.

@group(0) @binding(0) var visibility: texture_2d<f32>;
@group(0) @binding(1) var<storage, read_write> sums: array<f32>;

@compute @workgroup_size(8, 8)
fn add(@builtin(global_invocation_id) id: vec3u) {
    let size = textureDimensions(visibility);
    if any(id.xy >= size) {
        return;
    }
    sums[id.y * size.x + id.x] += textureLoad(visibility, id.xy, 0).r;
}
