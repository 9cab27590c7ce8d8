// An empty tile: a triangle over all of it, on the far plane. It clears one tile of an atlas and leaves the others as they are,
// which no load operation of a pass can.

import package::caster::whole_tile::umbrage_whole_tile;

@vertex
fn clear(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return umbrage_whole_tile(index, 0.0);
}
