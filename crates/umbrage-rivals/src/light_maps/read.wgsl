// Draws surfaces, and reads how much of up to three lights reaches them. Alpha is 1 where that is known.

struct Place {
    clip_from_mesh: mat4x4f,
    /// The instance's rectangle: its smallest corner and its size, as shares of a page.
    corner: vec2f,
    size: vec2f,
    /// The number of its page; below 0 for what has no texels.
    page: f32,
}

struct Lights {
    /// The first layer of each light in the atlas; below 0 for none.
    layers: vec4f,
}

@group(0) @binding(0) var<storage, read> places: array<Place>;
@group(0) @binding(1) var atlas: texture_2d_array<f32>;
@group(0) @binding(2) var bilinear: sampler;
@group(0) @binding(3) var<uniform> lights: Lights;

struct Surface {
    @builtin(position) position: vec4f,
    @location(0) in_page: vec2f,
    @location(1) @interpolate(flat) page: f32,
}

@vertex
fn surface(
    @builtin(instance_index) index: u32,
    @location(0) position: vec3f,
    @location(1) in_rectangle: vec2f,
) -> Surface {
    let place = places[index];
    let in_page = place.corner + in_rectangle * place.size;
    return Surface(place.clip_from_mesh * vec4f(position, 1.0), in_page, place.page);
}

fn visibility(layer: f32, surface: Surface) -> f32 {
    if layer < 0.0 {
        return 0.0;
    }
    return textureSampleLevel(atlas, bilinear, surface.in_page, u32(layer + surface.page), 0.0).r;
}

@fragment
fn reach(surface: Surface) -> @location(0) vec4f {
    if surface.page < 0.0 {
        return vec4f(0.0);
    }
    let layers = lights.layers;
    return vec4f(
        visibility(layers.x, surface),
        visibility(layers.y, surface),
        visibility(layers.z, surface),
        1.0,
    );
}
