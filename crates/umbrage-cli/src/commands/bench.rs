//! `umbrage bench`: frame times along the world's path.

use std::sync::Arc;

use serde::Serialize;
use umbrage::{Camera, Settings};
use umbrage_judge::statistics::Spread;
use umbrage_lab::{Milliseconds, Shot};
use umbrage_render::{Frame, Gpu, Rendered, Renderer, Show, ViewLoad};
use umbrage_scene::Scene;

use crate::args::BenchArgs;
use crate::failure::Outcome;
use crate::{advice, output, progress, settings, world};

/// Length of a world's path in time, for things that move, seconds.
const PATH_SECONDS: f32 = 10.0;

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
    frames: usize,
    milliseconds: Milliseconds,
    /// The same frames drawn otherwise, one after the other in the same run.
    #[serde(skip_serializing_if = "Option::is_none")]
    baselines: Option<Baselines>,
    /// The views of the last frame.
    views: Vec<View>,
    /// Every timed frame, in order: plan, casters, shade, frame, filter, bending.
    every_frame: Vec<[f64; 6]>,
}

#[derive(Serialize)]
struct Baselines {
    no_shadows: Milliseconds,
    no_culling: Milliseconds,
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
    advice::warn_of_open_casters(&scene, &settings);
    let shot = world::shot(&args.world, &scene, world::PICTURE)?;
    let gpu = Gpu::new(args.adapter.adapter.as_deref())?;
    let mut renderer = Renderer::new(&gpu, &scene, settings)?;
    let bar = progress::bar(u64::from(args.frames + args.warm_up), "frames");
    let (mut samples, mut no_shadows, mut no_culling, mut loads) =
        (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    for number in 0..args.frames + args.warm_up {
        let counted = number.checked_sub(args.warm_up);
        let share = counted.unwrap_or(0) as f32 / (args.frames.max(2) - 1) as f32;
        let frame = along_path(&shot, &scene, args, share)?;
        let Rendered { drawn, times } = renderer.render(&frame)?;
        loads = drawn.loads().to_vec();
        drop(drawn);
        let mut others = None;
        if args.baselines {
            let unshadowed = renderer.render(&Frame { show: Show::Unshadowed, ..frame.clone() })?.times;
            renderer.cull_parts = false;
            others = Some((unshadowed, renderer.render(&frame)?.times));
            renderer.cull_parts = true;
        }
        if counted.is_some() {
            samples.push(times);
            no_shadows.extend(others.map(|(times, _)| times));
            no_culling.extend(others.map(|(_, times)| times));
        }
        bar.inc(1);
    }
    bar.finish_and_clear();
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
        frames: samples.len(),
        milliseconds: Milliseconds::of(&samples),
        baselines: args.baselines.then(|| Baselines {
            no_shadows: Milliseconds::of(&no_shadows),
            no_culling: Milliseconds::of(&no_culling),
        }),
        views: loads.into_iter().map(view).collect(),
        every_frame: samples
            .iter()
            .map(|t| [t.plan, t.casters, t.shade, t.frame, t.filter, t.deform])
            .collect(),
    };
    match &args.json {
        Some(path) => output::write_json(path, &report)?,
        None => output::print(&text(&report))?,
    }
    Ok(())
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
    let mut text = format!(
        "{world}: {triangles} triangles, {width} x {height}, {frames} frames on {adapter}\n{bytes} bytes of shadow maps; passes by {clock}\n"
    );
    text += &table(&report.milliseconds);
    for View { light, split, draws, triangles } in &report.views {
        text += &format!("light {light} split {split}: {draws} draws, {triangles} triangles\n");
    }
    if let Some(Baselines { no_shadows, no_culling }) = &report.baselines {
        text +=
            &format!("without shadows\n{}without culling parts\n{}", table(no_shadows), table(no_culling));
        let (with, without) = (&report.milliseconds, no_shadows);
        text += &format!(
            "a frame takes {:.2} times as long with shadows\n",
            with.frame.median / without.frame.median
        );
        let share = with.casters.median / no_culling.casters.median;
        text += &format!("casters take {share:.2} times as long with culling\n");
    }
    text
}

fn table(milliseconds: &Milliseconds) -> String {
    let Milliseconds { plan, deform, casters, filter, shade, frame } = milliseconds;
    let row = |(name, spread): (&str, &Spread)| {
        let Spread { median, p5, p95 } = spread;
        format!("  {name:<8} {median:9.3} ms  ({p5:.3} to {p95:.3})\n")
    };
    [
        ("plan", plan),
        ("deform", deform),
        ("casters", casters),
        ("filter", filter),
        ("shade", shade),
        ("frame", frame),
    ]
    .into_iter()
    .map(row)
    .collect()
}
