//! What the shaders of receivers do where a surface does not cover all of its place. Solid surfaces have shaders that do
//! nothing about it.

use super::{Finish, Look, MATERIAL, RECEIVER, SCENE};
use crate::cover::Cover;

/// A pipeline treats what its surfaces leave open in one of these ways.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Covering {
    /// They leave nothing open.
    Solid,
    /// Surfaces are cut out.
    Cut(Edge),
    /// Surfaces are blended over what lies behind them.
    Veil,
}

/// Where the edge of what is cut out lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Edge {
    /// It lies where the picture of the material has it, whatever the distance: as a ray a pixel sees it.
    Exact,
    /// Alpha says which share of a pixel's samples is covered.
    Smooth,
}

impl Covering {
    /// Says how a look draws surfaces of a cover into pictures of so many samples a pixel. Where rays are to see the same, veils
    /// are there where they cover at least half.
    pub fn of(look: Look, cover: Cover, samples: u32) -> Self {
        let edge = match look {
            Look::Visibility | Look::Given => Edge::Exact,
            Look::World | Look::Unshadowed | Look::Marked(_) if samples > 1 => Edge::Smooth,
            Look::World | Look::Unshadowed | Look::Marked(_) => Edge::Exact,
        };
        match cover {
            Cover::Solid => Self::Solid,
            Cover::Cut => Self::Cut(edge),
            Cover::Veil if look.blends() => Self::Veil,
            Cover::Veil => Self::Cut(Edge::Exact),
        }
    }

    /// Whether alpha says which samples of a pixel are covered.
    pub fn is_alpha_to_coverage(self) -> bool {
        self == Self::Cut(Edge::Smooth)
    }
}

impl Look {
    /// Whether veils are blended over the picture; they are cut out otherwise.
    pub fn blends(self) -> bool {
        self.has_materials()
    }
}

/// The vertex shader of receivers that need nothing more.
pub(crate) const RECEIVER_ENTRY: &str = "receiver";
const COLOURED_ENTRY: &str = "coloured_receiver";

/// The vertex shader of receivers.
pub(crate) fn vertex_entry(look: Look, finish: Finish, covering: Covering) -> &'static str {
    match covering {
        Covering::Solid if look.has_materials() && finish == Finish::Glossy => COLOURED_ENTRY,
        Covering::Solid => RECEIVER_ENTRY,
        Covering::Cut(_) | Covering::Veil => COLOURED_ENTRY,
    }
}

const COLOURED: &str = include_str!("../../shaders/coloured.wgsl");
const EDGE_EXACT: &str = include_str!("../../shaders/cover/edge_exact.wgsl");

/// The fragment shader `shade`, which calls the look's `shown`, and the vertex shader where it is not the plain one.
pub(super) fn text(look: Look, finish: Finish, covering: Covering) -> String {
    const CUT: &str = include_str!("../../shaders/cover/cut.wgsl");
    let files: &[&str] = match (covering, vertex_entry(look, finish, covering) == RECEIVER_ENTRY) {
        (Covering::Solid, true) if look.has_materials() => &[include_str!("../../shaders/cover/solid.wgsl")],
        (Covering::Solid, true) => &[include_str!("../../shaders/cover/bare.wgsl")],
        (Covering::Solid, false) => &[COLOURED, include_str!("../../shaders/cover/solid_coloured.wgsl")],
        (Covering::Cut(Edge::Exact), _) => &[COLOURED, EDGE_EXACT, CUT],
        (Covering::Cut(Edge::Smooth), _) => {
            &[COLOURED, include_str!("../../shaders/cover/edge_smooth.wgsl"), CUT]
        }
        (Covering::Veil, _) => &[COLOURED, include_str!("../../shaders/cover/veil.wgsl")],
    };
    files.join("\n")
}

/// The camera's depth: of solid surfaces the vertex shader `receiver` alone; of others `coloured_receiver`, and the fragment
/// shader `cut_depth`.
pub(crate) fn depth(cover: Cover) -> String {
    match cover {
        Cover::Solid => [SCENE, RECEIVER].join("\n"),
        Cover::Cut | Cover::Veil => {
            let cut = include_str!("../../shaders/cover/cut_depth.wgsl");
            [SCENE, RECEIVER, MATERIAL, COLOURED, cut].join("\n")
        }
    }
}

/// What the camera sees, as [`umbrage::Resolve`] reads it: the vertex shaders of [`depth`], and the fragment shader `place`; of others
/// than solid surfaces `cut_place`.
pub(crate) fn places(cover: Cover) -> String {
    let place = include_str!("../../shaders/cover/place.wgsl");
    match cover {
        Cover::Solid => [SCENE, RECEIVER, place].join("\n"),
        Cover::Cut | Cover::Veil => {
            let cut = include_str!("../../shaders/cover/cut_place.wgsl");
            [SCENE, RECEIVER, MATERIAL, COLOURED, place, cut].join("\n")
        }
    }
}

/// Casters: of solid surfaces the vertex shader `caster`; of others `cut_caster`, and the fragment shaders `cut_out` and `dither`.
pub(crate) fn casters(library: &str, cover: Cover) -> String {
    let caster = include_str!("../../shaders/caster.wgsl");
    match cover {
        Cover::Solid => [library, caster].concat(),
        Cover::Cut | Cover::Veil => {
            let cut = include_str!("../../shaders/caster_cut.wgsl");
            [library, caster, MATERIAL, cut].concat()
        }
    }
}
