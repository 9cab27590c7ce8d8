//! `umbrage demo`: the default world three ways from one camera, as one picture that explains itself.
//!
//! A column a technique: the picture; the same with the splits tinted; the shadow maps; what they cost.

use anyhow::Context as _;
use image::{DynamicImage, GrayImage, RgbaImage};
use umbrage::{MapTexels, Preset, Settings, ShadowPlan};
use umbrage_render::{Frame, FrameTimes, Gpu, Picture, Renderer, Show};
use umbrage_scene::worlds;

use crate::args::DemoArgs;
use crate::commands::plan::splits_text;
use crate::commands::render::grey_map;
use crate::failure::Outcome;
use crate::label::Sheet;
use crate::{output, progress, world};

/// Pictures are drawn and printed this large, pixels.
const WIDTH: u32 = 640;
const HEIGHT: u32 = 360;
/// White between pictures.
const GAP: u32 = 16;
/// Side of a shadow map's thumbnail: three and their gaps are as wide as a picture.
const MAP: u32 = (WIDTH - 2 * GAP) / 3;
/// Room for the words over and under pictures.
const HEAD: u32 = 96;
const LINE: u32 = 26;
const WORDS: u32 = 5 * LINE;

/// What the rows are, in the column that has no shadows to show.
const LEGEND: [&str; 9] = [
    "Upper row: the world as it is drawn.",
    "",
    "Middle row: the same, each split of the view tinted.",
    "A split is a slice of depth with a shadow map of its own.",
    "",
    "Lower row: those shadow maps, seen from the sun,",
    "near dark, far pale, white where nothing casts.",
    "",
    "Below: where the view is cut, and what it costs.",
];

/// A way to draw the world, and what came of it.
struct Column {
    title: &'static str,
    shadowed: RgbaImage,
    tinted: Option<RgbaImage>,
    maps: Vec<RgbaImage>,
    words: Vec<String>,
}

pub fn run(args: &DemoArgs) -> Outcome {
    let scene = world::load(worlds::DEFAULT, 0)?;
    let gpu = Gpu::new(args.adapter.adapter.as_deref())?;
    let frame = main_frame(&scene)?;
    let mut renderer = Renderer::new(&gpu, &scene, Settings::default())?;
    let ways = [
        ("One shadow map of 1024² (zhang-ssm-1024)", Some("zhang-ssm-1024")),
        ("Three splits of 1024² (ferko-pssm-3x1024)", Some("ferko-pssm-3x1024")),
        ("No shadows", None),
    ];
    let bar = progress::bar(ways.len() as u64, "drawing");
    let mut columns = Vec::new();
    for (title, preset) in ways {
        columns.push(column(&mut renderer, &frame, title, preset, gpu.adapter.timestamps)?);
        bar.inc(1);
    }
    bar.finish_and_clear();
    let heading =
        format!("{}: {} triangles, one sun, one camera; {}", scene.name, scene.triangles(), gpu.adapter);
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
    Ok(())
}

/// The world's first camera and its sun.
fn main_frame(scene: &umbrage_scene::Scene) -> Outcome<Frame> {
    let camera = umbrage_render::camera(&scene.cameras[0], WIDTH as f32 / HEIGHT as f32)?;
    let (sun, sun_colour) = umbrage_render::sun(scene).context("the default world has a sun")?;
    Ok(Frame {
        camera,
        sun,
        sun_colour,
        seconds: 0.0,
        width: WIDTH,
        height: HEIGHT,
        samples: 4,
        show: Show::World,
    })
}

fn column(
    renderer: &mut Renderer<'_>,
    frame: &Frame,
    title: &'static str,
    preset: Option<&str>,
    has_timestamps: bool,
) -> Outcome<Column> {
    let clock = if has_timestamps { "device time" } else { "wall time" };
    let Some(preset) = preset else {
        let frame = Frame { show: Show::Unshadowed, ..*frame };
        let times = timed(renderer, &frame)?.1;
        let shadowed = image_of(renderer.picture()?)?;
        let words = vec![format!("shading {:.2} ms ({clock}, median of {RUNS})", times.shade)];
        return Ok(Column { title, shadowed, tinted: None, maps: Vec::new(), words });
    };
    let preset = Preset::named(preset).with_context(|| format!("there is a preset {preset}"))?;
    renderer.set_settings((preset.settings)())?;
    let (plan, times) = timed(renderer, frame)?;
    let shadowed = image_of(renderer.picture()?)?;
    let maps = renderer.maps().ok().map(|maps| thumbnails(&maps, &plan)).unwrap_or_default();
    renderer.render(&Frame { show: Show::Splits, ..*frame })?;
    let tinted = Some(image_of(renderer.picture()?)?);
    let texels: Vec<String> = plan.views().iter().map(|view| format!("{:.3}", view.texel_metres)).collect();
    let words = vec![
        format!("splits {} m", splits_text(plan.splits())),
        format!("a texel is {} m", texels.join(", ")),
        format!("{} texels, {} bytes", plan.layout().texels(), plan.layout().bytes()),
        format!("casters {:.2} ms, shading {:.2} ms ({clock}, median of {RUNS})", times.casters, times.shade),
    ];
    Ok(Column { title, shadowed, tinted, maps, words })
}

/// How often a picture is drawn for its times.
const RUNS: usize = 5;

/// Draws a frame several times with one sample a pixel, then once with all; the plan, and the median of each stage.
fn timed(renderer: &mut Renderer<'_>, frame: &Frame) -> Outcome<(ShadowPlan, FrameTimes)> {
    let mut times = Vec::new();
    for _ in 0..=RUNS {
        times.push(renderer.render(&Frame { samples: 1, ..*frame })?.times);
    }
    times.remove(0); // the first frame also makes what later ones reuse
    let last = renderer.render(frame)?;
    let median = |pick: fn(&FrameTimes) -> f64| {
        let mut values: Vec<f64> = times.iter().map(pick).collect();
        values.sort_by(f64::total_cmp);
        values[values.len() / 2]
    };
    let times = FrameTimes {
        plan: median(|t| t.plan),
        casters: median(|t| t.casters),
        shade: median(|t| t.shade),
        frame: median(|t| t.frame),
    };
    Ok((last.plan, times))
}

fn image_of(picture: Picture) -> anyhow::Result<RgbaImage> {
    RgbaImage::from_raw(picture.width, picture.height, picture.rgba)
        .context("a picture has four bytes a pixel")
}

fn thumbnails(maps: &MapTexels, plan: &ShadowPlan) -> Vec<RgbaImage> {
    let views = plan.views().iter();
    views
        .filter_map(|view| GrayImage::from_raw(view.tile.size, view.tile.size, grey_map(maps, view)))
        .map(|grey| DynamicImage::ImageLuma8(grey).into_rgba8())
        .collect()
}

fn compose(heading: &str, columns: &[Column]) -> anyhow::Result<RgbaImage> {
    let width = GAP + columns.len() as u32 * (WIDTH + GAP);
    let height = HEAD + 2 * (HEIGHT + GAP) + MAP + GAP + WORDS;
    let mut sheet = Sheet::new(width, height)?;
    let foot = HEAD + 2 * (HEIGHT + GAP) + MAP + GAP;
    sheet.write(heading, GAP, 12, 26.0);
    for (i, column) in columns.iter().enumerate() {
        let x = GAP + i as u32 * (WIDTH + GAP);
        let mut y = HEAD;
        sheet.write(column.title, x, y - LINE - 8, 24.0);
        sheet.place(&column.shadowed, x, y, WIDTH, HEIGHT);
        y += HEIGHT + GAP;
        for (j, line) in column.words.iter().enumerate() {
            sheet.write(line, x, foot + j as u32 * LINE, 20.0);
        }
        if column.tinted.is_none() {
            for (j, line) in LEGEND.iter().enumerate() {
                sheet.write(line, x, y + j as u32 * (LINE + 6), 22.0);
            }
        }
        if let Some(tinted) = &column.tinted {
            sheet.place(tinted, x, y, WIDTH, HEIGHT);
            y += HEIGHT + GAP;
            for (j, map) in column.maps.iter().enumerate() {
                sheet.place(map, x + j as u32 * (MAP + GAP), y, MAP, MAP);
            }
        }
    }
    Ok(sheet.image)
}
