// What a pixel sees, for who answers for a whole picture: position and normal. It needs `receiver.wgsl`.

/// The place of a unit vector on an octahedron, which is 0 for none.
fn packed_normal(normal: vec3f) -> u32 {
    let place = normal.xy / (abs(normal.x) + abs(normal.y) + abs(normal.z));
    let folded = (1.0 - abs(place.yx)) * select(vec2f(-1.0), vec2f(1.0), place >= vec2f(0.0));
    let packed = pack2x16snorm(select(place, folded, normal.z < 0.0));
    return select(packed, 1u, packed == 0u);
}

/// Where a fragment lies, and which way it faces.
fn place_of(receiver: Receiver) -> vec4u {
    let position = scene.eye + receiver.from_eye;
    return vec4u(bitcast<vec3u>(position), packed_normal(geometric_normal(receiver.from_eye)));
}

/// The fragment shader of solid surfaces.
@fragment
fn place(receiver: Receiver) -> @location(0) vec4u {
    return place_of(receiver);
}
