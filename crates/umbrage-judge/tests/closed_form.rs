//! Worlds whose shadows are known in closed form: the tracer must agree with them everywhere but within 1e-4 m of an edge.

use glam::{DVec3, Vec3};
use umbrage_judge::temporal::{Anchor, visibility};
use umbrage_judge::{Eye, Pixel, Sun, Truth, World};
use umbrage_scene::Camera;

/// Nearer to an edge than this the two may differ, metres.
const EDGE: f64 = 1e-4;

/// The suns that every world is lit by.
const SUNS: [Vec3; 4] =
    [Vec3::NEG_Y, Vec3::new(0.4, -1.0, 0.3), Vec3::new(-0.9, -0.35, 0.2), Vec3::new(0.05, -0.2, -1.0)];

/// Corners of a quad, as two triangles.
fn quad(a: Vec3, b: Vec3, c: Vec3, d: Vec3) -> [[Vec3; 3]; 2] {
    [[a, b, c], [a, c, d]]
}

fn ground() -> Vec<[Vec3; 3]> {
    let corner = |x, z| Vec3::new(x, 0.0, z) * 200.0;
    quad(corner(-1.0, -1.0), corner(-1.0, 1.0), corner(1.0, 1.0), corner(1.0, -1.0)).into()
}

/// Points of the ground, half of them spread over ±10 m, half of them crowded around wherever `shadowed` changes.
fn ground_points(shadowed: &impl Fn(DVec3) -> bool) -> Vec<DVec3> {
    let share = |i: usize, step: f64| (0.5 + step * i as f64).fract() * 20.0 - 10.0;
    let spread = |i: usize| DVec3::new(share(i, 0.754_877_666), 0.0, share(i, 0.569_840_290));
    let mut points: Vec<DVec3> = (0..20_000).map(spread).collect();
    for i in 0..20_000 {
        let (mut a, mut b) = (spread(i), spread(i + 1));
        if shadowed(a) == shadowed(b) {
            continue;
        }
        // An edge lies between the two: close in on it to a few times the tolerance, from both sides.
        while a.distance(b) > 4.0 * EDGE {
            let middle = (a + b) * 0.5;
            if shadowed(middle) == shadowed(a) { a = middle } else { b = middle }
        }
        points.extend([a + (a - b) * 2.0, b + (b - a) * 2.0, a, b]);
    }
    points
}

/// Demands that tracing agrees with `shadowed`, and says how many points were compared. `shadowed(p, grow)` is the closed
/// form with the caster grown by so many metres: where growing and shrinking it changes the answer, `p` is at an edge.
fn demand(what: &str, casters: &[[Vec3; 3]], sun: &Sun, shadowed: impl Fn(DVec3, f64) -> bool) {
    let world = World::of_triangles(ground().into_iter().chain(casters.iter().copied()).collect());
    let points = ground_points(&|p| shadowed(p, 0.0));
    let anchors: Vec<Anchor> = points.iter().map(|p| Anchor { position: *p, normal: DVec3::Y }).collect();
    let (mut compared, mut dark) = (0, 0);
    for (p, traced) in points.iter().zip(visibility(&world, sun, &anchors)) {
        let truth = shadowed(*p, 0.0);
        if shadowed(*p, EDGE) != truth || shadowed(*p, -EDGE) != truth {
            continue;
        }
        compared += 1;
        dark += usize::from(truth);
        assert_eq!(traced, if truth { 0.0 } else { 1.0 }, "{what}, sun {:?}: at {p}", sun.to_light);
    }
    assert!(compared > 20_000 && dark > 100, "{what}: {compared} points compared, {dark} of them shadowed");
}

#[test]
fn a_half_planes_shadow_ends_on_a_line() {
    const HEIGHT: f64 = 2.0;
    let corner = |x, z| Vec3::new(x, HEIGHT as f32, z);
    let plane = quad(corner(-500.0, -500.0), corner(-500.0, 500.0), corner(0.5, 500.0), corner(0.5, -500.0));
    for direction in SUNS {
        let sun = Sun::along(direction);
        let shift = sun.to_light / sun.to_light.y * HEIGHT;
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
        let sun = Sun::along(direction);
        demand("boxes", &casters, &sun, |p, grow| {
            boxes.iter().any(|(low, high)| meets_box(p, sun.to_light, *low - grow, *high + grow))
        });
    }
}

fn box_sides(low: DVec3, high: DVec3) -> Vec<[Vec3; 3]> {
    let corner = |i: usize| {
        let pick = |axis: usize| if i >> axis & 1 == 1 { high[axis] } else { low[axis] };
        DVec3::new(pick(0), pick(1), pick(2)).as_vec3()
    };
    let sides = [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]];
    sides.iter().flat_map(|[a, b, c, d]| quad(corner(*a), corner(*b), corner(*c), corner(*d))).collect()
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
        let sun = Sun::along(direction);
        demand("sphere", &sphere, &sun, |p, grow| {
            let to_centre = centre - p;
            let along = to_centre.dot(sun.to_light);
            along > 0.0 && (to_centre.length_squared() - along * along).sqrt() < 1.0 + grow
        });
    }
}

fn sphere(centre: DVec3, radius: f64, around: u32) -> Vec<[Vec3; 3]> {
    let point = |i: u32, j: u32| {
        let (u, v) = (f64::from(i) / f64::from(around), f64::from(j) / f64::from(around / 2));
        let ((s, c), (sp, cp)) =
            ((u * std::f64::consts::TAU).sin_cos(), (v * std::f64::consts::PI).sin_cos());
        (centre + DVec3::new(sp * c, cp, sp * s) * radius).as_vec3()
    };
    let patches = (0..around).flat_map(|i| (0..around / 2).map(move |j| (i, j)));
    patches
        .flat_map(|(i, j)| quad(point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)))
        .collect()
}

#[test]
fn every_pixel_of_a_picture_is_what_its_ray_finds() {
    let corner = |x, z| Vec3::new(x, 2.0, z);
    let plane = quad(corner(-500.0, -500.0), corner(-500.0, 500.0), corner(0.5, 500.0), corner(0.5, -500.0));
    let world = World::of_triangles(ground().into_iter().chain(plane).collect());
    let camera = Camera::looking("c", Vec3::new(3.0, 1.5, 6.0), Vec3::new(0.0, 0.0, -2.0), 1.0, 0.1, 1000.0);
    let eye = Eye::new(&camera, 160, 90);
    let sun = Sun::along(Vec3::new(0.4, -1.0, 0.3));
    let shift = sun.to_light / sun.to_light.y * 2.0;
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
