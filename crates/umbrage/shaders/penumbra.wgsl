// How wide a penumbra is. A disc of light is seen past a blocker's edge as a disc on the map, whose radius grows with the
// way between blocker and receiver (Fernando 2005; for a sun the way times the tangent of half its angle).

/// Radius of the disc on the map through which a light is seen past a blocker, metres at the receiver: both at depths along
/// the light's axis, 0 on the near plane and 1 on the far one.
fn umbrage_penumbra(lookup: UmbrageLookup, receiver: f32, blocker: f32) -> f32 {
    let size = umbrage_frame.lights[lookup.light].size;
    let deep = umbrage_frame.views[lookup.view_index].depth_metres;
    let way = max(receiver - blocker, 0.0) * deep;
    if umbrage_frame.views[lookup.view_index].spreads == 0u {
        return size * way;
    }
    return size * way / max(umbrage_frame.views[lookup.view_index].near_metres + blocker * deep, 1.1754944e-38);
}

/// That disc in texels, to the right and downward: at least half a texel, and at most as far as maps have room.
fn umbrage_penumbra_texels(lookup: UmbrageLookup, receiver: f32, blocker: f32) -> vec2f {
    let metres = umbrage_penumbra(lookup, receiver, blocker);
    return clamp(metres / max(lookup.texel_metres, vec2f(1.1754944e-38)), vec2f(0.5), vec2f(UMBRAGE_MAX_TEXELS));
}
