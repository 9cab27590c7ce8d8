//! The truth of a scene does not depend on how large it is, or on where in the world it stands; and it is known at
//! grazing light.

use glam::{DVec3, Mat4, Vec2, Vec3};
use proptest::prelude::*;
use umbrage_judge::{Eye, Light, Pixel, Truth, World};
use umbrage_scene::{Camera, Instance, Material, Mesh, Pose, Primitive, Scene};

/// A surface of these triangles.
fn surface(triangles: &[[Vec3; 3]]) -> Primitive {
    let positions: Vec<Vec3> = triangles.as_flattened().to_vec();
    let count = positions.len();
    let indices = (0..count as u32).collect();
    Primitive {
        positions,
        normals: vec![Vec3::Y; count],
        uvs: vec![Vec2::ZERO; count],
        indices,
        ..Primitive::default()
    }
}

/// A square of ground, two metres about its middle, and a tetrahedron of about one.
fn meshes() -> Vec<Mesh> {
    let corner = |x: f32, z: f32| Vec3::new(x, 0.0, z);
    let [a, b, c, d] = [corner(-1.0, -1.0), corner(-1.0, 1.0), corner(1.0, 1.0), corner(1.0, -1.0)];
    let ground = surface(&[[a, b, c], [a, c, d]]);
    let [a, b, c, d] = [
        Vec3::new(0.0, 1.0, 0.0),
        Vec3::new(-0.5, 0.1, -0.4),
        Vec3::new(0.6, 0.2, -0.3),
        Vec3::new(0.1, 0.3, 0.7),
    ];
    let solid = surface(&[[a, b, c], [a, c, d], [a, d, b], [b, d, c]]);
    vec![Mesh::new("ground", &[ground]), Mesh::new("solid", &[solid])]
}

/// A ground of 16 m and solids on it, `scale` times as large, and moved by `shift`, metres.
fn scene(places: &[Vec3], scale: f32, shift: Vec3) -> Scene {
    let at = |mesh, size: f32, place: Vec3| {
        let here =
            Mat4::from_translation(place * scale + shift) * Mat4::from_scale(Vec3::splat(size * scale));
        Instance::still(mesh, here)
    };
    let solids = places.iter().map(|place| at(1, 1.0, *place));
    Scene {
        meshes: meshes(),
        instances: std::iter::once(at(0, 16.0, Vec3::ZERO)).chain(solids).collect(),
        materials: vec![Material::plain("m", 1.0, 1.0, 1.0)],
        ..Scene::default()
    }
}

/// What is true of it under one of three lights: a sun of 20°, one of 0.2°, and a lamp 3 m above the ground.
fn truth(places: &[Vec3], light: usize, scale: f32, shift: Vec3) -> Truth {
    let at = |x, y, z| Vec3::new(x, y, z) * scale + shift;
    let camera =
        Camera::looking("c", Vec3::new(6.0, 4.0, 8.0) * scale, Vec3::ZERO, 1.0, 0.1 * scale, 100.0 * scale);
    let mut moved = camera;
    moved.world_from_camera.w_axis += shift.extend(0.0);
    let light = match light {
        0 => Light::sun(Vec3::new(0.8, -0.364, 0.6)),
        1 => Light::sun(Vec3::new(0.8, -0.0035, 0.6)),
        _ => Light::Point { position: at(1.0, 3.0, -2.0).as_dvec3(), range: f64::INFINITY, near: 0.0 },
    };
    let world = World::new(&scene(places, scale, shift), &Pose::default());
    Truth::new(&world, &Eye::new(&moved, 96, 64), &light, f64::from(100.0 * scale))
}

/// How many pixels are judged in both, and in how many of those they differ.
fn compare(a: &Truth, b: &Truth) -> (usize, usize) {
    let pairs = a.pixels.iter().zip(&b.pixels).filter(|(a, b)| a.is_judged() && b.is_judged());
    (pairs.clone().count(), pairs.filter(|(a, b)| a != b).count())
}

/// Places on a grid of sixteenths of a metre, which moves of up to 2¹⁹ m keep exact.
fn places() -> impl Strategy<Value = Vec<Vec3>> {
    let place = (-80i32..80, 0i32..20, -80i32..80)
        .prop_map(|(x, y, z)| Vec3::new(x as f32, y as f32, z as f32) / 16.0);
    prop::collection::vec(place, 1..6)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn a_scene_of_another_size_has_the_same_truth(places in places(), light in 0usize..3, exponent in -10i32..=10) {
        let metres = truth(&places, light, 1.0, Vec3::ZERO);
        let scaled = truth(&places, light, 2f32.powi(exponent), Vec3::ZERO);
        prop_assert_eq!(&scaled.pixels, &metres.pixels, "powers of two change no bit");
        // Others round: a pixel in a thousand may lie on an edge.
        let scaled = truth(&places, light, 10f32.powi(exponent.clamp(-6, 6)), Vec3::ZERO);
        let (judged, differ) = compare(&metres, &scaled);
        prop_assert!(judged > 1000 && differ * 1000 <= judged, "{} of {}", differ, judged);
        prop_assert!(scaled.judged().abs_diff(metres.judged()) * 500 <= judged, "{} {}", scaled.judged(), metres.judged());
    }

    #[test]
    fn a_scene_that_stands_elsewhere_has_the_same_truth(places in places(), light in 0usize..3, exponent in 0i32..=19, way in 0usize..3) {
        let mut shift = Vec3::ZERO;
        shift[way] = 2f32.powi(exponent);
        let here = truth(&places, light, 1.0, Vec3::ZERO);
        let there = truth(&places, light, 1.0, shift);
        let (judged, differ) = compare(&here, &there);
        prop_assert!(judged > 1000 && differ * 1000 <= judged, "{} of {}", differ, judged);
        // A lamp at 500 km is known to 12 cm, so that what it grazes is not.
        let lost = if light == 2 { 0.3 } else { 0.002 };
        prop_assert!(there.judged() as f64 >= (1.0 - lost) * here.judged() as f64, "{} {}", there.judged(), here.judged());
    }
}

#[test]
fn a_floor_is_judged_at_any_angle_above_rounding() {
    for elevation in [1e-6f64, 1e-5, 1e-4, 1e-3, 0.02, 0.5] {
        let light = Light::Sun { to_light: DVec3::new(elevation.cos(), elevation.sin(), 0.0) };
        let world = World::new(&scene(&[], 1.0, Vec3::ZERO), &Pose::default());
        let camera = Camera::looking("c", Vec3::new(0.0, 4.0, 6.0), Vec3::ZERO, 1.0, 0.1, 100.0);
        let truth = Truth::new(&world, &Eye::new(&camera, 64, 64), &light, 100.0);
        assert_eq!(truth.count(Pixel::Ambiguous), 0, "elevation {elevation}");
        assert_eq!(truth.judged(), truth.count(Pixel::Lit), "elevation {elevation}");
        assert!(truth.judged() > 2000, "elevation {elevation}: {}", truth.judged());
    }
}

#[test]
fn a_surface_that_rounding_may_have_turned_away_is_ambiguous_and_counted() {
    let world = World::new(&scene(&[], 1.0, Vec3::ZERO), &Pose::default());
    let camera = Camera::looking("c", Vec3::new(0.0, 4.0, 6.0), Vec3::ZERO, 1.0, 0.1, 100.0);
    let of = |elevation: f64| {
        let light = Light::Sun { to_light: DVec3::new(elevation.cos(), elevation.sin(), 0.0) };
        Truth::new(&world, &Eye::new(&camera, 64, 64), &light, 100.0)
    };
    for elevation in [0.0, 1e-8, -1e-8, 1e-7] {
        let truth = of(elevation);
        assert_eq!((truth.judged(), truth.count(Pixel::TurnedAway)), (0, 0), "elevation {elevation}");
        assert!(truth.count(Pixel::Ambiguous) > 2000, "elevation {elevation}");
    }
    assert_eq!(of(-1e-6).count(Pixel::Ambiguous), 0, "it is turned away for sure");
}

#[test]
fn a_wall_a_kilometre_long_shadows_a_floor_at_a_tenth_of_a_degree() {
    // 1 m high and 100 m away: its shadow is 573 m long at 0.1°, and 57 m at 1°.
    let corner = |x, z| Vec3::new(x, 0.0, z) * 1000.0;
    let [a, b, c, d] = [corner(-1.0, -1.0), corner(-1.0, 1.0), corner(1.0, 1.0), corner(1.0, -1.0)];
    let at = |y, z| Vec3::new(100.0, y, z);
    let [e, f, g, h] = [at(0.0, -500.0), at(0.0, 500.0), at(1.0, 500.0), at(1.0, -500.0)];
    let world = World::of_triangles(vec![[a, b, c], [a, c, d], [e, f, g], [e, g, h]]);
    let camera = Camera::looking("c", Vec3::new(0.0, 4.0, 6.0), Vec3::ZERO, 1.0, 0.1, 100.0);
    for (degrees, wanted) in [(0.1f64, Pixel::Shadowed), (1.0, Pixel::Lit)] {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        let light = Light::Sun { to_light: DVec3::new(cosine, sine, 0.0) };
        let truth = Truth::new(&world, &Eye::new(&camera, 64, 64), &light, 20.0);
        assert!(
            truth.judged() > 1500 && truth.count(wanted) == truth.judged(),
            "{degrees}°: {}",
            truth.count(wanted)
        );
    }
}

#[test]
fn what_casts_nothing_is_seen_and_shadows_nothing() {
    let count = |casts: [bool; 3]| {
        let mut scene = scene(&[Vec3::new(0.0, 1.0, 0.0)], 1.0, Vec3::ZERO);
        scene.instances[1].casts = casts[0];
        scene.instances[0].casts = casts[1];
        scene.materials[0].casts = casts[2];
        let world = World::new(&scene, &Pose::default());
        let camera = Camera::looking("c", Vec3::new(3.0, 4.0, 6.0), Vec3::ZERO, 1.0, 0.1, 100.0);
        let truth = Truth::new(&world, &Eye::new(&camera, 64, 64), &Light::sun(Vec3::NEG_Y), 100.0);
        (truth.count(Pixel::Shadowed), truth.count(Pixel::Sky))
    };
    let (shadowed, sky) = count([true; 3]);
    assert!(shadowed > 10, "{shadowed}");
    assert_eq!(count([false, true, true]), (0, sky), "the solid is still seen");
    assert_eq!(count([true, false, true]), (shadowed, sky), "the ground shadows nothing that is seen");
    assert_eq!(count([true, true, false]), (0, sky), "a material casts nothing, whatever is made of it");
}

#[test]
fn a_bulb_around_its_lamp_casts_nothing_within_the_lamps_near_distance() {
    let mut scene = scene(&[], 1.0, Vec3::ZERO);
    let bulb = Mat4::from_translation(Vec3::new(0.0, 2.0, 0.0)) * Mat4::from_scale(Vec3::splat(0.125));
    scene.instances.push(Instance::still(1, bulb));
    let world = World::new(&scene, &Pose::default());
    let camera = Camera::looking("c", Vec3::new(0.0, 1.5, 6.0), Vec3::ZERO, 0.8, 0.1, 100.0);
    let inside = DVec3::new(0.006, 2.05, 0.0);
    // The solid's corners are within 0.13 m of it.
    for (near, dark) in [(0.0, true), (0.001, true), (0.15, false)] {
        for light in [
            Light::Point { position: inside, range: f64::INFINITY, near },
            Light::Spot {
                position: inside,
                along: DVec3::NEG_Y,
                cos_outer: 0.02,
                range: f64::INFINITY,
                near,
            },
        ] {
            let truth = Truth::new(&world, &Eye::new(&camera, 64, 64), &light, 100.0);
            let wanted = if dark { Pixel::Shadowed } else { Pixel::Lit };
            let ground = truth
                .receivers
                .iter()
                .zip(&truth.pixels)
                .filter(|(r, _)| r.is_some_and(|r| r.position.y < 1e-9));
            assert!(ground.clone().count() > 500, "the ground is in sight");
            assert!(ground.clone().all(|(_, pixel)| *pixel == wanted), "near {near}: {light:?}");
        }
    }
}
