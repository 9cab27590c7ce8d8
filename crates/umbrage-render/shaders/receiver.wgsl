// The vertex shader of everything that receives shadows. It needs `scene.wgsl`.

struct Receiver {
    @builtin(position) @invariant clip: vec4f,
    /// From the eye, in world axes: small numbers, exact where precision is needed.
    @location(0) from_eye: vec3f,
    @location(1) normal: vec3f,
    @location(2) uv: vec2f,
}

/// Where this fragment asks for visibility, from the eye: its entry sets it. It needs a file of `place/`.
var<private> asked_from_eye: vec3f;

@vertex
fn receiver(
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
    @location(2) uv: vec2f,
    @location(3) instance: u32,
) -> Receiver {
    return placed_receiver(position, normal, uv, instance);
}

fn placed_receiver(position: vec3f, normal: vec3f, uv: vec2f, instance: u32) -> Receiver {
    let world_from_mesh = instances[instance];
    let world = (world_from_mesh * vec4f(position, 1.0)).xyz;
    // Normals go with the cofactors, which is right under any scale; a mirror turns them over.
    let a = world_from_mesh[0].xyz;
    let b = world_from_mesh[1].xyz;
    let c = world_from_mesh[2].xyz;
    let cofactors = mat3x3f(cross(b, c), cross(c, a), cross(a, b));
    let mirrored = dot(a, cross(b, c)) < 0.0;
    var out: Receiver;
    out.clip = scene.clip_from_world * vec4f(world, 1.0);
    out.from_eye = world - scene.eye;
    out.normal = cofactors * normal * select(1.0, -1.0, mirrored);
    out.uv = uv;
    return out;
}

/// Unit normal of the triangle, turned to the eye.
fn geometric_normal(from_eye: vec3f) -> vec3f {
    let normal = cross(dpdx(from_eye), dpdy(from_eye));
    let turned = normal * -sign(dot(normal, from_eye));
    return turned * inverseSqrt(max(dot(turned, turned), 1e-30));
}

/// Unit normal of the vertices, on the side of a geometric normal.
fn smooth_normal(receiver: Receiver, facing: vec3f) -> vec3f {
    let normal = receiver.normal * inverseSqrt(max(dot(receiver.normal, receiver.normal), 1e-30));
    return select(-normal, normal, dot(normal, facing) >= 0.0);
}
