//! `umbrage render`: a picture, its visibility, its shadow maps.

use std::path::Path;

use image::ExtendedColorType;
use umbrage::{Exact, Settings};
use umbrage_lab::aliasing::{Aliasing, AliasingSummary, heat_map};
use umbrage_lab::{Laboratory, Rays, Shot};
use umbrage_render::{Area, Drawn, Frame, Gpu, MapLook, Mark, RenderError, Renderer, Show};
use umbrage_scene::Scene;

use crate::args::RenderArgs;
use crate::failure::{Failure, Outcome};
use crate::{advice, output, settings, world};

pub fn run(args: &RenderArgs) -> Outcome {
    let pictures = [&args.output, &args.visibility, &args.maps, &args.aliasing];
    if pictures.into_iter().all(Option::is_none) {
        return Err(Failure::usage(
            "nothing to write: give -o FILE.png, --visibility FILE.png, --aliasing FILE.png or --maps DIR",
        ));
    }
    let settings = settings::resolve(&args.shadows)?;
    let scene = world::open_with(&args.world, &args.look)?;
    advice::warn(&scene, &settings);
    let show = match (args.no_shadows, args.splits) {
        (true, _) => Show::Unshadowed,
        (false, true) => Show::Marked(Mark::Splits),
        (false, false) => Show::World,
    };
    let shot = world::shot(&args.world, &scene, world::PICTURE)?;
    let frame =
        Frame { exposure: args.look.exposure(), haze: !args.look.no_haze, ..world::frame(&shot, show)? };
    let gpu = Gpu::new(args.adapter.adapter.as_deref())?;
    if let Some(path) = &args.aliasing {
        write_aliasing(path, &gpu, &scene, &shot, &settings)?;
    }
    let (mut renderer, rays) = Rays::renderer(&gpu, &scene, &settings)?;
    advice::warn_of_rays(&rays);
    let area = args.area_samples.map(|samples| Area { samples, degrees: args.area_degrees });
    if let Some(path) = &args.visibility {
        let grey = visibility(&mut renderer, &frame, 0, area)?;
        let bytes: Vec<u8> = grey.into_iter().map(|visibility| (255.0 * visibility).round() as u8).collect();
        output::write_png(path, frame.width, frame.height, &bytes, ExtendedColorType::L8)?;
    }
    if let Some(path) = &args.output {
        let show = match area {
            None => frame.show.clone(),
            Some(area) => Show::Given(soft(&mut renderer, &frame, area)?),
        };
        let picture = renderer.render(&Frame { show, ..frame.clone() })?.drawn.picture()?;
        output::write_png(path, picture.width, picture.height, &picture.rgba, ExtendedColorType::Rgba8)?;
    }
    if let Some(folder) = &args.maps {
        let drawn = renderer.render(&Frame { show: Show::Nothing, ..frame })?.drawn;
        write_maps(folder, &mut renderer, &drawn)?;
    }
    Ok(())
}

/// Returns how much of a light reaches each pixel, 0 to 1.
fn visibility(
    renderer: &mut Renderer,
    frame: &Frame,
    light: usize,
    area: Option<Area>,
) -> Result<Vec<f32>, RenderError> {
    if let Some(area) = area {
        return Ok(renderer.area(frame, light, area)?.visibility);
    }
    let frame = Frame { show: Show::Visibility(light), ..frame.clone() };
    Ok(renderer.render(&frame)?.drawn.picture()?.visibility())
}

/// The same of every light that has some size, one after the other.
fn soft(renderer: &mut Renderer, frame: &Frame, area: Area) -> Result<Vec<f32>, RenderError> {
    let lights = (0..frame.lights.len()).map(|light| Ok(renderer.area(frame, light, area)?.visibility));
    Ok(lights.collect::<Result<Vec<_>, RenderError>>()?.concat())
}

/// Writes how large texels look, and says it in a few numbers.
fn write_aliasing(path: &Path, gpu: &Gpu, scene: &Scene, shot: &Shot, settings: &Settings) -> Outcome {
    // Texels are those of the maps, whatever rays say.
    let settings = Settings { exact: Exact::Off, ..settings.clone() };
    let Aliasing { extents, summary } = Laboratory::new(gpu, scene)?.aliasing(shot, &settings, 0)?;
    let nothing =
        || anyhow::anyhow!("no texels to look at: the camera sees nothing that the light could reach");
    let AliasingSummary { median_px, p95_px, max_px, under_sampled, over_sampled, utilisation } =
        summary.ok_or_else(nothing)?;
    output::write_png(path, shot.width, shot.height, &heat_map(&extents), ExtendedColorType::Rgba8)?;
    output::print(&format!(
        "a texel is {median_px:.2} pixels long in the median, {p95_px:.2} at the 95th percentile, {max_px:.2} at most\n\
         {:.1} % of pixels have a longer texel than a pixel, {:.1} % a shorter one than half; {:.1} % of all texels are read\n",
        100.0 * under_sampled,
        100.0 * over_sampled,
        100.0 * utilisation,
    ))?;
    Ok(())
}

fn write_maps(folder: &Path, renderer: &mut Renderer, drawn: &Drawn) -> anyhow::Result<()> {
    std::fs::create_dir_all(folder)?;
    for view in drawn.plan().views() {
        let path = folder.join(format!("light{}-split{}.png", view.light, view.split));
        let map = renderer.read_map_picture(drawn, view.index, GREY_MAP, view.tile.size)?;
        let grey: Vec<u8> = map.rgba.into_iter().step_by(4).collect();
        output::write_png(&path, map.width, map.height, &grey, ExtendedColorType::L8)?;
    }
    Ok(())
}

/// A map as grey: near dark, far pale, stretched over what is in it; white where nothing is.
pub const GREY_MAP: MapLook = MapLook { invert: false, stretch: true, greys: [20, 220], even: false };
