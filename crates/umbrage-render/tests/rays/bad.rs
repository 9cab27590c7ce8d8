//! What no importer lets pass, and what a scene made in a program may hold: on the device it costs itself, and nothing else.

use glam::{Mat4, Vec2, Vec3, Vec4};
use umbrage_render::{Point, RayCasters};
use umbrage_scene::{Alpha, Instance, Light, Material, Mesh, Primitive, Scene, Texture};

use crate::{asked, facing, gpu};

/// One triangle of a material.
fn triangle(corners: [Vec3; 3], material: usize) -> Primitive {
    Primitive {
        positions: corners.to_vec(),
        normals: vec![Vec3::Y; 3],
        uvs: vec![Vec2::ZERO; 3],
        indices: vec![0, 1, 2],
        material,
        ..Primitive::default()
    }
}

/// A roof of 4 m a side at a height, as two triangles.
fn roof(height: f32, material: usize) -> Primitive {
    let corner = |x: f32, z: f32| Vec3::new(x, height, z);
    Primitive {
        positions: vec![corner(-2.0, -2.0), corner(-2.0, 2.0), corner(2.0, 2.0), corner(2.0, -2.0)],
        normals: vec![Vec3::Y; 4],
        uvs: vec![Vec2::ZERO; 4],
        indices: vec![0, 1, 2, 0, 2, 3],
        material,
        ..Primitive::default()
    }
}

fn materials() -> Vec<Material> {
    let plain = |name: &str| Material::plain(name, 0.5, 0.5, 0.5);
    let mask = |cutoff| Alpha::Mask { cutoff };
    vec![
        plain("solid"),
        Material { alpha: mask(f32::NAN), texture: Some(0), ..plain("no cut-off") },
        Material { alpha: mask(0.5), texture: Some(77), ..plain("no picture") },
        Material {
            alpha: Alpha::Blend,
            transmission: f32::NAN,
            base_colour: Vec4::splat(f32::NAN),
            ..plain("no number")
        },
    ]
}

/// Places under the roof, and places far beside it that nothing is over.
fn places() -> (Vec<Vec3>, Vec<Vec3>) {
    let at = |i: u32, far: f32| Vec3::new((i % 8) as f32 * 0.4 - 1.4 + far, 0.0, (i / 8) as f32 * 0.4 - 1.4);
    ((0..64).map(|i| at(i, 0.0)).collect(), (0..64).map(|i| at(i, 30.0)).collect())
}

/// What rays under a sun straight above and under a lamp say under the roof and beside it. All of it is a share.
fn answers(scene: &Scene) -> [(Vec<f32>, Vec<f32>); 2] {
    let (under, beside) = places();
    let all: Vec<Vec3> = under.iter().chain(&beside).copied().collect();
    let points = |light: &Light| all.iter().map(|place| facing(light, *place)).collect();
    let points: Vec<Vec<Point>> = scene.lights.iter().map(points).collect();
    let of_light = |answers: Vec<f32>| {
        assert!(answers.iter().all(|answer| (0.0..=1.0).contains(answer)), "{answers:?}");
        (answers[..under.len()].to_vec(), answers[under.len()..].to_vec())
    };
    let mut answers = asked(&gpu(), scene, Vec3::ZERO, &points).into_iter().map(of_light);
    [(); 2].map(|()| answers.next().expect("two lights"))
}

fn scene(meshes: Vec<Mesh>, instances: Vec<Instance>) -> Scene {
    let texture = Texture { name: String::new(), width: 2, height: 2, rgba: vec![128; 16] };
    let sun = Light::sun(-Vec3::Y, 1.0);
    let lamp = Light::point("lamp", Vec3::new(0.0, 60.0, 0.0), 1000.0, 1.0);
    Scene {
        meshes,
        instances,
        materials: materials(),
        textures: vec![texture],
        lights: vec![sun, lamp],
        ..Scene::default()
    }
}

/// The roof alone casts: what is bad is left out or is nowhere near.
fn assert_only_the_roof_casts(scene: &Scene, what: &str) {
    for (under, beside) in answers(scene) {
        assert!(under.iter().all(|answer| *answer == 0.0), "{what}, under the roof: {under:?}");
        assert!(beside.iter().all(|answer| *answer == 1.0), "{what}, beside it: {beside:?}");
    }
}

#[test]
fn corners_that_are_nowhere_and_triangles_without_area_cast_nothing() {
    let [nan, infinite] = [f32::NAN, f32::INFINITY].map(Vec3::splat);
    let bad = [
        triangle([nan, Vec3::X, Vec3::Z], 0),
        triangle([Vec3::ZERO, infinite, Vec3::Z], 0),
        triangle([Vec3::Y, Vec3::Y, Vec3::Y], 0),
        triangle([Vec3::ZERO, Vec3::Y, 2.0 * Vec3::Y], 0),
    ];
    let mut primitives = vec![roof(5.0, 0)];
    primitives.extend(bad);
    let meshes = vec![Mesh::new("roof and worse", &primitives)];
    let casters = RayCasters::of(&scene(meshes.clone(), vec![Instance::still(0, Mat4::IDENTITY)]));
    assert_eq!((casters.triangles(), casters.left_out()), (2, 4));
    assert_only_the_roof_casts(&scene(meshes, vec![Instance::still(0, Mat4::IDENTITY)]), "no triangles");
}

#[test]
fn instances_that_stand_nowhere_or_have_no_size_cast_nothing() {
    let matrices = [
        Mat4::ZERO,
        Mat4::from_scale(Vec3::ZERO),
        Mat4::from_scale(Vec3::splat(1e-30)),
        Mat4::from_cols_array(&[f32::NAN; 16]),
        Mat4::from_translation(Vec3::splat(f32::INFINITY)),
        Mat4::from_translation(Vec3::new(3e38, 3e38, 0.0)),
    ];
    let mut instances = vec![Instance::still(0, Mat4::from_scale(Vec3::new(-1.0, 1.0, 1.0)))];
    instances.extend(matrices.map(|matrix| Instance::still(1, matrix)));
    instances.push(Instance::still(2, Mat4::IDENTITY));
    let other = Mesh::new("other", &[roof(0.5, 0)]);
    let meshes = vec![Mesh::new("roof", &[roof(5.0, 0)]), other, Mesh::new("empty", &[])];
    assert_only_the_roof_casts(&scene(meshes, instances), "no instances");
}

#[test]
fn a_world_without_casters_is_lit() {
    for scene in [scene(Vec::new(), Vec::new()), scene(vec![Mesh::new("empty", &[])], Vec::new())] {
        for (under, beside) in answers(&scene) {
            assert!(under.iter().chain(&beside).all(|answer| *answer == 1.0), "{under:?} {beside:?}");
        }
    }
}

#[test]
fn triangles_beyond_all_measure_give_a_share_and_leave_others_as_they_are() {
    for metres in [1e6, 1e12, 1e18, 1e30, f32::MAX] {
        let corners = [Vec3::new(-1.0, 0.0, -1.0), Vec3::new(1.0, 0.0, -1.0), Vec3::new(0.0, 0.0, 1.0)];
        // Far below all receivers, so that it is over none of them.
        let huge = corners.map(|corner| metres * corner - 50.0 * Vec3::Y);
        let apart = vec![Mesh::new("roof", &[roof(5.0, 0)]), Mesh::new("huge", &[triangle(huge, 0)])];
        let instances = (0..2).map(|mesh| Instance::still(mesh, Mat4::IDENTITY)).collect();
        assert_only_the_roof_casts(&scene(apart, instances), &format!("{metres} m below"));
    }
}

#[test]
fn many_copies_in_one_place_answer_as_one() {
    let instances = vec![Instance::still(0, Mat4::IDENTITY); 500];
    assert_only_the_roof_casts(&scene(vec![Mesh::new("roof", &[roof(5.0, 0)])], instances), "copies");
}

#[test]
fn surfaces_without_a_picture_a_cut_off_or_a_number_give_a_share() {
    for material in 0..materials().len() {
        let bad = Mesh::new("bad", &[roof(4.0, material)]);
        let mut bare = bad.clone();
        bare.uvs.clear();
        for mesh in [bad, bare] {
            let what = &materials()[material].name;
            for (_, beside) in answers(&scene(vec![mesh], vec![Instance::still(0, Mat4::IDENTITY)])) {
                assert!(beside.iter().all(|answer| *answer == 1.0), "{what}: {beside:?}");
            }
        }
    }
}
