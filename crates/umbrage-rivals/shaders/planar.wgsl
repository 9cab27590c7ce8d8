// The triangles of a caster, flattened. It needs `flat.wgsl` and `mesh.wgsl`.

struct Corner {
    @builtin(position) clip: vec4f,
    /// How high above the plane the caster is there.
    @location(0) height: f32,
    @location(1) @interpolate(flat) which: u32,
}

@vertex
fn flatten(@builtin(vertex_index) vertex: u32, @builtin(instance_index) which: u32) -> Corner {
    let of_mesh = triangles[3u * flats[which].first_triangle + vertex];
    let point = vec4f(place(flats[which].first_vertex + of_mesh), 1.0);
    return Corner(flats[which].clip_from_mesh * point, dot(flats[which].height, point), which);
}

@fragment
fn shadow(corner: Corner) -> @location(0) f32 {
    let is_between = corner.height > flats[corner.which].least && corner.height < flats[corner.which].most;
    if !is_between || !is_on(corner.clip, corner.which) {
        discard;
    }
    return 0.0;
}
