//! Before anything is drawn, a frame allocates nothing after the first ones: boxes move, a plan is made, and lists are.

use glam::{Mat4, Vec2, Vec3};
use umbrage_render::draws::{DrawLists, PartTable};
use umbrage_render::umbrage::{Camera, ConvexVolume, Light, Projection, Settings, ShadowPlan, plan};
use umbrage_scene::{Alpha, Instance, Material, Mesh, Motion, Pose, Primitive, Scene};

/// Things on a lattice, of two materials; one in three turns about the middle of all.
fn scene() -> Scene {
    let thing = |material| Primitive {
        positions: vec![Vec3::ZERO, Vec3::X, Vec3::Y],
        normals: vec![Vec3::Z; 3],
        uvs: vec![Vec2::ZERO; 3],
        indices: vec![0, 1, 2],
        material,
        ..Primitive::default()
    };
    let turn = Motion::Rotation { centre: Vec3::ZERO, axis: Vec3::Y, radians_per_second: 1.0 };
    let instances = (0..3000u32).map(|i| {
        let at = Vec3::new((i % 60) as f32 * 4.0 - 120.0, 0.0, (i / 60) as f32 * 4.0 - 100.0);
        let motion = if i % 3 == 0 { turn } else { Motion::Still };
        Instance { motion, ..Instance::still(i as usize % 2, Mat4::from_translation(at)) }
    });
    let plain = Material::plain("m", 1.0, 1.0, 1.0);
    let pane = Material { alpha: Alpha::Blend, base_colour: plain.base_colour * 0.5, ..plain.clone() };
    Scene {
        meshes: [0, 1].map(|material| Mesh::new("thing", &[thing(material)])).into(),
        materials: vec![plain, pane],
        instances: instances.collect(),
        ..Scene::default()
    }
}

fn camera(frame: u32) -> Camera {
    let projection = Projection::Perspective { fov_y: 1.0, aspect: 1.5 };
    let eye = Vec3::new(frame as f32 - 16.0, 8.0, 60.0);
    Camera::looking(eye, Vec3::ZERO, Vec3::Y, projection, 1.0, 200.0).expect("a camera")
}

#[test]
fn a_frame_is_moved_planned_and_listed_without_an_allocation() {
    let scene = scene();
    let lights = [
        Light::directional(Vec3::new(0.4, -1.0, 0.2)).expect("a sun"),
        Light::point(Vec3::new(9.0, 4.0, 5.0), 50.0).expect("a point light"),
    ];
    let settings = Settings::default();
    let mut table = PartTable::new(&scene);
    let mut plan = plan(&camera(0), &lights, table.bounds(), &settings).expect("a plan");
    let mut lists = DrawLists::default();
    let frame = |number: u32, table: &mut PartTable, plan: &mut ShadowPlan, lists: &mut DrawLists| {
        let camera = camera(number);
        table.move_to(&scene.instances, &Pose::at(number as f32 * 0.1));
        plan.replan(&camera, &lights, table.bounds(), &settings).expect("a plan");
        lists.clear();
        for view in plan.views() {
            table.add_casters(lists, Some(&view.casters));
        }
        let seen = ConvexVolume::of_clip(&camera.clip_from_world());
        table.add_seen(lists, &seen, camera.eye());
        table.add_veils(lists, &seen, |middle| (middle - camera.eye()).dot(camera.forward()));
    };
    // Lists of other cameras may need a little more room, once.
    (1..32).for_each(|number| frame(number, &mut table, &mut plan, &mut lists));
    for number in 1..32 {
        let counted = allocation_counter::measure(|| frame(number, &mut table, &mut plan, &mut lists));
        assert_eq!(counted.count_total, 0, "{counted:?} in frame {number}");
    }
    assert!(lists.instances().len() > 1000, "{} instances are drawn", lists.instances().len());
}
