//! Rays that meet nothing but edges and corners, or lie in the plane of a triangle.

use glam::{Mat4, Vec2, Vec3};
use umbrage_render::umbrage::{Exact, Settings};
use umbrage_render::{Frame, Point, Renderer, Show};
use umbrage_scene::{Camera, Instance, Light, Material, Mesh, Primitive, Scene};

use crate::{asked, facing, gpu};

/// A net of triangles over the ground plane's middle, bent up and down, whose corners lie on whole metres.
fn net(side: u32) -> Mesh {
    let corners = || (0..=side).flat_map(|z| (0..=side).map(move |x| [x, z]));
    let place = |[x, z]: [u32; 2]| {
        let up = ((x * 7 + z * 5) % 4) as f32 / 4.0;
        Vec3::new(x as f32, 4.0 + up, z as f32) - 0.5 * side as f32 * Vec3::new(1.0, 0.0, 1.0)
    };
    let corner = |x: u32, z: u32| z * (side + 1) + x;
    let square = |[x, z]: [u32; 2]| {
        let [a, b, c, d] = [corner(x, z), corner(x + 1, z), corner(x, z + 1), corner(x + 1, z + 1)];
        [a, c, b, b, c, d]
    };
    let squares = (0..side).flat_map(|z| (0..side).map(move |x| [x, z]));
    let count = corners().count();
    let primitive = Primitive {
        positions: corners().map(place).collect(),
        normals: vec![Vec3::Y; count],
        uvs: vec![Vec2::ZERO; count],
        indices: squares.flat_map(square).collect(),
        ..Primitive::default()
    };
    Mesh::new("net", &[primitive])
}

fn scene(mesh: Mesh, world_from_mesh: Mat4, lights: Vec<Light>) -> Scene {
    Scene {
        meshes: vec![mesh],
        instances: vec![Instance::still(0, world_from_mesh)],
        materials: vec![Material::plain("solid", 0.5, 0.5, 0.5)],
        lights,
        ..Scene::default()
    }
}

#[test]
fn no_ray_slips_through_a_shared_edge_or_corner() {
    const SIDE: u32 = 16;
    // Under every corner, and under the middles of edges in both directions and of diagonals.
    let inner = |at: u32| at as f32 * 0.5 - 0.5 * SIDE as f32;
    let grid = (1..2 * SIDE).flat_map(|z| (1..2 * SIDE).map(move |x| Vec3::new(inner(x), 0.0, inner(z))));
    let places: Vec<Vec3> = grid.collect();
    let matrices = [
        ("as it is", Mat4::IDENTITY),
        ("mirrored and stretched", Mat4::from_scale(Vec3::new(-3.0, 0.1, 1.7))),
        ("turned", Mat4::from_rotation_y(0.7) * Mat4::from_rotation_z(0.2)),
    ];
    for (name, world_from_mesh) in matrices {
        // A sun down the mesh's own axis meets edges exactly; a lamp far above nearly.
        let below = |place: &Vec3| world_from_mesh.transform_point3(*place);
        let down = world_from_mesh.transform_vector3(-Vec3::Y);
        let lamp = world_from_mesh.transform_point3(Vec3::new(0.0, 40.0, 0.0));
        let lights = vec![Light::sun(down, 1.0), Light::point("lamp", lamp, 1000.0, 1.0)];
        let points = |light: &Light| places.iter().map(|place| facing(light, below(place))).collect();
        let points: Vec<Vec<Point>> = lights.iter().map(points).collect();
        let answers = asked(&gpu(), &scene(net(SIDE), world_from_mesh, lights), Vec3::ZERO, &points);
        for (light, answers) in answers.iter().enumerate() {
            let lit = answers.iter().filter(|answer| **answer > 0.0).count();
            assert_eq!(lit, 0, "{name}, light {light}: {lit} of {} rays slip through", answers.len());
        }
    }
}

#[test]
fn rays_in_the_plane_of_a_triangle_are_lit_or_dark_and_nothing_else() {
    let wall = Mesh::new(
        "wall",
        &[Primitive {
            positions: vec![Vec3::ZERO, 4.0 * Vec3::Y, Vec3::new(4.0, 4.0, 0.0), 4.0 * Vec3::X],
            normals: vec![Vec3::Z; 4],
            uvs: vec![Vec2::ZERO; 4],
            indices: vec![0, 1, 2, 0, 2, 3],
            ..Primitive::default()
        }],
    );
    let lights = vec![Light::sun(-Vec3::Y, 1.0), Light::point("lamp", Vec3::new(1.0, 9.0, 0.0), 1000.0, 1.0)];
    // Below the wall, in it, on its corners, and beside it.
    let at = |i: u32| Vec3::new((i % 9) as f32 * 0.5, (i / 9) as f32 - 2.0, 0.0);
    let places: Vec<Vec3> = (0..81).map(at).chain((0..81).map(|i| at(i) + 0.5 * Vec3::Z)).collect();
    let points = |light: &Light| places.iter().map(|place| facing(light, *place)).collect();
    let points: Vec<Vec<Point>> = lights.iter().map(points).collect();
    for answers in asked(&gpu(), &scene(wall, Mat4::IDENTITY, lights), Vec3::ZERO, &points) {
        assert!(answers.iter().all(|answer| *answer == 0.0 || *answer == 1.0), "{answers:?}");
        assert!(answers[81..].iter().all(|answer| *answer == 1.0), "nothing is over what is beside it");
    }
}

#[test]
fn pixels_of_several_samples_have_no_dots_where_triangles_meet() {
    // From so high a sun nothing of the net lies in shadow, and many of its edges are bent inward.
    let flat = Mat4::from_scale(Vec3::new(1.0, 0.4, 1.0));
    let scene = scene(net(40), flat, vec![Light::sun(Vec3::new(0.1, -1.0, 0.05), 1.0)]);
    let (eye, target) = (Vec3::new(3.0, 9.0, 24.0), Vec3::new(0.0, 1.5, 0.0));
    let camera = Camera::looking("over", eye, target, 0.9, 0.5, 100.0);
    let frame = Frame::of(&camera, &scene.lights, &Default::default(), [320, 200], Show::World);
    let frame = Frame { samples: 4, haze: false, ..frame.expect("a good camera") };
    let gpu = gpu();
    let picture = |exact, show| {
        let settings = Settings { exact, ..Settings::default() };
        let mut renderer = Renderer::new(&gpu, &scene, settings).expect("a renderer");
        let drawn = renderer.render(&Frame { show, ..frame.clone() }).expect("a frame").drawn;
        drawn.picture().expect("a picture").rgba
    };
    let lit = picture(Exact::Off, Show::Unshadowed);
    for exact in [Exact::Undecided, Exact::Always] {
        let traced = picture(exact, Show::World);
        let pixels = lit.chunks_exact(4).zip(traced.chunks_exact(4));
        let darker = pixels.filter(|(lit, traced)| lit[0].abs_diff(traced[0]) > 2).count();
        println!("{exact:?}: {darker} of {} pixels are darker", lit.len() / 4);
        // Rasterisers put corners on a grid of 1/256 of a pixel, so that a place may still lie beside its triangle.
        assert!(darker * 1000 < lit.len() / 4, "{exact:?}: {darker} of {} pixels", lit.len() / 4);
    }
}
