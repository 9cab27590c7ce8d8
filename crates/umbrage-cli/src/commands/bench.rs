//! `umbrage bench`: frame times along the world's path.

mod batch;

use std::sync::Arc;

use serde::Serialize;
use umbrage::{Camera, Settings};
use umbrage_judge::statistics::Spread;
use umbrage_lab::{Milliseconds, Rays, Shot};
use umbrage_render::{Frame, Gpu, Renderer, Show, ViewLoad};
use umbrage_scene::Scene;

use self::batch::{Bench, Timed, Way};
use super::measure::memory_of_rays;
use crate::args::{BaselineArg, BenchArgs};
use crate::failure::Outcome;
use crate::{advice, output, progress, settings, world};

/// Length of a world's path in time, for things that move, seconds.
const PATH_SECONDS: f32 = 10.0;
/// Batches of at most so many frames are timed: long enough for a mean, short enough for a spread, and for ways to take
/// turns often on a machine whose load changes.
const BATCH: usize = 6;

/// `umbrage bench --json`.
#[derive(Serialize)]
struct Report<'a> {
    world: &'a str,
    triangles: usize,
    width: u32,
    height: u32,
    samples: u32,
    adapter: String,
    /// Whether the device timed the passes; otherwise the wall clock did.
    timestamps: bool,
    settings: &'a Settings,
    texels: u64,
    bytes: u64,
    /// Bytes of the casters that rays go through; 0 where maps alone answer.
    occluder_bytes: u64,
    /// The time that their hierarchies took to build, seconds; left out where none were built.
    #[serde(skip_serializing_if = "Option::is_none")]
    occluder_seconds: Option<f64>,
    frames: usize,
    milliseconds: Times,
    /// The same frames drawn otherwise, batch by batch in turn in the same run.
    #[serde(skip_serializing_if = "Option::is_none")]
    baselines: Option<Baselines>,
    /// The views of the last frame.
    views: Vec<View>,
    /// Every timed frame, in order: plan, casters, shade, frame, filter, bending.
    every_frame: Vec<[f64; 6]>,
    /// The mean time of a frame in each batch, in order.
    batches: Vec<f64>,
}

/// Times of one way to draw. The spread of `frame` is that of the batches' means.
#[derive(Serialize)]
struct Times {
    #[serde(flatten)]
    stages: Milliseconds,
    /// The mean time of a frame over the whole run.
    frame_mean: f64,
}

#[derive(Serialize)]
struct Baselines {
    #[serde(skip_serializing_if = "Option::is_none")]
    no_shadows: Option<Times>,
    #[serde(skip_serializing_if = "Option::is_none")]
    no_culling: Option<Times>,
    #[serde(skip_serializing_if = "Option::is_none")]
    no_keeping: Option<Times>,
}

#[derive(Serialize)]
struct View {
    light: usize,
    split: usize,
    draws: usize,
    triangles: u64,
}

pub fn run(args: &BenchArgs) -> Outcome {
    let settings = settings::resolve(&args.shadows)?;
    let scene = world::open(&args.world)?;
    advice::warn(&scene, &settings);
    let shot = world::shot(&args.world, &scene, world::PICTURE)?;
    let gpu = Gpu::new(args.adapter.adapter.as_deref())?;
    let (mut renderer, rays) = Rays::renderer(&gpu, &scene, &settings)?;
    advice::warn_of_rays(&rays);
    let [shadowed, unshadowed, unculled, forgetful] = timed(args, &scene, &shot, &gpu, &mut renderer)?;
    let layout = renderer.shadows().layout();
    let report = Report {
        world: &scene.name,
        triangles: scene.triangles(),
        width: shot.width,
        height: shot.height,
        samples: args.samples,
        adapter: gpu.adapter.to_string(),
        timestamps: gpu.adapter.timestamps,
        settings: renderer.shadows().settings(),
        texels: layout.texels(),
        bytes: renderer.shadows().bytes(),
        occluder_bytes: renderer.shadows().occluder_bytes(),
        occluder_seconds: rays.seconds(),
        frames: shadowed.frames.len(),
        milliseconds: Times::of(&shadowed),
        baselines: (!args.baselines.is_empty()).then(|| Baselines {
            no_shadows: Times::of_any(&unshadowed),
            no_culling: Times::of_any(&unculled),
            no_keeping: Times::of_any(&forgetful),
        }),
        every_frame: shadowed
            .frames
            .iter()
            .map(|t| [t.plan, t.casters, t.shade, t.frame, t.filter, t.deform])
            .collect(),
        views: shadowed.loads.into_iter().map(view).collect(),
        batches: shadowed.batches,
    };
    match &args.json {
        Some(path) => output::write_json(path, &report)?,
        None => output::print(&text(&report))?,
    }
    Ok(())
}

/// Times frames along the path, with the baselines in turn where they are wanted.
fn timed(
    args: &BenchArgs,
    scene: &Scene,
    shot: &Shot,
    gpu: &Gpu,
    renderer: &mut Renderer,
) -> Outcome<[Timed; 4]> {
    let frames = args.frames as usize;
    let share = |number: usize| number as f32 / (frames.max(2) - 1) as f32;
    let mut before = along_path(shot, scene, args, 0.0)?;
    let bar = progress::bar(u64::from(args.frames + args.warm_up), "frames");
    for _ in 0..args.warm_up {
        renderer.render(&before)?;
        bar.inc(1);
    }
    let mut timed = [(); 4].map(|()| Timed::default());
    let has = |baseline| args.baselines.contains(&baseline);
    let ways = [
        (Way::Shadowed, true),
        (Way::Unshadowed, has(BaselineArg::Shadows)),
        (Way::Unculled, has(BaselineArg::Culling)),
        (Way::Forgetful, has(BaselineArg::Keeping)),
    ];
    for start in (0..frames).step_by(BATCH) {
        let numbers = start..frames.min(start + BATCH);
        let batch = numbers.map(|number| along_path(shot, scene, args, share(number)));
        let batch = batch.collect::<Outcome<Vec<_>>>()?;
        for ((way, _), timed) in ways.iter().zip(&mut timed).filter(|((_, is_wanted), _)| *is_wanted) {
            timed.add(Bench { renderer, gpu }, *way, &before, &batch)?;
        }
        bar.inc(batch.len() as u64);
        before = batch.into_iter().last().unwrap_or(before);
    }
    bar.finish_and_clear();
    Ok(timed)
}

impl Times {
    /// The times of a way that was drawn.
    fn of_any(timed: &Timed) -> Option<Self> {
        (!timed.frames.is_empty()).then(|| Self::of(timed))
    }

    fn of(timed: &Timed) -> Self {
        let frames = &timed.frames;
        let stages = Milliseconds { frame: Spread::of(timed.batches.clone()), ..Milliseconds::of(frames) };
        let frame_mean = frames.iter().map(|times| times.frame).sum::<f64>() / frames.len() as f64;
        Self { stages, frame_mean }
    }
}

/// The frame at a share of the way: the camera moves unless the command line says where it is.
fn along_path(shot: &Shot, scene: &Scene, args: &BenchArgs, share: f32) -> Outcome<Frame> {
    let pose = Arc::new(scene.pose(shot.pose.seconds + share * PATH_SECONDS));
    let shot = Shot { pose, ..shot.clone() };
    let frame = Frame { samples: args.samples, ..shot.frame(Show::World)? };
    let is_placed = args.world.place.camera.is_some() || args.world.place.eye.is_some();
    let Some(world_from_camera) = scene.path.world_from_camera(share).filter(|_| !is_placed) else {
        return Ok(frame);
    };
    let old = &frame.camera;
    let camera = Camera::new(world_from_camera, old.projection(), old.near(), old.far())?;
    Ok(Frame { camera, ..frame })
}

fn view(load: ViewLoad) -> View {
    let ViewLoad { light, split, draws, triangles } = load;
    View { light, split, draws, triangles }
}

fn text(report: &Report<'_>) -> String {
    let Report { world, triangles, width, height, adapter, frames, bytes, .. } = report;
    let clock = if report.timestamps { "device timestamps" } else { "wall clock" };
    let casters = memory_of_rays(report.occluder_bytes, report.occluder_seconds);
    let mut text = format!(
        "{world}: {triangles} triangles, {width} x {height}, {frames} frames on {adapter}\n{bytes} bytes of shadow maps{casters}; passes by {clock}, each frame waited for; frames as a window draws them, in the mean\n"
    );
    text += &table(&report.milliseconds);
    for View { light, split, draws, triangles } in &report.views {
        text += &format!("light {light} split {split}: {draws} draws, {triangles} triangles\n");
    }
    let with = &report.milliseconds;
    let Some(Baselines { no_shadows, no_culling, no_keeping }) = &report.baselines else { return text };
    if let Some(without) = no_shadows {
        let ratio = with.frame_mean / without.frame_mean;
        text += &format!("without shadows\n{}", table(without));
        text += &format!("a frame takes {ratio:.2} times as long with shadows\n");
    }
    if let Some(unculled) = no_culling {
        let ratio = with.stages.casters.median / unculled.stages.casters.median;
        text += &format!("without culling parts\n{}", table(unculled));
        text += &format!("casters take {ratio:.2} times as long with culling\n");
    }
    if let Some(anew) = no_keeping {
        let ratio = with.stages.casters.median / anew.stages.casters.median;
        text += &format!("with every map drawn anew\n{}", table(anew));
        text += &format!("casters take {ratio:.3} times as long where tiles are kept\n");
    }
    text
}

fn table(times: &Times) -> String {
    let Times { stages: Milliseconds { plan, deform, casters, filter, shade, frame }, frame_mean } = times;
    let row = |(name, spread): (&str, &Spread)| {
        let Spread { median, p5, p95 } = spread;
        format!("  {name:<8} {median:9.3} ms  ({p5:.3} to {p95:.3})\n")
    };
    let stages =
        [("plan", plan), ("deform", deform), ("casters", casters), ("filter", filter), ("shade", shade)];
    let stages: String = stages.into_iter().map(row).collect();
    let Spread { median: _, p5, p95 } = frame;
    stages + &format!("  {:<8} {frame_mean:9.3} ms  ({p5:.3} to {p95:.3} in batches)\n", "frame")
}
