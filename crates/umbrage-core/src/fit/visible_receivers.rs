//! What the eye sees of a slice, from the light: an outline on the map's plane, and the depths that it lies at.

use std::ops::Range;

use glam::{DVec2, DVec3};

use super::outline::Outline;
use super::{Fitted, Map, Slice};
use crate::convex::ConvexBody;
use crate::light_frustum::LightFrustum;
use crate::space::LightSpace;
use crate::warp::{Sight, Warp, warp};

/// Gathered point by point.
pub(super) struct Seen<'a> {
    pub light: LightSpace,
    pub outline: &'a mut Outline,
    /// Along the light's axis, metres.
    pub metres: Range<f64>,
    /// From the eye, metres.
    depths: Range<f64>,
    /// What is at the least of these, in world space.
    nearest: DVec3,
    eye: DVec3,
    forward: DVec3,
    /// From the tip of a spot along its axis: nothing that is nearer has a place on the map, metres.
    least_near: f64,
}

impl<'a> Seen<'a> {
    pub fn new(slice: &Slice<'_>, outline: &'a mut Outline) -> Self {
        outline.clear();
        let nothing = f64::INFINITY..f64::NEG_INFINITY;
        Self {
            light: slice.light_along_view(),
            outline,
            metres: nothing.clone(),
            depths: nothing,
            nearest: DVec3::ZERO,
            eye: slice.camera.eye().as_dvec3(),
            forward: slice.camera.forward().as_dvec3(),
            least_near: match &slice.light_frustum {
                LightFrustum::Parallel(_) => 0.0,
                LightFrustum::Spread(pyramid) => pyramid.least_near(),
            },
        }
    }

    pub fn add(&mut self, point: DVec3) {
        let point = self.before_tip(point);
        let place = self.light.to_light(point);
        self.metres = widened(&self.metres, self.light.metres_at(place.z), 0.0);
        self.add_depth(point, DVec3::ZERO);
        self.outline.add(place.truncate());
    }

    /// Adds a whole box; its corners only where the outline does not hold them already.
    pub fn add_box(&mut self, centre: DVec3, half: DVec3) {
        let signs = [-1.0, 1.0];
        if self.light.tip.is_some() {
            for (x, y, z) in
                signs.iter().flat_map(|x| signs.iter().flat_map(move |y| signs.map(|z| (*x, *y, z))))
            {
                self.add(centre + half * DVec3::new(x, y, z));
            }
            return;
        }
        let LightSpace { right, up, along, .. } = self.light;
        let middle = self.light.to_light(centre);
        let reach = DVec3::new(right.abs().dot(half), up.abs().dot(half), along.abs().dot(half));
        self.metres = widened(&self.metres, middle.z, reach.z);
        self.add_depth(centre, half);
        let middle = middle.truncate();
        if self.outline.holds(middle, reach.truncate()) {
            return;
        }
        let [x, y, z] = [0, 1, 2].map(|i| DVec2::new(right[i], up[i]) * half[i]);
        for corner in [x + y + z, x + y - z, x - y + z, x - y - z] {
            self.outline.add(middle + corner);
            self.outline.add(middle - corner);
        }
    }

    /// Clipping is as exact as the coordinates are large: it may leave the tip itself, which has no place on the map.
    fn before_tip(&self, point: DVec3) -> DVec3 {
        let LightSpace { along, tip, .. } = self.light;
        let short = tip.map_or(0.0, |tip| self.least_near - along.dot(point - tip));
        point + along * short.max(0.0)
    }

    fn add_depth(&mut self, centre: DVec3, half: DVec3) {
        let (depth, reach) = (self.forward.dot(centre - self.eye), self.forward.abs().dot(half));
        if depth - reach < self.depths.start {
            self.nearest = centre - half * self.forward.signum();
        }
        self.depths = widened(&self.depths, depth, reach);
    }

    /// The view of a rectangle around it all: warped as the settings say, else turned by what `turn` makes of the
    /// outline.
    pub fn fitted(self, slice: &Slice<'_>, receivers: &ConvexBody, turn: fn(&[DVec2]) -> DVec2) -> Fitted {
        let Self { light, outline, metres, depths, nearest, .. } = self;
        let corners = outline.corners();
        let (camera, world) = (slice.camera, slice.bounds.world);
        let room = 0.5 * (slice.padding() - 1.0);
        let sight =
            Sight { camera, light: &light, outline: corners, depths, nearest, receivers, world, room };
        let (side, warp) = match warp(slice.settings.warp, &sight) {
            Some((ahead, warp)) => (-ahead.perp(), warp),
            None => (turn(corners), Warp::default()),
        };
        let turned = |p: &DVec2| DVec2::new(p.dot(side), p.dot(side.perp()));
        let (min, max) = corners
            .iter()
            .map(|p| warp.apply(turned(p)))
            .fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(min, max): (DVec2, DVec2), p| {
                (min.min(p), max.max(p))
            });
        let (min, max) = slice.padded(&light, min, max);
        let texel = slice.texel(min, max);
        let largest = corners.iter().map(|p| warp.unwarped(turned(p), texel)).fold(0.0, f64::max);
        let texel_metres = if light.tip.is_some() { largest * metres.end } else { largest };
        let metres = slice.depths(&light, texel_metres, metres);
        slice.fitted(&Map { light: light.turned(side), warp, min, max, texel_metres, metres }, receivers)
    }
}

/// A range that also holds `middle` ± `reach`.
fn widened(range: &Range<f64>, middle: f64, reach: f64) -> Range<f64> {
    range.start.min(middle - reach)..range.end.max(middle + reach)
}

#[cfg(test)]
mod tests {
    use glam::{DMat4, Vec3};

    use super::*;
    use crate::fit::fit;
    use crate::{
        Bounds, Camera, Fit, Light, Projection, Settings, TexelExtent, plan, settings, texel_extent,
    };

    /// The camera, the world and the light's direction of V29.
    fn v29() -> (Camera, Bounds, DVec3) {
        let projection = Projection::Perspective { fov_y: std::f32::consts::FRAC_PI_3, aspect: 4.0 / 3.0 };
        let eye = Vec3::new(0.0, 10.0, 0.0);
        let camera = Camera::looking(eye, eye + Vec3::new(0.0, -0.2, -1.0), Vec3::Y, projection, 1.0, 100.0);
        let bounds = Bounds::of_world(Vec3::new(-50.0, 0.0, -100.0), Vec3::new(50.0, 20.0, 10.0));
        (camera.expect("a camera"), bounds, DVec3::new(0.3, -1.0, -0.4).normalize_or_zero())
    }

    /// The planner's map of 1024² texels for V29, and the same without its room for the filter.
    fn v29_map(warp: settings::Warp, fit_to: Fit) -> (DMat4, DMat4) {
        let (camera, bounds, along) = v29();
        let settings = Settings { warp, fit: fit_to, splits: 1, ..Settings::default() };
        let light_frustum = LightFrustum::Parallel(along);
        let slice = Slice {
            camera: &camera,
            depths: 1.0..100.0,
            light_frustum,
            resolution: 1024,
            bounds: &bounds,
            settings: &settings,
        };
        let map = fit(&slice, &mut Outline::default()).clip_from_world;
        let room = slice.padding();
        (map, DMat4::from_scale(DVec3::new(room, room, 1.0)) * map)
    }

    #[test]
    fn a_map_warped_by_the_planner_has_the_texels_of_v29() {
        let (camera, ..) = v29();
        let (_, map) = v29_map(settings::Warp::Lispsm, Fit::Scene);
        // Depth; m, m_min, area; u and v, which points up there.
        for (z, printed, uv) in [
            (15.0, [1.0295, 0.7157, 0.7367], [0.362326453, 0.509653621]),
            (20.0, [0.9600, 0.6209, 0.5961], [0.381976727, 0.61354237]),
            (30.0, [0.8864, 0.5276, 0.4677], [0.406270301, 0.741979716]),
            (50.0, [0.8241, 0.4546, 0.3746], [0.43026976, 0.868862106]),
            (80.0, [0.7876, 0.4143, 0.3263], [0.446108628, 0.95260039]),
            (99.0, [0.7757, 0.4016, 0.3115], [0.451600546, 0.98163553]),
        ] {
            let position = DVec3::new(0.0, 0.0, -z);
            let got_uv = 0.5 * map.project_point3(position).truncate() + 0.5;
            // Directions here are rounded to f32.
            assert!((got_uv - DVec2::from(uv)).length() < 1e-6, "z {z}: at {got_uv} of the map, not {uv:?}");
            let got = texel_extent(&camera, 800, 600, &map, 1024.0, position, DVec3::Y);
            let TexelExtent { largest, smallest, area } = got.expect("an extent");
            for (got, wanted) in [largest, smallest, area].into_iter().zip(printed) {
                // Four decimals are printed.
                assert!((got - wanted).abs() < 5.1e-5 + 1e-6, "z {z}: {got}, not {wanted}");
            }
        }
    }

    #[test]
    fn the_line_at_infinity_of_v29_lies_behind_the_nearest_receivers_by_n_opt() {
        // On the map w is 1 on the nearest receivers' line and grows by 1 / n_opt a metre along the view.
        let (map, _) = v29_map(settings::Warp::Lispsm, Fit::Scene);
        let n_opt = 1.0 / map.row(3).truncate().length();
        assert!((n_opt - 12.311900).abs() < 1e-5, "{n_opt}");
        let (_, _, along) = v29();
        assert!(map.row(3).truncate().dot(along).abs() < 1e-9, "all of a ray has the same w");
    }

    #[test]
    fn the_even_map_of_v29_has_the_sides_of_its_box() {
        let (camera, bounds, along) = v29();
        let settings = Settings::default();
        let slice = Slice {
            camera: &camera,
            depths: 1.0..100.0,
            light_frustum: LightFrustum::Parallel(along),
            resolution: 1024,
            bounds: &bounds,
            settings: &settings,
        };
        let body = ConvexBody::of_slice(&camera.slice_corners(1.0..100.0)).clipped_by_box(&bounds.world);
        assert!((body.volume() - 131399.48056).abs() < 0.1, "{} m³", body.volume());
        let mut outline = Outline::default();
        let mut seen = Seen::new(&slice, &mut outline);
        body.corners().for_each(|point| seen.add(point));
        let eye = seen.light.to_light(camera.eye().as_dvec3());
        assert!((seen.metres.start - eye.z + 3.950690991).abs() < 1e-4, "{:?}", seen.metres);
        assert!((seen.metres.end - eye.z - 58.130751625).abs() < 1e-4, "{:?}", seen.metres);
        assert!(
            (seen.depths.start - 1.0).abs() < 1e-6 && (seen.depths.end - 100.0).abs() < 1e-4,
            "{:?}",
            seen.depths
        );
        let (min, max) = crate::fit::rotation::rectangle(seen.outline.corners(), DVec2::X);
        let (min, max) = (min - eye.truncate(), max - eye.truncate());
        assert!((min - DVec2::new(-46.564242006, 0.434210816)).length() < 1e-4, "{min}");
        assert!((max - DVec2::new(56.728168544, 104.707292111)).length() < 1e-4, "{max}");
    }

    #[test]
    fn every_view_of_a_plan_has_the_matrix_of_its_fit() {
        let (camera, bounds, along) = v29();
        let light = Light::directional(along.as_vec3()).expect("a light");
        for (warp, fit) in [(settings::Warp::Lispsm, Fit::Scene), (settings::Warp::Tsm, Fit::View)] {
            let settings = Settings { warp, fit, splits: 1, ..Settings::default() };
            let plan = plan(&camera, &[light], &bounds, &settings).expect("a plan");
            let (map, _) = v29_map(warp, fit);
            let difference = plan.views()[0].clip_from_world.as_dmat4() - map;
            let largest =
                [0, 1, 2, 3].map(|i| difference.row(i).abs().max_element()).into_iter().fold(0.0, f64::max);
            assert!(largest < 1e-5, "{warp:?}: {difference}");
        }
    }

    #[test]
    fn the_tip_of_a_spot_and_what_is_behind_it_are_moved_before_it() {
        let (camera, bounds, along) = v29();
        let settings = Settings::default();
        let light = Light::spot(Vec3::new(5.0, 12.0, -30.0), along.as_vec3(), 0.5, 40.0).expect("a spot");
        let light_frustum = LightFrustum::of(light.kind, 0, 1024, &bounds, &settings);
        let slice = Slice {
            camera: &camera,
            depths: 1.0..100.0,
            light_frustum,
            resolution: 1024,
            bounds: &bounds,
            settings: &settings,
        };
        let mut outline = Outline::default();
        let mut seen = Seen::new(&slice, &mut outline);
        let tip = seen.light.tip.expect("a tip");
        for behind in [0.0, 1e-9, 1.0] {
            seen.add(tip - seen.light.along * behind);
        }
        assert!(
            seen.outline.corners().iter().all(|p| p.length() < 1e-6),
            "they lie on the axis: {:?}",
            seen.outline
        );
        assert!(seen.metres.start > 0.0 && seen.metres.end < 0.1, "{:?} m before the tip", seen.metres);
    }
}
