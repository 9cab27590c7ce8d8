//! `umbrage bench`: frame times along the world's path.

use serde::Serialize;
use umbrage::Settings;
use umbrage_render::{Frame, FrameTimes, Gpu, Renderer, Show, ViewLoad};
use umbrage_scene::{Camera, Scene};

use crate::args::BenchArgs;
use crate::failure::Outcome;
use crate::{output, progress, settings, world};

/// Length of a world's path in time, for things that move, seconds.
const PATH_SECONDS: f32 = 10.0;

/// `umbrage bench --json`.
#[derive(Serialize)]
struct Report<'a> {
    world: &'a str,
    triangles: usize,
    width: u32,
    height: u32,
    adapter: String,
    /// Whether the device timed the passes; otherwise the wall clock did.
    timestamps: bool,
    settings: &'a Settings,
    shadows: bool,
    cull_parts: bool,
    texels: u64,
    bytes: u64,
    frames: usize,
    milliseconds: Milliseconds,
    /// Of the last frame.
    views: Vec<View>,
    /// Every timed frame, in order.
    samples: Vec<[f64; 4]>,
}

#[derive(Serialize)]
struct Milliseconds {
    plan: Spread,
    casters: Spread,
    shade: Spread,
    frame: Spread,
}

#[derive(Serialize)]
struct View {
    split: usize,
    draws: usize,
    triangles: u64,
}

/// The middle of some numbers, and where all but the outer twentieths of them lie.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Spread {
    pub median: f64,
    pub p5: f64,
    pub p95: f64,
}

pub fn run(args: &BenchArgs) -> Outcome {
    let settings = settings::resolve(&args.shadows)?;
    let scene = world::load(&args.world.world, args.world.seed)?;
    let show = if args.no_shadows { Show::Unshadowed } else { Show::World };
    let frame = world::frame(&args.world, &scene, show)?;
    let gpu = Gpu::new(args.adapter.adapter.as_deref())?;
    let mut renderer = Renderer::new(&gpu, &scene, settings)?;
    renderer.cull_parts = !args.no_cull;
    let bar = progress::bar(u64::from(args.frames + args.warm_up), "frames");
    let (mut samples, mut loads) = (Vec::new(), Vec::new());
    for number in 0..args.frames + args.warm_up {
        let counted = number.checked_sub(args.warm_up);
        let share = counted.unwrap_or(0) as f32 / (args.frames.max(2) - 1) as f32;
        let rendered = renderer.render(&along_path(&frame, &scene, args, share)?)?;
        if counted.is_some() {
            samples.push(rendered.times);
        }
        loads = rendered.views;
        bar.inc(1);
    }
    bar.finish_and_clear();
    let layout = renderer.shadows().layout();
    let report = Report {
        world: &scene.name,
        triangles: scene.triangles(),
        width: frame.width,
        height: frame.height,
        adapter: gpu.adapter.to_string(),
        timestamps: gpu.adapter.timestamps,
        settings: renderer.shadows().settings(),
        shadows: !args.no_shadows,
        cull_parts: !args.no_cull,
        texels: layout.texels(),
        bytes: layout.bytes(),
        frames: samples.len(),
        milliseconds: milliseconds(&samples),
        views: loads.into_iter().map(view).collect(),
        samples: samples.iter().map(|t| [t.plan, t.casters, t.shade, t.frame]).collect(),
    };
    match &args.json {
        Some(path) => output::write_json(path, &report)?,
        None => output::print(&text(&report))?,
    }
    Ok(())
}

/// The frame at a share of the way: the camera moves unless the command line says where it is.
fn along_path(frame: &Frame, scene: &Scene, args: &BenchArgs, share: f32) -> Outcome<Frame> {
    let seconds = frame.seconds + share * PATH_SECONDS;
    let is_placed = args.world.camera.is_some() || args.world.eye.is_some();
    let Some(world_from_camera) = scene.path.world_from_camera(share).filter(|_| !is_placed) else {
        return Ok(Frame { seconds, ..*frame });
    };
    let lens = scene.cameras[0].lens;
    let (near, far) = (frame.camera.near(), frame.camera.far());
    let camera = Camera { name: String::new(), world_from_camera, lens, near, far };
    let camera = umbrage_render::camera(&camera, frame.width as f32 / frame.height as f32)?;
    Ok(Frame { camera, seconds, ..*frame })
}

fn view(load: ViewLoad) -> View {
    let ViewLoad { split, draws, triangles } = load;
    View { split, draws, triangles }
}

fn milliseconds(samples: &[FrameTimes]) -> Milliseconds {
    let of = |pick: fn(&FrameTimes) -> f64| spread(samples.iter().map(pick).collect());
    Milliseconds {
        plan: of(|t| t.plan),
        casters: of(|t| t.casters),
        shade: of(|t| t.shade),
        frame: of(|t| t.frame),
    }
}

/// Median and 5th and 95th percentile, by nearest rank; zeros of nothing.
fn spread(mut values: Vec<f64>) -> Spread {
    values.sort_by(f64::total_cmp);
    let rank = |share: f64| {
        let index = (share * values.len() as f64).ceil() as usize;
        values.get(index.saturating_sub(1)).copied().unwrap_or(0.0)
    };
    Spread { median: rank(0.5), p5: rank(0.05), p95: rank(0.95) }
}

fn text(report: &Report<'_>) -> String {
    let Report { world, triangles, width, height, adapter, frames, milliseconds, views, bytes, .. } = report;
    let clock = if report.timestamps { "device timestamps" } else { "wall clock" };
    let mut text = format!(
        "{world}: {triangles} triangles, {width} x {height}, {frames} frames on {adapter}\n{bytes} bytes of shadow maps; passes by {clock}\n"
    );
    let Milliseconds { plan, casters, shade, frame } = milliseconds;
    for (name, Spread { median, p5, p95 }) in
        [("plan", plan), ("casters", casters), ("shade", shade), ("frame", frame)]
    {
        text += &format!("{name:<8} {median:9.3} ms  ({p5:.3} to {p95:.3})\n");
    }
    for View { split, draws, triangles } in views {
        text += &format!("split {split}: {draws} draws, {triangles} triangles\n");
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_spread_of_one_to_a_hundred_is_5_50_95() {
        let values = (1..=100).rev().map(f64::from).collect();
        assert_eq!(spread(values), Spread { median: 50.0, p5: 5.0, p95: 95.0 });
        assert_eq!(spread(vec![7.0]), Spread { median: 7.0, p5: 7.0, p95: 7.0 });
    }
}
