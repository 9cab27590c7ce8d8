//! Where the survey is seen from: above the valley, in a street, among the lamps, and on a flight.

use glam::{Vec2, Vec3};

use super::land::{Land, stream};
use super::{VIADUCT, in_world, town};
use crate::worlds::stage::{Stage, View};

/// In a street, whose far end is near.
const STREET: View = View { fov_degrees: 60.0, near: 0.25, far: 700.0 };

pub(super) fn look(stage: &mut Stage, land: &Land) {
    let at = |east: f32, north: f32, up: f32| in_world(land.at(Vec2::new(east, north)) + Vec3::Z * up);
    let beside_stream = |east: f32, north: f32, up: f32| at(east, stream(east) + north, up);
    let in_town = |along: f32, north: f32, up: f32| in_world(town::above(land, along, north, up));
    let main = (in_town(-560.0, 250.0, 62.0), in_town(40.0, 30.0, 4.0));
    stage.look("main", main.0, main.1);
    stage.look_far(at(5150.0, -1050.0, 460.0), at(6300.0, 300.0, 0.0));
    stage.look_through(STREET, "close", in_town(-262.0, 224.5, 1.7), in_town(-150.0, 226.0, 3.0));
    stage.look(
        "split",
        beside_stream(VIADUCT + 150.0, 400.0, 9.0),
        beside_stream(VIADUCT + 24.0, 90.0, 10.0),
    );
    stage.look_into_light(beside_stream(6900.0, 330.0, 26.0), 11.0);
    stage.look_through(STREET, "lamps", in_town(-45.0, 13.0, 1.9), in_town(14.0, 5.0, 2.4));
    stage.fly(&[
        main,
        (beside_stream(5700.0, 500.0, 90.0), in_town(60.0, 40.0, 5.0)),
        (in_town(-150.0, -90.0, 45.0), in_town(20.0, 40.0, 10.0)),
        (in_town(40.0, -200.0, 40.0), in_town(30.0, 40.0, 10.0)),
        (beside_stream(6700.0, -120.0, 50.0), beside_stream(7500.0, 40.0, 20.0)),
        (beside_stream(7250.0, 60.0, 30.0), beside_stream(8200.0, 100.0, 30.0)),
        (beside_stream(7900.0, 200.0, 90.0), beside_stream(7000.0, 100.0, 0.0)),
    ]);
}
