// Everything that depends on the kind of a light: a new kind adds its constant here, and its case to these functions.

import package::frame::umbrage_frame;

/// Parallel rays.
const UMBRAGE_LIGHT_SUN: u32 = 0u;
/// A cone of rays from an apex.
const UMBRAGE_LIGHT_SPOT: u32 = 1u;
/// Rays in all directions from a point; its views are the faces of a cube.
const UMBRAGE_LIGHT_POINT: u32 = 2u;

/// Unit direction from a world-space point to a light.
fn umbrage_direction_to_light(light: u32, world_position: vec3f) -> vec3f {
    let place = umbrage_frame.lights[light].place;
    if umbrage_frame.lights[light].kind == UMBRAGE_LIGHT_SUN {
        return place;
    }
    let toward = place - world_position;
    return toward * inverseSqrt(max(dot(toward, toward), 1e-30));
}

/// How far a ray from a world-space point toward a light goes before it has passed the light, at most `longest`, metres.
fn umbrage_distance_to_light(light: u32, world_position: vec3f, longest: f32) -> f32 {
    if umbrage_frame.lights[light].kind == UMBRAGE_LIGHT_SUN {
        return longest;
    }
    return min(longest, distance(umbrage_frame.lights[light].place, world_position));
}

/// Farther than all that a light shines on, metres.
const UMBRAGE_FARTHEST_LIGHT: f32 = 1e18;

/// Whether a light shines on a world-space point: within its range and its cone, or as near to its rim as rounding may move it.
fn umbrage_shines_on(light: u32, world_position: vec3f) -> bool {
    let distance = umbrage_distance_to_light(light, world_position, UMBRAGE_FARTHEST_LIGHT);
    let from_light = -umbrage_direction_to_light(light, world_position);
    let cosine = dot(umbrage_frame.lights[light].axis, from_light);
    return distance <= umbrage_frame.lights[light].range && cosine >= umbrage_frame.lights[light].cos_rim - 1e-5;
}

/// How far before a light casters end on a ray that leads to it along a unit direction, metres: where the maps of its views
/// begin, which are the faces of a cube around a point light.
fn umbrage_near_along(light: u32, to_light: vec3f) -> f32 {
    let size = abs(to_light);
    let of_face = max(size.x, max(size.y, size.z));
    let of_spot = max(-dot(umbrage_frame.lights[light].axis, to_light), 1e-6);
    let along_axis = select(of_face, of_spot, umbrage_frame.lights[light].kind == UMBRAGE_LIGHT_SPOT);
    return umbrage_frame.lights[light].near / along_axis;
}

/// The way from a world-space point to the point of a light that lies aside of its middle, in radii of the light: metres for a
/// lamp, and of no certain length for a sun.
fn umbrage_light_point(light: u32, world_position: vec3f, aside: vec3f) -> vec3f {
    let moved = umbrage_frame.lights[light].place + aside * umbrage_frame.lights[light].size;
    if umbrage_frame.lights[light].kind == UMBRAGE_LIGHT_SUN {
        return moved * UMBRAGE_FARTHEST_LIGHT;
    }
    return moved - world_position;
}

/// Whether the views of a light are the faces of a cube, +X, −X, +Y, −Y, +Z, −Z, and not slices of the camera's depth.
fn umbrage_has_faces(light: u32) -> bool {
    return umbrage_frame.lights[light].kind == UMBRAGE_LIGHT_POINT;
}

/// The face of the cube around a light that a world-space point is seen through: that of the largest part of its direction.
fn umbrage_face(light: u32, world_position: vec3f) -> u32 {
    let from_light = world_position - umbrage_frame.lights[light].place;
    let size = abs(from_light);
    let is_x = size.x >= size.y && size.x >= size.z;
    let is_y = !is_x && size.y >= size.z;
    let part = select(select(from_light.z, from_light.y, is_y), from_light.x, is_x);
    return select(select(4u, 2u, is_y), 0u, is_x) + select(0u, 1u, part < 0.0);
}

/// How much rounding may make of a stored depth and of the one that it is compared with.
fn umbrage_depth_rounding(view_index: u32, stored: f32) -> f32 {
    let rounding = umbrage_frame.views[view_index].depth_rounding;
    return rounding.x + rounding.y * abs(stored);
}

/// From unwarped stored depth, 1 on the near plane and 0 on the far one, to linear depth in a view: 0 on the near plane and 1
/// on the far one. Parallel views store depth evenly, others as 1 / d.
fn umbrage_linear_of_unwarped(view_index: u32, unwarped: f32) -> f32 {
    if umbrage_frame.views[view_index].light_kind == UMBRAGE_LIGHT_SUN {
        return 1.0 - unwarped;
    }
    let near = umbrage_frame.views[view_index].near_metres;
    let depth = umbrage_frame.views[view_index].depth_metres;
    return (1.0 - unwarped) * near / (near + unwarped * depth);
}

/// How much stored depth falls a metre along the light where linear depth is `linear` and the warp scales by `scale`.
fn umbrage_stored_a_metre(view_index: u32, linear: f32, scale: f32) -> f32 {
    let deep = umbrage_frame.views[view_index].depth_metres;
    if umbrage_frame.views[view_index].light_kind == UMBRAGE_LIGHT_SUN {
        return scale / deep;
    }
    // Stored depth is (1 / d − 1 / far) / (1 / near − 1 / far).
    let near = umbrage_frame.views[view_index].near_metres;
    let metres = near + linear * deep;
    return scale * near * (near + deep) / (deep * metres * metres);
}

/// Radius of the disc on the map through which a light is seen past a blocker's edge, metres at the receiver. Depths are
/// linear. The radius grows with the way between blocker and receiver (Fernando 2005): for a sun it is the way times the tangent
/// of half the sun's angle.
fn umbrage_penumbra_metres(light: u32, view_index: u32, receiver: f32, blocker: f32) -> f32 {
    let size = umbrage_frame.lights[light].size;
    let deep = umbrage_frame.views[view_index].depth_metres;
    let way = max(receiver - blocker, 0.0) * deep;
    if umbrage_frame.lights[light].kind == UMBRAGE_LIGHT_SUN {
        return size * way;
    }
    return size * way / max(umbrage_frame.views[view_index].near_metres + blocker * deep, 1.1754944e-38);
}
