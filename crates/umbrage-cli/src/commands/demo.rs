//! `umbrage demo`: a world three ways from one camera, beside the truth, as one picture that explains itself.
//!
//! A column a technique: the picture; where it is wrong; which map serves what; the shadow maps; what they cost.
//! The last technique traces what its maps cannot decide, and the last column is the judge's own tracing.

use std::sync::Arc;

use anyhow::Context as _;
use image::RgbaImage;
use umbrage::{Exact, LightKind, Settings, ShadowPlan};
use umbrage_lab::{Judged, Laboratory, Measurement, Shot, TruthKind};
use umbrage_render::{Drawn, Frame, Gpu, Mark, Picture, Renderer, Show};
use umbrage_scene::{Scene, Shining};

use crate::args::DemoArgs;
use crate::commands::plan::splits_text;
use crate::commands::render::GREY_MAP;
use crate::failure::{Failure, Outcome};
use crate::label::Sheet;
use crate::{advice, commands::view, output, progress, world};

/// Pictures are drawn and printed this large, pixels.
const WIDTH: u32 = 640;
const HEIGHT: u32 = 360;
/// White between pictures.
const GAP: u32 = 16;
/// Side of a shadow map's thumbnail: four and their gaps are as wide as a picture.
const MAP: u32 = (WIDTH - 3 * GAP) / 4;
/// Room for the words over and under pictures.
const HEAD: u32 = 96;
const LINE: u32 = 26;
const WORDS: u32 = 8 * LINE;

/// As many maps as a picture is wide.
const MOST_VIEWS: usize = 4;

/// A picture is drawn so many times to be timed.
const RUNS: u32 = 5;

/// What the rows are, in the column that has no shadow maps to show.
const LEGEND: [&str; 16] = [
    "Upper row: the world as it is drawn; here with the shadows that",
    "the others are judged by, a ray from every pixel to the light.",
    "",
    "Second row: where shadows are wrong. Orange is shadowed and",
    "should be lit, blue is lit and should be shadowed. What is",
    "darkest is not judged: sky, and surfaces turned from the light.",
    "",
    "Third row: tinted by the shadow map that serves each place.",
    "Each split, a slice of depth, has a map of its own; the finest",
    "map that covers a place serves it.",
    "",
    "Lower row: those shadow maps, seen from the light,",
    "near dark, far pale, white where nothing casts.",
    "",
    "Below: where the view is cut, how wrong shadows are, and what",
    "they cost.",
];

/// A way to draw the world, and what came of it.
struct Column {
    title: String,
    shadowed: RgbaImage,
    wrong: RgbaImage,
    tinted: RgbaImage,
    maps: Vec<RgbaImage>,
    words: Vec<String>,
    truth: RgbaImage,
}

pub fn run(args: &DemoArgs) -> Outcome {
    let scene = world::load(&args.world, 0)?;
    if args.window_only {
        return view::of_demo(args, scene);
    }
    let gpu = Gpu::new(args.adapter.adapter.as_deref())?;
    let shot = main_shot(&scene)?;
    let mut laboratory = Laboratory::new(&gpu, &scene)?;
    let four = Settings::default();
    // The same bytes and all else alike: what differs is the splits.
    let one = Settings { splits: 1, resolution: 2 * four.resolution, ..four.clone() };
    // The same maps once more: what differs is the rays.
    let exact = Settings { exact: Exact::Undecided, ..four.clone() };
    let bar = progress::bar(3, "drawing and judging");
    let mut columns = Vec::new();
    for settings in [one, four, exact] {
        columns.push(column(&mut laboratory, &shot, &settings, gpu.adapter.timestamps)?);
        bar.inc(1);
    }
    bar.finish_and_clear();
    advice::warn_of_rays(laboratory.rays());
    let lights =
        if shot.lights.len() == 1 { "one light".to_owned() } else { format!("{} lights", shot.lights.len()) };
    let heading =
        format!("{}: {} triangles, {lights}, one camera; {}", scene.name, scene.triangles(), gpu.adapter);
    let sheet = compose(&heading, &columns)?;
    let (width, height) = sheet.dimensions();
    output::write_png(&args.output, width, height, &sheet, image::ExtendedColorType::Rgba8)?;
    let mut text = format!("{heading}\n");
    for column in &columns {
        text += &format!("\n{}\n", column.title);
        column.words.iter().for_each(|line| text += &format!("  {line}\n"));
    }
    output::print(&text)?;
    eprintln!("picture: {}", args.output.display());
    if !args.no_window && view::is_possible() {
        // The picture is there, whatever becomes of the window.
        if let Err(failure) = view::of_demo(args, scene) {
            eprintln!("no window: {failure}");
        }
    }
    Ok(())
}

/// The world's first camera and its lights.
fn main_shot(scene: &Scene) -> Outcome<Shot> {
    let camera = scene.cameras.first().context("this world has no camera")?.clone();
    let pose = Arc::new(scene.pose(0.0));
    let Shining { lights, warnings } = Shining::choose(&scene.lights, &camera, &pose, umbrage::MAX_LIGHTS);
    world::warn(&warnings);
    if lights.is_empty() {
        return Err(Failure::usage("this world has no light; `umbrage render` takes one as --sun X,Y,Z"));
    }
    Ok(Shot { camera, lights, pose, width: WIDTH, height: HEIGHT })
}

fn column(
    laboratory: &mut Laboratory<'_>,
    shot: &Shot,
    settings: &Settings,
    has_timestamps: bool,
) -> Outcome<Column> {
    // Two by two samples a pixel for what is drawn and for what is exact.
    let large = Shot { width: 2 * shot.width, height: 2 * shot.height, ..shot.clone() };
    let Judged { shaded, true_picture, .. } = laboratory.judge(&large, settings, None, TruthKind::Hard, 0)?;
    let (shadowed, truth) = (halved(&image_of(shaded)?), halved(&image_of(true_picture)?));
    let judged = laboratory.judge(shot, settings, None, TruthKind::Hard, RUNS)?;
    let renderer = laboratory.renderer();
    let drawn = renderer.render(&Frame { samples: 4, ..shot.frame(Show::World)? })?.drawn;
    let maps = thumbnails(renderer, &drawn);
    let tinted = image_of(renderer.show(&drawn, &Show::Marked(Mark::Splits))?.picture()?)?;
    let words = words(&judged.measurement, &judged.plan, has_timestamps)?;
    let Judged { heat_map, plan: judged_plan, measurement, .. } = judged;
    let wrong = image_of(heat_map)?;
    // Splits are a sun's.
    let maps_title = match (main_rays(&judged_plan), settings.splits) {
        (Some(LightKind::Directional { .. }), 1) => format!("One shadow map of {}²", settings.resolution),
        (Some(LightKind::Directional { .. }), splits) => {
            format!("{splits} splits of {}²", settings.resolution)
        }
        _ => views_text(&judged_plan),
    };
    let title = if measurement.occluder_bytes > 0 {
        format!("Exact, in real time: {maps_title}, and rays")
    } else {
        maps_title
    };
    Ok(Column { title, shadowed, wrong, tinted, maps, words, truth })
}

fn main_rays(plan: &ShadowPlan) -> Option<LightKind> {
    plan.lights().first().map(|light| light.kind())
}

fn views_text(plan: &ShadowPlan) -> String {
    let views = plan.views().len();
    format!("{views} shadow map{}", if views == 1 { "" } else { "s" })
}

/// What a technique does, how wrong it is, and what it costs.
fn words(measurement: &Measurement, plan: &ShadowPlan, has_timestamps: bool) -> anyhow::Result<Vec<String>> {
    let error = measurement
        .error
        .as_ref()
        .context("no pixels to judge: the camera sees nothing that a light could reach")?;
    let times = measurement.milliseconds.unwrap_or_default();
    let clock = if has_timestamps { "device time" } else { "wall time" };
    // Of many lights' views the first few will do.
    let texels: Vec<String> =
        plan.views().iter().take(MOST_VIEWS).map(|view| format!("{:.3}", view.texel_metres)).collect();
    let percent = |share: f64| format!("{:.2} %", 100.0 * share);
    let edges =
        error.edge_displacement_px.map_or_else(String::new, |px| format!("; edges off by {px:.2} pixels"));
    let mut words = vec![
        match main_rays(plan) {
            Some(LightKind::Directional { .. }) => format!("splits {} m", splits_text(plan.splits())),
            _ => views_text(plan),
        },
        format!("a texel is {} m", texels.join(", ")),
        format!("{} of pixels wrongly shadowed or lit{edges}", percent(error.mis_shadowed)),
        format!("visibility is off by {} in the mean", percent(error.mae)),
        format!(
            "{} shadowed falsely, {} lit falsely",
            percent(error.false_shadow),
            percent(error.false_light)
        ),
        format!("{} texels, {} bytes", measurement.texels, measurement.bytes),
        format!(
            "casters {:.2} ms, shading {:.2} ms ({clock}, median of {RUNS})",
            times.casters.median, times.shade.median
        ),
    ];
    if let Some(seconds) = measurement.occluder_seconds.filter(|_| measurement.occluder_bytes > 0) {
        words.push(format!(
            "and {} bytes of casters for rays, built once in {seconds:.1} s",
            measurement.occluder_bytes
        ));
    }
    Ok(words)
}

/// A picture of half the size: each pixel is the mean of four.
fn halved(picture: &RgbaImage) -> RgbaImage {
    image::imageops::thumbnail(picture, picture.width() / 2, picture.height() / 2)
}

fn image_of(picture: Picture) -> anyhow::Result<RgbaImage> {
    RgbaImage::from_raw(picture.width, picture.height, picture.rgba)
        .context("a picture has four bytes a pixel")
}

/// The first maps; none where the adapter cannot read them (GL).
fn thumbnails(renderer: &mut Renderer, drawn: &Drawn) -> Vec<RgbaImage> {
    let views = drawn.plan().views().iter().take(MOST_VIEWS);
    let painted =
        views.map_while(|view| renderer.read_map_picture(drawn, view.index, GREY_MAP, view.tile.size).ok());
    painted.filter_map(|map| image_of(map).ok()).collect()
}

fn compose(heading: &str, columns: &[Column]) -> anyhow::Result<RgbaImage> {
    let width = GAP + (columns.len() as u32 + 1) * (WIDTH + GAP);
    let rows = 3 * (HEIGHT + GAP);
    let foot = HEAD + rows + MAP + GAP;
    let mut sheet = Sheet::new(width, foot + WORDS)?;
    sheet.write(heading, GAP, 12, 26.0);
    let mut x = GAP;
    for column in columns {
        sheet.write(&column.title, x, HEAD - LINE - 8, 24.0);
        for (picture, y) in [&column.shadowed, &column.wrong, &column.tinted].into_iter().zip([0, 1, 2]) {
            sheet.place(picture, x, HEAD + y * (HEIGHT + GAP), WIDTH, HEIGHT);
        }
        for (map, j) in column.maps.iter().zip(0..) {
            sheet.place(map, x + j * (MAP + GAP), HEAD + rows, MAP, MAP);
        }
        for (line, j) in column.words.iter().zip(0..) {
            sheet.write(line, x, foot + j * LINE, 20.0);
        }
        x += WIDTH + GAP;
    }
    sheet.write("Exact, traced by the judge", x, HEAD - LINE - 8, 24.0);
    if let Some(column) = columns.last() {
        sheet.place(&column.truth, x, HEAD, WIDTH, HEIGHT);
    }
    for (line, j) in LEGEND.iter().zip(0..) {
        sheet.write(line, x, HEAD + HEIGHT + GAP + j * (LINE + 6), 22.0);
    }
    Ok(sheet.image)
}
