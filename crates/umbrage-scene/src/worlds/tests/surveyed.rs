//! Is the surveyed land one surface, and are there the lights and the distance that it was made for?

use std::collections::HashMap;

use super::*;

/// The corners of every triangle of the land, in the world.
fn land(scene: &Scene) -> Vec<[Vec3; 3]> {
    let grounds = scene.instances.iter().filter(|i| scene.meshes[i.mesh].name == "ground");
    let triangles = grounds.flat_map(|instance| {
        let mesh = &scene.meshes[instance.mesh];
        let corner = |i: u32| instance.world_from_mesh.transform_point3(mesh.positions[i as usize]);
        mesh.indices.as_chunks().0.iter().map(move |t: &[u32; 3]| t.map(corner))
    });
    triangles.collect()
}

#[test]
fn the_land_of_the_survey_has_no_gap_and_no_overlap() {
    let (mut edges, mut square_metres) = (HashMap::<[[u32; 3]; 2], i32>::new(), 0.0_f64);
    for [a, b, c] in land(&survey::build(0)) {
        let area = (c - a).as_dvec3().cross((b - a).as_dvec3()).y * -0.5;
        assert!(area > 0.0, "a triangle at {a} looks down or is none: {area} m²");
        square_metres += area;
        for (from, to) in [(a, b), (b, c), (c, a)] {
            let [from, to] = [from, to].map(|p| p.to_array().map(f32::to_bits));
            // An edge that two triangles share is walked once each way.
            let (edge, way) = if from < to { ([from, to], 1) } else { ([to, from], -1) };
            *edges.entry(edge).or_default() += way;
        }
    }
    assert!((square_metres / 20_480.0_f64.powi(2) - 1.0).abs() < 1e-9, "{square_metres} m²");
    let border = |v: u32| f32::from_bits(v).abs() == 10_240.0;
    for ([a, b], ways) in edges.into_iter().filter(|(_, ways)| *ways != 0) {
        let at_border = [0, 2].into_iter().any(|axis| border(a[axis]) && a[axis] == b[axis]);
        assert!(at_border && ways.abs() == 1, "a gap at {:?}", a.map(f32::from_bits));
    }
}

#[test]
fn triangles_of_the_survey_are_of_many_sizes_and_some_are_slivers() {
    let scene = survey::build(0);
    let longest = |t: &[Vec3; 3]| t[0].distance(t[1]).max(t[1].distance(t[2])).max(t[2].distance(t[0]));
    let sizes: Vec<f32> = land(&scene).iter().map(longest).collect();
    let (small, large) =
        (sizes.iter().copied().fold(f32::INFINITY, f32::min), sizes.iter().copied().fold(0.0, f32::max));
    assert!(small < 15.0 && large > 200.0, "from {small} to {large} m");
    let wires = scene.meshes.iter().find(|mesh| mesh.name == "wires").expect("a power line");
    let corner = |i: u32| wires.positions[i as usize];
    let slim = |t: &[Vec3; 3]| longest(t).powi(2) / (t[1] - t[0]).cross(t[2] - t[0]).length();
    let slimmest =
        wires.indices.as_chunks().0.iter().map(|t: &[u32; 3]| slim(&t.map(corner))).fold(0.0, f32::max);
    assert!(slimmest > 200.0, "{slimmest} times as long as wide");
}

#[test]
fn the_survey_is_far_from_its_origin_and_has_lamps_of_every_kind() {
    let scene = survey::build(0);
    assert!((scene.origin.length() - 200_000.0).abs() < 200.0, "{} m", scene.origin.length());
    assert!(scene.lights.len() <= 16, "{} lights", scene.lights.len());
    let count = |kind: fn(LightKind) -> bool| scene.lights.iter().filter(|light| kind(light.kind)).count();
    for (name, found) in [
        ("a sun", count(|kind| matches!(kind, LightKind::Directional))),
        (
            "spots with a range",
            count(|kind| matches!(kind, LightKind::Spot { range, .. } if range.is_finite())),
        ),
        ("spots without", count(|kind| matches!(kind, LightKind::Spot { range, .. } if range.is_infinite()))),
        (
            "point lights with a range",
            count(|kind| matches!(kind, LightKind::Point { range } if range.is_finite())),
        ),
        (
            "point lights without",
            count(|kind| matches!(kind, LightKind::Point { range } if range.is_infinite())),
        ),
    ] {
        assert!(found > 0, "no {name}");
    }
    let nearest =
        scene.lights[1..].iter().map(|light| light.position().length()).fold(f32::INFINITY, f32::min);
    assert!(nearest > 5_000.0, "a lamp {nearest} m from the middle");
}
