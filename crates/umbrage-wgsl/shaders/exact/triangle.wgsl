// Whether a ray meets a triangle.
//
// The corners are seen along the ray, as two coordinates across it, and the triangle holds the ray where all three edges turn the
// same way around it (after Woop, Benthin and Wald 2013). Triangles that share an edge see it alike, and what rounding makes of
// a turn counts for both: no ray slips through between them.
//
// What lies so near to the receiver's own plane, or to the lamp's place, as rounding may have moved either is not between them.

import package::exact::ray::{UMBRAGE_ROUNDING, UmbrageRay};

/// Where a ray meets a triangle.
struct UmbrageHit {
    is_hit: bool,
    /// How much each corner counts there.
    weights: vec3f,
}

/// Where a ray meets a triangle on the way to `end`, metres along it. A lamp is `lamp` metres away; a sun is farther than all.
fn umbrage_hit(ray: UmbrageRay, corners: mat3x3f, end: f32, lamp: f32) -> UmbrageHit {
    let a = corners[0] - ray.origin;
    let b = corners[1] - ray.origin;
    let c = corners[2] - ray.origin;
    // Two directions across the ray (Duff et al. 2017), of any length.
    let d = ray.direction;
    let size = length(d);
    let facing = select(-1.0, 1.0, d.z >= 0.0) * size;
    let p = -1.0 / (facing + d.z);
    let q = d.x * d.y * p;
    let right = vec3f(facing + d.x * d.x * p, q, -d.x);
    let up = vec3f(q, facing + d.y * d.y * p, -d.y);
    let x = vec3f(dot(right, a), dot(right, b), dot(right, c));
    let y = vec3f(dot(up, a), dot(up, b), dot(up, c));
    let plus = x.yzx * y.zxy;
    let minus = y.yzx * x.zxy;
    let turns = plus - minus;
    let slack = (abs(plus) + abs(minus)) * 2.4e-7;
    let inside = all(turns >= -slack) || all(turns <= slack);
    let all_turns = turns.x + turns.y + turns.z;
    let along = vec3f(dot(d, a), dot(d, b), dot(d, c)) / (size * size);
    let weights = turns / select(all_turns, 1.0, all_turns == 0.0);
    let distance = dot(weights, along);
    // How far the receiver and the lamp are off the triangle's plane.
    let across = cross(b - a, c - a);
    let off = dot(across, a);
    let reach = max(max(length(corners[0]), length(corners[1])), max(length(corners[2]), length(ray.origin)));
    let near = (UMBRAGE_ROUNDING * reach + ray.slack) * length(across);
    let off_lamp = off - lamp * dot(across, d);
    let is_between = abs(off) > near && abs(off_lamp) > near && distance > 0.0 && distance < end;
    return UmbrageHit(inside && all_turns != 0.0 && is_between, weights);
}
