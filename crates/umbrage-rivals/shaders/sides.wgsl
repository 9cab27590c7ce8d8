// The sides of volumes: what is extruded of edges between a triangle that faces the light and one that faces away.
//
// It needs `shot.wgsl`, `instance.wgsl` and `pieces.wgsl`.

/// The two vertices of each edge; the triangle left of the way from one to the other seen from outside, and the one right of it.
@group(0) @binding(8) var<storage, read> edges: array<vec4u>;

fn is_away(first_word: u32, triangle: u32) -> bool {
    return ((turned_away[first_word + triangle / 32u] >> (triangle % 32u)) & 1u) == 1u;
}

@compute @workgroup_size(64)
fn side(
    @builtin(workgroup_id) group: vec3u,
    @builtin(num_workgroups) groups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let number = group.x + group.y * groups.x;
    let job = jobs[min(number, arrayLength(&jobs) - 1u)];
    let edge = job.y * 64u + lane;
    let word = instances[job.x].first_word;
    var is_silhouette = false;
    var turned = 0u;
    if number < arrayLength(&jobs) && edge < instances[job.x].edges {
        let its = edges[instances[job.x].first_edge + edge];
        let left = is_away(word, its.z);
        is_silhouette = left != is_away(word, its.w);
        turned = select(2u, 0u, left);
    }
    append(lane, is_silhouette, vec2u(job.x, (edge << 2u) | turned | 1u));
}
