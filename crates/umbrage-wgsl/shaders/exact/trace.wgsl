// A ray from a point toward a light, through all that casts.
//
// It walks the hierarchy over instances, and in each instance whose box it meets the hierarchy of its mesh, in that mesh's own
// space. Nodes lie in depth-first order with a link past each subtree, so no stack is needed. Rays beside each other look for
// their next leaf together, and then ask its triangles together (after Aila and Laine 2009).

import chosen::umbrage_covered;
import package::exact::occluders::{UmbragePlaced, umbrage_corners, umbrage_nodes, umbrage_placed, umbrage_triangles};
import package::exact::ray::{UmbrageRay, umbrage_meets, umbrage_ray};
import package::exact::triangle::umbrage_hit;

/// What a ray has found.
struct UmbrageTrace {
    /// The share of light that comes past all triangles.
    share: f32,
    /// Whether the ray has passed the box of something whose shape rays do not know.
    passed_bent: bool,
}

fn umbrage_corner(corner: u32) -> vec3f {
    let at = 3u * corner;
    return vec3f(umbrage_corners[at], umbrage_corners[at + 1u], umbrage_corners[at + 2u]);
}

/// The next leaf that a ray meets among nodes from `first` on to `last`; and where to go on. The leaf is 0 where there is none.
fn umbrage_next_leaf(ray: UmbrageRay, first: u32, last: u32, end: f32) -> vec2u {
    var node = first;
    var leaf = 0u;
    while node < last && leaf == 0u {
        let meets = umbrage_meets(ray, umbrage_nodes[node].low, umbrage_nodes[node].high, end);
        leaf = select(0u, umbrage_nodes[node].leaf, meets);
        node = select(umbrage_nodes[node].next, node + 1u, meets);
    }
    return vec2u(leaf, node);
}

/// The share of light that comes past the triangles of a leaf, whose corners begin at `corner_offset`.
fn umbrage_past_leaf(ray: UmbrageRay, leaf: u32, corner_offset: u32, end: f32, lamp: f32) -> f32 {
    var share = 1.0;
    let first = leaf >> 3u;
    for (var i = first; i < first + (leaf & 7u); i++) {
        let triangle = umbrage_triangles[i];
        let place = triangle.xyz + corner_offset;
        let corners = mat3x3f(umbrage_corner(place.x), umbrage_corner(place.y), umbrage_corner(place.z));
        let hit = umbrage_hit(ray, corners, end, lamp);
        if hit.is_hit {
            share *= 1.0 - umbrage_covered(triangle, hit.weights);
        }
    }
    return share;
}

/// A ray in the space of an instance's mesh. What rounding moves by `far` in the world is moved so much farther there, at most.
fn umbrage_ray_of(placed: UmbragePlaced, world_position: vec3f, to_light: vec3f, far: f32) -> UmbrageRay {
    let rows = transpose(mat3x3f(placed.row_x.xyz, placed.row_y.xyz, placed.row_z.xyz));
    let begin = vec3f(placed.row_x.w, placed.row_y.w, placed.row_z.w);
    let squares = vec3f(
        dot(placed.row_x.xyz, placed.row_x.xyz), dot(placed.row_y.xyz, placed.row_y.xyz),
        dot(placed.row_z.xyz, placed.row_z.xyz));
    let reach = far * sqrt(max(max(squares.x, squares.y), squares.z));
    return umbrage_ray(rows * world_position + begin, rows * to_light, reach);
}

/// What lies between a world-space point and a light that lies in a unit direction, `lamp` metres away. Nothing casts beyond
/// `end`, metres from the point.
fn umbrage_trace(world_position: vec3f, to_light: vec3f, lamp: f32, end: f32) -> UmbrageTrace {
    let far = length(world_position);
    let world_ray = umbrage_ray(world_position, to_light, far);
    var trace = UmbrageTrace(1.0, false);
    var top = vec2u(0u, 0u);
    while trace.share > 0.0 {
        top = umbrage_next_leaf(world_ray, top.y, umbrage_nodes[0].next, end);
        if top.x == 0u {
            break;
        }
        let placed = umbrage_placed[top.x - 1u];
        trace.passed_bent = trace.passed_bent || placed.first == placed.end;
        let ray = umbrage_ray_of(placed, world_position, to_light, far);
        var within = vec2u(0u, placed.first);
        while within.y < placed.end && trace.share > 0.0 {
            within = umbrage_next_leaf(ray, within.y, placed.end, end);
            trace.share *= umbrage_past_leaf(ray, within.x, placed.corner_offset, end, lamp);
        }
    }
    return trace;
}
