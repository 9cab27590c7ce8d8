//! `umbrage measure`: how wrong shadows are, and what they cost.

use std::collections::BTreeMap;
use std::path::Path;

use image::ExtendedColorType;
use serde::Serialize;
use umbrage_judge::statistics::Interval;
use umbrage_judge::{DepthBand, jittered};
use umbrage_lab::figures::{self, Figure};
use umbrage_lab::{
    Foreign, ForeignError, Judged, Laboratory, Measurement, Motion, OfFamily, SUB_PIXELS, Shot, Technique,
    TruthKind, Watch, Wrong, files,
};
use umbrage_render::{Gpu, Picture};
use umbrage_rivals::{BakeProgress, Family};
use umbrage_scene::Scene;

use crate::args::{MeasureArgs, MotionArg, TruthArg};
use crate::failure::{Failure, Outcome};
use crate::{advice, output, progress, settings, world};

/// Pictures are measured this large where the command line does not say, pixels.
const SIZE: (u32, u32) = (640, 360);

/// `umbrage measure --json`.
#[derive(Serialize)]
struct Report<'a> {
    #[serde(flatten)]
    measurement: &'a Measurement,
    /// The scene's own origin lies here in the coordinates of the world's file, metres.
    origin: [f64; 3],
    /// The mean of every figure over the jittered cameras, and how far from the true mean it may be.
    #[serde(skip_serializing_if = "Option::is_none")]
    intervals: &'a Option<BTreeMap<&'static str, Sure>>,
    /// What is wrong with the shadows that another renderer drew.
    #[serde(skip_serializing_if = "Option::is_none")]
    pictures: &'a Option<ForeignError>,
}

#[derive(Serialize)]
struct Sure {
    mean: f64,
    half_width_95: f64,
    samples: Interval,
}

/// What came of measuring.
pub struct Measured {
    pub judged: Judged,
    origin: [f64; 3],
    intervals: Option<BTreeMap<&'static str, Sure>>,
    pictures: Option<ForeignError>,
}

pub fn run(args: &MeasureArgs) -> Outcome {
    check_outputs(args)?;
    let measured = measure(args)?.of_some_pixels()?;
    write_pictures(args, &measured.judged)?;
    let text = if args.json.is_some() { measured.json()? } else { measured.text() };
    Ok(output::write_text(args.json.as_deref().unwrap_or(Path::new("-")), &text)?)
}

/// Measures what is asked for.
pub fn measure(args: &MeasureArgs) -> Outcome<Measured> {
    let settings = settings::resolve(&args.shadows)?;
    let scene = world::open(&args.world)?;
    advice::warn(&scene, &settings);
    let shot = world::shot(&args.world, &scene, SIZE)?;
    let foreign = args.pictures.as_deref().map(|folder| foreign(folder, &shot)).transpose()?;
    let gpu = Gpu::new(args.adapter.adapter.as_deref())?;
    let mut laboratory = Laboratory::new(&gpu, &scene)?;
    let bar = progress::bar(u64::from(args.repeats), "measuring");
    let mut family =
        args.family.map(|family| ready(&gpu, &scene, family, args.keep.as_deref())).transpose()?;
    if let Some(family) = &family {
        advice::warn_of_left(&scene, family.left());
    }
    let mut judged = laboratory.judge(&shot, &settings, technique(&mut family), kind(args), args.frames)?;
    bar.inc(1);
    advice::warn_of_rays(laboratory.rays());
    let mut others = Vec::new();
    for repeat in 1..args.repeats {
        let moved = Shot { camera: jittered(&shot.camera, repeat), ..shot.clone() };
        others.push(laboratory.judge(&moved, &settings, technique(&mut family), kind(args), 0)?.measurement);
        bar.inc(1);
    }
    if let Some(arg) = args.motion {
        judged.measurement.flicker =
            Some(laboratory.flicker(&shot, &settings, motion(arg), Watch::default())?);
    }
    let pictures = match &foreign {
        Some(foreign) => laboratory.judge_foreign(&shot, &judged, foreign)?,
        None => None,
    };
    bar.finish_and_clear();
    let intervals = (!others.is_empty()).then(|| intervals(&judged.measurement, &others));
    Ok(Measured { judged, origin: scene.origin.to_array(), intervals, pictures })
}

impl Measured {
    /// The same, where there is anything to judge.
    pub fn of_some_pixels(self) -> Outcome<Self> {
        match self.judged.measurement.error {
            Some(_) => Ok(self),
            None => {
                Err(anyhow::anyhow!("no pixels to judge: the camera sees nothing that a light could reach")
                    .into())
            }
        }
    }

    pub fn json(&self) -> anyhow::Result<String> {
        let Self { judged, origin, intervals, pictures } = self;
        output::json(&Report { measurement: &judged.measurement, origin: *origin, intervals, pictures })
    }

    fn text(&self) -> String {
        text(&self.judged.measurement, self.intervals.as_ref()) + &foreign_text(self.pictures.as_ref())
    }
}

/// A family made ready, with a bar for what takes long.
fn ready(gpu: &Gpu, scene: &Scene, family: Family, keep: Option<&Path>) -> Outcome<OfFamily> {
    let bar = progress::bar(0, "making ready");
    let tell = |so_far: BakeProgress| {
        bar.set_length(so_far.total.unwrap_or(0) as u64);
        bar.set_position(so_far.done as u64);
        true
    };
    let ready = OfFamily::ready(gpu, scene, family, keep, &tell);
    bar.finish_and_clear();
    Ok(ready?)
}

fn technique(family: &mut Option<OfFamily>) -> Option<&mut dyn Technique> {
    family.as_mut().map(|family| family as &mut dyn Technique)
}

/// Whether everything can be written where it is wanted, before any work is done.
fn check_outputs(args: &MeasureArgs) -> Outcome {
    let files = [&args.json, &args.heat_map, &args.true_picture].into_iter().flatten();
    for path in files.filter(|path| path.as_os_str() != "-") {
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
        files::check_writable(folder.unwrap_or(Path::new(".")))?;
    }
    Ok(())
}

/// What another renderer drew of the shot, which has one light.
fn foreign(folder: &Path, shot: &Shot) -> Outcome<Foreign> {
    let lights = shot.lights.len();
    if lights != 1 {
        let wanted = "--pictures is judged by one light; choose it with --light or --sun";
        return Err(Failure::usage(format!("{wanted}, got {lights}")));
    }
    Ok(Foreign::read(folder)?)
}

fn kind(args: &MeasureArgs) -> TruthKind {
    match args.truth {
        TruthArg::Hard => TruthKind::Hard,
        TruthArg::SubPixel => TruthKind::SubPixel(SUB_PIXELS),
        TruthArg::Soft => TruthKind::Soft { samples: args.sun_points, angle: args.sun_angle.to_radians() },
    }
}

fn motion(arg: MotionArg) -> Motion {
    match arg {
        MotionArg::Translate => Motion::Translate,
        MotionArg::Yaw => Motion::Yaw,
        MotionArg::Walk => Motion::Walk,
        MotionArg::Fast => Motion::Fast,
        MotionArg::Sun => Motion::Sun,
        MotionArg::Objects => Motion::Objects,
        MotionArg::SubTexel => Motion::SubTexel,
    }
}

fn write_pictures(args: &MeasureArgs, judged: &Judged) -> anyhow::Result<()> {
    for (path, picture) in [(&args.heat_map, &judged.heat_map), (&args.true_picture, &judged.true_picture)] {
        if let Some(path) = path {
            let Picture { width, height, rgba } = picture;
            output::write_png(path, *width, *height, rgba, ExtendedColorType::Rgba8)?;
        }
    }
    Ok(())
}

/// Every figure that all measurements have.
fn intervals(first: &Measurement, others: &[Measurement]) -> BTreeMap<&'static str, Sure> {
    let sure = |figure: &'static Figure| {
        let samples =
            std::iter::once(first).chain(others).map(|m| figure.of(m)).collect::<Option<Vec<f64>>>()?;
        let samples = Interval::of(samples);
        Some((figure.key, Sure { mean: samples.mean(), half_width_95: samples.half_width(), samples }))
    };
    figures::ALL.iter().filter_map(sure).collect()
}

fn text(measurement: &Measurement, intervals: Option<&BTreeMap<&'static str, Sure>>) -> String {
    let Measurement { world, camera, triangles, width, height, adapter, truth, texels, .. } = measurement;
    let mut text =
        format!("{world}, camera {camera}: {triangles} triangles, {width} x {height} on {adapter}\n");
    text += &memory_text(measurement);
    // Most worlds have no glass.
    let partly = if truth.partial > 0 { format!(", {} lit in part", truth.partial) } else { String::new() };
    text += &format!(
        "{} pixels judged, {} of them shadowed{partly}, {} ambiguous; {:.0} pixels of shadow edge\n\n",
        truth.pixels, truth.shadowed, truth.ambiguous, truth.edge_px
    );
    for figure in figures::ALL.iter().filter(|figure| !figure.key.starts_with("truth")) {
        let Some(value) = figure.of(measurement) else { continue };
        if figure.key == "texels" && *texels == 0 {
            continue;
        }
        let sure = intervals.and_then(|intervals| intervals.get(figure.key));
        let mean = sure.filter(|sure| sure.half_width_95 > 0.0).map_or_else(String::new, |sure| {
            format!("   mean {} ± {}", figure.text(sure.mean), figure.text(sure.half_width_95))
        });
        text += &format!("{:<20} {:>14}{mean}\n", figure.label, figure.text(value));
    }
    if let Some(flicker) = &measurement.flicker {
        text += &format!(
            "{} points watched for {} frames, {} times in sight in two frames in a row\n",
            flicker.points, flicker.frames, flicker.pairs
        );
    }
    for (i, band) in measurement.splits.iter().enumerate() {
        text += &format!("split {i}: {}\n", band_text(band));
    }
    text
}

/// What shadows are read from: maps, or another family with maps or without.
fn memory_text(measurement: &Measurement) -> String {
    let Measurement { texels, bytes, occluder_bytes, occluder_seconds, made_ready, .. } = measurement;
    let casters = memory_of_rays(*occluder_bytes, *occluder_seconds);
    match (made_ready, texels) {
        (None, texels) => format!("{texels} texels, {bytes} bytes of shadow maps{casters}\n"),
        (Some(_), 0) => format!("{bytes} bytes, and no shadow maps\n"),
        (Some(_), texels) => {
            format!("{bytes} bytes, among them shadow maps of {texels} texels{casters}\n")
        }
    }
}

/// What rays go through, after the maps; nothing where maps alone answer.
pub fn memory_of_rays(bytes: u64, seconds: Option<f64>) -> String {
    match (bytes, seconds) {
        (0, _) => String::new(),
        (bytes, None) => format!(", {bytes} bytes of casters for rays"),
        (bytes, Some(seconds)) => format!(", {bytes} bytes of casters for rays, built in {seconds:.2} s"),
    }
}

fn foreign_text(pictures: Option<&ForeignError>) -> String {
    let Some(ForeignError { pixels, share, error, ours }) = pictures else { return String::new() };
    let wrong = |wrong: &Wrong| {
        format!("{:.3} % mis-shadowed, mean error {:.4}", 100.0 * wrong.mis_shadowed, wrong.mae)
    };
    let share = 100.0 * share;
    format!(
        "\nof {pixels} pixels, {share:.1} % of those judged:\n  pictures {}\n  ours     {}\n",
        wrong(error),
        wrong(ours)
    )
}

fn band_text(band: &DepthBand) -> String {
    let DepthBand { depths: [from, to], pixels, mis_shadowed, mae, edge_displacement_px, .. } = band;
    let edges =
        edge_displacement_px.map_or_else(String::new, |px| format!(", edges displaced by {px:.3} px"));
    let wrong = format!("{:.3} % mis-shadowed, mean error {mae:.4}", 100.0 * mis_shadowed);
    format!("{from:.1} to {to:.1} m, {pixels} pixels, {wrong}{edges}")
}
