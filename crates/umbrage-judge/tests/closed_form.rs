//! Worlds under suns whose shadows are known in closed form: the tracer must agree with them everywhere but within 1e-4 m
//! of an edge.

mod shapes;

use glam::{DVec3, Vec3};
use shapes::{box_sides, demand, ground, quad, sphere};
use umbrage_judge::{Eye, Light, Pixel, Truth, World};
use umbrage_scene::Camera;

/// The suns that every world is lit by.
const SUNS: [Vec3; 4] =
    [Vec3::NEG_Y, Vec3::new(0.4, -1.0, 0.3), Vec3::new(-0.9, -0.35, 0.2), Vec3::new(0.05, -0.2, -1.0)];

/// A sun that shines along a direction, and the unit direction to it.
fn sun(along: Vec3) -> (Light, DVec3) {
    (Light::sun(along), (-along.as_dvec3()).normalize_or_zero())
}

#[test]
fn a_half_planes_shadow_ends_on_a_line() {
    const HEIGHT: f64 = 2.0;
    let corner = |x, z| Vec3::new(x, HEIGHT as f32, z);
    let plane = quad(corner(-500.0, -500.0), corner(-500.0, 500.0), corner(0.5, 500.0), corner(0.5, -500.0));
    for direction in SUNS {
        let (sun, to_light) = sun(direction);
        let shift = to_light / to_light.y * HEIGHT;
        demand("half-plane", &plane, &sun, |p, grow| (p + shift).x < 0.5 + grow);
    }
}

#[test]
fn a_row_of_boxes_casts_a_row_of_shadows() {
    let boxes: Vec<(DVec3, DVec3)> = (0..5)
        .map(|i| (DVec3::new(f64::from(i) * 3.0 - 7.0, 0.25, -0.5), f64::from(i)))
        .map(|(low, i)| (low, low + DVec3::new(1.0, 0.5 + i * 0.5, 1.5)))
        .collect();
    let casters: Vec<[Vec3; 3]> = boxes.iter().flat_map(|(low, high)| box_sides(*low, *high)).collect();
    for direction in SUNS {
        let (sun, to_light) = sun(direction);
        demand("boxes", &casters, &sun, |p, grow| {
            boxes.iter().any(|(low, high)| meets_box(p, to_light, *low - grow, *high + grow))
        });
    }
}

/// Whether the half-line from `p` along `to_light` meets a box: it is inside all three slabs at once.
fn meets_box(p: DVec3, to_light: DVec3, low: DVec3, high: DVec3) -> bool {
    let (mut enter, mut leave) = (0.0f64, f64::INFINITY);
    for axis in 0..3 {
        if to_light[axis] == 0.0 {
            if p[axis] < low[axis] || p[axis] > high[axis] {
                return false;
            }
            continue;
        }
        let (a, b) = ((low[axis] - p[axis]) / to_light[axis], (high[axis] - p[axis]) / to_light[axis]);
        (enter, leave) = (enter.max(a.min(b)), leave.min(a.max(b)));
    }
    enter < leave
}

#[test]
fn a_spheres_shadow_is_where_rays_pass_nearer_than_its_radius() {
    // Its triangles lie within 2e-5 m of the sphere.
    let centre = DVec3::new(0.3, 1.0, -0.2);
    let sphere = sphere(centre, 1.0, 512);
    for direction in SUNS {
        let (sun, to_light) = sun(direction);
        demand("sphere", &sphere, &sun, |p, grow| {
            let to_centre = centre - p;
            let along = to_centre.dot(to_light);
            along > 0.0 && (to_centre.length_squared() - along * along).sqrt() < 1.0 + grow
        });
    }
}

#[test]
fn every_pixel_of_a_picture_is_what_its_ray_finds() {
    let corner = |x, z| Vec3::new(x, 2.0, z);
    let plane = quad(corner(-500.0, -500.0), corner(-500.0, 500.0), corner(0.5, 500.0), corner(0.5, -500.0));
    let world = World::of_triangles(ground().into_iter().chain(plane).collect());
    let camera = Camera::looking("c", Vec3::new(3.0, 1.5, 6.0), Vec3::new(0.0, 0.0, -2.0), 1.0, 0.1, 1000.0);
    let eye = Eye::new(&camera, 160, 90);
    let (sun, to_light) = sun(Vec3::new(0.4, -1.0, 0.3));
    let shift = to_light / to_light.y * 2.0;
    let truth = Truth::new(&world, &eye, &sun, 50.0);
    let mut seen = std::collections::BTreeMap::new();
    for (pixel, receiver) in truth.pixels.iter().zip(&truth.receivers) {
        *seen.entry(format!("{pixel:?}")).or_insert(0) += 1;
        let Some(receiver) = receiver else {
            assert_eq!(*pixel, Pixel::Sky);
            continue;
        };
        let wanted = if receiver.position.y > 1.0 {
            Pixel::TurnedAway
        } else if receiver.depth > 50.0 {
            Pixel::Beyond
        } else if (receiver.position + shift).x < 0.5 {
            Pixel::Shadowed
        } else {
            Pixel::Lit
        };
        assert_eq!(*pixel, wanted, "{receiver:?}");
    }
    assert_eq!(seen.len(), 5, "sky, turned away, beyond, lit and shadowed are all seen: {seen:?}");
}
