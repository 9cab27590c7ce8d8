//! Things to cast shadows, and the demand that tracing agrees with a closed form.

use glam::{DVec3, Vec3};
use umbrage_judge::temporal::{Anchor, visibility};
use umbrage_judge::{Light, World};

/// Nearer to an edge than this the two may differ, metres.
const EDGE: f64 = 1e-4;

/// Corners of a quad, as two triangles.
pub fn quad(a: Vec3, b: Vec3, c: Vec3, d: Vec3) -> [[Vec3; 3]; 2] {
    [[a, b, c], [a, c, d]]
}

/// 400 m × 400 m at height 0.
pub fn ground() -> Vec<[Vec3; 3]> {
    let corner = |x, z| Vec3::new(x, 0.0, z) * 200.0;
    quad(corner(-1.0, -1.0), corner(-1.0, 1.0), corner(1.0, 1.0), corner(1.0, -1.0)).into()
}

/// The six sides of a box.
pub fn box_sides(low: DVec3, high: DVec3) -> Vec<[Vec3; 3]> {
    let corner = |i: usize| {
        let pick = |axis: usize| if i >> axis & 1 == 1 { high[axis] } else { low[axis] };
        DVec3::new(pick(0), pick(1), pick(2)).as_vec3()
    };
    let sides = [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]];
    sides.iter().flat_map(|[a, b, c, d]| quad(corner(*a), corner(*b), corner(*c), corner(*d))).collect()
}

/// A sphere of `around` × `around` / 2 patches.
pub fn sphere(centre: DVec3, radius: f64, around: u32) -> Vec<[Vec3; 3]> {
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
pub fn demand(what: &str, casters: &[[Vec3; 3]], light: &Light, shadowed: impl Fn(DVec3, f64) -> bool) {
    let world = World::of_triangles(ground().into_iter().chain(casters.iter().copied()).collect());
    let points = ground_points(&|p| shadowed(p, 0.0));
    let anchors: Vec<Anchor> =
        points.iter().map(|p| Anchor { position: *p, normal: DVec3::Y, lift: 0.0 }).collect();
    let (mut compared, mut dark) = (0, 0);
    for (p, traced) in points.iter().zip(visibility(&world, light, &anchors)) {
        let truth = shadowed(*p, 0.0);
        if shadowed(*p, EDGE) != truth || shadowed(*p, -EDGE) != truth {
            continue;
        }
        compared += 1;
        dark += usize::from(truth);
        assert_eq!(traced, if truth { 0.0 } else { 1.0 }, "{what}, {light:?}: at {p}");
    }
    assert!(compared > 20_000 && dark > 100, "{what}: {compared} points compared, {dark} of them shadowed");
}
