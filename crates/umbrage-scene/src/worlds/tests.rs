mod rigged;
mod surveyed;
mod views;

use std::f64::consts::PI;

use glam::{DVec3, Mat4, Vec3};

use super::*;
use crate::{Lens, Light, LightKind, Pose};

/// What a world is to be: name, triangles, area in km², casters, moving ones, and near and far of the main camera.
type Row = (&'static str, usize, f32, usize, usize, [f32; 2]);

const TABLE: [Row; 17] = [
    ("primitives", 1_300, 0.0016, 17, 0, [1.0, 80.0]),
    // The solids turn, and the lamp flies with the light.
    ("orbit", 1_300, 0.0016, 8, 8, [1.0, 80.0]),
    ("bunny", 3_676, 0.0009, 1, 0, [0.5, 100.0]),
    ("tutorial-room", 4_714, 0.0016, 8, 0, [0.5, 100.0]),
    ("bias-court", 21_848, 0.001024, 17, 0, [0.2, 100.0]),
    ("closed-room", 22_352, 12.6e-3 * 9.6e-3, 23, 0, [0.1, 30.0]),
    ("dragon", 47_796, 0.0009, 1, 0, [0.5, 100.0]),
    ("brick-ground", 60_000, 0.04, 64, 6, [0.5, 200.0]),
    ("robot-war", 240_000, 1.44, 160, 0, [1.0, 800.0]),
    ("huge-chessboard", 51_000, 0.49, 32, 0, [1.0, 800.0]),
    ("night-chessboard", 54_000, 0.49, 32 + 12, 0, [1.0, 800.0]),
    ("knights", 1_000_000, 1.6, 60, 30, [1.0, 800.0]),
    // A windmill is a tower and a rotor.
    ("mining-terrain", 1_300_000, 2.56, 10 + 2 * 15 + 20 + 10, 25, [1.0, 1000.0]),
    // A quarter of the land is 5.12 km wide.
    ("survey", 953_000, 26.2144, 3138, 0, [1.0, 5000.0]),
    // Eight trees of 17 boughs, three poplars and five swathes of tall grass move in the wind.
    ("grove", 248_904, 1.0, 3923, 8 * 17 + 3 + 5, [0.3, 560.0]),
    // People, flags and bunting, a carousel with horses, signs, pinwheels and bulbs.
    ("village-fair", 338_000, 0.0144, 219, 100 + 12 + 13 + 7 + 4 + 11, [0.25, 110.0]),
    // Five hangings move in the draught.
    ("atrium", 67_456, 0.002304, 130, 5, [0.3, 45.0]),
];

/// The surfaces that others stand on.
fn is_ground(scene: &Scene, mesh: usize) -> bool {
    ["ground", "frame"].contains(&scene.meshes[mesh].name.as_str())
}

/// The height of the ground at the (x, z) of `point`; minus infinity beyond its edge.
fn height_below(scene: &Scene, point: Vec3) -> f32 {
    let mut highest = f32::NEG_INFINITY;
    for instance in scene.instances.iter().filter(|i| is_ground(scene, i.mesh)) {
        let (mesh, at) = (&scene.meshes[instance.mesh], instance.world_from_mesh);
        let over = |b: crate::Aabb| {
            let b = b.transformed(&at);
            b.min.x <= point.x && point.x <= b.max.x && b.min.z <= point.z && point.z <= b.max.z
        };
        for part in mesh.parts.iter().filter(|part| over(part.bounds)) {
            for t in mesh.indices[part.indices.start as usize..part.indices.end as usize].as_chunks().0 {
                let [a, b, c] = (*t as [u32; 3]).map(|i| at.transform_point3(mesh.positions[i as usize]));
                let area = |p: Vec3, q: Vec3, r: Vec3| (q - p).cross(r - p).y;
                let (whole, u, v) = (area(a, b, c), area(a, point, c), area(a, b, point));
                let (u, v) = (u / whole, v / whole);
                if whole > 0.0 && u >= -1e-4 && v >= -1e-4 && u + v <= 1.0001 {
                    highest = highest.max(a.y + (b.y - a.y) * u + (c.y - a.y) * v);
                }
            }
        }
    }
    highest
}

fn assert_as_tabled(scene: &Scene, (name, triangles, area, casters, moving, [near, far]): Row) {
    assert_eq!(scene.name, name);
    let off = scene.triangles().abs_diff(triangles) as f32 / triangles as f32;
    assert!(off <= 0.02, "{name} has {} triangles, wanted {triangles}", scene.triangles());
    let grounds = scene.instances.iter().filter(|i| scene.meshes[i.mesh].name == "ground");
    let sides = grounds.map(|i| scene.meshes[i.mesh].bounds.transformed(&i.world_from_mesh).size());
    let square_metres = sides.map(|size| size.x * size.z).fold(f32::INFINITY, f32::min);
    assert!(
        (square_metres * 1e-6 / area - 1.0).abs() < 0.01,
        "{name} is {square_metres} m², wanted {area} km²"
    );
    let standing = scene.instances.iter().filter(|i| !is_ground(scene, i.mesh));
    assert_eq!(standing.count(), casters, "casters of {name}");
    assert_eq!(scene.instances.iter().filter(|i| i.is_dynamic()).count(), moving, "moving casters of {name}");
    assert_eq!([scene.cameras[0].near, scene.cameras[0].far], [near, far], "depth range of {name}");
}

fn assert_valid(scene: &Scene) {
    for mesh in &scene.meshes {
        let count = mesh.positions.len();
        assert!(mesh.normals.len() == count && mesh.uvs.len() == count, "attributes of {}", mesh.name);
        assert!(mesh.positions.iter().all(|p| p.is_finite()), "positions of {}", mesh.name);
        assert!(mesh.normals.iter().all(|n| n.is_normalized()), "normals of {}", mesh.name);
        assert!(mesh.uvs.iter().all(|uv| uv.is_finite()), "texture coordinates of {}", mesh.name);
        assert!(mesh.indices.iter().all(|&i| (i as usize) < count), "indices of {}", mesh.name);
        assert!(
            mesh.parts.iter().all(|part| part.material < scene.materials.len()),
            "materials of {}",
            mesh.name
        );
    }
    for material in &scene.materials {
        assert!(material.texture.is_none_or(|t| t < scene.textures.len()), "texture of {}", material.name);
    }
    for texture in &scene.textures {
        assert_eq!(texture.rgba.len(), (4 * texture.width * texture.height) as usize, "{}", texture.name);
    }
    assert!(scene.instances.iter().all(|i| i.mesh < scene.meshes.len() && i.world_from_mesh.is_finite()));
}

/// The unit direction in which a light shines at a place; `None` where that is outside its cone or range.
fn shines_along(light: &Light, place: Vec3) -> Option<Vec3> {
    let from_light = place - light.position();
    let along = from_light.normalize_or_zero();
    match light.kind {
        LightKind::Directional => Some(light.direction()),
        LightKind::Point { range } => (from_light.length() <= range).then_some(along),
        LightKind::Spot { inner: _, outer, range } => {
            let inside = light.direction().dot(along) >= outer.cos();
            (inside && from_light.length() <= range).then_some(along)
        }
    }
}

fn assert_seen_well(scene: &Scene) {
    let names: Vec<&str> = scene.cameras.iter().map(|camera| camera.name.as_str()).collect();
    assert_eq!(names[..5], ["main", "far", "close", "split", "dueling"], "cameras of {}", scene.name);
    let duel = &scene.cameras[4];
    let light = shines_along(&scene.lights[0], duel.eye());
    let against = light.map_or(1.0, |along| duel.forward().dot(along));
    assert!(against <= -0.98, "{}: the dueling camera sees {against} along the light", scene.name);
    for camera in &scene.cameras {
        let height = camera.eye().y - height_below(scene, camera.eye());
        assert!(height > 0.5, "{}: camera {} is {height} m above the ground", scene.name, camera.name);
        assert!(matches!(camera.lens, Lens::Perspective { .. }), "{} has perspective", camera.name);
    }
    let steps = 4 * (scene.path.keys.len() - 1);
    for t in (0..=steps).map(|i| i as f32 / steps as f32) {
        let eye = scene.path.world_from_camera(t).map_or(Vec3::ZERO, |m: Mat4| m.w_axis.truncate());
        let height = eye.y - height_below(scene, eye);
        assert!(height > 1.0, "{}: the path is {height} m above the ground at {t}", scene.name);
    }
}

#[test]
fn every_world_is_what_its_table_says_valid_and_seen_well() {
    assert_eq!(ALL.len(), TABLE.len());
    for (world, row) in ALL.iter().zip(TABLE) {
        let scene = world.build(0);
        assert_as_tabled(&scene, row);
        assert_valid(&scene);
        rigged::assert_rig_valid(&scene);
        assert_seen_well(&scene);
        let sunny = scene.lights.iter().any(|light| light.kind == LightKind::Directional);
        assert_eq!(sunny, !views::SUNLESS.contains(&world.name), "{} has a sun", world.name);
    }
}

#[test]
fn a_seed_names_one_world() {
    for world in ALL {
        let [a, b, c] = [5, 5, 6].map(|seed| world.build(seed));
        assert_eq!(a.instances, b.instances, "{} from one seed", world.name);
        let corners =
            |scene: &Scene| scene.meshes.iter().map(|mesh| mesh.positions.clone()).collect::<Vec<_>>();
        assert!(corners(&a) == corners(&b), "shapes of {} from one seed", world.name);
        assert_ne!(a.instances, c.instances, "{} from two seeds", world.name);
    }
}

#[test]
fn the_light_of_orbit_is_where_the_decks_formula_has_it_and_looks_at_the_middle() {
    let scene = orbit::build(0);
    let light = &scene.lights[0];
    // Shares of the loop that are keys, and that are none.
    for t in [0.0, 0.011, 1.0 / 12.0, 0.237, 0.5, 0.618, 0.8765, 1.0 - 1e-6] {
        let pose = light.world_from_light_in(&scene.pose(t as f32 * orbit::LOOP_SECONDS));
        let (eye, along) = (pose.w_axis.truncate(), -pose.z_axis.truncate());
        let (sin, cos) = ((6.0 * PI * t).sin(), (4.0 * PI * t).cos());
        // A twentieth of the deck's (300 sin 6πt, 200, 100 cos 4πt + 250).
        let deck = DVec3::new(15.0 * sin, 10.0, 5.0 * cos + 12.5).as_vec3();
        assert!(eye.distance(deck) < 1e-4, "{t}: {eye}, not {deck}");
        assert!((eye + along * eye.length()).length() < 1e-3, "{t}: from {eye} along {along}");
    }
    let start = light.world_from_light_in(&scene.pose(0.0));
    assert!(start.abs_diff_eq(light.world_from_light, 1e-6), "it stands where it begins");
    let end = light.world_from_light_in(&scene.pose(orbit::LOOP_SECONDS));
    assert!(end.abs_diff_eq(start, 1e-4), "a whole loop");
}

#[test]
fn the_solids_of_orbit_turn_twice_in_a_loop() {
    let scene = orbit::build(0);
    let solid = &scene.instances[1];
    let at = |share: f32| solid.world_from_mesh_in(&Pose::at(share * orbit::LOOP_SECONDS));
    assert!(at(0.5).abs_diff_eq(at(0.0), 1e-4), "720° at t = 1 are a whole turn at t = 1/2");
    assert!(!at(0.25).abs_diff_eq(at(0.0), 0.5), "half a turn");
}

#[test]
fn the_default_world_exists_and_others_do_not() {
    assert!(ALL.iter().any(|world| world.name == DEFAULT));
    assert!(build("narnia", 0).is_none());
}
