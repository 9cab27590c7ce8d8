//! Round solids: a profile turned about the Y axis.

use std::f32::consts::{FRAC_PI_2, PI, TAU};

use glam::{Affine3A, Quat, Vec3};

use super::Solid;

/// Turns a profile of (radius, height), listed from the bottom up along the outside, about the Y axis. Ends that are
/// not on the axis are closed with a flat disc.
pub(crate) fn lathe(profile: &[[f32; 2]], segments: u32) -> Solid {
    let mut solid = Solid::default();
    let mut below: Option<([f32; 2], u32)> = None;
    for &[radius, height] in profile {
        let on_axis = radius <= 0.0;
        if let (Some(([r, _], low)), true) = (below, on_axis)
            && r > 0.0
        {
            solid.cap(low, segments, Vec3::Y * height, true);
        }
        let ring = solid.points.len() as u32;
        if !on_axis {
            solid.points.extend((0..segments).map(|i| around_y(radius, height, i as f32 / segments as f32)));
            match below {
                Some(([r, _], low)) if r > 0.0 => solid.band(low, ring, segments),
                Some(([_, y], _)) => solid.cap(ring, segments, Vec3::Y * y, false),
                None => solid.cap(ring, segments, Vec3::Y * height, false),
            }
        }
        below = Some(([radius, height], ring));
    }
    if let Some(([radius, height], ring)) = below
        && radius > 0.0
    {
        solid.cap(ring, segments, Vec3::Y * height, true);
    }
    solid
}

/// The point at `share` of a turn, counter-clockwise seen from above, starting at +Z.
fn around_y(radius: f32, height: f32, share: f32) -> Vec3 {
    let (sin, cos) = (share * TAU).sin_cos();
    Vec3::new(radius * sin, height, radius * cos)
}

/// A smooth profile through `keys`, with `steps` pieces between each two; radii stay at least 0.
pub(crate) fn curve(keys: &[[f32; 2]], steps: usize) -> Vec<[f32; 2]> {
    let last = keys.len().saturating_sub(1);
    let at = |i: usize, axis: usize, t: f32| {
        let p = [i.saturating_sub(1), i, i + 1, i + 2].map(|k| keys[k.min(last)][axis]);
        let (c, d) = (p[2] - p[0], 2.0 * p[0] - 5.0 * p[1] + 4.0 * p[2] - p[3]);
        0.5 * (2.0 * p[1] + c * t + d * t * t + (3.0 * p[1] - p[0] - 3.0 * p[2] + p[3]) * t * t * t)
    };
    let mut points: Vec<[f32; 2]> = (0..last * steps)
        .map(|k| (k / steps, (k % steps) as f32 / steps as f32))
        .map(|(i, t)| [at(i, 0, t).max(0.02), at(i, 1, t)])
        .collect();
    points.extend(keys.last());
    if let (Some(start), Some(key)) = (points.first_mut(), keys.first()) {
        *start = *key;
    }
    points
}

/// A ball about the origin.
pub(crate) fn sphere(radius: f32, segments: u32, rings: u32) -> Solid {
    let ring = |i: u32| (i as f32 / rings as f32 - 0.5) * PI;
    let inner = (1..rings).map(|i| [radius * ring(i).cos(), radius * ring(i).sin()]);
    let profile: Vec<_> = std::iter::once([0.0, -radius]).chain(inner).chain([[0.0, radius]]).collect();
    lathe(&profile, segments)
}

/// Stands on the ground.
pub(crate) fn cylinder(radius: f32, height: f32, segments: u32) -> Solid {
    frustum(radius, radius, height, segments)
}

/// Stands on the ground, point up.
pub(crate) fn cone(radius: f32, height: f32, segments: u32) -> Solid {
    lathe(&[[radius, 0.0], [0.0, height]], segments)
}

/// A cone without its point, or an upturned one; stands on the ground.
pub(crate) fn frustum(bottom: f32, top: f32, height: f32, segments: u32) -> Solid {
    lathe(&[[bottom, 0.0], [top, height]], segments)
}

/// A ring about the Y axis: `radius` to the middle of the tube, which is `thickness` in radius.
pub(crate) fn torus(radius: f32, thickness: f32, segments: u32, sides: u32) -> Solid {
    let mut solid = Solid::default();
    for side in 0..sides {
        let (sin, cos) = (side as f32 / sides as f32 * TAU).sin_cos();
        let ring = |i: u32| around_y(radius + thickness * cos, thickness * sin, i as f32 / segments as f32);
        solid.points.extend((0..segments).map(ring));
    }
    for side in 0..sides {
        solid.band(side * segments, (side + 1) % sides * segments, segments);
    }
    solid
}

/// A rounded limb from `a` to `b`, with a radius at each end.
pub(crate) fn limb(a: Vec3, b: Vec3, radius_a: f32, radius_b: f32, segments: u32) -> Solid {
    let length = a.distance(b);
    let rings = (segments / 4).max(2);
    let angle = |i: u32| i as f32 / rings as f32 * FRAC_PI_2;
    let bottom = (1..=rings).map(|i| [radius_a * angle(i).sin(), -radius_a * angle(i).cos()]);
    let top = (0..rings).map(|i| [radius_b * angle(i).cos(), length + radius_b * angle(i).sin()]);
    let profile: Vec<_> = std::iter::once([0.0, -radius_a])
        .chain(bottom)
        .chain(top)
        .chain([[0.0, length + radius_b]])
        .collect();
    let along = (b - a).normalize_or(Vec3::Y);
    lathe(&profile, segments)
        .at(Affine3A::from_rotation_translation(Quat::from_rotation_arc(Vec3::Y, along), a))
}
