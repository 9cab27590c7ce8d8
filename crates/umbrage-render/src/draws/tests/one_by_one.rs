//! Lists from the tree are those from looking at every part of every instance.

use glam::{Mat4, Quat, Vec3, Vec4};
use proptest::prelude::*;
use umbrage_scene::{Alpha, Material, Motion};

use super::*;

/// The draws of some casters without a tree: part by part, and instance by instance.
fn add_casters(
    table: &PartTable,
    lists: &mut DrawLists,
    volume: &ConvexVolume,
    is_wanted: impl Fn(u32) -> bool,
) {
    let DrawLists { instances, draws, ends, .. } = lists;
    let mut open = open::Open::after(instances, draws);
    for (i, _) in table.parts.iter().enumerate().filter(|(_, part)| part.casts) {
        for (number, slot) in (0..).zip(&table.slots).filter(|(_, slot)| slot.part as usize == i) {
            let aabb = table.aabb(number);
            if is_wanted(slot.instance) && !aabb.is_empty() && volume.may_touch_box(&aabb) {
                open.add(*slot, &table.parts);
            }
        }
    }
    open.close(&table.parts);
    ends.push(draws.len());
}

/// What is seen, without a tree.
fn add_seen(table: &PartTable, lists: &mut DrawLists, volume: &ConvexVolume, eye: Vec3) {
    let mut seen = Vec::new();
    for (i, part) in table.parts.iter().enumerate().filter(|(_, part)| part.cover != Cover::Veil) {
        let slots = (0..).zip(&table.slots).filter(|(_, slot)| slot.part as usize == i);
        let boxes = slots.map(|(number, slot)| (table.aabb(number), slot.instance));
        let touching = boxes.filter(|(aabb, _)| !aabb.is_empty() && volume.may_touch_box(aabb));
        let mut near: Vec<(f32, u32)> =
            touching.map(|(aabb, instance)| (nearest_first::distance(part, &aabb, eye), instance)).collect();
        near.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let start = lists.instances.len() as u32;
        lists.instances.extend(near.iter().map(|(_, instance)| *instance));
        if let Some((depth, _)) = near.first() {
            seen.push(Draw { depth: *depth, ..part.draw(start..start + near.len() as u32) });
        }
    }
    seen.sort_by(|a, b| (a.cover, a.depth).partial_cmp(&(b.cover, b.depth)).expect("numbers"));
    lists.draws.append(&mut seen);
    lists.ends.push(lists.draws.len());
}

/// The veils without a tree.
fn add_veils(table: &PartTable, lists: &mut DrawLists, volume: &ConvexVolume, depth: impl Fn(Vec3) -> f32) {
    let first = lists.draws.len();
    for (number, slot) in (0..).zip(&table.slots) {
        let (part, aabb) = (&table.parts[slot.part as usize], table.aabb(number));
        if part.cover == Cover::Veil && !aabb.is_empty() && volume.may_touch_box(&aabb) {
            let place = lists.instances.len() as u32;
            lists.instances.push(slot.instance);
            let depth = depth(0.5 * (aabb.min + aabb.max));
            lists.draws.push(Draw { depth, ..part.draw(place..place + 1) });
        }
    }
    lists.draws[first..].sort_by(|a, b| b.depth.total_cmp(&a.depth));
    lists.ends.push(lists.draws.len());
}

/// Surfaces of every kind: solid ones, cut ones, panes, a sky, and what casts nothing.
fn materials() -> Vec<Material> {
    let plain = Material::plain("m", 1.0, 1.0, 1.0);
    let faded = Material { base_colour: Vec4::new(1.0, 1.0, 1.0, 0.5), ..plain.clone() };
    vec![
        plain.clone(),
        Material { alpha: Alpha::Mask { cutoff: 0.6 }, ..faded.clone() },
        Material { alpha: Alpha::Blend, ..faded },
        Material { casts: false, unlit: true, ..plain.clone() },
        Material { casts: false, ..plain },
    ]
}

fn instance() -> impl Strategy<Value = Instance> {
    let place = (prop::array::uniform3(-60.0f32..60.0), 0.0f32..6.0, any::<bool>(), 0.01f32..2.0);
    (0usize..6, place, any::<bool>(), 0u32..3).prop_map(
        |(mesh, (at, turn, mirrored, scale), casts, moves)| {
            let size = Vec3::new(if mirrored { -scale } else { scale }, scale, scale);
            let matrix =
                Mat4::from_scale_rotation_translation(size, Quat::from_rotation_y(turn), Vec3::from(at));
            let turns = Motion::Rotation { centre: Vec3::ZERO, axis: Vec3::Y, radians_per_second: turn };
            let motion = if moves == 0 { turns } else { Motion::Still };
            Instance { motion, casts, ..Instance::still(mesh, matrix) }
        },
    )
}

fn volume() -> impl Strategy<Value = ConvexVolume> {
    let from = (prop::array::uniform3(-90.0f32..90.0), prop::array::uniform3(-60.0f32..60.0), 0.1f32..2.0);
    from.prop_filter_map("a camera", |(eye, target, fov_y)| {
        let lens = umbrage::Projection::Perspective { fov_y, aspect: 1.5 };
        let camera = umbrage::Camera::looking(eye.into(), target.into(), Vec3::Y, lens, 0.5, 150.0);
        camera.ok().map(|camera| ConvexVolume::of_clip(&camera.clip_from_world()))
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn lists_from_the_tree_are_those_from_every_box(
        instances in proptest::collection::vec(instance(), 0..120),
        poses in proptest::collection::vec(0.0f32..9.0, 0..4),
        volumes in proptest::collection::vec(volume(), 3),
    ) {
        let row = |of: &[(u32, usize)]| of.iter().map(|(count, material)| row(*count, *material)).collect::<Vec<_>>();
        // Long ones have several parts, and some several materials.
        let kinds = [
            row(&[(4, 0)]), row(&[(5000, 0), (3, 4)]), row(&[(4, 1)]), row(&[(4, 2)]), row(&[(4, 3)]),
            row(&[(3000, 0), (4, 2), (9, 1), (2500, 3)]),
        ];
        let meshes = kinds.iter().map(|primitives| Mesh::new("m", primitives)).collect();
        let scene = Scene { meshes, instances, materials: materials(), ..Scene::default() };
        let mut table = PartTable::new(&scene);
        let (mut lists, mut all) = (DrawLists::default(), DrawLists::default());
        for pose in poses {
            table.move_to(&scene.instances, &Pose::at(pose));
        }
        let depth = |middle: Vec3| middle.z;
        for volume in volumes.iter().chain([&ConvexVolume::default(), &ConvexVolume::empty()]) {
            table.add_casters(&mut lists, Some(volume));
            for moving in [false, true] {
                add_casters(&table, &mut all, volume, |instance| table.moves(instance) == moving);
            }
            table.add_seen(&mut lists, volume, Vec3::X);
            add_seen(&table, &mut all, volume, Vec3::X);
            table.add_veils(&mut lists, volume, depth);
            add_veils(&table, &mut all, volume, depth);
        }
        prop_assert_eq!(&lists.draws, &all.draws);
        prop_assert_eq!(&lists.instances, &all.instances);
        prop_assert_eq!(&lists.ends, &all.ends);
    }
}
