// What the passes of a picture know of its camera and of the light whose shadows it shows. Positions are relative to the eye, in
// world axes, metres.

struct Shot {
    /// To the right edge of the picture: at depth 1 of a perspective camera, at every depth of parallel rays.
    right: vec3f,
    /// 1 where the camera's rays are parallel.
    is_parallel: u32,
    /// To the upper edge.
    up: vec3f,
    /// The view depth of the nearest thing that is visible.
    near: f32,
    /// The unit direction of view.
    forward: vec3f,
    /// The view depth of the farthest thing that is visible.
    far: f32,
    /// The light, homogeneous: w is 1 at a place in the world, and 0 in the direction to a sun.
    light: vec4f,
    /// The unit direction in which a spot shines.
    axis: vec3f,
    /// The cosine of the half angle of a spot's cone; -2 of other lights.
    cos_outer: f32,
    /// The distance at which the light ends.
    range: f32,
    /// The number of corners that a piece of a volume has: 3 under a sun before a perspective camera, 6 otherwise.
    corners: u32,
    /// The tangent of half the angle that a sun is seen under, or the radius of a lamp; 0 of a point.
    size: f32,
}

@group(0) @binding(0) var<uniform> shot: Shot;

/// The view depth of what has a depth, 1 to 0 exclusive, in the receivers' texture.
fn view_depth(depth: f32) -> f32 {
    let span = shot.far - shot.near;
    if shot.is_parallel == 1u {
        return shot.far - depth * span;
    }
    return shot.near * shot.far / (depth * span + shot.near);
}

/// Where a point of the picture, −1 to 1 with y up, lies at a view depth.
fn from_eye(point: vec2f, z: f32) -> vec3f {
    let aside = shot.right * point.x + shot.up * point.y;
    if shot.is_parallel == 1u {
        return aside + shot.forward * z;
    }
    return (aside + shot.forward) * z;
}

/// Whether the light shines at a place, whatever is between them.
fn is_reached(place: vec3f) -> bool {
    if shot.light.w == 0.0 {
        return true;
    }
    let from_light = place - shot.light.xyz;
    let distance = length(from_light);
    return distance < shot.range && dot(from_light, shot.axis) > shot.cos_outer * distance;
}
