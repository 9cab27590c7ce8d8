//! A plan as plain data: all that a foreign renderer needs to draw its views and to read them.
//!
//! Names of formats, faces and samplers are WebGPU's. Matrices are four rows of four; a point is a column on their right.

use serde::Serialize;
use umbrage_core::{
    CasterFaces, DepthFormat, Filter, LightKind, MapLayout, Rays, Settings, ShadowPlan, ShadowView,
};

use crate::storage_factor::{min_storage_factor, storage_factor};

/// A plan. Its fields in other languages are those of `umbrage plan --json`.
#[derive(Clone, Debug, Serialize)]
pub struct PlanData {
    /// The split distances of suns, view depths in metres.
    splits: Vec<f64>,
    picture: Picture,
    camera: Camera,
    lights: Vec<Light>,
    maps: Maps,
    casters: Casters,
    views: Vec<View>,
    /// A sun overhead needs so many texels for each pixel, 1 or more: with these splits, and at the least.
    storage_factor: f64,
    min_storage_factor: f64,
    texels: u64,
    bytes: u64,
}

#[derive(Clone, Debug, Serialize)]
struct Picture {
    width: u32,
    height: u32,
}

/// Its depth is reversed: 1 at `near`, 0 at `far`.
#[derive(Clone, Debug, Serialize)]
struct Camera {
    eye: [f32; 3],
    forward: [f32; 3],
    near: f32,
    far: f32,
    clip_from_world: [[f32; 4]; 4],
}

#[derive(Clone, Debug, Serialize)]
struct Light {
    #[serde(flatten)]
    kind: Kind,
    /// The place of its first view in `views`, and how many follow one another.
    first_view: usize,
    view_count: usize,
}

#[derive(Clone, Debug, Serialize)]
#[serde(rename_all = "lowercase", tag = "kind")]
enum Kind {
    /// `direction` is the way the light travels.
    Sun {
        direction: [f32; 3],
    },
    /// `half_angle` from the axis to the rim, radians; `range` in metres.
    Spot {
        position: [f32; 3],
        direction: [f32; 3],
        half_angle: f32,
        range: f32,
    },
    Point {
        position: [f32; 3],
        range: f32,
    },
}

/// The texture that holds the views' tiles, and how it is compared with.
#[derive(Clone, Debug, Serialize)]
struct Maps {
    width: u32,
    height: u32,
    layers: u32,
    format: &'static str,
    compare_sampler: Sampler,
}

#[derive(Clone, Debug, Serialize)]
#[serde(rename_all = "camelCase")]
struct Sampler {
    compare: &'static str,
    mag_filter: &'static str,
    min_filter: &'static str,
}

/// What the pipelines that draw casters are set to. Depth is reversed: a tile is cleared to 0, and nearer depths, which are
/// greater, replace farther ones.
#[derive(Clone, Debug, Serialize)]
struct Casters {
    cull_mode: &'static str,
    depth_compare: &'static str,
    depth_clear: f32,
    depth_bias: i32,
    depth_bias_slope_scale: f32,
    unclipped_depth: bool,
}

#[derive(Clone, Debug, Serialize)]
struct View {
    light: usize,
    split: usize,
    tile: Tile,
    clip_from_world: [[f32; 4]; 4],
    texel_metres: f32,
    depths: [f32; 2],
    near_metres: f32,
    depth_metres: f32,
    /// Whether depth is stored as 1 / d, as it is where rays spread from a point.
    spreads: bool,
    /// What a warp scales stored depth by, at x and y of NDC, is dot(this, (x, y, 1)).
    depth_scale: [f32; 3],
    /// Planes (a, b, c, d) around what may cast into this view: inside, a x + b y + c z + d ≥ 0. `null` where nothing may.
    casters: Option<Vec<[f32; 4]>>,
}

#[derive(Clone, Debug, Serialize)]
struct Tile {
    layer: u32,
    x: u32,
    y: u32,
    size: u32,
}

impl PlanData {
    /// Returns a plan for a picture of so many pixels.
    pub fn new(plan: &ShadowPlan, [width, height]: [u32; 2]) -> Self {
        let (settings, layout) = (plan.settings(), plan.layout());
        Self {
            splits: plan.splits().to_vec(),
            picture: Picture { width, height },
            camera: camera(plan),
            lights: (0..plan.lights().len()).map(|index| light(plan, index)).collect(),
            maps: maps(layout, &settings.filter),
            casters: casters(settings),
            views: plan.views().iter().map(view).collect(),
            storage_factor: storage_factor(plan),
            min_storage_factor: min_storage_factor(plan),
            texels: layout.texels(),
            bytes: layout.bytes(),
        }
    }
}

fn rows(matrix: &glam::Mat4) -> [[f32; 4]; 4] {
    [0, 1, 2, 3].map(|i| matrix.row(i).to_array())
}

fn camera(plan: &ShadowPlan) -> Camera {
    let camera = plan.camera();
    Camera {
        eye: camera.eye().to_array(),
        forward: camera.forward().to_array(),
        near: camera.near(),
        far: camera.far(),
        clip_from_world: rows(&camera.clip_from_world()),
    }
}

fn light(plan: &ShadowPlan, index: usize) -> Light {
    let of_light = |view: &&ShadowView| view.light == index;
    Light {
        kind: match plan.lights()[index].kind() {
            LightKind::Directional { direction } => Kind::Sun { direction: direction.to_array() },
            LightKind::Spot { position, direction, half_angle, range } => Kind::Spot {
                position: position.to_array(),
                direction: direction.to_array(),
                half_angle,
                range,
            },
            LightKind::Point { position, range } => Kind::Point { position: position.to_array(), range },
        },
        first_view: plan.views().iter().find(of_light).map_or(0, |view| view.index),
        view_count: plan.views().iter().filter(of_light).count(),
    }
}

fn maps(layout: MapLayout, filter: &Filter) -> Maps {
    let MapLayout { width, height, layers, depth } = layout;
    let format = match depth {
        DepthFormat::F32 => "depth32float",
        DepthFormat::U16 => "depth16unorm",
    };
    let mode = if matches!(filter, Filter::Hard {}) { "nearest" } else { "linear" };
    let compare_sampler = Sampler { compare: "greater-equal", mag_filter: mode, min_filter: mode };
    Maps { width, height, layers, format, compare_sampler }
}

fn casters(settings: &Settings) -> Casters {
    Casters {
        cull_mode: match settings.bias.casters {
            CasterFaces::Both => "none",
            CasterFaces::Front => "back",
            CasterFaces::Back => "front",
        },
        depth_compare: "greater-equal",
        depth_clear: 0.0,
        depth_bias: -settings.bias.raster_constant,
        depth_bias_slope_scale: -settings.bias.raster_slope,
        unclipped_depth: settings.flattens_casters(),
    }
}

fn view(view: &ShadowView) -> View {
    let umbrage_core::Tile { layer, x, y, size } = view.tile;
    let plane = |plane: &umbrage_core::Plane| plane.normal.extend(plane.distance).to_array();
    View {
        light: view.light,
        split: view.split,
        tile: Tile { layer, x, y, size },
        clip_from_world: rows(&view.clip_from_world.as_mat4()),
        texel_metres: view.texel_metres,
        depths: [view.depths.start, view.depths.end],
        near_metres: view.near_metres,
        depth_metres: view.depth_metres,
        spreads: matches!(view.rays, Rays::FromApex { .. }),
        depth_scale: view.depth_scale.to_array(),
        casters: (!view.casters.is_empty()).then(|| view.casters.planes().iter().map(plane).collect()),
    }
}
