//! Fit to all that a spot or a face of a point light reaches. The map then depends on the light alone: its edges hold
//! still under any motion of the camera, and faces of a cube meet.

use glam::{DVec2, DVec3};

use crate::casters::CasterPolicy;
use crate::depth_range::{DepthRange, margin};
use crate::light_frustum::Pyramid;
use crate::receivers::{Receivers, ViewInput};
use crate::rectangle::{Rectangle, padded, texel_sides};
use crate::region::{Area, Region};

/// How deep the map is.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Depths {
    /// As deep as its receivers, if there are any: depth is finer, and changes with the camera.
    OfReceivers,
    /// As deep as the light reaches.
    OfLight,
}

pub(super) fn region<'a>(
    input: &ViewInput<'_>,
    pyramid: &Pyramid,
    receivers: &'a Receivers,
    depths: Depths,
) -> (Region<'a>, CasterPolicy) {
    let receivers = &receivers.body;
    let space = input.light_frustum.space(DVec3::Y);
    let side = DVec2::splat(pyramid.half_side);
    // A face is padded already.
    let (min, max) = if pyramid.is_face { (-side, side) } else { padded(input, &space, -side, side) };
    let texel_metres = texel_sides(min, max, input.resolution).max_element() * pyramid.reach;
    let of_light = || pyramid.min_near..pyramid.reach + margin(input, texel_metres, &(0.0..pyramid.reach));
    let depths = match depths {
        Depths::OfReceivers if !receivers.is_empty() => {
            let metres = receivers.corners().map(|p| space.axis.dot(p - pyramid.apex));
            let (near, far) =
                metres.fold((f64::INFINITY, f64::NEG_INFINITY), |(n, f), d| (n.min(d), f.max(d)));
            DepthRange::OfReceivers(near..far)
        }
        Depths::OfReceivers | Depths::OfLight => DepthRange::OfMap(of_light()),
    };
    let area = Area::Fixed(Rectangle { min, max, texel_metres });
    (Region { space, area, depths, receivers }, CasterPolicy::OverMap)
}

#[cfg(test)]
mod tests {
    use glam::Vec3;

    use super::*;
    use crate::homography::Homography;
    use crate::light_frustum::Limits;
    use crate::light_projection::LightProjection;
    use crate::space::LightSpace;
    use crate::{Aabb, Bounds, DepthFormat};

    #[test]
    fn depths_on_a_cubes_faces_are_those_of_v14() {
        let world = Aabb { min: Vec3::splat(-50.0), max: Vec3::splat(50.0) };
        let bounds = Bounds::within(world, Vec::new());
        let limits = Limits { range: 25.0, near: 0.0, depth: DepthFormat::F32, flattens: true };
        let apex = Vec3::new(7.0, -2.0, 3.0);
        // Offset; its face and the depth on it, between 0.1 m and 25 m.
        for (offset, face, depth) in [
            (DVec3::new(3.0, 1.0, -2.0), 0, 0.9705488621151273),
            (DVec3::new(0.0, -7.0, 1.0), 3, 0.9896729776247849),
            (DVec3::new(0.5, 0.2, 0.9), 4, 0.892458723784025),
        ] {
            let pyramid = Pyramid::face(apex, face, 1.01, limits, &bounds);
            assert_eq!(pyramid.reach, 25.0);
            let projection = LightProjection {
                space: LightSpace::new(pyramid.axis, DVec3::Y).with_apex(pyramid.apex),
                homography: Homography::IDENTITY,
                min: DVec2::splat(-pyramid.half_side),
                max: DVec2::splat(pyramid.half_side),
                depths: 0.1..25.0,
            };
            let ndc = projection.clip_from_world().project_point3(apex.as_dvec3() + offset);
            assert!((1.0 - ndc.z - depth).abs() < 1e-9, "{offset}: {}, not {depth}", ndc.z);
            assert!(ndc.truncate().abs().max_element() < 1.0, "{offset} is not on face {face}: {ndc}");
        }
    }
}
