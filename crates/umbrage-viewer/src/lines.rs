//! A shadow plan as lines: slices of the camera's frustum, volumes of the maps, volumes of the casters.
//!
//! World space, metres. A line is cut at the eye's near plane before it is projected.

use glam::{DMat4, DVec3, Vec2, Vec4};
use umbrage::{Camera, ConvexBody, ConvexVolume, ShadowPlan};

/// A line segment by its ends, world space, metres.
pub type Line = [DVec3; 2];

/// Which parts of a shadow plan are drawn as lines.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PlanLines {
    /// The slices of the camera's frustum that the splits serve.
    pub slices: bool,
    /// The volume that each map covers.
    pub maps: bool,
    /// The volume that holds every caster of a map, clipped to the world.
    pub casters: bool,
}

impl PlanLines {
    /// Returns whether any part is drawn.
    pub fn any(self) -> bool {
        self != Self::default()
    }
}

/// Returns lines of the first light's views, each with the number of its split, which gives its colour. Volumes are clipped
/// to `reach` metres from the origin along each axis.
pub fn of_plan(plan: &ShadowPlan, chosen: PlanLines, reach: f64) -> Vec<(usize, Line)> {
    let mut lines = Vec::new();
    let mut sliced = None;
    for view in plan.views().iter().filter(|view| view.light == 0) {
        // The faces of a point light serve the same depths.
        if chosen.slices && sliced.as_ref() != Some(&view.depths) {
            let corners =
                plan.camera().slice_corners(f64::from(view.depths.start)..f64::from(view.depths.end));
            lines.extend(edges(&ConvexBody::of_slice(&corners)).map(|line| (view.split, line)));
            sliced = Some(view.depths.clone());
        }
        if chosen.maps {
            lines.extend(map_edges(&view.clip_from_world).map(|line| (view.split, line)));
        }
        if chosen.casters {
            lines.extend(edges(&body(&view.casters, reach)).map(|line| (view.split, line)));
        }
    }
    lines
}

/// The twelve edges of what a map covers: a box for a sun, a truncated pyramid for a punctual light.
fn map_edges(clip_from_world: &DMat4) -> impl Iterator<Item = Line> + use<> {
    let world_from_clip = clip_from_world.inverse();
    let corner = move |i: usize| {
        let side = |bit: usize| if i >> bit & 1 == 1 { 1.0 } else { -1.0 };
        world_from_clip.project_point3(DVec3::new(side(0), side(1), (i >> 2 & 1) as f64))
    };
    let pairs = (0..8).flat_map(|i| [1, 2, 4].map(|bit| (i, i | bit))).filter(|(a, b)| a != b);
    pairs.map(move |(a, b)| [corner(a), corner(b)]).filter(|[a, b]| a.is_finite() && b.is_finite())
}

/// A volume as a body, within a cube of `reach` metres each way.
fn body(volume: &ConvexVolume, reach: f64) -> ConvexBody {
    if volume.is_empty() {
        return ConvexBody::default();
    }
    let cube = ConvexBody::of_box(DVec3::splat(-reach), DVec3::splat(reach));
    let planes = volume.planes().iter();
    planes.fold(cube, |body, plane| body.clipped(plane.normal.as_dvec3(), f64::from(plane.distance)))
}

/// Each edge once.
fn edges(body: &ConvexBody) -> impl Iterator<Item = Line> {
    // Both faces of an edge have it, in opposite senses.
    let first = |a: &DVec3, b: &DVec3| a.to_array() < b.to_array();
    body.edges().filter(move |(a, b)| first(a, b)).map(|(a, b)| [a, b]).collect::<Vec<_>>().into_iter()
}

/// Projects a line onto the picture, in shares of its size from the upper left corner; `None` where all of it lies behind
/// the eye.
pub fn project(camera: &Camera, [a, b]: Line) -> Option<[Vec2; 2]> {
    let clip = |p: DVec3| camera.clip_from_world() * p.as_vec3().extend(1.0);
    let (mut a, mut b) = (clip(a), clip(b));
    // Reversed depth: what is nearer than the near plane has z above w.
    let inside = |p: &Vec4| p.w - p.z;
    let (from_a, from_b) = (inside(&a), inside(&b));
    if from_a < 0.0 && from_b < 0.0 {
        return None;
    }
    let cut = a.lerp(b, from_a / (from_a - from_b));
    if from_a < 0.0 {
        a = cut;
    } else if from_b < 0.0 {
        b = cut;
    }
    let place = |p: Vec4| Vec2::new(0.5 + 0.5 * p.x / p.w, 0.5 - 0.5 * p.y / p.w);
    (a.w > 0.0 && b.w > 0.0).then(|| [place(a), place(b)])
}

#[cfg(test)]
mod tests {
    use glam::Vec3;
    use umbrage::{Bounds, Light, Settings};

    use super::*;

    fn camera() -> Camera {
        let scene =
            umbrage_scene::Camera::looking("c", Vec3::new(0.0, 5.0, 20.0), Vec3::ZERO, 1.0, 0.5, 100.0);
        umbrage_render::camera(&scene, 1.5).unwrap()
    }

    fn plan() -> ShadowPlan {
        let bounds = Bounds::of_world(Vec3::new(-30.0, 0.0, -30.0), Vec3::new(30.0, 4.0, 30.0));
        let sun = Light::directional(Vec3::new(0.3, -1.0, -0.2)).unwrap();
        umbrage::plan(&camera(), &[sun], &bounds, &Settings::default()).unwrap()
    }

    #[test]
    fn a_slice_and_a_map_have_twelve_edges() {
        let plan = plan();
        let count = |chosen| of_plan(&plan, chosen, 100.0).len();
        assert_eq!(count(PlanLines { slices: true, ..PlanLines::default() }), 4 * 12);
        assert_eq!(count(PlanLines { maps: true, ..PlanLines::default() }), 4 * 12);
        assert!(count(PlanLines { casters: true, ..PlanLines::default() }) >= 12);
        assert_eq!(count(PlanLines::default()), 0);
    }

    #[test]
    fn slices_of_punctual_lights_are_the_depths_that_their_maps_serve() {
        let bounds = Bounds::of_world(Vec3::new(-30.0, 0.0, -30.0), Vec3::new(30.0, 4.0, 30.0));
        let slices = |light: Light| {
            let settings = Settings { spot_splits: 2, ..Settings::default() };
            let plan = umbrage::plan(&camera(), &[light], &bounds, &settings).unwrap();
            of_plan(&plan, PlanLines { slices: true, ..PlanLines::default() }, 100.0).len()
        };
        assert_eq!(slices(Light::spot(Vec3::Y * 9.0, Vec3::NEG_Y, 0.6, 50.0).unwrap()), 2 * 12);
        assert_eq!(slices(Light::point(Vec3::Y * 9.0, 50.0).unwrap()), 12, "six faces, one slice");
    }

    #[test]
    fn a_volumes_lines_lie_in_the_volume() {
        let plan = plan();
        for (split, line) in of_plan(&plan, PlanLines { casters: true, ..PlanLines::default() }, 100.0) {
            let view = plan.views().iter().find(|view| view.split == split).unwrap();
            let middle = ((line[0] + line[1]) * 0.5).as_vec3();
            for plane in view.casters.planes() {
                assert!(plane.signed_distance(middle) > -1e-2, "{split}: {middle}");
            }
        }
    }

    #[test]
    fn lines_are_seen_before_the_eye_alone() {
        let camera = camera();
        let [middle, _] = project(&camera, [DVec3::ZERO, DVec3::Y]).unwrap();
        assert!(middle.distance(Vec2::splat(0.5)) < 1e-5, "what is looked at is in the middle: {middle}");
        assert_eq!(project(&camera, [DVec3::new(0.0, 9.0, 40.0), DVec3::new(3.0, 9.0, 50.0)]), None);
        let through = project(&camera, [DVec3::ZERO, DVec3::new(0.0, 9.0, 40.0)]).unwrap();
        assert!(through.iter().all(|p| p.is_finite()), "{through:?}");
    }
}
