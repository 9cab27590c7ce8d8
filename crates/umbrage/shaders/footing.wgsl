// How a view's texels lie at one point of the world. One form for every view, parallel, from a tip or warped; derived in
// umbrage-core, `footing.rs`, which it mirrors.

struct UmbrageFooting {
    /// Sides of a texel across the light, metres of world space: a texel to the right on the map, and one downward.
    right: vec3f,
    down: vec3f,
    /// How much the place on the map grows a metre, in texels to the right and downward; and how much stored depth does.
    right_gradient: vec3f,
    down_gradient: vec3f,
    depth_gradient: vec3f,
}

/// The footing of a point with clip position `clip`, which has w > 0.
fn umbrage_footing(view_index: u32, clip: vec4f) -> UmbrageFooting {
    // Rows of the matrix, without their last entries.
    let rows = transpose(umbrage_frame.views[view_index].clip_from_world);
    let ndc = clip.xyz / clip.w;
    let half = 0.5 * umbrage_frame.views[view_index].tile_size / clip.w;
    var footing: UmbrageFooting;
    footing.right_gradient = (rows[0].xyz - rows[3].xyz * ndc.x) * half;
    footing.down_gradient = (rows[1].xyz - rows[3].xyz * ndc.y) * -half;
    footing.depth_gradient = (rows[2].xyz - rows[3].xyz * ndc.z) / clip.w;
    let across = cross(footing.right_gradient, footing.down_gradient);
    let square = max(dot(across, across), 1.1754944e-38);
    footing.right = cross(footing.down_gradient, across) / square;
    footing.down = cross(across, footing.right_gradient) / square;
    return footing;
}

/// How much stored depth grows on a receiver's plane from a texel to the next, to the right and downward. `cosine` is that
/// of the angle between normal and light. Steep planes count as less steep, and those turned away as flat: what they show
/// is the shadow of their other side.
fn umbrage_slope(footing: UmbrageFooting, world_normal: vec3f, cosine: f32) -> vec2f {
    let square = dot(world_normal, cross(footing.right_gradient, footing.down_gradient));
    if cosine <= 0.0 || abs(square) < 1.1754944e-38 {
        return vec2f(0.0);
    }
    let right = dot(world_normal, cross(footing.depth_gradient, footing.down_gradient));
    let down = dot(world_normal, cross(footing.right_gradient, footing.depth_gradient));
    let sine = sqrt(max(1.0 - cosine * cosine, 0.0));
    return vec2f(right, down) / square * (cosine / max(cosine, sine / UMBRAGE_STEEPEST_PLANE));
}
