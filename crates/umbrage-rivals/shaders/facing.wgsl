// Which triangles face away from the light: one bit each, found once, so that caps and sides agree. Those that do are caps.
//
// It needs `shot.wgsl`, `instance.wgsl`, `mesh.wgsl` and `pieces.wgsl`.

/// A triangle that light meets at a smaller sine of an angle counts as facing it. It shadows nothing that one could see, and as a
/// cap it would lie in a lit surface.
const EDGE_ON: f32 = 1e-6;

var<workgroup> words: array<atomic<u32>, 2>;

fn faces_away(instance: u32, triangle: u32) -> bool {
    let first = 3u * (instances[instance].first_triangle + triangle);
    let base = instances[instance].first_vertex;
    let a = place(base + triangles[first]);
    let b = place(base + triangles[first + 1u]);
    let c = place(base + triangles[first + 2u]);
    let light = instances[instance].light;
    let normal = cross(b - a, c - a);
    let to_light = light.xyz - a * light.w;
    // A lamp stands inside its bulb.
    let others = max(distance(light.xyz, b), distance(light.xyz, c));
    let is_bulb = light.w == 1.0 && max(length(to_light), others) < instances[instance].near;
    return !is_bulb && dot(normal, to_light) < -EDGE_ON * length(normal) * length(to_light);
}

@compute @workgroup_size(64)
fn face(
    @builtin(workgroup_id) group: vec3u,
    @builtin(num_workgroups) groups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let number = group.x + group.y * groups.x;
    let job = jobs[min(number, arrayLength(&jobs) - 1u)];
    let triangle = job.y * 64u + lane;
    let is_there = number < arrayLength(&jobs) && triangle < instances[job.x].triangles;
    let is_away = is_there && (instances[job.x].flags & CASTS) != 0u && faces_away(job.x, triangle);
    if is_away {
        atomicOr(&words[lane / 32u], 1u << (lane % 32u));
    }
    workgroupBarrier();
    if number < arrayLength(&jobs) && lane < 2u {
        turned_away[instances[job.x].first_word + 2u * job.y + lane] = atomicLoad(&words[lane]);
    }
    append(lane, is_away, vec2u(job.x, triangle << 1u));
}
