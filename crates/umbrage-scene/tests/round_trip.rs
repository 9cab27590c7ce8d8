//! A scene that is written and read again is the same scene, bit for bit.

#[path = "round_trip/rigs.rs"]
mod rigs;

use std::f32::consts::FRAC_PI_2;

use glam::{Affine2, DVec3, Mat4, Quat, Vec2, Vec3, Vec4};
use proptest::collection::vec;
use proptest::prelude::*;
use umbrage_scene::*;

/// Everything of a scene that a file keeps, with floats as bits, so that 0 and −0 differ.
fn bits(scene: &Scene) -> Vec<String> {
    let floats = |numbers: &[f32]| format!("{:x?}", numbers.iter().map(|x| x.to_bits()).collect::<Vec<_>>());
    let matrix = |m: &Mat4| floats(&m.to_cols_array());
    let vector = |v: &Vec3| floats(&v.to_array());
    let mut bits = Vec::new();
    for Mesh { name, positions, normals, uvs, colours, indices, parts, bounds, influences, targets } in
        &scene.meshes
    {
        bits.push(format!("mesh {name:?} {indices:?} {parts:?} {bounds:?} {influences:?} {targets:?}"));
        bits.extend(positions.iter().chain(normals).map(vector));
        bits.extend(uvs.iter().map(|uv| floats(&uv.to_array())));
        bits.extend(colours.iter().map(|colour| floats(&colour.to_array())));
    }
    let movement = |motion: &Motion| match motion {
        Motion::Still => String::new(),
        Motion::Rotation { centre, axis, radians_per_second } => {
            vector(centre) + &vector(axis) + &floats(&[*radians_per_second])
        }
        Motion::Node { node, node_from_thing } => format!("{node} {}", matrix(node_from_thing)),
        Motion::Skin { node } => format!("{node}"),
    };
    for Instance { name, mesh, world_from_mesh, motion, casts, node, skin } in &scene.instances {
        bits.push(format!(
            "instance {name:?} {mesh} {} {} {casts} {node:?} {skin:?}",
            matrix(world_from_mesh),
            movement(motion)
        ));
    }
    for Material {
        name,
        base_colour,
        texture,
        metallic,
        roughness,
        specular,
        emission,
        alpha,
        transmission,
        unlit,
        casts,
        maps,
    } in &scene.materials
    {
        let numbers = floats(&[*metallic, *roughness, *specular, emission.x, emission.y, emission.z]);
        let base = floats(&base_colour.to_array());
        bits.push(format!("material {name:?} {base} {texture:?} {numbers} {alpha:?} {transmission:?} {unlit} {casts} {maps:?}"));
    }
    bits.extend(scene.textures.iter().map(|texture| format!("{texture:?}")));
    for Camera { name, world_from_camera, lens, near, far } in &scene.cameras {
        let (kind, size) = match lens {
            Lens::Perspective { fov_y } => ("perspective", *fov_y),
            Lens::Orthographic { half_height } => ("orthographic", *half_height),
        };
        bits.push(format!("{kind} {name:?} {} {}", matrix(world_from_camera), floats(&[size, *near, *far])));
    }
    for Light { name, world_from_light, colour, intensity, kind, near, motion } in &scene.lights {
        let colour = floats(&[colour.x, colour.y, colour.z, *intensity, *near]);
        let movement = movement(motion);
        bits.push(format!("light {name:?} {} {colour} {kind:?} {movement}", matrix(world_from_light)));
    }
    bits.push(format!("{:?}", scene.exposed_for.map(f32::to_bits)));
    bits.extend(scene.path.keys.iter().map(|key| vector(&key.eye) + &vector(&key.target)));
    bits.push(format!("{:?}", scene.rig));
    bits.push(format!("origin {}", scene.origin));
    bits
}

fn assert_survives(scene: &Scene) {
    let bytes = to_glb(scene).unwrap();
    let Imported { scene: again, warnings } = load_glb_bytes(&bytes, "again.glb").unwrap();
    assert_eq!(warnings, [""; 0]);
    for (got, want) in bits(&again).iter().zip(&bits(scene)) {
        assert_eq!(got, want);
    }
    assert_eq!(bits(&again).len(), bits(scene).len());
    assert_eq!(to_glb(&Scene { name: scene.name.clone(), ..again }).unwrap(), bytes, "the same file, too");
}

/// A finite number of ordinary size, with many digits; sometimes −0.
fn number() -> impl Strategy<Value = f32> {
    prop_oneof![Just(-0.0), -1e6f32..1e6, -1.0f32..1.0, -1e-6f32..1e-6]
}

fn point() -> impl Strategy<Value = Vec3> {
    [number(), number(), number()].prop_map(Vec3::from)
}

fn direction() -> impl Strategy<Value = Vec3> {
    [-1.0f32..1.0, -1.0f32..1.0, -1.0f32..1.0].prop_map(|v| Vec3::from(v).normalize_or(Vec3::Y))
}

/// Stands anywhere, turned anyhow.
fn rigid() -> impl Strategy<Value = Mat4> {
    (direction(), 0.0f32..6.3, point())
        .prop_map(|(axis, angle, at)| Mat4::from_rotation_translation(Quat::from_axis_angle(axis, angle), at))
}

fn primitive() -> impl Strategy<Value = Primitive> {
    let colour = [0.0f32..=1.0, 0.0f32..=1.0, 0.0f32..=1.0, 0.0f32..=1.0].prop_map(Vec4::from);
    let vertex = (point(), direction(), [number(), number()].prop_map(Vec2::from), colour);
    (vec(vertex, 3..12), vec([0..64u32, 0..64, 0..64], 1..8), 0..3usize, any::<bool>()).prop_map(
        |(vertices, triangles, material, has_colours)| {
            let count = vertices.len() as u32;
            Primitive {
                positions: vertices.iter().map(|v| v.0).collect(),
                normals: vertices.iter().map(|v| v.1).collect(),
                uvs: vertices.iter().map(|v| v.2).collect(),
                colours: vertices.iter().filter(|_| has_colours).map(|v| v.3).collect(),
                indices: triangles.into_iter().flatten().map(|i| i % count).collect(),
                material,
                ..Primitive::default()
            }
        },
    )
}

fn motion() -> impl Strategy<Value = Motion> {
    let turn = (point(), direction(), number()).prop_map(|(centre, axis, pace)| Motion::Rotation {
        centre,
        axis,
        radians_per_second: pace,
    });
    prop_oneof![Just(Motion::Still), turn]
}

fn instance() -> impl Strategy<Value = Instance> {
    let scale = [0.1f32..5.0, -5.0f32..-0.1, 0.1f32..5.0].prop_map(|s| Mat4::from_scale(s.into()));
    (".{0,8}", 0..2usize, rigid(), scale, motion(), any::<bool>()).prop_map(
        |(name, mesh, pose, scale, motion, casts)| Instance {
            name,
            mesh,
            world_from_mesh: pose * scale,
            motion,
            casts,
            node: None,
            skin: None,
        },
    )
}

fn camera() -> impl Strategy<Value = Camera> {
    let lens = prop_oneof![
        (0.01f32..3.0).prop_map(|fov_y| Lens::Perspective { fov_y }),
        (0.01f32..1e4).prop_map(|half_height| Lens::Orthographic { half_height }),
    ];
    (".{0,8}", rigid(), lens, 1e-3f32..10.0, 11.0f32..1e5).prop_map(
        |(name, world_from_camera, lens, near, far)| Camera { name, world_from_camera, lens, near, far },
    )
}

fn light() -> impl Strategy<Value = Light> {
    let near = prop_oneof![Just(0.0f32), 1e-3f32..10.0];
    let range = prop_oneof![Just(f32::INFINITY), 0.1f32..1e4];
    let kind = prop_oneof![
        Just(LightKind::Directional),
        range.clone().prop_map(|range| LightKind::Point { range }),
        (0.0f32..0.7, 0.8f32..=FRAC_PI_2, range).prop_map(|(inner, outer, range)| LightKind::Spot {
            inner,
            outer,
            range
        }),
    ];
    (".{0,8}", rigid(), [0.0f32..1.0, 0.0f32..1.0, 0.0f32..1.0], 0.0f32..1e5, kind, near, motion()).prop_map(
        |(name, world_from_light, colour, intensity, kind, near, motion)| Light {
            name,
            world_from_light,
            colour: colour.into(),
            intensity,
            kind,
            near,
            motion,
        },
    )
}

/// Numbers of a material: colour, shares and the scale of normals, emission, what it has, and its coverage.
type Numbers = ([f32; 4], [f32; 4], [f32; 3], [bool; 6], (Alpha, f32));

fn material(i: usize, textures: usize, numbers: Numbers) -> Material {
    let (colour, [a, b, c, scale], light, has, (alpha, transmission)) = numbers;
    let is_there = i < textures;
    let map = |has: bool| (is_there && has).then_some(Map { texture: i, picture_from_uv: Affine2::IDENTITY });
    Material {
        name: format!("m{i}"),
        base_colour: Vec4::from(colour),
        texture: is_there.then_some(i),
        metallic: a,
        roughness: b,
        specular: if has[0] { 1.0 } else { c },
        emission: Vec3::from(light) * f32::from(u8::from(has[1])),
        unlit: has[2],
        alpha,
        transmission,
        casts: i != 2,
        maps: Maps {
            metallic_roughness: map(has[3]),
            normal: map(has[4]).map(|map| (map, scale)),
            occlusion: map(has[5]).map(|map| (map, c)),
            emission: map(has[1]),
        },
    }
}

/// An alpha, and what is transmitted.
fn coverage() -> impl Strategy<Value = (Alpha, f32)> {
    let mask = prop_oneof![Just(0.0), Just(0.5), -2.0f32..2.0].prop_map(|cutoff| Alpha::Mask { cutoff });
    let alpha = prop_oneof![Just(Alpha::Opaque), Just(Alpha::Blend), mask];
    (alpha, prop_oneof![Just(0.0f32), Just(1.0), 0.0f32..1.0])
}

fn scene() -> impl Strategy<Value = Scene> {
    let meshes = [vec(primitive(), 1..4), vec(primitive(), 1..4)]
        .prop_map(|[a, b]| vec![Mesh::new("", &a), Mesh::new("b", &b)]);
    let colour = [-2.0f32..2.0, 0.0f32..1.0, 0.0f32..1.0, 0.0f32..1.0];
    let shares = [0.0f32..=1.0, 0.0f32..=1.0, 0.0f32..=1.0, -3.0f32..=3.0];
    let emission = [0.0f32..1e4, 0.0f32..1e4, 0.0f32..1.0];
    let colours = vec((colour, shares, emission, any::<[bool; 6]>(), coverage()), 3);
    let picture = (1..5u32, 1..5u32).prop_flat_map(|(width, height)| {
        vec(any::<u8>(), 4 * (width * height) as usize).prop_map(move |rgba| Texture {
            name: "picture".to_owned(),
            width,
            height,
            rgba,
        })
    });
    let path = vec((point(), point()), 1..6);
    let views = (vec(camera(), 1..3), vec(light(), 1..4), path);
    (meshes, vec(instance(), 1..6), colours, vec(picture, 0..3), views)
        .prop_map(|(meshes, instances, colours, textures, (cameras, lights, path))| Scene {
            exposed_for: (lights.len() > 1).then_some(0.1),
            name: "random".to_owned(),
            meshes,
            instances,
            materials: (0..).zip(colours).map(|(i, numbers)| material(i, textures.len(), numbers)).collect(),
            textures,
            cameras,
            lights,
            path: CameraPath {
                keys: path.into_iter().map(|(eye, target)| PathKey { eye, target }).collect(),
            },
            rig: Rig::default(),
            environment: None,
            origin: DVec3::ZERO,
        })
        .prop_filter("something has a size", |scene| {
            scene.bounds_in(&scene.pose(0.0)).size().max_element() > 1e-6
        })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn random_scenes_survive(scene in scene()) {
        assert_survives(&scene);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20_000))]

    #[test]
    fn every_finite_float_survives_the_text_between(x in any::<f32>().prop_filter("finite", |x| x.is_finite())) {
        let text = gltf::json::serialize::to_string(&x).unwrap();
        let again: f32 = gltf::json::deserialize::from_str(&text).unwrap();
        prop_assert_eq!(again.to_bits(), x.to_bits(), "{}", text);
    }
}

/// A bumpy field of `side` × `side` × 2 triangles.
fn field(side: u32) -> Primitive {
    let mut field = Primitive::default();
    for z in 0..=side {
        for x in 0..=side {
            let (u, v) = (x as f32 / side as f32, z as f32 / side as f32);
            field.positions.push(Vec3::new(u * 30.0, (u * 9.0).sin() * (v * 7.0).cos(), v * 30.0));
            field.normals.push(Vec3::new(-(u * 9.0).cos(), 2.0, (v * 7.0).sin()).normalize_or_zero());
            field.uvs.push(Vec2::new(u, v));
        }
    }
    let row = side + 1;
    for z in 0..side {
        for x in 0..side {
            let i = z * row + x;
            field.indices.extend([i, i + row, i + 1, i + 1, i + row, i + row + 1]);
        }
    }
    field
}

fn large_scene() -> Scene {
    let mesh = Mesh::new("hills", &[field(100), Primitive { material: 1, ..field(60) }, field(40)]);
    Scene {
        name: "large".to_owned(),
        meshes: vec![mesh],
        instances: (0..50)
            .map(|i| Instance::still(0, Mat4::from_translation(Vec3::X * 0.1 * i as f32)))
            .collect(),
        materials: vec![Material::plain("grass", 0.1, 0.4, 0.2), Material::plain("rock", 0.3, 0.3, 0.3)],
        cameras: vec![Camera::looking("c", Vec3::splat(40.0), Vec3::ZERO, 1.0, 0.1, 200.0)],
        lights: vec![Light::sun(Vec3::new(-0.4, -1.0, -0.3), 3.0)],
        path: CameraPath { keys: vec![PathKey { eye: Vec3::ONE, target: Vec3::ZERO }] },
        ..Scene::default()
    }
}

#[test]
fn a_scene_of_many_parts_survives() {
    let scene = large_scene();
    assert!(scene.meshes[0].parts.len() > 16, "{} parts", scene.meshes[0].parts.len());
    assert_survives(&scene);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    // Few different places make many equal centroids, where halves are hardest to tell apart.
    #[test]
    fn cutting_a_mesh_that_was_cut_changes_nothing(
        positions in vec([0..5i8, 0..3i8, 0..4i8].prop_map(|p| Vec3::from(p.map(f32::from))), 40),
        indices in vec(0..40u32, 3 * 2049..3 * 9000),
    ) {
        let count = positions.len();
        let indices = indices[..indices.len() / 3 * 3].to_vec();
        let soup = Primitive { positions, normals: vec![Vec3::Y; count], uvs: vec![Vec2::ZERO; count], indices, ..Primitive::default() };
        let mesh = Mesh::new("soup", std::slice::from_ref(&soup));
        let again = Mesh::new("soup", &[Primitive { indices: mesh.indices.clone(), ..soup }]);
        prop_assert!(mesh.parts.len() > 1, "cut");
        prop_assert_eq!(again.indices, mesh.indices);
        prop_assert_eq!(again.parts, mesh.parts);
    }
}

#[test]
fn spots_as_wide_as_gltf_allows_survive() {
    let mut scene = large_scene();
    let almost = FRAC_PI_2.next_down();
    scene.lights = [(0.0, FRAC_PI_2), (almost, FRAC_PI_2), (0.5, almost), (0.0, 1e-3)]
        .map(|(inner, outer)| Light::spot("spot", Vec3::Y * 9.0, Vec3::ZERO, inner, outer, 20.0, 80.0))
        .to_vec();
    assert_survives(&scene);
}

#[test]
fn the_file_is_valid_where_readers_are_strict() {
    let bytes = to_glb(&large_scene()).unwrap();
    assert_eq!(bytes.len() % 4, 0);
    assert_eq!(bytes[8..12], (bytes.len() as u32).to_le_bytes());
    // This reader validates, and wants the extent of positions.
    let gltf::Gltf { document, blob } = gltf::Gltf::from_slice(&bytes).unwrap();
    let used: Vec<&str> = document.extensions_used().collect();
    // The built-in worlds' surfaces reflect nothing, which the format has a word for.
    assert_eq!(used, ["KHR_materials_specular", "KHR_lights_punctual"]);
    let length = blob.unwrap().len();
    for view in document.views() {
        assert!(view.offset() % 4 == 0 && view.offset() + view.length() <= length, "{}", view.index());
    }
}

#[test]
fn what_cannot_be_drawn_is_left_out() {
    let mut scene = large_scene();
    scene.meshes.insert(0, Mesh::new("nothing", &[]));
    scene.instances.push(Instance::still(1, Mat4::IDENTITY));
    for instance in &mut scene.instances[..10] {
        instance.mesh = 1;
    }
    let again = load_glb_bytes(&to_glb(&scene).unwrap(), "again.glb").unwrap().scene;
    assert_eq!((again.meshes.len(), again.instances.len()), (1, 11));
}

#[test]
fn scenes_that_contradict_themselves_are_not_written() {
    let spoils: [fn(&mut Scene); 12] = [
        |scene| scene.instances[0].mesh = 7,
        |scene| scene.instances[0].world_from_mesh.w_axis.x = f32::NAN,
        |scene| scene.meshes[0].positions[0].x = f32::INFINITY,
        |scene| scene.meshes[0].normals.truncate(2),
        |scene| scene.meshes[0].indices[0] = u32::MAX,
        |scene| scene.meshes[0].parts[0].material = 9,
        |scene| scene.materials[0].texture = Some(0),
        |scene| scene.materials[0].alpha = Alpha::Mask { cutoff: f32::INFINITY },
        |scene| scene.materials[0].transmission = f32::NAN,
        |scene| scene.cameras[0].far = f32::NAN,
        |scene| {
            scene.lights[0].motion =
                Motion::Rotation { centre: Vec3::ZERO, axis: Vec3::Y, radians_per_second: f32::NAN };
        },
        |scene| scene.path.keys[0].eye.y = f32::NAN,
    ];
    for (i, spoil) in spoils.iter().enumerate() {
        let mut scene = large_scene();
        spoil(&mut scene);
        let error = to_glb(&scene).unwrap_err().to_string();
        assert!(error.ends_with("in scene \"large\"") && !error.contains('\n'), "spoil {i}: {error}");
    }
}

/// The corners of every triangle where it stands, as bits, in some order that does not depend on the file.
fn corners(scene: &Scene) -> Vec<[u32; 9]> {
    let mut corners = Vec::new();
    for Instance { mesh, world_from_mesh, .. } in &scene.instances {
        let Mesh { positions, indices, .. } = &scene.meshes[*mesh];
        for triangle in indices.chunks_exact(3) {
            let place = |i: u32| world_from_mesh.transform_point3(positions[i as usize]).to_array();
            let bits: Vec<u32> = triangle.iter().flat_map(|i| place(*i)).map(f32::to_bits).collect();
            corners.push(bits.try_into().expect("three corners"));
        }
    }
    corners.sort_unstable();
    corners
}

#[test]
fn parts_that_are_written_apart_are_the_same_triangles_and_share_no_vertices() {
    let scene = worlds::build("dragon", 0).expect("a world");
    let glb = to_glb_with(&scene, Vertices::Apart).expect("a file");
    let read = load_glb_bytes(&glb, "dragon").expect("a scene").scene;
    assert_eq!(corners(&read), corners(&scene));
    let json = gltf::Gltf::from_slice(&glb).expect("glTF").document;
    let primitives: Vec<gltf::Primitive<'_>> =
        json.meshes().flat_map(|mesh| mesh.primitives().collect::<Vec<_>>()).collect();
    let mut seen = std::collections::BTreeSet::new();
    for primitive in &primitives {
        let positions = primitive.get(&gltf::Semantic::Positions).expect("positions");
        let triangles = primitive.indices().expect("indices").count() / 3;
        assert!(
            positions.count() <= 3 * triangles,
            "{} vertices of {triangles} triangles",
            positions.count()
        );
        assert!(seen.insert(positions.index()), "its own");
    }
    assert!(primitives.len() > scene.meshes.len(), "there are meshes of several parts");
}
