// A caster before a plane, flattened onto it along the light's rays.

struct Flat {
    /// To the picture, by way of the plane.
    clip_from_mesh: mat4x4f,
    eye_from_mesh: mat4x4f,
    mesh_from_eye: mat4x4f,
    /// The height above the plane is this times a place in the space of the mesh.
    height: vec4f,
    /// The plane: its unit normal, toward the light, and the distance of the eye along it.
    plane: vec4f,
    /// The light in the space of the mesh, homogeneous.
    light: vec4f,
    /// Where the mesh's own begin in the buffers of all: vertices, triangles, edges.
    first_vertex: u32,
    first_triangle: u32,
    first_edge: u32,
    /// The number of the plane, from 1.
    number: u32,
    /// What is lower than this is part of the plane, or behind it.
    least: f32,
    /// What is higher than this is beyond the light.
    most: f32,
}

@group(0) @binding(3) var<storage, read> flats: array<Flat>;
@group(0) @binding(4) var marks: texture_2d<u32>;

/// Whether a pixel lies on the plane of a flat caster.
fn is_on(clip: vec4f, which: u32) -> bool {
    return textureLoad(marks, vec2i(clip.xy), 0).x == flats[which].number;
}
