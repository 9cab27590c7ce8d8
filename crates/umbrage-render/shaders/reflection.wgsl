// How a surface reflects: microfacets, as glTF 2.0 has them in appendix B.
//
// D: Trowbridge and Reitz 1975 (GGX, Walter et al. 2007). V: Smith's shadowing, correlated (Heitz 2014). F: Schlick 1994.
// All that comes from around: Karis, *Physically Based Shading on Mobile*, 2014.

/// A surface at a place, lit or not.
struct Surface {
    /// Unit, on the eye's side.
    normal: vec3f,
    /// Linear RGB that is scattered.
    diffuse: vec3f,
    /// Linear RGB that is reflected head-on, and at a grazing angle.
    head_on: vec3f,
    grazing: vec3f,
    roughness: f32,
    /// How much of the light around reaches it, 0 to 1.
    open: f32,
    /// What it sends out by itself, exposed.
    emission: vec3f,
}

/// Smoother surfaces show lights of no size as points that no pixel holds.
const SMOOTHEST: f32 = 0.045;

/// What a surface sends to the eye of light from a direction, as a share of what a white matte surface that faces the light
/// sends back. All directions are unit, and lead away from the surface.
fn reflected(surface: Surface, toward_eye: vec3f, toward_light: vec3f) -> vec3f {
    let halfway = normalize(toward_eye + toward_light);
    let normal_light = max(dot(surface.normal, toward_light), 0.0);
    let normal_eye = max(abs(dot(surface.normal, toward_eye)), 1e-4);
    let normal_half = clamp(dot(surface.normal, halfway), 0.0, 1.0);
    let eye_half = clamp(dot(toward_eye, halfway), 0.0, 1.0);
    let alpha = surface.roughness * surface.roughness;
    let square = alpha * alpha;
    let spread = (normal_half * square - normal_half) * normal_half + 1.0;
    // Without its 1 / π, which the light that arrives has too.
    let distribution = square / (spread * spread);
    let masking = normal_light * sqrt(normal_eye * normal_eye * (1.0 - square) + square)
        + normal_eye * sqrt(normal_light * normal_light * (1.0 - square) + square);
    let fresnel = surface.head_on + (surface.grazing - surface.head_on) * pow(1.0 - eye_half, 5.0);
    let mirrored = fresnel * (distribution * 0.5 / max(masking, 1e-6));
    return (surface.diffuse * (1.0 - fresnel) + mirrored) * normal_light;
}

/// The share of evenly bright surroundings that is reflected to the eye, and not scattered.
fn reflected_share(surface: Surface, normal_eye: f32) -> vec3f {
    let r = surface.roughness * vec4f(-1.0, -0.0275, -0.572, 0.022) + vec4f(1.0, 0.0425, 1.04, -0.04);
    let a = min(r.x * r.x, exp2(-9.28 * normal_eye)) * r.x + r.y;
    let factors = vec2f(-1.04, 1.04) * a + r.zw;
    return surface.head_on * factors.x + surface.grazing * max(factors.y, 0.0);
}
