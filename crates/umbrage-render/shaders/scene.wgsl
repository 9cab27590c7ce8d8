// What all passes over the scene read, as group 0: from where it is seen, the lights that shade it, and where its
// instances stand.

struct Light {
    /// In world space: the unit direction to a sun, and 0; or the position of a punctual light, and 1.
    place: vec4f,
    /// Unit axis of a spot.
    axis: vec3f,
    /// Metres.
    range: f32,
    /// Linear RGB: of a sun on a surface that faces it; of others the same at one metre.
    colour: vec3f,
    /// How a spot fades toward its rim: scale and offset of the cosine to its axis.
    cone_scale: f32,
    cone_offset: f32,
}

struct Scene {
    clip_from_world: mat4x4f,
    world_from_clip: mat4x4f,
    eye: vec3f,
    light_count: u32,
    /// Unit, in world space, for the sky.
    direction_to_sun: vec3f,
    /// How bright the sky is: 1 by day.
    daylight: f32,
    /// Linear RGB of the sun's light on a surface that faces it.
    sun: vec3f,
    /// The light whose visibility is shown.
    shown_light: u32,
    /// Size of the picture, pixels.
    size: vec2u,
    lights: array<Light, 16>,
}

@group(0) @binding(0) var<uniform> scene: Scene;
@group(0) @binding(1) var<storage, read> instances: array<mat4x4f>;
