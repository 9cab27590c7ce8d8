//! The tree finds what looking at every box finds, however boxes moved, and plans are the same.

use glam::{DMat4, DVec3, Mat4, Vec3};
use proptest::prelude::*;

use super::*;
use crate::{Camera, DepthFormat, Fit, Light, Projection, Select, Settings, ShadowPlan, Warp, plan};

/// The same boxes in a tree of one leaf, which is looked through from the first box to the last.
fn flat(bounds: &Bounds) -> Bounds {
    Bounds { tree: Tree::flat(bounds.objects()), ..bounds.clone() }
}

fn point(reach: f32) -> impl Strategy<Value = Vec3> {
    prop::array::uniform3(-reach..reach).prop_map(Vec3::from)
}

/// Boxes with a size, without one in some direction, or that hold nothing.
fn finite_box() -> impl Strategy<Value = Aabb> {
    let of = |(min, size): (Vec3, Vec3)| Aabb { min, max: min + size };
    let size = prop::array::uniform3(prop_oneof![Just(0.0f32), 0.0f32..30.0]).prop_map(Vec3::from);
    prop_oneof![
        6 => (point(300.0), size).prop_map(of),
        1 => Just(Aabb::EMPTY),
        1 => (point(9.0), point(9.0)).prop_map(|(min, max)| Aabb { min, max }),
    ]
}

/// The same, and boxes without an end or a number.
fn any_box() -> impl Strategy<Value = Aabb> {
    let odd =
        prop_oneof![Just(f32::NAN), Just(f32::INFINITY), Just(f32::NEG_INFINITY), Just(f32::MAX), Just(0.0)];
    let odd = (prop::array::uniform6(odd), point(99.0)).prop_map(|([a, b, c, d, e, f], at)| Aabb {
        min: Vec3::new(a, b, c) + at,
        max: Vec3::new(d, e, f) + at,
    });
    prop_oneof![30 => finite_box(), 1 => odd]
}

fn volume() -> impl Strategy<Value = ConvexVolume> {
    let at = (point(300.0), point(300.0), 0.05f32..2.0, any::<bool>());
    at.prop_map(|(eye, target, fov_y, is_row)| {
        let projection = Projection::Perspective { fov_y, aspect: 1.3 };
        let camera = Camera::looking(eye, target, Vec3::Y, projection, 0.5, 400.0).ok().filter(|_| !is_row);
        // Planes across an axis have normals with zeros.
        let across = Mat4::from_scale(Vec3::splat(0.01));
        ConvexVolume::of_clip(&camera.map_or(across, |camera| camera.clip_from_world()))
    })
}

/// What touches a volume, box by box.
fn touching_one_by_one(bounds: &Bounds, volume: &ConvexVolume) -> Vec<u32> {
    let boxes = (0..).zip(bounds.objects());
    boxes
        .filter(|(_, aabb)| !aabb.is_empty() && volume.may_touch_box(aabb))
        .map(|(number, _)| number)
        .collect()
}

fn touching(bounds: &Bounds, volume: &ConvexVolume) -> Vec<u32> {
    let mut found = Vec::new();
    bounds.touching(volume, |number| found.push(number));
    found.sort_unstable();
    found
}

/// The distance to the nearest box, box by box.
fn nearest_one_by_one(bounds: &Bounds, from: DVec3) -> f64 {
    let squares = bounds.objects().iter().filter(|aabb| !aabb.is_empty()).map(|aabb| {
        let (min, max) = (aabb.min.as_dvec3(), aabb.max.as_dvec3());
        (min - from).max(from - max).max(DVec3::ZERO).length_squared()
    });
    squares.fold(f64::INFINITY, f64::min).sqrt()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn what_touches_a_volume_is_found_however_boxes_moved(
        boxes in proptest::collection::vec(any_box(), 0..300),
        moves in proptest::collection::vec(proptest::collection::vec((0usize..320, any_box()), 0..300), 0..5),
        volumes in proptest::collection::vec(volume(), 4),
    ) {
        let mut bounds = Bounds::new(boxes);
        for moved in moves {
            bounds.set(moved);
        }
        for volume in volumes.into_iter().chain([ConvexVolume::default(), ConvexVolume::empty()]) {
            prop_assert_eq!(touching(&bounds, &volume), touching_one_by_one(&bounds, &volume));
        }
        let can_be_planned = bounds.objects().iter().all(|aabb| !aabb.is_unbounded());
        prop_assert_eq!(bounds.can_be_planned(), can_be_planned);
    }

    #[test]
    fn the_world_and_what_is_nearest_are_those_of_a_new_tree(
        boxes in proptest::collection::vec(finite_box(), 0..300),
        moves in proptest::collection::vec(proptest::collection::vec((0usize..320, finite_box()), 0..300), 0..5),
        from in proptest::collection::vec(point(500.0), 8),
    ) {
        let mut bounds = Bounds::new(boxes);
        for moved in moves {
            bounds.set(moved);
        }
        let new = Bounds::new(bounds.objects().to_vec());
        prop_assert_eq!(&bounds, &new);
        for from in from.into_iter().map(Vec3::as_dvec3) {
            let nearest = nearest_one_by_one(&bounds, from);
            prop_assert_eq!([bounds.distance_from(from), new.distance_from(from)], [nearest, nearest]);
        }
    }

    #[test]
    fn a_plan_from_a_tree_is_the_plan_from_every_box(
        boxes in proptest::collection::vec(finite_box(), 1..400),
        moved in proptest::collection::vec((0usize..400, finite_box()), 0..400),
        (eye, target) in (point(200.0), point(200.0)), fov_y in 0.2f32..2.0, sun in point(1.0),
        (apex, along) in (point(200.0), point(1.0)),
        warp in prop_oneof![Just(Warp::None), Just(Warp::Lispsm), Just(Warp::Tsm)],
        select in prop_oneof![Just(Select::Map), Just(Select::Depth)],
        depth in prop_oneof![Just(DepthFormat::F32), Just(DepthFormat::U16)],
    ) {
        let projection = Projection::Perspective { fov_y, aspect: 1.5 };
        let Ok(camera) = Camera::looking(eye, target, Vec3::Y, projection, 0.5, 400.0) else { return Ok(()) };
        let lights = [
            Light::directional(sun + Vec3::NEG_Y * 1e-3),
            Light::spot(apex, along + Vec3::NEG_Y * 1e-3, 0.7, 150.0),
            Light::point(apex, 90.0),
        ];
        let lights = lights.map(|light| light.expect("a light"));
        let mut bounds = Bounds::new(boxes);
        bounds.set(moved);
        let settings = Settings { fit: Fit::Scene, warp, select, depth, splits: 3, ..Settings::default() };
        let [tree, all] = [&bounds, &flat(&bounds)].map(|bounds| plan(&camera, &lights, bounds, &settings));
        let (tree, all) = (tree.expect("a plan"), all.expect("a plan"));
        let fault = difference(&tree, &all, &bounds);
        prop_assert!(fault.is_none(), "{}", fault.unwrap_or_default());
    }
}

/// Whether what touches one volume touches another, give or take a centimetre. A corner that rounding leaves between two planes
/// may have a third.
fn is_within(a: &ConvexVolume, b: &ConvexVolume, bounds: &Bounds) -> bool {
    let boxes = bounds.objects().iter().filter(|aabb| !aabb.is_empty() && a.may_touch_box(aabb));
    boxes.into_iter().all(|aabb| b.may_touch(aabb.min - 0.01, aabb.max + 0.01))
}

/// What is not the same in two plans but for the rounding of sums in another order.
fn difference(a: &ShadowPlan, b: &ShadowPlan, bounds: &Bounds) -> Option<String> {
    let near = |a: f64, b: f64, size: f64| (a - b).abs() <= 1e-9 * size;
    a.views().iter().zip(b.views()).find_map(|(a, b)| {
        let size =
            |matrix: DMat4| matrix.to_cols_array().into_iter().fold(0.0, |most, x: f64| x.abs().max(most));
        let matrices = a.clip_from_world.to_cols_array().into_iter().zip(b.clip_from_world.to_cols_array());
        let is_same = matrices.into_iter().all(|(x, y)| near(x, y, size(b.clip_from_world)))
            && near(f64::from(a.texel_metres), f64::from(b.texel_metres), 1e3 * f64::from(b.texel_metres))
            && is_within(&a.casters, &b.casters, bounds)
            && is_within(&b.casters, &a.casters, bounds)
            && a.casters.is_empty() == b.casters.is_empty();
        (!is_same).then(|| format!("{a:#?}\n\nbut\n\n{b:#?}"))
    })
}

#[test]
fn a_box_without_an_end_is_found_as_it_is_alone() {
    // Along x it is inside of planes across y, whose sums with it are no numbers.
    let bounds = Bounds::new(vec![Aabb { min: Vec3::ZERO, max: Vec3::new(f32::INFINITY, 1.0, 1.0) }]);
    let across = ConvexVolume::of_clip(&Mat4::from_scale(Vec3::splat(0.01)));
    assert_eq!(touching(&bounds, &across), touching_one_by_one(&bounds, &across));
    assert!(!bounds.can_be_planned());
}

#[test]
fn a_tree_that_was_outgrown_is_built_anew_and_finds_as_few() {
    // A row of boxes that trade places with others far away, all at once.
    let at = |x: usize| {
        let min = Vec3::X * x as f32;
        Aabb { min, max: min + Vec3::splat(0.5) }
    };
    let count = 4096;
    let mut bounds = Bounds::new((0..count).map(at).collect());
    let slab = ConvexVolume::of_clip(&(Mat4::from_scale(Vec3::new(0.1, 1e-3, 1e-3))));
    let looked_at = |bounds: &Bounds| {
        let mut count = Counted { volume: &slab, nodes: 0 };
        bounds.tree().search(&mut count, ());
        count.nodes
    };
    let few = looked_at(&bounds);
    assert!(few < 40, "{few} of {count} boxes need so many nodes");
    bounds.set((0..count).map(|i| (i, at(i * 1023 % count))));
    assert!(looked_at(&bounds) < 40, "{} nodes after a shuffle", looked_at(&bounds));
    assert_eq!(touching(&bounds, &slab), touching_one_by_one(&bounds, &slab));
}

/// Counts the nodes that a search for what touches a volume looks at.
struct Counted<'a> {
    volume: &'a ConvexVolume,
    nodes: usize,
}

impl Search for Counted<'_> {
    type State = ();

    fn node(&mut self, around: &Aabb, (): ()) -> Below<()> {
        self.nodes += 1;
        if self.volume.may_touch_box(around) { Below::Some(()) } else { Below::Nothing }
    }

    fn boxes(&mut self, _numbers: &[u32], (): ()) {}
}
