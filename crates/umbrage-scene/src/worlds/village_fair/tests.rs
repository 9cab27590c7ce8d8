//! Is there the crowd that the fair was made for, and does it move as people do?

use glam::Mat4;

use super::*;
use crate::worlds::canvas::covered;
use crate::{Alpha, Instance, LightKind, Motion, Pose};

/// The people of the fair.
fn people(scene: &Scene) -> Vec<&Instance> {
    scene.instances.iter().filter(|instance| instance.skin.is_some()).collect()
}

/// The places of a person's vertices in a pose, in the world.
fn bent(scene: &Scene, person: &Instance, pose: &Pose) -> Vec<Vec3> {
    let joints: Vec<Mat4> = pose.joints(&scene.rig, person.skin.expect("a skin")).collect();
    let mesh = &scene.meshes[person.mesh];
    let at = person.world_from_mesh_in(pose);
    let place = |vertex: usize| {
        let sum: Vec3 = mesh
            .influences
            .of(vertex)
            .map(|(joint, weight)| joints[joint].transform_point3(mesh.positions[vertex]) * weight)
            .sum();
        at.transform_point3(sum)
    };
    (0..mesh.positions.len()).map(place).collect()
}

#[test]
fn a_hundred_people_have_bones_and_a_skin_of_their_own() {
    let scene = build(0);
    let people = people(&scene);
    assert_eq!((people.len(), crowd::PEOPLE), (100, 100));
    let mut skins: Vec<usize> = people.iter().filter_map(|person| person.skin).collect();
    skins.dedup();
    assert_eq!(skins.len(), 100, "skins");
    for person in people {
        let (mesh, joints) =
            (&scene.meshes[person.mesh], scene.rig.skins[person.skin.expect("a skin")].joints.len());
        assert!((1000..=3000).contains(&mesh.triangles()), "{} has {}", mesh.name, mesh.triangles());
        assert!((15..=25).contains(&joints), "{joints} joints");
        assert!(matches!(person.motion, Motion::Skin { .. }), "{:?}", person.motion);
    }
}

#[test]
fn people_stand_on_the_green_or_the_stage_whatever_they_do() {
    let scene = build(0);
    for seconds in [0.0, 1.7, 11.3] {
        let pose = scene.pose(seconds);
        for person in people(&scene) {
            let heights: Vec<f32> = bent(&scene, person, &pose).iter().map(|place| place.y).collect();
            let (low, high) = (
                heights.iter().copied().fold(f32::INFINITY, f32::min),
                heights.iter().copied().fold(0.0, f32::max),
            );
            let floor = if low > 0.5 { village::STAGE_HEIGHT } else { 0.0 };
            assert!(
                (-0.12..0.25).contains(&(low - floor)),
                "{} at {seconds} s: {low} m",
                scene.meshes[person.mesh].name
            );
            assert!(
                (0.95..2.5).contains(&(high - floor)),
                "{} at {seconds} s: {high} m",
                scene.meshes[person.mesh].name
            );
        }
    }
}

#[test]
fn no_two_people_move_alike_and_none_stretches() {
    let scene = build(0);
    let [start, soon, later] = [0.0, 0.4, 1.3].map(|seconds| scene.pose(seconds));
    for person in people(&scene) {
        let mesh = &scene.meshes[person.mesh];
        let [from, to, then] = [&start, &soon, &later].map(|pose| bent(&scene, person, pose));
        let moved = |to: &[Vec3]| from.iter().zip(to).map(|(a, b)| a.distance(*b)).fold(0.0, f32::max);
        let most = moved(&to).max(moved(&then));
        assert!((0.005..6.0).contains(&most), "{} moves by {most} m", mesh.name);
        for edge in mesh.indices.as_chunks().0.iter().map(|t: &[u32; 3]| [t[0] as usize, t[1] as usize]) {
            let [rest, bent] = [&mesh.positions, &to].map(|places| places[edge[0]].distance(places[edge[1]]));
            assert!(bent < 1.2 * rest + 0.2, "{}: an edge of {rest} m is {bent} m long", mesh.name);
        }
    }
}

#[test]
fn there_are_flags_signs_lamps_lace_and_tarpaulin() {
    let scene = build(0);
    let named = |name: &str| scene.instances.iter().filter(|i| scene.meshes[i.mesh].name == name).count();
    assert_eq!(["flag", "bunting", "horse", "pinwheel", "sign"].map(named), [6, 6, 12, 4, 7]);
    let count = |kind: fn(LightKind) -> bool| scene.lights.iter().filter(|light| kind(light.kind)).count();
    let spots = count(|kind| matches!(kind, LightKind::Spot { .. }));
    let points = count(|kind| matches!(kind, LightKind::Point { .. }));
    assert_eq!((scene.lights.len(), spots, points), (16, 3, 12));
    let blends = scene.materials.iter().filter(|material| material.alpha == Alpha::Blend).count();
    assert_eq!(blends, 2);
    let share = covered(&cloth::lace());
    assert!((0.5..0.8).contains(&share), "lace covers {share}");
    let shown = |seconds: f32| {
        let pose = scene.pose(seconds);
        scene.instances.iter().filter(|instance| !instance.is_visible_in(&pose)).count()
    };
    assert_eq!([0.5, 1.5, 2.5].map(shown), [3, 3, 3], "two of six signs are dark, and the broken one");
}
