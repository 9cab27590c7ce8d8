//! `umbrage plan --json`: a plan of a world, with what it was made from, the bindings of all texts and the frame's bytes.

use std::collections::BTreeMap;

use base64::Engine as _;
use glam::DVec3;
use serde::Serialize;
use umbrage::shaders::{FrameBytes, Surroundings};
use umbrage::{Settings, ShadowPlan};
use umbrage_interchange::{BindingData, PlanData, Stage, Stages};

/// The whole of it.
#[derive(Serialize)]
pub struct PlanJson<'a> {
    world: &'a str,
    triangles: usize,
    /// The scene's own origin lies here in the coordinates of the world's file, metres; all points are measured from there.
    origin: [f64; 3],
    settings: &'a Settings,
    #[serde(flatten)]
    plan: PlanData,
    /// What the texts of `umbrage wgsl` bind, stage by stage.
    bindings: BTreeMap<Stage, Vec<BindingData>>,
    /// The bytes of `umbrage_frame`, in base64.
    frame: String,
}

/// What the plan is of, beside itself.
pub struct About<'a> {
    pub world: &'a str,
    pub triangles: usize,
    pub origin: [f64; 3],
    pub picture: [u32; 2],
}

impl<'a> PlanJson<'a> {
    pub fn new(about: &About<'a>, plan: &'a ShadowPlan, stages: &Stages<'_>) -> Self {
        let About { world, triangles, origin, picture } = *about;
        let (settings, layout) = (plan.settings(), plan.layout());
        let map_size = [layout.width, layout.height];
        let mut frame = FrameBytes::default();
        // Who reads this gives positions in world space.
        let surroundings = Surroundings { map_size, picture_size: picture, origin: DVec3::ZERO };
        let bindings = Stage::ALL.into_iter().filter_map(|stage| {
            let bindings = stages.bindings(stage)?;
            Some((stage, bindings.iter().map(BindingData::from).collect()))
        });
        Self {
            world,
            triangles,
            origin,
            settings,
            plan: PlanData::new(plan, picture),
            bindings: bindings.collect(),
            frame: base64::prelude::BASE64_STANDARD.encode(frame.write(plan, settings, &surroundings)),
        }
    }
}
