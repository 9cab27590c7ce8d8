//! Tests of which parts are drawn into a view.

use glam::{Mat4, Vec2, Vec3};
use umbrage::ConvexVolume;
use umbrage_scene::{Mesh, Primitive};

use super::*;

mod epochs;
mod levels;
mod one_by_one;

/// A row of `count` small triangles along x, one a metre.
fn row(count: u32, material: usize) -> Primitive {
    let corners = [Vec3::ZERO, Vec3::X * 0.5, Vec3::Z * 0.5];
    let positions: Vec<Vec3> = (0..count).flat_map(|i| corners.map(|c| c + Vec3::X * i as f32)).collect();
    let normals = vec![Vec3::Y; positions.len()];
    let uvs = vec![Vec2::ZERO; positions.len()];
    let indices = (0..positions.len() as u32).collect();
    Primitive { normals, uvs, indices, positions, material, ..Primitive::default() }
}

fn scene() -> Scene {
    let meshes = vec![Mesh::new("long", &[row(8192, 0)]), Mesh::new("short", &[row(4, 0), row(4, 1)])];
    let at = |mesh, x, z| Instance::still(mesh, Mat4::from_translation(Vec3::new(x, 0.0, z)));
    let instances = vec![at(0, 0.0, 0.0), at(1, 0.0, 50.0), at(1, 100.0, 50.0)];
    Scene { meshes, instances, ..Scene::default() }
}

/// The half-space x ≤ `limit`.
fn before(limit: f32) -> ConvexVolume {
    let mut matrix = Mat4::ZERO;
    matrix.w_axis.w = limit;
    matrix.w_axis.z = limit * 0.5;
    matrix.x_axis.x = 1.0;
    ConvexVolume::of_clip(&matrix)
}

/// A half-space that holds all of the scene.
fn everywhere() -> ConvexVolume {
    before(1e6)
}

#[test]
fn casters_are_a_draw_a_mesh_when_materials_go_together() {
    let scene = scene();
    let mut lists = DrawLists::default();
    PartTable::new(&scene).add_casters(&mut lists, None);
    PartTable::new(&scene).add_seen(&mut lists, &everywhere(), Vec3::ZERO);
    let triangles = |view: usize| lists.view(view).iter().map(Draw::triangles).sum::<u64>();
    assert_eq!((lists.view(0).len(), triangles(0)), (2, 8192 + 16));
    assert_eq!(lists.view(1), [], "nothing moves");
    assert_eq!(
        (lists.view(2).len(), triangles(2)),
        (6, 8192 + 16),
        "each part by itself, as they lie at other distances"
    );
}

#[test]
fn only_parts_that_touch_the_volume_are_drawn() {
    let scene = scene();
    let mut lists = DrawLists::default();
    PartTable::new(&scene).add_casters(&mut lists, Some(&before(50.0)));
    PartTable::new(&scene).add_casters(&mut lists, Some(&ConvexVolume::empty()));
    // The first of four parts of the long row, and the nearer one of the two short rows.
    assert_eq!(lists.view(0).iter().map(Draw::triangles).collect::<Vec<_>>(), [2048, 8]);
    assert!((1..4).all(|view| lists.view(view).is_empty()));
}

#[test]
fn what_casts_nothing_is_seen_and_drawn_into_no_map_and_skies_are_not_planned_for() {
    let mut scene = scene();
    scene.materials = (0..2).map(|i| umbrage_scene::Material::plain(&i.to_string(), 1.0, 1.0, 1.0)).collect();
    let triangles = |scene: &Scene| {
        let mut lists = DrawLists::default();
        let table = PartTable::new(scene);
        table.add_casters(&mut lists, None);
        table.add_seen(&mut lists, &everywhere(), Vec3::ZERO);
        let of = |view: usize| lists.view(view).iter().map(Draw::triangles).sum::<u64>();
        (of(0), of(2), table.bounds().objects().iter().filter(|aabb| !aabb.is_empty()).count())
    };
    // Four parts and twice two, of 4 triangles each.
    assert_eq!(triangles(&scene), (8192 + 16, 8192 + 16, 8));
    scene.materials[1].casts = false;
    assert_eq!(triangles(&scene), (8192 + 8, 8192 + 16, 8));
    scene.instances[0].casts = false;
    assert_eq!(triangles(&scene), (8, 8192 + 16, 8));
    scene.materials[0].unlit = true;
    assert_eq!(triangles(&scene), (8, 8192 + 16, 4), "the long row is a sky");
    assert_eq!(PartTable::new(&scene).bounds().world().min.z, 50.0);
    scene.instances[0].casts = true;
    assert_eq!(triangles(&scene), (8192 + 8, 8192 + 16, 8), "what is unlit and casts is no sky");
}

#[test]
fn lists_that_are_made_again_take_no_more_room() {
    let scene = scene();
    let table = PartTable::new(&scene);
    let mut lists = DrawLists::default();
    let mut room = || {
        lists.clear();
        table.add_casters(&mut lists, None);
        table.add_seen(&mut lists, &before(50.0), Vec3::ZERO);
        let DrawLists { instances, draws, ends, touched: _, touched_levels: _, by_distance: _ } = &lists;
        let (instances, draws, ends) = (instances.as_ptr_range(), draws.as_ptr_range(), ends.as_ptr_range());
        (instances, draws, ends)
    };
    assert_eq!(room(), room(), "the same lists in the same place");
}

#[test]
fn boxes_move_with_what_moves_and_hold_it_on_its_way() {
    let mut scene = scene();
    let axis = umbrage_scene::Motion::Rotation { centre: Vec3::ZERO, axis: Vec3::Y, radians_per_second: 1.0 };
    scene.instances[1].motion = axis;
    let mut table = PartTable::new(&scene);
    let start = table.bounds().clone();
    table.move_to(&scene.instances, &Pose::at(1.0));
    let moved = table.bounds().clone();
    assert_ne!(moved, start);
    assert_eq!(moved, PartTable::new(&scene).into_bounds_in(&scene.instances, &Pose::at(1.0)));
    for step in 1..20 {
        let pose = Pose::at(1.0 + 0.1 * step as f32);
        table.move_to(&scene.instances, &pose);
        let now = PartTable::new(&scene).into_bounds_in(&scene.instances, &pose);
        for (reach, now) in table.bounds().objects().iter().zip(now.objects()) {
            assert!(reach.min.cmple(now.min).all() && reach.max.cmpge(now.max).all(), "{reach:?}, {now:?}");
        }
    }
}

#[test]
fn solid_parts_come_first_and_veils_from_the_deepest_on() {
    use umbrage_scene::{Alpha, Material};
    let mut scene = scene();
    let with = |alpha, w| Material {
        alpha,
        base_colour: glam::Vec4::new(1.0, 1.0, 1.0, w),
        ..Material::plain("m", 1.0, 1.0, 1.0)
    };
    scene.materials =
        vec![with(Alpha::Blend, 0.5), with(Alpha::Opaque, 0.5), with(Alpha::Mask { cutoff: 0.6 }, 0.5)];
    scene.meshes.push(Mesh::new("cut", &[row(4, 2)]));
    scene.instances.push(Instance::still(2, Mat4::IDENTITY));
    let table = PartTable::new(&scene);
    let mut lists = DrawLists::default();
    table.add_casters(&mut lists, None);
    table.add_seen(&mut lists, &everywhere(), Vec3::ZERO);
    table.add_veils(&mut lists, &everywhere(), |middle| middle.z + 0.001 * middle.x);
    let covers = |view: usize| lists.view(view).iter().map(|draw| draw.cover).collect::<Vec<_>>();
    // The four parts of the long row are one draw.
    assert_eq!(covers(0), [Cover::Solid, Cover::Cut, Cover::Veil, Cover::Veil]);
    assert_eq!(covers(2), [Cover::Solid, Cover::Cut]);
    assert_eq!(covers(3), [Cover::Veil; 6]);
    let depths: Vec<f32> = lists.view(3).iter().map(|draw| draw.depth).collect();
    assert!(depths.is_sorted_by(|a, b| a >= b) && depths[0] > 50.0 && depths[5] < 10.0, "{depths:?}");
}
