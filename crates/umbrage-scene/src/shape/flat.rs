//! Solids with flat faces: boxes, prisms, pyramids; the icosphere, whose many faces make rocks; and the open sheet.

use std::collections::HashMap;

use glam::{Vec2, Vec3};

use super::Solid;

/// A box about the origin.
pub(crate) fn cuboid(x: f32, y: f32, z: f32) -> Solid {
    prism(&rectangle(x, y), z)
}

/// A box about the origin whose edges are cut by `bevel`.
pub(crate) fn bevelled(x: f32, y: f32, z: f32, bevel: f32) -> Solid {
    let (w, h, b) = (x * 0.5, y * 0.5, bevel);
    let outline = [
        [w, -h + b],
        [w, h - b],
        [w - b, h],
        [-w + b, h],
        [-w, h - b],
        [-w, -h + b],
        [-w + b, -h],
        [w - b, -h],
    ];
    bevelled_prism(&outline, z, bevel)
}

/// The corners of a rectangle about the origin, counter-clockwise.
fn rectangle(x: f32, y: f32) -> [[f32; 2]; 4] {
    let (w, h) = (x * 0.5, y * 0.5);
    [[w, -h], [w, h], [-w, h], [-w, -h]]
}

/// A four-sided pyramid that stands on the ground.
pub(crate) fn pyramid(width: f32, height: f32) -> Solid {
    let w = width * 0.5;
    let points = [[-w, -w], [-w, w], [w, w], [w, -w]].map(|[x, z]| Vec3::new(x, 0.0, z));
    let mut solid = Solid { points: points.to_vec(), triangles: vec![[0, 2, 1], [0, 3, 2]] };
    solid.cap(0, 4, Vec3::Y * height, true);
    solid
}

/// A level rectangle about the origin that looks up, of `pieces` strips along x; its middle bulges upwards by `bulge`. It
/// has no thickness: it is open, and both of its sides are one surface.
pub(crate) fn sheet(x: f32, z: f32, pieces: u32, bulge: f32) -> Solid {
    let mut solid = Solid::default();
    for i in 0..=pieces {
        let share = i as f32 / pieces as f32 - 0.5;
        let height = bulge * (1.0 - 4.0 * share * share);
        solid.points.extend([-0.5, 0.5].map(|side| Vec3::new(share * x, height, side * z)));
        if i > 0 {
            let [a, b, c, d] = [2 * i - 2, 2 * i - 1, 2 * i, 2 * i + 1];
            solid.triangles.extend([[a, b, c], [c, b, d]]);
        }
    }
    solid
}

/// A simple outline in the plane z = 0, counter-clockwise seen from +Z, drawn out to `depth` about that plane.
pub(crate) fn prism(outline: &[[f32; 2]], depth: f32) -> Solid {
    let outline: Vec<Vec2> = outline.iter().map(|&p| p.into()).collect();
    stack(&outline, &[(&outline, -depth * 0.5), (&outline, depth * 0.5)])
}

/// A [`prism`] whose front and back edges are cut by `bevel`.
pub(crate) fn bevelled_prism(outline: &[[f32; 2]], depth: f32, bevel: f32) -> Solid {
    let outline: Vec<Vec2> = outline.iter().map(|&p| p.into()).collect();
    let (inner, half) = (inset(&outline, bevel), depth * 0.5);
    let layers = [(&inner, -half), (&outline, -half + bevel), (&outline, half - bevel), (&inner, half)];
    stack(&outline, &layers.map(|(ring, z)| (ring.as_slice(), z)))
}

/// Rings of equal length at growing z, joined and closed at both ends.
fn stack<R: AsRef<[Vec2]>>(outline: &[Vec2], layers: &[(R, f32)]) -> Solid {
    let count = outline.len() as u32;
    let mut solid = Solid::default();
    for (layer, (ring, z)) in layers.iter().enumerate() {
        solid.points.extend(ring.as_ref().iter().map(|p| p.extend(*z)));
        if layer > 0 {
            let low = (layer as u32 - 1) * count;
            solid.band(low, low + count, count);
        }
    }
    let top = (layers.len() as u32 - 1) * count;
    for [a, b, c] in triangulate(outline) {
        solid.triangles.push([a, c, b]);
        solid.triangles.push([top + a, top + b, top + c]);
    }
    solid
}

/// The outline moved inwards by `distance`; corners at most twice as far.
fn inset(outline: &[Vec2], distance: f32) -> Vec<Vec2> {
    let count = outline.len();
    let inwards = |a: Vec2, b: Vec2| (b - a).perp().normalize_or_zero();
    (0..count)
        .map(|i| {
            let (before, here, after) =
                (outline[(i + count - 1) % count], outline[i], outline[(i + 1) % count]);
            let (m, n) = (inwards(before, here), inwards(here, after));
            here + (m + n) * (distance / (1.0 + m.dot(n)).max(0.5))
        })
        .collect()
}

/// Cuts a simple counter-clockwise outline into triangles by clipping ears.
fn triangulate(outline: &[Vec2]) -> Vec<[u32; 3]> {
    let mut left: Vec<u32> = (0..outline.len() as u32).collect();
    let mut triangles = Vec::new();
    let cross = |a: u32, b: u32, c: u32| {
        let [a, b, c] = [a, b, c].map(|i| outline[i as usize]);
        (b - a).perp_dot(c - a)
    };
    while left.len() > 3 {
        let corner = |i: usize| left[i % left.len()];
        let ear = (0..left.len()).find(|&i| {
            let (a, b, c) = (corner(i), corner(i + 1), corner(i + 2));
            let inside = |p: u32| cross(a, b, p) >= 0.0 && cross(b, c, p) >= 0.0 && cross(c, a, p) >= 0.0;
            cross(a, b, c) > 0.0 && !left.iter().any(|&p| ![a, b, c].contains(&p) && inside(p))
        });
        let i = ear.unwrap_or(0);
        triangles.push([corner(i), corner(i + 1), corner(i + 2)]);
        left.remove((i + 1) % left.len());
    }
    triangles.extend(left.as_chunks().0);
    triangles
}

/// A ball of 20 · 4^`level` nearly equal triangles.
pub(crate) fn icosphere(radius: f32, level: u32) -> Solid {
    let t = (1.0 + 5.0_f32.sqrt()) * 0.5;
    let mut points: Vec<Vec3> = Vec::new();
    for (a, b) in [(-1.0, t), (1.0, t), (-1.0, -t), (1.0, -t)] {
        points.extend([Vec3::new(a, b, 0.0), Vec3::new(0.0, a, b), Vec3::new(b, 0.0, a)]);
    }
    points.iter_mut().for_each(|p| *p = p.normalize_or_zero());
    // The faces of an icosahedron are the triples of corners that are all one edge apart.
    let near = |a: Vec3, b: Vec3| a.dot(b) > 0.4;
    let mut triangles = Vec::new();
    for a in 0..12 {
        for b in a + 1..12 {
            for c in b + 1..12 {
                let [p, q, r] = [points[a], points[b], points[c]];
                if near(p, q) && near(q, r) && near(r, p) {
                    let outside = (q - p).cross(r - p).dot(p) > 0.0;
                    triangles.push((if outside { [a, b, c] } else { [a, c, b] }).map(|i| i as u32));
                }
            }
        }
    }
    for _ in 0..level {
        let mut middles: HashMap<(u32, u32), u32> = HashMap::new();
        let mut finer = Vec::with_capacity(triangles.len() * 4);
        for [a, b, c] in triangles {
            let mut middle = |a: u32, b: u32| {
                *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
                    points.push((points[a as usize] + points[b as usize]).normalize_or_zero());
                    points.len() as u32 - 1
                })
            };
            let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
            finer.extend([[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]);
        }
        triangles = finer;
    }
    points.iter_mut().for_each(|p| *p *= radius);
    Solid { points, triangles }
}
