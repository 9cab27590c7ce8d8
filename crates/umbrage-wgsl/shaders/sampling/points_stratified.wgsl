// At every place other points of the table are picked, each by itself (opengl-tutorial 16).

import constants::UMBRAGE_TABLE;
import package::sampling::pcg::umbrage_pcg;

/// A point of the unit disc for a place with this noise: one of the table, whatever `point` is.
fn umbrage_point(point: vec2f, i: u32, noise: f32) -> vec2f {
    var table = UMBRAGE_TABLE;
    return table[umbrage_pcg(u32(noise * 16777216.0) * 64u + i) % 16u];
}
