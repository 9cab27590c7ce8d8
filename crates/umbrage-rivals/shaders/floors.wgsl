// On which plane each pixel lies: the number of the first, counted from 1; 0 where it lies on none; 255 where no light is to be
// blocked, or nothing is seen.
//
// It needs `shot.wgsl`, `whole_picture.wgsl` and `receivers.wgsl`.

struct Floor {
    /// The unit normal, toward the light, and the distance of the eye along it.
    plane: vec4f,
    /// The box around its surfaces.
    least: vec3f,
    /// The most that a surface lies off the plane.
    slack: f32,
    most: vec3f,
    /// 1 where the eye and the light are on the same side of the plane.
    is_there: u32,
}

const LIT: u32 = 255u;

/// The share of its distance by which a pixel may lie off its plane.
const ROUNDING: f32 = 2e-5;

@group(0) @binding(2) var<uniform> floors: array<Floor, 32>;

@fragment
fn mark(covering: Covering) -> @location(0) u32 {
    let depth = seen_depth(covering.clip);
    if depth == 0.0 {
        return LIT;
    }
    let z = view_depth(depth);
    let place = from_eye(covering.point, z);
    for (var i = 0u; i < 32u; i += 1u) {
        let slack = floors[i].slack + ROUNDING * z;
        let is_on = abs(dot(floors[i].plane, vec4f(place, 1.0))) <= slack
            && all(place >= floors[i].least - slack) && all(place <= floors[i].most + slack);
        if floors[i].is_there == 1u && is_on {
            return select(LIT, i + 1u, is_reached(place));
        }
    }
    return 0u;
}
