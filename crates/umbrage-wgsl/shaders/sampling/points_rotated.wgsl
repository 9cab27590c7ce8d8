// At every place the points are turned by another angle.

/// A point of the unit disc for a place with this noise.
fn umbrage_point(point: vec2f, i: u32, noise: f32) -> vec2f {
    let angle = 6.2831853 * noise;
    let turn = vec2f(cos(angle), sin(angle));
    return vec2f(point.x * turn.x - point.y * turn.y, point.x * turn.y + point.y * turn.x);
}
