//! An experiment as a user might write it, and rows that no GPU has drawn: their figures follow simple formulas.

use std::collections::BTreeMap;
use std::io::Cursor;

use image::{DynamicImage, ImageFormat, RgbImage, RgbaImage};
use umbrage::Settings;
use umbrage_judge::statistics::Spread;
use umbrage_judge::{Causes, Error, Verdict};
use umbrage_lab::heat::heat_map;
use umbrage_lab::{
    Claim, Experiment, Machine, Measurement, Milliseconds, Outcome, Pictures, Plot, Row, Run, Sweep,
    TruthCounts, Variant, Watch,
};

/// Four variants, one of which sweeps λ.
pub fn experiment() -> Experiment {
    let variant = |name: &str, reported: &[(&str, &str)]| Variant {
        name: name.to_owned(),
        preset: "default".to_owned(),
        set: toml::Table::new(),
        family: None,
        area: None,
        sweep: None,
        reported: reported.iter().map(|(a, b)| ((*a).to_owned(), (*b).to_owned())).collect(),
    };
    let lambda = Sweep {
        key: "lambda".to_owned(),
        values: (0..9).map(|i| toml::Value::Float(f64::from(i) / 8.0)).collect(),
    };
    Experiment {
        title: "Parallel-split shadow maps against one map".to_owned(),
        source: "Zhang, Sun, Xu, Lun: Parallel-Split Shadow Maps for Large-scale Virtual Environments, VRCIA 2006, \
                 figure 7 and table 1"
            .to_owned(),
        reported: "Four splits of 1024² texels show fewer aliased edges than one map of the same memory, near and \
                   far.\n\nThe mean of the uniform and the logarithmic scheme is said to be the best compromise; no \
                   number is given for it."
            .to_owned(),
        worlds: ["forest", "city", "terrain", "pillars"].map(str::to_owned).to_vec(),
        cameras: ["ground", "above"].map(str::to_owned).to_vec(),
        variants: vec![
            variant("one map, 1024²", &[("forest", "38 fps"), ("city", "41 fps")]),
            variant("one map, 2048²", &[]),
            variant("four splits", &[("forest", "29 fps, visibly sharper"), ("city", "31 fps")]),
            Variant { sweep: Some(lambda), ..variant("four splits, λ", &[]) },
        ],
        seed: 7,
        size: [640, 360],
        repeats: 16,
        frames: 120,
        pictures: true,
        enlarged: [("forest".to_owned(), [10, 20, 60, 40])].into(),
        motions: vec![],
        watch: Watch::default(),
        truths: vec![],
        light_points: 256,
        columns: [
            "error.mis_shadowed",
            "error.false_shadow",
            "error.false_light",
            "error.edge_displacement_px",
            "flip",
            "bytes",
            "milliseconds.frame.median",
        ]
        .map(str::to_owned)
        .to_vec(),
        plots: vec![
            plot("bytes", "error.mis_shadowed", true, true, false),
            plot("milliseconds.frame.median", "error.mis_shadowed", false, true, false),
            plot("sweep", "error.mis_shadowed", false, false, false),
            plot("sweep", "error.edge_displacement_px", false, false, true),
        ],
        claims: vec![
            claim("Splits are less wrong than one map of the same memory.", "four splits", 1.0),
            claim("Splits are less than a fifth as wrong.", "four splits", 0.21),
            claim("A larger map is a twentieth as wrong.", "one map, 2048²", 0.05),
        ],
    }
}

/// A plot.
pub fn plot(x: &str, y: &str, log_x: bool, pareto: bool, by_world: bool) -> Plot {
    Plot { x: x.to_owned(), y: y.to_owned(), log_x, pareto, by_world, variants: vec![] }
}

/// A claim about mis-shadowed pixels, against the small map.
pub fn claim(says: &str, variant: &str, times: f64) -> Claim {
    Claim {
        says: says.to_owned(),
        figure: "error.mis_shadowed".to_owned(),
        variant: variant.to_owned(),
        than: "one map, 1024²".to_owned(),
        times,
        worlds: vec![],
        cameras: vec![],
    }
}

/// Every row of an experiment, in the order it would be run.
pub fn rows(experiment: &Experiment) -> Vec<Row> {
    let mut rows = Vec::new();
    for (w, world) in experiment.worlds.iter().enumerate() {
        for (c, camera) in experiment.cameras.iter().enumerate() {
            for (i, variant) in experiment.variants.iter().enumerate() {
                let values = variant.sweep.iter().flat_map(|sweep| sweep.values.iter().cloned().map(Some));
                let values: Vec<_> = if variant.sweep.is_none() { vec![None] } else { values.collect() };
                for swept in values {
                    for repeat in 0..experiment.repeats {
                        rows.push(row(experiment, (world, w), (camera, c), i, swept.clone(), repeat));
                    }
                }
            }
        }
    }
    rows
}

fn row(
    experiment: &Experiment,
    (world, w): (&str, usize),
    (camera, c): (&str, usize),
    variant: usize,
    swept: Option<toml::Value>,
    repeat: u32,
) -> Row {
    let lambda = swept.as_ref().and_then(toml::Value::as_float).unwrap_or(0.5);
    let (splits, resolution) = [(1, 1024), (1, 2048), (4, 1024), (4, 1024)][variant % 4];
    let settings = Settings { splits, resolution, lambda: lambda as f32, ..Settings::default() };
    let texels = u64::from(splits * resolution * resolution);
    let jitter = noise(&[w, c, repeat as usize]);
    let own = noise(&[w, c, repeat as usize, variant]);
    let base = [0.052, 0.027, 0.0105, 0.0105][variant % 4] * (1.0 + 2.0 * (lambda - 0.6).powi(2));
    let wrong = base * (1.0 + 0.4 * w as f64) * (1.0 + 0.2 * jitter) * (1.0 + 0.05 * own);
    let frame = 1.1 + 0.35 * f64::from(splits) + f64::from(resolution) / 1024.0 * 0.4 + 0.2 * w as f64;
    let frame = frame + 0.02 * own;
    let first = repeat == 0;
    let measurement = Measurement {
        world: world.to_owned(),
        triangles: 40_000 * (w + 1),
        camera: camera.to_owned(),
        width: experiment.size[0],
        height: experiment.size[1],
        adapter: MACHINE_ADAPTER.to_owned(),
        settings: settings.clone(),
        texels,
        bytes: texels * 4,
        occluder_bytes: 0,
        occluder_seconds: None,
        traced_a_pixel: None,
        made_ready: None,
        shadows_milliseconds: None,
        truth: TruthCounts {
            pixels: 150_000,
            ambiguous: 90,
            shadowed: 40_000,
            partial: 0,
            edge_px: 5_000.0,
            standard_error: 0.0,
        },
        error: Some(error(wrong)),
        sub_pixel: None,
        sun: None,
        wide_sun: None,
        lights: vec![],
        aliasing: Default::default(),
        flip: Some(2.0 * wrong),
        splits: vec![],
        around_cuts: vec![],
        milliseconds: (first && experiment.frames > 0).then(|| milliseconds(frame)),
        every_frame: vec![],
        flicker: None,
    };
    let pictures = (first && experiment.pictures).then(|| pictures(experiment.size, w + 4 * c, wrong));
    let run = Run {
        world: world.to_owned(),
        world_hash: String::new(),
        seed: experiment.seed,
        camera: camera.to_owned(),
        repeat,
        settings,
        family: None,
        area: None,
        truths: vec![],
        light_points: experiment.light_points,
        size: experiment.size,
        frames: if first { experiment.frames } else { 0 },
        pictures: first && experiment.pictures,
        motion: None,
        watch: experiment.watch,
        adapter: MACHINE_ADAPTER.to_owned(),
        program: "5f2c8a01d9".to_owned(),
    };
    let machine = Machine {
        adapter: MACHINE_ADAPTER.to_owned(),
        timestamps: true,
        system: "linux x86_64".to_owned(),
        cores: 16,
        commit: "6294189".to_owned(),
    };
    Row { variant, swept, run, outcome: Outcome { machine, measurement, pictures } }
}

const MACHINE_ADAPTER: &str =
    "llvmpipe (LLVM 15.0.6, 256 bits) (software, vulkan, llvmpipe Mesa 22.3.6 (LLVM 15.0.6))";

/// From −1 to 1, the same for the same numbers.
fn noise(numbers: &[usize]) -> f64 {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    for number in numbers {
        state = (state ^ *number as u64).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        state ^= state >> 29;
    }
    (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
}

/// An error of which two thirds are false shadow.
pub fn error(wrong: f64) -> Error {
    Error {
        mis_shadowed: wrong,
        false_shadow: wrong * 2.0 / 3.0,
        false_light: wrong / 3.0,
        rmse: wrong.sqrt(),
        mae: wrong,
        bias: -wrong / 3.0,
        edge_displacement_px: Some(30.0 * wrong),
        hausdorff_95_px: Some(200.0 * wrong),
        causes: Causes::default(),
        decades: vec![],
    }
}

fn milliseconds(frame: f64) -> Milliseconds {
    let spread = |median: f64| Spread { median, p5: 0.93 * median, p95: 1.15 * median };
    Milliseconds {
        plan: spread(0.05),
        deform: spread(0.0),
        casters: spread(0.5 * frame),
        filter: spread(0.0),
        shade: spread(0.4 * frame),
        frame: spread(frame),
    }
}

/// Discs of shade on a lit plane, with edges as wide as the picture is wrong.
fn pictures([width, height]: [u32; 2], place: usize, wrong: f64) -> Pictures {
    let mut shaded = RgbImage::new(width, height);
    let mut verdicts = Vec::new();
    for (x, y, pixel) in shaded.enumerate_pixels_mut() {
        let (across, up) = (f64::from(x) / f64::from(width), f64::from(y) / f64::from(height));
        if up < 0.3 {
            *pixel = image::Rgb([150, 190, 225]);
            verdicts.push(Verdict::NotJudged);
            continue;
        }
        let wave = (19.0 * across + place as f64).sin() * (13.0 * up + 2.0 * place as f64).cos() - 0.2;
        let step = noise(&[(x / 6) as usize, (y / 6) as usize, place]) * 3.0 * wrong;
        let (truth, drawn) = (wave > 0.0, wave + step > 0.0);
        let light = if drawn { 60.0 } else { 175.0 } * (0.7 + 0.3 * up);
        *pixel = image::Rgb([light as u8, (light * 0.97) as u8, (light * 0.8) as u8]);
        verdicts.push(match (truth, drawn) {
            (false, true) => Verdict::FalseShadow,
            (true, false) => Verdict::FalseLight,
            _ => Verdict::Right,
        });
    }
    let rgba = DynamicImage::ImageRgb8(shaded.clone()).into_rgba8();
    let heat = RgbaImage::from_raw(width, height, heat_map(rgba.as_raw(), &verdicts)).unwrap();
    let file = |picture: DynamicImage, format| {
        let mut bytes = Cursor::new(Vec::new());
        picture.write_to(&mut bytes, format).unwrap();
        bytes.into_inner()
    };
    Pictures {
        exact: file(DynamicImage::ImageRgb8(shaded.clone()), ImageFormat::Jpeg),
        shaded: file(DynamicImage::ImageRgb8(shaded), ImageFormat::Jpeg),
        error: file(DynamicImage::ImageRgb8(DynamicImage::ImageRgba8(heat).into_rgb8()), ImageFormat::Png),
    }
}

/// One world, one camera, two variants, no pictures.
pub fn small() -> Experiment {
    let mut experiment = experiment();
    experiment.worlds.truncate(1);
    experiment.cameras.truncate(1);
    experiment.variants.truncate(3);
    experiment.variants.iter_mut().for_each(|variant| variant.reported = BTreeMap::new());
    experiment.pictures = false;
    experiment
}
