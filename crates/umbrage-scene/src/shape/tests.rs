use std::collections::HashMap;

use glam::{Vec2, Vec3};

use super::flat::prism;
use super::*;

/// Every edge is shared by two triangles that run along it in opposite directions, and the volume is positive.
fn assert_closed(name: &str, solid: &Solid) {
    let mut edges: HashMap<(u32, u32), i32> = HashMap::new();
    for [a, b, c] in &solid.triangles {
        for (from, to) in [(*a, *b), (*b, *c), (*c, *a)] {
            *edges.entry((from.min(to), from.max(to))).or_default() += if from < to { 1 } else { -1 };
        }
    }
    assert!(edges.values().all(|sum| *sum == 0), "{name} is not closed");
    let volume: f32 = solid
        .triangles
        .iter()
        .map(|t| t.map(|i| solid.points[i as usize]))
        .map(|[a, b, c]| a.dot(b.cross(c)) / 6.0)
        .sum();
    assert!(volume > 0.0, "{name} is inside out: {volume} m³");
}

#[test]
fn every_solid_is_closed_and_faces_outwards() {
    let hook = [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [3.0, 3.0], [3.0, 1.0], [0.0, 1.0]];
    let bow = [(Vec3::ZERO, 0.5), (Vec3::Y, 0.4), (Vec3::new(1.0, 2.0, 0.0), 0.0)];
    let solids = [
        ("cuboid", cuboid(1.0, 2.0, 3.0)),
        ("bevelled", bevelled(1.0, 2.0, 3.0, 0.1)),
        ("prism", prism(&hook, 1.0)),
        ("bevelled_prism", bevelled_prism(&hook, 1.0, 0.1)),
        ("pyramid", pyramid(2.0, 1.0)),
        ("icosphere", icosphere(1.0, 2)),
        ("lathe", lathe(&[[1.0, 0.0], [0.5, 1.0], [1.0, 2.0]], 7)),
        ("curve", lathe(&curve(&[[0.0, 0.0], [1.0, 0.5], [0.0, 1.0]], 4), 7)),
        ("sphere", sphere(1.0, 8, 5)),
        ("cylinder", cylinder(1.0, 2.0, 8)),
        ("cone", cone(1.0, 2.0, 8)),
        ("frustum", frustum(1.0, 0.5, 2.0, 8)),
        ("torus", torus(2.0, 0.5, 9, 6)),
        ("limb", limb(Vec3::X, Vec3::new(2.0, -3.0, 1.0), 0.5, 0.3, 8)),
        ("tube", tube(&bow, 6)),
        ("beam", beam(Vec3::X, Vec3::Z, 0.1, 5)),
        ("leaf", leaf(Vec3::ZERO, Vec3::Z, Vec3::Y, 0.3)),
        ("mirror image", pyramid(1.0, 1.0).moved(2.0, 0.0, 0.0).both_sides()),
    ];
    solids.iter().for_each(|(name, solid)| assert_closed(name, solid));
}

#[test]
fn an_icosphere_of_level_two_has_320_triangles() {
    assert_eq!(icosphere(1.0, 2).triangles.len(), 20 * 16);
}

#[test]
fn a_box_keeps_its_edges_and_a_ball_has_none() {
    let corners = cuboid(1.0, 1.0, 1.0).painted(0);
    assert_eq!(corners.positions.len(), 24, "three normals at each of eight corners");
    let ball = sphere(1.0, 24, 12).painted(0);
    assert_eq!(ball.positions.len(), 2 + 11 * 24, "one normal at each corner");
    let off = ball.positions.iter().zip(&ball.normals).map(|(p, n)| p.distance(*n)).fold(0.0, f32::max);
    assert!(off < 0.05, "the normal of a unit ball is its point: off by {off}");
}

#[test]
fn the_ground_is_as_high_as_its_triangles() {
    let ground = Ground::new(8.0, 32, |p: Vec2| p.x + 2.0 * p.y);
    assert!((ground.height(1.3, -0.7) - (1.3 - 1.4)).abs() < 1e-5, "a tilted plane has no error");
    assert_eq!(ground.height(100.0, 0.0), 4.0);
    let tiles = ground.primitives(3, 2.0);
    assert_eq!(tiles.len(), 1);
    assert_eq!(tiles[0].indices.len(), 3 * 32);
    let [a, b, c] = [0, 1, 2].map(|i| tiles[0].positions[tiles[0].indices[i] as usize]);
    assert!((b - a).cross(c - a).y > 0.0, "it faces up");
}
