// A surface's numbers and its own colour, as group 2. 

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
    /// 1 where the surface covers its place wholly or not at all.
    is_mask: u32,
    /// The least alpha that covers, of a mask.
    cutoff: f32,
    /// The share of light that does not go through where the surface covers.
    solidity: f32,
}

@group(2) @binding(0) var<uniform> material: Material;
@group(2) @binding(1) var base_texture: texture_2d<f32>;
@group(2) @binding(2) var base_sampler: sampler;

/// The alpha of the base colour's picture, as red: for whoever wants alpha alone.
@group(2) @binding(7) var alpha_texture: texture_2d<f32>;

/// The alpha of the base colour, of the picture itself whatever the distance, as rays see it.
fn exact_alpha(uv: vec2f) -> f32 {
    return material.base_colour.a * textureSampleLevel(alpha_texture, base_sampler, uv, 0.0).r;
}

/// The base colour, linear RGBA.
fn base_colour(uv: vec2f) -> vec4f {
    return material.base_colour * textureSample(base_texture, base_sampler, uv);
}

/// How much of its place the surface covers where the alpha of its base colour is this, 0 to 1.
fn coverage(alpha: f32) -> f32 {
    let covered = select(clamp(alpha, 0.0, 1.0), select(0.0, 1.0, alpha >= material.cutoff), material.is_mask == 1u);
    return covered * material.solidity;
}
