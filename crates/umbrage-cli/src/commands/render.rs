//! `umbrage render`: a picture, its visibility, its shadow maps.

use std::path::Path;

use image::ExtendedColorType;
use umbrage::{MapTexels, ShadowView};
use umbrage_render::{Frame, Gpu, Renderer, Show};

use crate::args::RenderArgs;
use crate::failure::{Failure, Outcome};
use crate::{output, settings, world};

pub fn run(args: &RenderArgs) -> Outcome {
    if args.output.is_none() && args.visibility.is_none() && args.maps.is_none() {
        return Err(Failure::words(
            "nothing to write: give -o FILE.png, --visibility FILE.png or --maps DIR",
        ));
    }
    let settings = settings::resolve(&args.shadows)?;
    let scene = world::load(&args.world.world, args.world.seed)?;
    let show = match (args.no_shadows, args.splits) {
        (true, _) => Show::Unshadowed,
        (false, true) => Show::Splits,
        (false, false) => Show::World,
    };
    let frame = world::frame(&args.world, &scene, show)?;
    let gpu = Gpu::new(args.adapter.adapter.as_deref())?;
    let mut renderer = Renderer::new(&gpu, &scene, settings)?;
    if let Some(path) = &args.visibility {
        renderer.render(&Frame { show: Show::Visibility(0), ..frame.clone() })?;
        let picture = renderer.picture()?;
        let grey: Vec<u8> = picture.rgba.iter().step_by(4).copied().collect();
        output::write_png(path, picture.width, picture.height, &grey, ExtendedColorType::L8)?;
    }
    let rendered = renderer.render(&frame)?;
    if let Some(path) = &args.output {
        let picture = renderer.picture()?;
        output::write_png(path, picture.width, picture.height, &picture.rgba, ExtendedColorType::Rgba8)?;
    }
    if let Some(folder) = &args.maps {
        write_maps(folder, &renderer.maps()?, rendered.plan.views())?;
    }
    Ok(())
}

fn write_maps(folder: &Path, maps: &MapTexels, views: &[ShadowView]) -> anyhow::Result<()> {
    std::fs::create_dir_all(folder)?;
    for view in views {
        let path = folder.join(format!("light{}-split{}.png", view.light, view.split));
        output::write_png(
            &path,
            view.tile.size,
            view.tile.size,
            &grey_map(maps, view),
            ExtendedColorType::L8,
        )?;
    }
    Ok(())
}

/// A map as grey: near dark, far pale, stretched over what is in it; white where nothing is.
pub fn grey_map(maps: &MapTexels, view: &ShadowView) -> Vec<u8> {
    let cast = || maps.tile(view.tile).filter(|depth| *depth < 1.0);
    let (near, far) = (cast().fold(1.0, f32::min), cast().fold(0.0, f32::max));
    let range = (far - near).max(1e-6);
    let grey = |depth: f32| if depth < 1.0 { 20.0 + 200.0 * (depth - near) / range } else { 255.0 };
    maps.tile(view.tile).map(|depth| grey(depth) as u8).collect()
}
