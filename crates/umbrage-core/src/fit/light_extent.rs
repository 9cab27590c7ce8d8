//! Fit to all that a spot or a face of a point light reaches. The map then depends on the light alone: its edges hold
//! still under any motion of the camera, and faces of a cube meet.

use glam::DVec2;

use super::{Fitted, Map, Slice};
use crate::convex::ConvexBody;
use crate::light_frustum::Pyramid;
use crate::settings::Fit;
use crate::warp::Warp;

pub(crate) fn fit(slice: &Slice<'_>, pyramid: &Pyramid, receivers: &ConvexBody) -> Fitted {
    let light = slice.light_frustum.space(glam::DVec3::Y);
    let side = DVec2::splat(pyramid.half_side);
    // A face has its guard texels already.
    let (min, max) = if pyramid.is_face { (-side, side) } else { slice.padded(&light, -side, side) };
    let texel_metres = slice.texel(min, max).max_element() * pyramid.reach;
    let depths = receivers.corners().map(|p| light.along.dot(p - pyramid.tip));
    let (near, far) = depths.fold((f64::INFINITY, f64::NEG_INFINITY), |(n, f), d| (n.min(d), f.max(d)));
    let metres = if receivers.is_empty() || slice.settings.fit == Fit::Stable {
        pyramid.least_near()..pyramid.reach + slice.margin(texel_metres, &(0.0..pyramid.reach))
    } else {
        slice.depths(&light, texel_metres, near..far)
    };
    slice.fitted(&Map { light, warp: Warp::default(), min, max, texel_metres, metres }, receivers)
}

#[cfg(test)]
mod tests {
    use glam::{DMat4, DVec3, Vec3};

    use super::*;
    use crate::light_frustum::LightFrustum;
    use crate::{Aabb, Bounds, Light, Settings};

    #[test]
    fn depths_on_a_cubes_faces_are_those_of_v14() {
        let world = Aabb { min: Vec3::splat(-50.0), max: Vec3::splat(50.0) };
        let bounds = Bounds { world, objects: Vec::new() };
        let tip = Vec3::new(7.0, -2.0, 3.0);
        let light = Light::point(tip, 25.0).expect("a lamp");
        // Offset; its face and the depth on it, between 0.1 m and 25 m.
        for (offset, face, depth) in [
            (DVec3::new(3.0, 1.0, -2.0), 0, 0.9705488621151273),
            (DVec3::new(0.0, -7.0, 1.0), 3, 0.9896729776247849),
            (DVec3::new(0.5, 0.2, 0.9), 4, 0.892458723784025),
        ] {
            let light_frustum = LightFrustum::of(light.kind, face, 1024, &bounds, &Settings::default());
            let LightFrustum::Spread(pyramid) = light_frustum else { panic!("a lamp's rays spread") };
            assert_eq!(pyramid.reach, 25.0);
            let side = DVec2::splat(pyramid.half_side);
            let map = Map {
                light: light_frustum.space(DVec3::Y),
                warp: Warp::default(),
                min: -side,
                max: side,
                texel_metres: 1.0,
                metres: 0.1..25.0,
            };
            let [x, y, z, w] = map.rows();
            let ndc = DMat4::from_cols(x, y, z, w).transpose().project_point3(tip.as_dvec3() + offset);
            assert!((ndc.z - depth).abs() < 1e-9, "{offset}: {}, not {depth}", ndc.z);
            assert!(ndc.truncate().abs().max_element() < 1.0, "{offset} is not on face {face}: {ndc}");
        }
    }
}
