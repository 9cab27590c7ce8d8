// A ray from a point toward a light, through all that casts.
//
// It walks the hierarchy over instances, and in each instance whose box it meets the hierarchy of its mesh, in that mesh's own
// space. Nodes lie in depth-first order with a link past each subtree, so no stack is needed. Rays beside each other look for
// their next leaf together, and then ask its triangles together (after Aila and Laine 2009).

import chosen::umbrage_covered;
import package::exact::occluders::{umbrage_corners, umbrage_nodes, umbrage_placed, umbrage_triangles};
import package::exact::ray::{umbrage_meets, umbrage_ray};
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

/// What lies between a world-space point and a light that lies in a unit direction, `lamp` metres away. Nothing casts beyond
/// `end`, metres from the point.
fn umbrage_trace(world_position: vec3f, to_light: vec3f, lamp: f32, end: f32) -> UmbrageTrace {
    let far = length(world_position);
    let world_ray = umbrage_ray(world_position, to_light, far);
    var trace = UmbrageTrace(1.0, false);
    let top_end = umbrage_nodes[0].next;
    var top = 0u;
    while top < top_end {
        // The next instance.
        var instance = 0u;
        while top < top_end && instance == 0u {
            let meets = umbrage_meets(world_ray, umbrage_nodes[top].low, umbrage_nodes[top].high, end);
            instance = select(0u, umbrage_nodes[top].leaf, meets);
            top = select(umbrage_nodes[top].next, top + 1u, meets);
        }
        if instance == 0u {
            break;
        }
        let placed = umbrage_placed[instance - 1u];
        if placed.first == placed.end {
            trace.passed_bent = true;
            continue;
        }
        let rows = transpose(mat3x3f(placed.row_x.xyz, placed.row_y.xyz, placed.row_z.xyz));
        let begin = vec3f(placed.row_x.w, placed.row_y.w, placed.row_z.w);
        // What is moved in the world is moved so much farther here, at most.
        let squares = vec3f(
            dot(placed.row_x.xyz, placed.row_x.xyz), dot(placed.row_y.xyz, placed.row_y.xyz),
            dot(placed.row_z.xyz, placed.row_z.xyz));
        let reach = far * sqrt(max(max(squares.x, squares.y), squares.z));
        let ray = umbrage_ray(rows * world_position + begin, rows * to_light, reach);
        var node = placed.first;
        while node < placed.end {
            // The next leaf.
            var leaf = 0u;
            while node < placed.end && leaf == 0u {
                let meets = umbrage_meets(ray, umbrage_nodes[node].low, umbrage_nodes[node].high, end);
                leaf = select(0u, umbrage_nodes[node].leaf, meets);
                node = select(umbrage_nodes[node].next, node + 1u, meets);
            }
            let first = leaf >> 3u;
            for (var i = first; i < first + (leaf & 7u); i++) {
                let triangle = umbrage_triangles[i];
                let place = triangle.xyz + placed.corner_offset;
                let corners = mat3x3f(umbrage_corner(place.x), umbrage_corner(place.y), umbrage_corner(place.z));
                let hit = umbrage_hit(ray, corners, end, lamp);
                if hit.is_hit {
                    trace.share *= 1.0 - umbrage_covered(triangle, hit.weights);
                }
            }
            if trace.share <= 0.0 {
                break;
            }
        }
        if trace.share <= 0.0 {
            break;
        }
    }
    return trace;
}
