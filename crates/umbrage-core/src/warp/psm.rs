//! Perspective shadow maps: the map is drawn in the camera's own post-perspective space.
//!
//! Stamminger & Drettakis, *Perspective Shadow Maps*, SIGGRAPH 2002. In that space the light is a point: the image of its
//! direction, or of its apex. The map looks from there at what is seen, as Kozlov (GPU Gems, ch. 14) advises, not at the
//! whole cube. The plane through the light that is across that look is what goes to infinity. All rays lie in planes
//! through the light, so the plane is a line on the map.
//!
//! A light behind the viewer is an image with w < 0, and one across the view an image at infinity: the sums below are
//! homogeneous, and neither is special. The near plane of the camera is moved out to the nearest receivers, as the paper
//! advises, and the camera back until all casters are before it, as Kozlov does: here they would be drawn all the same, but
//! an eye that has them close behind itself has next to no texels for what is far.

use std::ops::Range;

use glam::{DMat4, DVec2, DVec3, DVec4};

use super::input::WarpInput;
use crate::camera::Camera;

/// (a, b, s): the line of light space that goes to infinity is a x + b y = constant, and s is how much a x + b y exceeds
/// that constant at the nearest receivers. Not positive where the line cuts through them, as it can where the light is
/// just outside of what is seen.
pub(super) fn vanishing_line(input: &WarpInput<'_>) -> Option<DVec3> {
    let post = post_perspective(input.camera, slide(input), &input.view_depths);
    let light = post
        * match input.light.apex {
            Some(apex) => apex.extend(1.0),
            None => (-input.light.axis).extend(0.0),
        };
    let look = middle_of_cone(|| {
        let images = input.receivers.corners().map(|corner| post.project_point3(corner));
        images.map(|image| (image * light.w - light.truncate()).normalize_or_zero())
    });
    // The plane through the light, across the look, as a row: of post-perspective space, of the world, of light space.
    let row = (look * light.w).extend(-look.dot(light.truncate()));
    let light_from_world =
        DMat4::from_cols_array_2d(&input.light.rows().map(|row| row.to_array())).transpose();
    let row = light_from_world.inverse().transpose() * (post.transpose() * row);
    let at = |p: &DVec2| row.x * p.x + row.y * p.y + row.w;
    let nearest = input.outline.iter().map(at).fold(f64::INFINITY, f64::min);
    let line = DVec3::new(row.x, row.y, nearest);
    line.is_finite().then_some(line)
}

/// The axis of the smallest cone around some unit directions, nearly (Bădoiu & Clarkson 2003): a look that sees them all,
/// where one sees them all.
fn middle_of_cone<I: Iterator<Item = DVec3>>(directions: impl Fn() -> I) -> DVec3 {
    const ROUNDS: u32 = 24;
    let mut axis = directions().sum::<DVec3>().normalize_or_zero();
    for round in 1..=ROUNDS {
        let farthest = directions().min_by(|a, b| a.dot(axis).total_cmp(&b.dot(axis)));
        axis += (farthest.unwrap_or(axis) - axis) / f64::from(round + 1);
    }
    axis
}

/// How far back the camera must go so that the nearest caster is no nearer than the nearest receiver is now, metres.
fn slide(input: &WarpInput<'_>) -> f64 {
    let WarpInput { camera, light, receivers, world, .. } = input;
    let (eye, forward) = (camera.eye().as_dvec3(), camera.forward().as_dvec3());
    let (min, max) = (world.min.as_dvec3(), world.max.as_dvec3());
    let nearest_caster = receivers.corners().map(|receiver| {
        let toward = light.apex.map_or(-light.axis, |apex| apex - receiver);
        // Where the ray to the light leaves the world; an apex is one such step away.
        let leaves = DVec3::select(toward.cmplt(DVec3::ZERO), min, max) - receiver;
        let steps = DVec3::select(toward.cmpeq(DVec3::ZERO), DVec3::INFINITY, leaves / toward).min_element();
        let steps = if light.apex.is_some() { steps.min(1.0) } else { steps };
        let caster = receiver + toward * steps.max(0.0);
        forward.dot(receiver - eye).min(forward.dot(caster - eye))
    });
    let slide = input.view_depths.start - nearest_caster.fold(input.view_depths.start, f64::min);
    if slide.is_finite() { slide } else { 0.0 }
}

/// World to the clip space of the camera, slid back, with forward depth over a range of its own depths, in f64.
fn post_perspective(camera: &Camera, slide: f64, depths: &Range<f64>) -> DMat4 {
    let axis = |v: glam::Vec4| v.truncate().as_dvec3();
    let view = camera.world_from_view();
    let eye = axis(view.w_axis);
    let row = |axis: DVec3| axis.extend(-axis.dot(eye));
    let (half_height, half_width) = camera.half_extents(1.0);
    let depth = row(-axis(view.z_axis)) + DVec4::W * slide;
    let near = depths.start + slide;
    let far = (depths.end + slide).max(near * 1.001);
    let [x, y] = camera.centre().map(f64::from);
    let rows = [
        row(axis(view.x_axis)) / half_width + depth * x,
        row(axis(view.y_axis)) / half_height + depth * y,
        (depth - DVec4::W * near) * (far / (far - near)),
        depth,
    ];
    DMat4::from_cols_array_2d(&rows.map(|row| row.to_array())).transpose()
}

#[cfg(test)]
mod tests {
    use glam::Vec3;

    use super::*;
    use crate::Projection;

    #[test]
    fn images_of_the_light_are_those_of_v9() {
        let projection = Projection::Perspective { fov_y: 60f32.to_radians(), aspect: 1.0 };
        let camera = Camera::looking(Vec3::ZERO, Vec3::NEG_Z, Vec3::Y, projection, 1.0, 100.0);
        let post = camera.map(|camera| post_perspective(&camera, 0.0, &(1.0..100.0))).unwrap_or_default();
        for (to_light, image) in [
            (DVec3::Y, DVec4::new(0.0, 1.732050808, 0.0, 0.0)),
            (DVec3::new(0.3, 1.0, -0.2), DVec4::new(0.519615242, 1.732050808, 0.202020202, 0.2)),
            (DVec3::new(0.0, 0.5, 0.8), DVec4::new(0.0, 0.866025404, -0.808080808, -0.8)),
            (DVec3::new(0.0, 1.0, -0.001), DVec4::new(0.0, 1.732050808, 0.001010101, 0.001)),
        ] {
            let got = post * to_light.extend(0.0);
            assert!((got - image).abs().max_element() < 1e-6, "{to_light}: {got}, not {image}");
        }
    }
}
