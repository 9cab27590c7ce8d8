//! The built-in worlds: large scenes made in code, after those that shadow papers were measured on.
//!
//! Each world is deterministic: the same name and seed give the same scene. Each has at least the cameras "main",
//! "far" (all of it), "close" (the edge of a shadow), "split" (along the ground, so that split planes cross visible
//! shadows) and "dueling" (against the first light, the hardest case for warped shadow maps), and a flight path.
//!
//! Most have a sun of 3 lux. Some have spot or point lights instead, which may move. Their candela are chosen for the same
//! eye: candela / distance² is 1 to 3 lux at the places that matter. How bright that looks is for whoever draws them to say.

mod atrium;
mod bias_court;
mod brick_ground;
mod canvas;
mod cards;
mod closed_room;
mod grove;
mod huge_chessboard;
mod knights;
mod mining_terrain;
mod night_chessboard;
mod orbit;
mod picture;
mod primitives;
mod rigging;
mod robot_war;
mod scanned;
mod stage;
mod survey;
mod tutorial_room;
mod village_fair;

#[cfg(test)]
mod tests;

use crate::Scene;

/// A world that can be built by its name.
#[derive(Clone, Copy, Debug)]
pub struct World {
    /// The name of the world on the command line.
    pub name: &'static str,
    /// The publication that the world is modelled after, or what it was made for.
    pub source: &'static str,
    /// A summary of what is in the world, in one line.
    pub summary: &'static str,
    build: fn(u64) -> Scene,
}

impl World {
    /// Builds the world. The same `seed` gives the same scene; seed 0 is the one in the pictures.
    pub fn build(&self, seed: u64) -> Scene {
        (self.build)(seed)
    }
}

/// The name of the world that is shown when none is asked for.
pub const DEFAULT: &str = "mining-terrain";

const THESIS: &str = "Ferko 2010, figure 5.5";
const PSSM: &str = "Zhang et al. 2006, table 1";

/// All built-in worlds, of which small ones come first.
pub const ALL: &[World] = &[
    World {
        name: "primitives",
        source: THESIS,
        summary: "1,300 triangles of basic solids on a ground",
        build: primitives::build,
    },
    World {
        name: "orbit",
        source: "a course deck on shadow rendering",
        summary: "basic solids that turn, and a spot light that moves to and fro around them on the deck's curve, in 24 s",
        build: orbit::build,
    },
    World {
        name: "bunny",
        source: THESIS,
        summary: "the Stanford bunny, 3 m tall, on a ground",
        build: scanned::bunny,
    },
    World {
        name: "tutorial-room",
        source: "opengl-tutorial.org, Tutorial 16",
        summary: "a room with thick walls and a window, under one spot light of 45°",
        build: tutorial_room::build,
    },
    World {
        name: "bias-court",
        source: "made for judging biases",
        summary: "planes at 0° to 85° to the sun, walls of 1 to 100 mm, stairs, a ball and open sheets in a court",
        build: bias_court::build,
    },
    World {
        name: "closed-room",
        source: "made for point lights",
        summary: "a closed, furnished room of 108 m² with one point light",
        build: closed_room::build,
    },
    World {
        name: "dragon",
        source: THESIS,
        summary: "the Stanford dragon, 4 m tall, on a ground",
        build: scanned::dragon,
    },
    World {
        name: "brick-ground",
        source: "a course report on directional shadow maps, 2021",
        summary: "a fighter, a helicopter, UFOs and other static and rotating objects over 200 m of repeated brick",
        build: brick_ground::build,
    },
    World {
        name: "robot-war",
        source: PSSM,
        summary: "160 static robots on 1.44 km², 240 K triangles",
        build: robot_war::build,
    },
    World {
        name: "huge-chessboard",
        source: PSSM,
        summary: "32 chessmen on a board of 0.49 km², 51 K triangles",
        build: huge_chessboard::build,
    },
    World {
        name: "night-chessboard",
        source: PSSM,
        summary: "the huge chessboard at night, under twelve spot lights, 54 K triangles",
        build: night_chessboard::build,
    },
    World {
        name: "knights",
        source: PSSM,
        summary: "15 dwarfs and 15 knights on the march, trees and cacti on 1.6 km² of desert, 1 M triangles",
        build: knights::build,
    },
    World {
        name: "mining-terrain",
        source: PSSM,
        summary: "clawbots, windmills, rocks and trees around an open pit of 2.56 km², 1.3 M triangles",
        build: mining_terrain::build,
    },
    World {
        name: "survey",
        source: "made for worlds far from their origin",
        summary: "a surveyed valley, 20 km across and 200 km from its origin, with a town under twelve lamps, 950 K triangles",
        build: survey::build,
    },
    World {
        name: "grove",
        source: "made for surfaces with holes",
        summary: "a glade in a wood of leaves cut out of pictures, a chain-link fence and tall grass in the wind, 250 K triangles",
        build: grove::build,
    },
    World {
        name: "village-fair",
        source: "made for crowds",
        summary: "a hundred people with bones, flags, a carousel and stalls of cloth under fifteen lamps at sunset, 340 K triangles",
        build: village_fair::build,
    },
    World {
        name: "atrium",
        source: "made for glass and cloth",
        summary: "a court of columns and arcades under a glass roof, with hangings, palms and ten lamps, 67 K triangles",
        build: atrium::build,
    },
];

/// Builds the world called `name`; `None` where there is none of that name.
pub fn build(name: &str, seed: u64) -> Option<Scene> {
    ALL.iter().find(|world| world.name == name).map(|world| world.build(seed))
}
