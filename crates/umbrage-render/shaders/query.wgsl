// The visibility of points of the world. In front of it goes umbrage's receiver text, whose bindings are group 1.

struct Point {
    /// World space, metres.
    position: vec3f,
    /// Unit geometric normal.
    normal: vec3f,
}

struct Query {
    /// Of the frame's camera.
    clip_from_world: mat4x4f,
    /// Size of its picture, pixels.
    size: vec2f,
    light: u32,
}

@group(0) @binding(0) var<uniform> query: Query;
@group(0) @binding(1) var<storage, read> points: array<Point>;
@group(0) @binding(2) var<storage, read_write> answers: array<f32>;

/// Where a point lies in the picture, pixels; the upper left corner for what is behind the eye.
fn pixel_of(position: vec3f) -> vec2f {
    let clip = query.clip_from_world * vec4f(position, 1.0);
    if clip.w <= 0.0 {
        return vec2f(0.0);
    }
    return (vec2f(0.5, -0.5) * clip.xy / clip.w + 0.5) * query.size;
}

@compute @workgroup_size(64)
fn find_visibility(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&points) {
        return;
    }
    let point = points[id.x];
    answers[id.x] = umbrage_light_visibility(query.light, point.position, point.normal, pixel_of(point.position));
}
