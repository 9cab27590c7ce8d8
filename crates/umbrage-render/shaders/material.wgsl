// A surface's numbers and its own colour, as group 2. It needs `receiver.wgsl`.

/// Where on a picture a vertex is: the columns of a matrix, and an offset.
struct Place {
    columns: vec4f,
    offset: vec2f,
}

/// See `Material` of umbrage-scene.
struct Material {
    base_colour: vec4f,
    emission: vec3f,
    metallic: f32,
    roughness: f32,
    specular: f32,
    normal_scale: f32,
    occlusion_strength: f32,
    /// Of the pictures of metal and roughness, of normals, of occlusion, and of emission.
    places: array<Place, 4>,
    /// 1 where the base colour is shown whatever shines.
    unlit: u32,
}

@group(2) @binding(0) var<uniform> material: Material;
@group(2) @binding(1) var base_texture: texture_2d<f32>;
@group(2) @binding(2) var base_sampler: sampler;

/// The base colour, linear RGB.
fn base_colour(receiver: Receiver) -> vec3f {
    return material.base_colour.rgb * textureSample(base_texture, base_sampler, receiver.uv).rgb;
}
