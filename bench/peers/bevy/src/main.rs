//! Bevy as a peer: draws an exported world with Bevy's own loader, materials and cascades, times frames with and
//! without shadow maps, and writes the pictures that visibility is taken from.
//!
//! It prints one JSON object. Frames are timed as `umbrage bench` does it: two in flight, the mean over a batch, batches with
//! and without maps in turn. Cameras and the sun come from what `umbrage worlds export --cameras` writes.
//!
//! Without `--umbrage` it shares no code with what it is compared with; with it, Bevy has the plug-in of `integrations/bevy`.
//!
//! This program does not: open a window.

mod app;
mod pace;
mod pictures;
mod stage;
mod views;

use std::path::PathBuf;

use anyhow::ensure;
use bevy::math::Vec3;
use clap::Parser;
use serde_json::json;

use crate::app::Peer;
use crate::views::Views;

/// Draws a .glb in Bevy, and prints what its shadows cost, as JSON.
#[derive(Debug, Parser)]
pub struct Args {
    /// The world, as `umbrage worlds export` writes it
    pub scene: PathBuf,
    /// Its cameras and lights, as `umbrage worlds export --cameras` writes them
    #[arg(long)]
    pub cameras: PathBuf,
    /// One of the cameras, by name or by number from 0
    #[arg(long, default_value = "0")]
    pub camera: String,
    /// The way sunlight travels, as X,Y,Z; that of the world's first sun where it is not given
    #[arg(long, allow_hyphen_values = true, value_parser = views::direction)]
    pub sun: Option<Vec3>,
    /// Width of the picture, pixels
    #[arg(long, default_value_t = 640)]
    pub width: u32,
    /// Height of the picture, pixels
    #[arg(long, default_value_t = 360)]
    pub height: u32,
    /// Shadow maps, or cascades
    #[arg(long, default_value_t = 4)]
    pub maps: usize,
    /// Texels a side of each map
    #[arg(long, default_value_t = 1024)]
    pub resolution: usize,
    /// Where the first cascade ends, metres; 3 % of the camera's far distance where it is not given
    #[arg(long)]
    pub first_bound: Option<f32>,
    /// Maps are read so: `hardware` is 2 x 2 PCF, `gaussian` Bevy's default
    #[arg(long, default_value = "hardware", value_parser = ["hardware", "gaussian"])]
    pub filter: String,
    /// Give Bevy the plug-in `bevy_umbrage`: its cascades and its lookup
    #[arg(long)]
    pub umbrage: bool,
    /// Run Bevy's systems one after another: for pictures on a busy machine, where threads wait long for each other. Its times are
    /// not Bevy's
    #[arg(long)]
    pub one_thread: bool,
    /// Frames a batch: Bevy pipelines frames, so that fewer say little
    #[arg(long, default_value_t = 14, value_parser = clap::value_parser!(u32).range(1..))]
    pub frames: u32,
    /// Batches of each kind, with maps and without; 0 times nothing
    #[arg(long, default_value_t = 1)]
    pub batches: u32,
    /// A folder for lit.png, unshadowed.png and ambient.png
    #[arg(long)]
    pub pictures: Option<PathBuf>,
}

fn main() -> anyhow::Result<()> {
    let args = Args::parse();
    ensure!(
        args.maps > 0 && args.resolution > 0,
        "need a map of at least one texel, got {} of {}²",
        args.maps,
        args.resolution
    );
    ensure!(
        args.width > 0 && args.height > 0,
        "need a picture of at least one pixel, got {} x {}",
        args.width,
        args.height
    );
    let views = Views::read(&args.cameras)?;
    let mut peer = Peer::load(&args, views.camera(&args.camera)?, views.sun(args.sun)?)?;
    let (mut with, mut without) = (Vec::new(), Vec::new());
    for _ in 0..args.batches {
        without.push(peer.batch(false, args.frames)?);
        with.push(peer.batch(true, args.frames)?);
    }
    if let Some(folder) = &args.pictures {
        peer.write_pictures(folder)?;
    }
    let report = json!({
        "peer": if args.umbrage { "Bevy with bevy_umbrage" } else { "Bevy" },
        "version": "0.19.1",
        "adapter": peer.adapter(),
        "triangles": peer.triangles(),
        "width": args.width,
        "height": args.height,
        "maps": args.maps,
        "resolution": args.resolution,
        "filter": args.filter,
        "cascades": peer.bounds(),
        "frames_a_batch": args.frames,
        "milliseconds": { "no_shadows": without, "shadows": with },
    });
    println!("{report:#}");
    Ok(())
}
