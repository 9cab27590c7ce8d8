//! What papers, a thesis, a tutorial and engines measured or ship, as data.
//!
//! The engines' are their defaults of 2026, as far as this planner has what they do; what differs is said.
//!
//! The thesis and the tutorial say how their depths are biased, and so do their presets. The paper does not: its presets have the
//! bias that is exact for a flat receiver, so that what differs between two of them is what it compared.

use super::preset::Preset;
use crate::filter::{Disc, Filter};
use crate::fit::Fit;
use crate::light_box::LightBox;
use crate::settings::{Bias, CasterFaces, DepthFormat, Scheme, Select, Settings, Storage};
use crate::warp::Warp;

/// The presets that come from others.
pub(super) const PUBLISHED: [Preset; 18] = [
    Preset {
        name: "ferko-sm-1024",
        source: "Ferko 2010, table 5.1: one map of 1024² over the world",
        settings: || of_the_world(ferko(1, 1024)),
    },
    Preset {
        name: "ferko-sm-2048",
        source: "Ferko 2010, table 5.1: one map of 2048² over the world",
        settings: || of_the_world(ferko(1, 2048)),
    },
    Preset {
        name: "ferko-pssm-3x512",
        source: "Ferko 2010, table 5.2: three maps of 512², λ = 0.5",
        settings: || ferko(3, 512),
    },
    Preset {
        name: "ferko-pssm-3x1024",
        source: "Ferko 2010, table 5.2: three maps of 1024², λ = 0.5",
        settings: || ferko(3, 1024),
    },
    Preset {
        name: "zhang-ssm-1024",
        source: "Zhang et al. 2006, §4: one map of 1024²",
        settings: || zhang(1, 1024),
    },
    Preset {
        name: "zhang-psm-1024",
        source: "Zhang et al. 2006, §4: one map of 1024², PSM",
        settings: || Settings { warp: Warp::Psm, ..zhang(1, 1024) },
    },
    Preset {
        name: "zhang-lispsm-1024",
        source: "Zhang et al. 2006, §4: one map of 1024², LiSPSM",
        settings: || Settings { warp: Warp::Lispsm, ..zhang(1, 1024) },
    },
    Preset {
        name: "zhang-tsm-1024",
        source: "Zhang et al. 2006, §4: one map of 1024², TSM",
        settings: || Settings { warp: Warp::Tsm, ..zhang(1, 1024) },
    },
    Preset {
        name: "zhang-pssm2-512",
        source: "Zhang et al. 2006, table 1: PSSM(2; 512²) with TSM inside",
        settings: || Settings { warp: Warp::Tsm, ..zhang(2, 512) },
    },
    Preset {
        name: "zhang-pssm3-512",
        source: "Zhang et al. 2006, table 1: PSSM(3; 512²) with TSM inside",
        settings: || Settings { warp: Warp::Tsm, ..zhang(3, 512) },
    },
    Preset {
        name: "zhang-pssm4-512",
        source: "Zhang et al. 2006, table 1: PSSM(4; 512²) with TSM inside",
        settings: || Settings { warp: Warp::Tsm, ..zhang(4, 512) },
    },
    Preset {
        name: "tutorial-16",
        source: "opengl-tutorial 16: one map of 1024² over a box of 20 × 20 × 30 m, 16 bits, four stratified points, back faces cast, a bias by slope",
        settings: tutorial,
    },
    Preset {
        name: "shao-2020",
        source: "Shao's report: one map of 1024² over a box of 40 × 40 × 100 m, PCF of nine comparisons, a constant bias",
        settings: report,
    },
    Preset {
        name: "bevy",
        source: "Bevy 0.20-dev: four stable maps of 2048² to 150 m, Castaño 5 × 5; its normal bias has no sine, ours has",
        settings: || Settings {
            scheme: Scheme::Manual,
            manual: vec![10.0, 24.66, 60.82], // 10 m, then equal ratios to 150 m
            distance: Some(150.0),
            blend: 0.2,
            resolution: 2048,
            filter: Filter::Optimised { size: 5 },
            // 1.8 √2 texels along the normal; the kernel reaches 3 texels, and a texel's diagonal is √2.
            bias: Bias { normal: 0.6, constant: 0.02, ..Bias::NONE },
            ..peer()
        },
    },
    Preset {
        name: "godot",
        source: "Godot 4.7: four stable maps of 2048² in 16 bits to 100 m, a spiral of points turned by noise",
        settings: || Settings {
            scheme: Scheme::Manual,
            manual: vec![10.0, 20.0, 50.0],
            distance: Some(100.0),
            resolution: 2048,
            depth: DepthFormat::U16,
            storage: Storage::Atlas,
            filter: Filter::Vogel(Disc { taps: 8, radius_texels: 1.5, ..Disc::default() }),
            bias: Bias { normal: 0.8, constant: 0.1, ..Bias::NONE },
            ..peer()
        },
    },
    Preset {
        name: "filament",
        source: "Filament 1.74: one map of 1024² to 100 m with LiSPSM, Castaño 3 × 3, polygon offset and a normal bias",
        settings: || Settings {
            splits: 1,
            distance: Some(100.0),
            fit: Fit::Scene,
            warp: Warp::Lispsm,
            filter: Filter::Optimised { size: 3 },
            bias: Bias { normal: 0.5, constant: 0.001, raster_constant: 2, raster_slope: 0.5, ..Bias::NONE },
            ..peer()
        },
    },
    Preset {
        name: "three",
        source: "three.js r185 with its CSM addon: three stable maps of 2048², λ = 0.5, five points turned by noise, back faces cast",
        settings: || Settings {
            splits: 3,
            lambda: 0.5,
            resolution: 2048,
            filter: Filter::Vogel(Disc { taps: 5, radius_texels: 1.0, ..Disc::default() }),
            bias: Bias { casters: CasterFaces::Back, ..Bias::NONE },
            ..peer()
        },
    },
    Preset {
        name: "mjp",
        source: "Pettineo's Shadows: four maps of 2048², cuts at 5, 15 and 50 % of 250 m, PCF 7 × 7 with the receiver's plane",
        settings: || Settings {
            scheme: Scheme::Manual,
            manual: vec![12.5, 37.5, 125.0],
            distance: Some(250.0),
            fit: Fit::View,
            resolution: 2048,
            select: Select::Map,
            blend: 0.1,
            filter: Filter::Pcf { size: 7 },
            bias: Bias { receiver_plane: true, constant: 0.005, ..Bias::NONE },
            ..peer()
        },
    },
];

/// The tutorial: its biases are 0.005 and 0.01 of a depth range of 30 m, here in texels of its map.
fn tutorial() -> Settings {
    let slope = 0.005 * 30.0 / (20.0 / 1024.0);
    let disc = Disc { taps: 4, radius_texels: 1024.0 / 700.0, centred: false, ..Disc::default() };
    Settings {
        splits: 1,
        depth: DepthFormat::U16,
        filter: Filter::Stratified(disc),
        bias: Bias { slope, slope_limit: 2.0, casters: CasterFaces::Back, ..Bias::NONE },
        light_box: Some(LightBox::default()),
        ..of_the_world(base())
    }
}

/// The report: 100 m of depth, here about the world's origin; where its light stands, it does not say.
fn report() -> Settings {
    let light_box = LightBox {
        half_width: 20.0,
        half_height: 20.0,
        near: -50.0,
        depth_range: 100.0,
        ..LightBox::default()
    };
    Settings {
        splits: 1,
        filter: Filter::Pcf { size: 3 },
        bias: Bias { constant: 0.05, ..Bias::NONE },
        light_box: Some(light_box),
        ..of_the_world(base())
    }
}

/// The baseline of thesis, tutorial and report: a map that does not follow the camera.
fn of_the_world(settings: Settings) -> Settings {
    Settings { fit: Fit::World, ..settings }
}

/// What all have in common: maps of 1024² in 32 bits unless they say otherwise, a view by depth, and every caster as it is.
fn base() -> Settings {
    Settings {
        resolution: 1024,
        depth: DepthFormat::F32,
        select: Select::Depth,
        caster_error: 0.0,
        ..Settings::default()
    }
}

/// What engines have in common: stable maps, no receiver's plane.
fn peer() -> Settings {
    Settings { fit: Fit::Stable, bias: Bias::NONE, ..base() }
}

/// The thesis: practical splits with λ = 0.5, boxes around the slices' objects, one comparison a pixel, and its polygon offset.
fn ferko(splits: u32, resolution: u32) -> Settings {
    let bias = Bias { raster_slope: 2.0, raster_constant: 1, ..Bias::NONE };
    Settings { splits, resolution, lambda: 0.5, fit: Fit::Scene, bias, ..source() }
}

/// The paper: practical splits (eq. 6), boxes around the slices, one comparison a pixel.
fn zhang(splits: u32, resolution: u32) -> Settings {
    Settings { splits, resolution, lambda: 0.5, fit: Fit::View, ..source() }
}

/// What thesis and paper have: one comparison a pixel, and, where the source says no other bias, an offset along the normal.
fn source() -> Settings {
    Settings { filter: Filter::Hard {}, bias: Bias { normal: 1.0, constant: 0.002, ..Bias::NONE }, ..base() }
}
