//! Which levels of detail are drawn into a view, and what is left out.

use glam::{DVec3, Mat4, Quat, Vec3};
use proptest::prelude::*;
use umbrage::{Camera, Light, Projection, Settings, ShadowPlan, Warp, plan};
use umbrage_scene::CasterMesh;

use super::super::detail::Detail;
use super::*;

/// Rough ground of 80 by 80 quads, 40 m wide.
fn ground() -> Mesh {
    let place = |i: u32| {
        let (x, z) = ((i % 81) as f32 * 0.5 - 20.0, (i / 81) as f32 * 0.5 - 20.0);
        Vec3::new(x, (x * 0.7).sin() * (z * 0.9).cos() + 0.2 * (5.0 * x + z).sin(), z)
    };
    let positions: Vec<Vec3> = (0..81 * 81).map(place).collect();
    let quads = (0..80u32).flat_map(|z| (0..80u32).map(move |x| z * 81 + x));
    let indices = quads.flat_map(|i| [i, i + 81, i + 1, i + 1, i + 81, i + 82]).collect();
    let (normals, uvs) = (vec![Vec3::Y; positions.len()], vec![Vec2::ZERO; positions.len()]);
    Mesh::new("ground", &[Primitive { positions, normals, uvs, indices, ..Primitive::default() }])
}

fn levels_of(scene: &Scene) -> Vec<MeshLevels> {
    let made = scene.meshes.iter().map(|mesh| CasterMesh::with_levels(mesh, |_| true));
    made.map(|made| MeshLevels { levels: made.levels, first_index: 0, first_vertex: 0 }).collect()
}

/// The plan of a sun and a lamp, seen from somewhere.
fn planned(scene: &Scene, eye: Vec3, warp: Warp) -> ShadowPlan {
    let lens = Projection::Perspective { fov_y: 1.0, aspect: 1.5 };
    let camera = Camera::looking(eye, Vec3::ZERO, Vec3::Y, lens, 0.5, 400.0).expect("a camera");
    let sun = Light::directional(Vec3::new(0.3, -1.0, 0.2)).expect("a sun");
    let lamp = Light::point(Vec3::new(3.0, 30.0, -5.0), 200.0).expect("a lamp");
    let settings = Settings { warp, ..Settings::default() };
    plan(&camera, &[sun, lamp], PartTable::new(scene).bounds(), &settings).expect("a plan")
}

fn instance() -> impl Strategy<Value = Instance> {
    let place = (prop::array::uniform3(-120.0f32..120.0), 0.0f32..6.0, prop::array::uniform3(-2.0f32..2.0));
    place.prop_map(|(at, turn, scale)| {
        let turn = Quat::from_rotation_y(turn);
        Instance::still(0, Mat4::from_scale_rotation_translation(scale.into(), turn, at.into()))
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    #[test]
    fn of_each_caster_one_level_is_drawn_and_no_farther_off_than_texels_allow(
        instances in proptest::collection::vec(instance(), 1..8),
        eye in prop::array::uniform3(5.0f32..150.0), texels in 0.0f32..1.0,
        warp in prop_oneof![Just(Warp::None), Just(Warp::Tsm)],
    ) {
        let scene = Scene { meshes: vec![ground()], instances, ..Scene::default() };
        let mut table = PartTable::new(&scene);
        let levels = levels_of(&scene);
        table.set_levels(&levels);
        for view in planned(&scene, eye.into(), warp).views() {
            let mut lists = DrawLists::default();
            let farthest = table.add_detailed(&mut lists, &ConvexVolume::default(), &Detail::of(view, texels));
            let mut drawn = vec![0; scene.instances.len()];
            for draw in lists.view(0) {
                let instances = draw.instances.start as usize..draw.instances.end as usize;
                lists.instances[instances].iter().for_each(|i| drawn[*i as usize] += draw.indices.len() / 3);
            }
            let mut errors = 0.0f32;
            for (instance, triangles) in scene.instances.iter().zip(drawn) {
                let found = levels[0].levels.iter().find(|level| level.triangles() == triangles);
                prop_assert!(found.is_some(), "{triangles} triangles");
                let stretch = |axis: Vec3| instance.world_from_mesh.transform_vector3(axis).length();
                let scale = stretch(Vec3::X).max(stretch(Vec3::Y)).max(stretch(Vec3::Z));
                let error = found.map_or(0.0, |level| level.error) * scale;
                errors = errors.max(error);
                // Where a view has the mesh at all, no texel in it is finer than the error allows.
                for position in scene.meshes[0].positions.iter().step_by(97) {
                    let point = instance.world_from_mesh.transform_point3(*position);
                    if error > 0.0 && view.covers(point.as_dvec3(), 0.0) {
                        let texel = view.texel_basis_at(point).texel_metres();
                        prop_assert!(error <= texels * texel * 1.001, "{error} m in texels of {texel} m");
                    }
                }
            }
            prop_assert!((farthest - errors).abs() <= 1e-4 * errors, "{farthest}, not {errors}");
        }
    }

    #[test]
    fn what_is_left_out_covers_no_texels_centre(
        at in prop::array::uniform3(-60.0f64..60.0), size in prop::array::uniform3(0.0f64..0.3),
        eye in prop::array::uniform3(5.0f32..150.0),
    ) {
        let scene = Scene { meshes: vec![ground()], instances: vec![Instance::still(0, Mat4::IDENTITY)], ..Scene::default() };
        let (min, max) = (DVec3::from(at), DVec3::from(at) + DVec3::from(size));
        for view in planned(&scene, eye.into(), Warp::None).views() {
            let aabb = Aabb { min: min.as_vec3(), max: max.as_vec3() };
            if !Detail::of(view, 0.25).is_missed(&aabb) {
                continue;
            }
            // Between which centres each corner lies.
            let cells = [0, 1, 2, 3, 4, 5, 6, 7].map(|i| {
                let pick = |bit: i32, axis: usize| if i & bit == 0 { min[axis] } else { max[axis] };
                let ndc = view.clip_from_world.project_point3(DVec3::new(pick(1, 0), pick(2, 1), pick(4, 2)));
                let texel = (ndc.truncate() * 0.5 + 0.5) * f64::from(view.tile.size);
                (texel + 0.5).floor()
            });
            let is_one = |axis: usize| cells.iter().all(|cell| cell[axis] == cells[0][axis]);
            prop_assert!(is_one(0) || is_one(1), "{aabb:?} in view {}", view.index);
        }
    }
}

#[test]
fn levels_stand_in_for_solid_parts_alone_and_without_detail_they_are_the_mesh() {
    let mut scene = scene();
    scene.meshes.push(ground());
    scene.instances.push(Instance::still(2, Mat4::IDENTITY));
    let count = |table: &PartTable| {
        let mut lists = DrawLists::default();
        table.add_casters(&mut lists, None);
        let of = |wanted| {
            lists.view(0).iter().filter(|draw| draw.geometry == wanted).map(Draw::triangles).sum::<u64>()
        };
        [of(Geometry::Meshes), of(Geometry::Levels)]
    };
    let mut table = PartTable::new(&scene);
    let all = scene.triangles() as u64;
    assert_eq!(count(&table), [all, 0]);
    let mut levels = levels_of(&scene);
    table.set_levels(&levels);
    assert_eq!(count(&table), [0, all]);
    levels[2].levels.clear();
    table.set_levels(&levels);
    assert_eq!(count(&table), [12800, all - 12800], "what has none casts as it is");
}
