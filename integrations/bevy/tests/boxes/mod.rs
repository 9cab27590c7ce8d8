//! The boxes, and what rays say of them.

use bevy::prelude::*;

/// Size of the pictures, pixels.
pub const SIZE: [u32; 2] = [320, 180];
/// Half the height of what is seen over its distance.
const HALF_HEIGHT: f32 = 0.5;
/// The way that the sun's light travels.
pub const SUN: Vec3 = Vec3::new(-0.7, -0.6, -0.4);
/// What is seen lies within so many metres.
pub const FAR: f32 = 150.0;

/// Middles and half sizes. The first is the ground.
pub fn boxes() -> Vec<(Vec3, Vec3)> {
    let ground = (Vec3::new(0.0, -1.0, 0.0), Vec3::new(300.0, 1.0, 300.0));
    let posts = (0..12).flat_map(|row| (-4..=4).map(move |column| (row, column))).map(|(row, column)| {
        let [x, z] = [column as f32 * 6.0 + row as f32, row as f32 * -9.0];
        let height = 1.0 + ((row * 7 + column * 3 + 40) % 5) as f32;
        (Vec3::new(x, height, z), Vec3::new(0.4, height, 0.4))
    });
    std::iter::once(ground).chain(posts).collect()
}

/// Where the camera stands.
pub fn camera() -> Transform {
    Transform::from_xyz(1.0, 5.0, 16.0).looking_at(Vec3::new(0.0, 1.0, -14.0), Vec3::Y)
}

/// The whole vertical field of view, radians.
pub fn fov() -> f32 {
    2.0 * HALF_HEIGHT.atan()
}

/// Whether the sun reaches what each pixel sees; `None` where that is nothing, or turned away from the sun, or too far.
pub fn truth() -> Vec<Option<bool>> {
    let (boxes, camera) = (boxes(), camera());
    let [width, height] = SIZE.map(|side| side as f32);
    let pixels = (0..SIZE[1]).flat_map(|y| (0..SIZE[0]).map(move |x| (x as f32 + 0.5, y as f32 + 0.5)));
    let seen = pixels.map(|(x, y)| {
        let across = (2.0 * x / width - 1.0) * HALF_HEIGHT * width / height;
        let way = camera.rotation * Vec3::new(across, (1.0 - 2.0 * y / height) * HALF_HEIGHT, -1.0);
        let hit = |(middle, half): &(Vec3, Vec3)| enters(camera.translation, way, *middle, *half);
        let (depth, normal) = boxes.iter().filter_map(hit).min_by(|a, b| a.0.total_cmp(&b.0))?;
        let is_judged = depth < 0.95 * FAR && normal.dot(-SUN) > 0.0;
        let point = camera.translation + way * depth + normal * 1e-3;
        let is_lit = !boxes.iter().any(|(middle, half)| enters(point, -SUN, *middle, *half).is_some());
        is_judged.then_some(is_lit)
    });
    seen.collect()
}

/// Where a ray enters a box from outside, in lengths of its way, and the normal there.
fn enters(start: Vec3, way: Vec3, middle: Vec3, half: Vec3) -> Option<(f32, Vec3)> {
    let (one, other) = ((middle - half - start) / way, (middle + half - start) / way);
    let (near, far) = (one.min(other), one.max(other));
    let enter = near.max_element();
    let axis = near.max_position();
    let normal = Vec3::AXES[axis] * -way[axis].signum();
    (enter > 0.0 && enter <= far.min_element()).then_some((enter, normal))
}
