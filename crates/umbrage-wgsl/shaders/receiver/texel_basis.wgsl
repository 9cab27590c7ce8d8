// How a view's texels lie at one point of the world. One form for every view, parallel, from a tip or warped; derived in
// umbrage-core, `texel_basis.rs`, which it mirrors.

import constants::UMBRAGE_STEEPEST_PLANE;
import package::storage::map::{umbrage_clip_from_local, umbrage_tile_size};

struct UmbrageTexelBasis {
    /// Sides of a texel across the light, metres of world space: a texel to the right on the map, and one downward.
    right: vec3f,
    down: vec3f,
    /// How much the place on the map grows a metre, in texels to the right and downward; and how much stored depth does.
    right_gradient: vec3f,
    down_gradient: vec3f,
    depth_gradient: vec3f,
}

/// The texel basis at a point with clip position `clip`, which has w > 0.
fn umbrage_texel_basis(view_index: u32, clip: vec4f) -> UmbrageTexelBasis {
    // Rows of the matrix, without their last entries.
    let rows = transpose(umbrage_clip_from_local(view_index));
    let ndc = clip.xyz / clip.w;
    let half = 0.5 * umbrage_tile_size(view_index) / clip.w;
    var texel_basis: UmbrageTexelBasis;
    texel_basis.right_gradient = (rows[0].xyz - rows[3].xyz * ndc.x) * half;
    texel_basis.down_gradient = (rows[1].xyz - rows[3].xyz * ndc.y) * -half;
    texel_basis.depth_gradient = (rows[2].xyz - rows[3].xyz * ndc.z) / clip.w;
    let across = cross(texel_basis.right_gradient, texel_basis.down_gradient);
    let square = max(dot(across, across), 1.1754944e-38);
    texel_basis.right = cross(texel_basis.down_gradient, across) / square;
    texel_basis.down = cross(across, texel_basis.right_gradient) / square;
    return texel_basis;
}

/// How much stored depth grows on a receiver's plane from a texel to the next, to the right and downward. `cosine` is that
/// of the angle between normal and light. Steep planes count as less steep, and those turned away as flat: what they show
/// is the shadow of their other side.
fn umbrage_slope(texel_basis: UmbrageTexelBasis, world_normal: vec3f, cosine: f32) -> vec2f {
    let square = dot(world_normal, cross(texel_basis.right_gradient, texel_basis.down_gradient));
    if cosine <= 0.0 || abs(square) < 1.1754944e-38 {
        return vec2f(0.0);
    }
    let right = dot(world_normal, cross(texel_basis.depth_gradient, texel_basis.down_gradient));
    let down = dot(world_normal, cross(texel_basis.right_gradient, texel_basis.depth_gradient));
    let sine = sqrt(max(1.0 - cosine * cosine, 0.0));
    return vec2f(right, down) / square * (cosine / max(cosine, sine / UMBRAGE_STEEPEST_PLANE));
}
