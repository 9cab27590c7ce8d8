//! A surveyed landscape, 20 km across and 200 km from the origin of its coordinates, as offices export them: terrain as a
//! triangulated irregular network under a picture from the air, roads as strips, houses as outlines drawn up, thin wires,
//! and a town with street lamps in the evening sun, six kilometres from the middle of it all.
//!
//! The survey has x east, y north and z up, in metres; meshes have their vertices from the middle of their quarter of the
//! land, and instances rotate them to y up.

mod houses;
mod lamps;
mod land;
mod photo;
mod quarters;
mod tin;
mod town;
mod views;
mod ways;
mod wood;
mod works;

use glam::{DVec3, Mat4, Vec2, Vec3};

use self::land::{Land, stations, stream};
use self::quarters::Quarters;
use self::ways::Way;
use super::stage::{Stage, View};
use crate::Scene;
use crate::paint::Paint;

const VIEW: View = View { fov_degrees: 60.0, near: 1.0, far: 5000.0 };

/// The middle of the land in the survey's coordinates, with y up as the world has it: 152 km east, 130 km north.
const ORIGIN: DVec3 = DVec3::new(152_000.0, 0.0, -130_000.0);

/// The east of the viaduct, and of the country roads' bridges besides the one in town.
const VIADUCT: f32 = 7600.0;
const BRIDGES: [f32; 2] = [-1300.0, 4300.0];

pub(super) fn build(seed: u64) -> Scene {
    let mut stage = Stage::new("survey", seed, VIEW, Vec3::new(0.66, -0.36, -0.62));
    stage.scene.origin = ORIGIN;
    stage.scene.lights[0].colour = Vec3::new(1.0, 0.88, 0.72);
    let mut land = Land::new(seed as i32);
    let roads = build_roads(&mut land);
    land.dig_stream();
    ground(&mut stage, &land, seed as i32);
    settle(&mut stage, &land, &roads);
    string_wires(&mut stage, &land);
    plant(&mut stage, &land, &roads);
    lamps::put_up(&mut stage, &land);
    views::look(&mut stage, &land);
    stage.scene
}

/// The roads: along the valley on both banks, over the bridges, to the hills, and the streets.
#[derive(Debug)]
struct Roads {
    valley: Way,
    south_bank: Way,
    crossings: Vec<Way>,
    hill: Way,
    market: Way,
    streets: Vec<Way>,
}

fn build_roads(land: &mut Land) -> Roads {
    let valley: Vec<Vec2> = stations(|east| stream(east) + town::ROAD_FROM_STREAM).collect();
    let south: Vec<Vec2> = stations(|east| stream(east) - 240.0).collect();
    let valley = Way::build(land, &valley, 4.2, 30);
    let south_bank = Way::build(land, &south, 3.4, 30);
    let town_bridge = town::MARKET_EAST + town::BRIDGE_STREET;
    let crossings = BRIDGES.into_iter().chain([town_bridge]).map(|east| {
        let north = |share: f32| stream(east) - 240.0 + share * (240.0 + town::ROAD_FROM_STREAM);
        let through = [0.0, 0.4, 0.6, 1.0].map(|share| Vec2::new(east, north(share)));
        Way::build(land, &ways::course(&through), 3.2, 60)
    });
    let crossings = crossings.collect();
    let foot = Vec2::new(town_bridge, stream(town_bridge) - 240.0);
    let bends = [
        [0.0, 0.0],
        [60.0, -260.0],
        [620.0, -520.0],
        [-140.0, -900.0],
        [640.0, -1330.0],
        [200.0, -1900.0],
        [900.0, -2700.0],
    ];
    let hill = ways::course(&bends.map(|bend| foot + Vec2::from(bend)));
    let hill = Way::build(land, &hill, 3.2, 20);
    let market = town::market(land);
    Roads { valley, south_bank, crossings, hill, market, streets: town::streets(land) }
}

/// The network of triangles, finest in and around the town, under pictures from the air: a coarse one of everything, and
/// fine ones of the quarters that the town lies in.
fn ground(stage: &mut Stage, land: &Land, seed: i32) {
    let whole = stage.textured(photo::take(land, seed, Vec2::ZERO, land::SIDE, 1024));
    let market = town::on_land(Vec2::ZERO);
    let tolerance = |p: Vec2| 0.35 + 3.6 * land::smooth(900.0, 7000.0, p.distance(market));
    let primitives = tin::primitives(land, &mut stage.dice, tolerance);
    for (quarter, mut primitive) in primitives.into_iter().enumerate() {
        let (middle, side) = (quarters::middle(quarter).truncate(), quarters::SIDE);
        primitive.material = whole;
        if ((market - middle).abs() - side * 0.5).max_element() < 400.0 {
            primitive.material = stage.textured(photo::take(land, seed, middle, side, 1536));
            let corner = Vec2::new(middle.x, -middle.y) / land::SIDE + 0.5 - 0.5 / quarters::ACROSS as f32;
            primitive.uvs.iter_mut().for_each(|uv| *uv = (*uv - corner) * quarters::ACROSS as f32);
        }
        let mesh = stage.add(crate::Mesh::new("ground", &[primitive]));
        stage.place(mesh, quarters::standing(quarter));
    }
}

/// Roads, water, bridges and houses, in quarters.
fn settle(stage: &mut Stage, land: &Land, roads: &Roads) {
    let Roads { valley, south_bank, crossings, hill, market, streets } = roads;
    let (mut strips, mut buildings) = (Quarters::new(), Quarters::new());
    ways::lay_water(&mut strips);
    for way in [valley, south_bank, hill].into_iter().chain(crossings) {
        way.lay(Paint::Slate, &mut strips);
    }
    market.spread(town::PAVED, &mut strips);
    streets.iter().for_each(|street| street.lay(town::PAVED, &mut strips));
    crossings.iter().for_each(|way| works::bridge(way, &mut buildings));
    works::viaduct(land, VIADUCT, 46.0, &mut buildings);
    town::build(land, &mut stage.dice, &mut buildings);
    for stations in [150..176, 640..668, 1120..1150, 1370..1395, 1880..1910] {
        town::hamlet(land, &mut stage.dice, valley, stations.clone(), &mut buildings);
        town::hamlet(land, &mut stage.dice, south_bank, stations, &mut buildings);
    }
    town::hamlet(land, &mut stage.dice, hill, 150..210, &mut buildings);
    deliver(stage, "roads", &strips);
    deliver(stage, "buildings", &buildings);
}

/// A power line down the valley, which changes banks at the town.
fn string_wires(stage: &mut Stage, land: &Land) {
    let north = |east: f32| stream(east) + 700.0 - 1250.0 * land::smooth(4200.0, 5400.0, east);
    let course: Vec<Vec2> =
        (0..=54).map(|i| -8200.0 + i as f32 * 320.0).map(|east| Vec2::new(east, north(east))).collect();
    let pylons = works::pylons(land, &course);
    let mesh = stage.mesh("pylon", &works::pylon());
    for (foot, turn) in &pylons {
        stage.place(mesh, wood::upright(*foot, *turn, 1.0));
    }
    let mut wires = Quarters::new();
    works::wires(&pylons, &mut wires);
    deliver(stage, "wires", &wires);
}

fn plant(stage: &mut Stage, land: &Land, roads: &Roads) {
    let kinds: Vec<usize> = (0..3)
        .map(|_| wood::round(&mut stage.dice))
        .collect::<Vec<_>>()
        .iter()
        .map(|tree| stage.mesh("tree", tree))
        .collect();
    for (i, at) in wood::single(land, &mut stage.dice, &roads.valley.line).into_iter().enumerate() {
        stage.place(kinds[i % kinds.len()], at);
    }
    let stand = wood::spruces(&mut stage.dice);
    let stand = stage.mesh("spruces", &stand);
    let market = town::on_land(Vec2::ZERO);
    for at in wood::stands(land, &mut stage.dice, market, 3200.0) {
        stage.place(stand, at);
    }
}

/// Adds a mesh for each quarter that has something, and places it.
fn deliver(stage: &mut Stage, name: &str, quarters: &Quarters) {
    for (quarter, model) in quarters.0.iter().enumerate().filter(|(_, model)| model.triangles() > 0) {
        let mesh = stage.mesh(name, model);
        stage.place(mesh, quarters::standing(quarter));
    }
}

/// A point of the survey in the world.
fn in_world(point: Vec3) -> Vec3 {
    let world: Mat4 = quarters::WORLD_FROM_SURVEY;
    world.transform_point3(point)
}
