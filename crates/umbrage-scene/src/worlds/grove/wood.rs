//! The wood around the glade: thousands of trees of crossed cards, and a looser edge of whole trees.

use glam::{Mat4, Quat, Vec2, Vec3};
use noise_functions::{Noise as _, Perlin};

use super::land::SIDE;
use super::leaves::Materials;
use super::{POPLARS, SWAYING, TREES, trees};
use crate::Mesh;
use crate::dice::Dice;
use crate::paint::Paint;
use crate::shape::{Ground, tube};
use crate::worlds::cards::{Card, UNTINTED, WHOLE};
use crate::worlds::stage::Stage;

/// Trees stand on a lattice so wide, and not exactly.
const LATTICE: f32 = 13.0;

/// How far inside of the glade a place is, metres; negative in the wood.
fn into_glade(place: Vec2) -> f32 {
    let across = 240.0 - (place.x - 30.0 + 12.0 * (place.y * 0.02).sin()).abs();
    across.min(place.y + 310.0)
}

/// Plants spruces and broad trees where no glade is.
pub(super) fn plant(stage: &mut Stage, ground: &Ground, materials: &Materials, seed: i32) {
    let broad = {
        let mut cards = trees::crossed(materials.crowns[0], 15.0, 17.0, 2);
        // What is seen from above is a clump of its own.
        let tilt = Quat::from_rotation_y(0.3) * Quat::from_rotation_x(0.25);
        let (right, up) = (tilt * Vec3::X * 11.0, tilt * Vec3::NEG_Z * 11.0);
        let corner = Vec3::Y * 11.0 - (right + up) * 0.5;
        cards.add(Card { corner, right, up, picture: WHOLE.map(|at| at * 0.62 + 0.19) }, UNTINTED);
        cards.bent_from(Vec3::Y * 7.0, 0.8)
    };
    let spruce = trees::crossed(materials.crowns[1], 11.0, 22.0, 2).bent_from(Vec3::Y * 5.0, 0.6);
    let trunk = |height: f32| tube(&[(Vec3::NEG_Y, 0.34), (Vec3::Y * height, 0.12)], 5);
    let kinds = [("broad tree", broad, 9.0), ("spruce", spruce, 19.0)].map(|(name, cards, height)| {
        let trunk = trunk(height).painted(Paint::Bark as usize);
        stage.add(Mesh::new(name, &[trunk, cards.into_primitive()]))
    });
    let count = (SIDE / LATTICE) as i32;
    for (column, row) in (0..count).flat_map(|column| (0..count).map(move |row| (column, row))) {
        let dice = &mut stage.dice;
        let jitter = Vec2::new(dice.between(-0.36, 0.36), dice.between(-0.36, 0.36));
        let place = (Vec2::new(column as f32, row as f32) + 0.5 + jitter) * LATTICE - SIDE * 0.5;
        let (yaw, tall, wide) = (dice.angle(), dice.between(0.8, 1.3), dice.between(0.85, 1.15));
        if into_glade(place) > -6.0 {
            continue;
        }
        let damp =
            Perlin.frequency(1.0 / 120.0).seed(seed).sample2(place.to_array()) + dice.between(-0.2, 0.2);
        let feet = ground.at(place.x, place.y);
        let scale = Vec3::new(tall * wide, tall, tall * wide);
        let at = Mat4::from_scale_rotation_translation(scale, Quat::from_rotation_y(yaw), feet);
        stage.place(kinds[usize::from(damp > 0.0)], at);
    }
}

/// Where whole trees stand: along the edge of the glade, and a few in it.
pub(super) fn edge(dice: &mut Dice) -> Vec<Vec2> {
    let taken = || TREES.into_iter().chain(SWAYING).chain(POPLARS);
    let mut places: Vec<Vec2> = Vec::new();
    while places.len() < 48 {
        let place = Vec2::new(dice.between(-230.0, 290.0), dice.between(-320.0, 230.0));
        let free = |other: Vec2, room: f32| other.distance(place) > room;
        let inside = into_glade(place);
        let wanted = (-4.0..14.0).contains(&inside);
        if wanted && taken().all(|tree| free(tree, 22.0)) && places.iter().all(|tree| free(*tree, 9.0)) {
            places.push(place);
        }
    }
    places
}
