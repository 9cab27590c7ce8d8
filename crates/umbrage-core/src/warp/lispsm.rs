//! Light space perspective shadow maps: the line at infinity lies where the largest error over the depth is least.
//!
//! Wimmer, Scherzer & Purgathofer, *Light Space Perspective Shadow Maps*, EGSR 2004, with the authors' revision of 2005.
//! Paper → here: n → the distance, d → `length`, z_n and z_f → `depths`. n_opt = (z_n + √(z_n z_f)) / sin γ is the same
//! as d / (√(z_f / z_n) − 1), which needs no angle and holds for punctual lights. As light and view become parallel z_f nears z_n,
//! and the distance grows without bound; in a deep view it does so only in the last moment, so a fade helps.

use super::frame::WarpFrame;

/// How far behind the nearest receivers the line at infinity lies.
pub(super) fn distance(frame: &WarpFrame<'_>) -> Option<f64> {
    let ratio = frame.depths.end / frame.depths.start;
    (ratio > 1.0).then(|| frame.length / (ratio.sqrt() - 1.0))
}

#[cfg(test)]
mod tests {
    use glam::{DVec2, DVec3, Vec3};

    use crate::bounds::Aabb;
    use crate::camera::{Camera, Projection};
    use crate::convex::ConvexBody;
    use crate::homography::Homography;
    use crate::space::LightSpace;
    use crate::warp::Warp;
    use crate::warp::frame::WarpFrame;
    use crate::warp::input::WarpInput;
    use crate::warp::lispsm::distance;

    /// The warp of a map 99 m long whose nearest receivers are at view depth 1, under a sun at this angle to the view.
    /// And how far behind them the line at infinity lies before it fades.
    fn v7(degrees: f64) -> (LightSpace, Option<Homography>, Option<f64>) {
        let projection = Projection::Perspective { fov_y: 1.0, aspect: 1.0 };
        let camera =
            Camera::looking(Vec3::ZERO, Vec3::NEG_Z, Vec3::Y, projection, 1.0, 100.0).expect("a camera");
        let (sine, cosine) = degrees.to_radians().sin_cos();
        let light = LightSpace::new(DVec3::new(0.0, -sine, -cosine), DVec3::NEG_Z);
        let nearest = DVec3::new(0.0, 0.0, -1.0);
        let low = light.to_light(nearest).y;
        let outline =
            [(-9.0, 0.0), (9.0, 0.0), (30.0, 99.0), (-30.0, 99.0)].map(|(x, y)| DVec2::new(x, low + y));
        let input = WarpInput {
            camera: &camera,
            light: &light,
            outline: &outline,
            view_depths: 1.0..100.0,
            nearest,
            receivers: &ConvexBody::default(),
            world: Aabb::EMPTY,
            padding: 0.0,
        };
        let warped = Warp::Lispsm.perspective(&input);
        let frame = input.ahead().and_then(|ahead| WarpFrame::new(&input, ahead));
        (light, warped, frame.and_then(|frame| distance(&frame)))
    }

    #[test]
    fn the_line_at_infinity_is_that_of_v7_at_every_angle() {
        for (degrees, n_opt) in [
            (90.0, 11.000000),
            (60.0, 11.908708),
            (45.0, 13.330889),
            (30.0, 16.212670),
            (15.0, 23.799471),
            (5.0, 47.076293),
            (2.0, 89.133061),
            (1.0, 151.933301),
        ] {
            for degrees in [degrees, 180.0 - degrees] {
                let (_, _, distance) = v7(degrees);
                let distance = distance.expect("a warp");
                assert!((distance - n_opt).abs() < 1e-6 * n_opt, "{degrees}°: {distance}, not {n_opt}");
            }
        }
    }

    #[test]
    fn depths_under_a_sun_overhead_lie_on_the_map_as_in_v7() {
        let (light, warped, _) = v7(90.0);
        let homography = warped.expect("a warp");
        let place = |z: f64| homography.apply(light.to_light(DVec3::new(0.0, 0.0, -z)).truncate()).y;
        for (z, t) in [
            (1.0, 0.0),
            (2.0, 0.092593),
            (5.0, 0.296296),
            (10.0, 0.5),
            (20.0, 0.703704),
            (50.0, 0.907407),
            (100.0, 1.0),
        ] {
            let got = (place(z) - place(1.0)) / (place(100.0) - place(1.0));
            assert!((got - t).abs() < 1e-6, "{z} m: {got}, not {t}");
        }
    }

    #[test]
    fn there_is_no_warp_where_light_and_view_are_parallel() {
        for degrees in [0.0, 1e-9, 1e-3, 179.999, 180.0] {
            let (_, warped, _) = v7(degrees);
            assert_eq!(warped, None, "{degrees}°");
        }
    }
}
