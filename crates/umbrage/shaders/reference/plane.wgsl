// Every texel is compared with the depth that the receiver's plane has at the texel's centre: a flat receiver agrees with
// what it has drawn itself, whatever its slope.
//
// On a plane with unit normal n, in a view whose clip x, y and z grow along X, Y and Z (perpendicular, as they are in
// parallel views), depth changes with x by −(n·X)|Z|² / ((n·Z)|X|²), and with y likewise. Here n·Z is −cosine · |Z|.
// Views with a perspective need another formula: there, x and depth share a denominator.

/// How much the depth of a receiver's plane grows from a texel to the next, to the right and downward. `cosine` is that
/// of the angle between normal and light. A surface that is turned away is left to the shadow of its other side.
fn umbrage_gradient(view_index: u32, world_normal: vec3f, cosine: f32) -> vec2f {
    if cosine <= 0.0 {
        return vec2f(0.0);
    }
    let m = umbrage_frame.views[view_index].clip_from_world;
    let right = vec3f(m[0].x, m[1].x, m[2].x);
    let down = -vec3f(m[0].y, m[1].y, m[2].y);
    let along = vec2f(dot(world_normal, right) / dot(right, right), dot(world_normal, down) / dot(down, down));
    let sine = sqrt(max(1.0 - cosine * cosine, 0.0));
    let limited = max(cosine, sine / UMBRAGE_STEEPEST_PLANE);
    let tile_size = umbrage_frame.views[view_index].tile_size;
    return along * (2.0 / (tile_size * umbrage_frame.views[view_index].depth_metres * limited));
}
