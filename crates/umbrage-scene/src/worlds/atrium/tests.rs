//! Is the atrium closed where it is of stone, and does the sun come in where it is of glass?

use super::*;
use crate::worlds::canvas::covered;
use crate::{Alpha, LightKind};

#[test]
fn glass_is_clear_tinted_or_dim_and_fringe_has_holes() {
    let scene = build(0);
    let panes = |name: &str| {
        let material = scene.materials.iter().position(|material| material.name == name).expect("a material");
        let parts = scene.meshes.iter().flat_map(|mesh| &mesh.parts).filter(|part| part.material == material);
        (parts.map(|part| part.indices.len() / 6).sum::<usize>(), &scene.materials[material])
    };
    let (clear, tinted, dim) = (panes("clear glass"), panes("tinted glass"), panes("dim glass"));
    assert_eq!(clear.0 + tinted.0 + dim.0, 2 * 20 * 4 + 18 * 6, "every place between bars has a pane");
    assert!(clear.0 > 4 * (tinted.0 + dim.0) && tinted.0 > 0 && dim.0 > 0, "{} clear", clear.0);
    assert_eq!(clear.1.coverage(1.0), 0.0);
    assert!((tinted.1.coverage(1.0) - 0.25).abs() < 1e-6 && (dim.1.coverage(0.35) - 0.35).abs() < 1e-6);
    for (name, texture) in
        [("fringe", hangings::fringe()), ("frond", palms::frond(&mut crate::dice::Dice::new(0)))]
    {
        let share = covered(&texture);
        assert!((0.25..0.75).contains(&share), "{name} covers {share}");
    }
    let masks = scene.materials.iter().filter(|material| matches!(material.alpha, Alpha::Mask { .. }));
    assert_eq!(masks.count(), 2);
}

#[test]
fn there_is_a_sun_and_lamps_of_both_kinds_within_the_walls() {
    let scene = build(0);
    let mut counts = [0; 3];
    for light in &scene.lights {
        let place = light.position();
        match light.kind {
            LightKind::Directional => counts[0] += 1,
            LightKind::Spot { .. } => counts[1] += 1,
            LightKind::Point { .. } => counts[2] += 1,
        }
        let inside = place.x.abs() < WALLS.x && place.z.abs() < WALLS.y && place.y < RIDGE;
        assert!(inside, "{} at {place}", light.name);
    }
    assert_eq!(counts, [1, 2, 8]);
}

#[test]
fn stone_is_closed_and_cloth_and_glass_are_not() {
    let scene = build(0);
    let open: Vec<&str> = scene.open_meshes().map(|mesh| mesh.name.as_str()).collect();
    assert_eq!(
        open,
        ["ground", "roof panes", "roof panes", "wall panes", "hanging", "carpet", "palm", "palm"]
    );
}
