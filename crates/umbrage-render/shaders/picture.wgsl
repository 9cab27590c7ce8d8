// How a picture is exposed, and what lies around its scene, as group 0. It needs `scene.wgsl`.

struct Picture {
    /// From luminance to what the tone map gets. The lights and the sky of `Scene` are multiplied with it already.
    exposure: f32,
    /// Halvings by haze in a metre; 0 without haze.
    haze: f32,
    /// From the numbers of the environment's texture to luminance.
    environment_scale: f32,
    /// The light of the surroundings on a surface as spherical harmonics, in the order 00, 1-1, 10, 11, 2-2, 2-1, 20, 21, 22:
    /// what a white surface sends back, exposed. Used with an environment picture.
    around: array<vec4f, 9>,
}

@group(0) @binding(2) var<storage, read> picture: Picture;
