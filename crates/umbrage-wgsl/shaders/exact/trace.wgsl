// A ray from a point toward a light, through all that casts.
//
// It walks the hierarchy over instances, and in each instance whose box it meets the hierarchy of its mesh, in that mesh's own
// space. Nodes lie in depth-first order with a link past each subtree, so no stack is needed. Rays beside each other look for
// their next leaf together, and then ask its triangles together (after Aila and Laine 2009).

import chosen::umbrage_covered;
import package::exact::occluders::{umbrage_corner, umbrage_instance, umbrage_node, umbrage_top_node, umbrage_triangle};
import package::exact::ray::{UMBRAGE_ROUNDING, UmbrageRay, umbrage_box_ray, umbrage_meets};
import package::exact::triangle::umbrage_hit;

/// What a ray has found.
struct UmbrageTrace {
    /// The share of light that comes past all triangles.
    share: f32,
    /// Whether the ray has passed the box of something bent, whose shape rays do not know.
    passed_bent: bool,
}

/// What lies between a world-space point and a light that lies in a unit direction, `lamp` metres away. Nothing casts beyond
/// `end`, metres from the point.
fn umbrage_trace(world_position: vec3f, to_light: vec3f, lamp: f32, end: f32) -> UmbrageTrace {
    let slack = UMBRAGE_ROUNDING * length(world_position);
    let world_ray = umbrage_box_ray(world_position, to_light, vec3f(0.0));
    var trace = UmbrageTrace(1.0, false);
    let top_end = umbrage_top_node(0u).next;
    var top = 0u;
    while top < top_end {
        var instance = 0u;
        while top < top_end && instance == 0u {
            let node = umbrage_top_node(top);
            let meets = umbrage_meets(world_ray, node.low, node.high, end);
            instance = select(0u, node.leaf, meets);
            top = select(node.next, top + 1u, meets);
        }
        if instance == 0u {
            break;
        }
        let placed = umbrage_instance(instance - 1u);
        if placed.first == placed.end {
            trace.passed_bent = true;
            continue;
        }
        let rows = transpose(mat3x3f(placed.row_x.xyz, placed.row_y.xyz, placed.row_z.xyz));
        let origin = rows * world_position + vec3f(placed.row_x.w, placed.row_y.w, placed.row_z.w);
        let direction = rows * to_light;
        let ray = UmbrageRay(origin, direction, slack * length(direction));
        let in_grid = (origin - placed.grid_low) * placed.grid_scale;
        let margin = 1.0 + 1e-6 * (abs(in_grid) + abs(placed.grid_low * placed.grid_scale));
        let box_ray = umbrage_box_ray(in_grid, direction * placed.grid_scale, margin);
        var at = placed.first;
        while at < placed.end {
            var leaf = 0u;
            while at < placed.end && leaf == 0u {
                let node = umbrage_node(at);
                let meets = umbrage_meets(box_ray, node.low, node.high, end);
                let is_leaf = (node.link & 7u) != 0u;
                leaf = select(0u, node.link, meets && is_leaf);
                at = select(node.link >> 3u, at + 1u, meets || is_leaf);
            }
            let first = leaf >> 3u;
            for (var i = first; i < first + (leaf & 7u); i++) {
                let triangle = umbrage_triangle(i);
                let corners =
                    mat3x3f(umbrage_corner(triangle.x), umbrage_corner(triangle.y), umbrage_corner(triangle.z));
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
