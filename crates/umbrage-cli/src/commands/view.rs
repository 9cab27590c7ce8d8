//! `umbrage view`: the window.

use std::sync::Arc;

use umbrage::Settings;
use umbrage_judge::statistics::Spread;
use umbrage_scene::Scene;
use umbrage_viewer::Start;
use umbrage_viewer::bench::{self, Benched, Pair};
use umbrage_viewer::link::Link;
use umbrage_viewer::load::Source;
use umbrage_viewer::native::{self, Options};
use umbrage_viewer::reload::Reload;

use crate::args::{DemoArgs, ViewArgs, WorldArgs};
use crate::failure::{Failure, Outcome};
use crate::{output, settings, world};

pub fn run(args: &ViewArgs) -> Outcome {
    let start = match &args.link {
        Some(text) => of_link(args, text)?,
        None => of_words(args)?,
    };
    if !native::has_display() {
        return Err(work(native::NO_DISPLAY.to_owned()));
    }
    let size = args.size.map(|(width, height)| [width as f32, height as f32]);
    let options = Options { adapter: args.adapter.adapter.clone(), size, unlimited: false };
    match args.bench {
        None => native::run(start, &options).map_err(work),
        Some(frames) => {
            let benched = bench::run(start, &options, frames).map_err(work)?;
            Ok(output::print(&text(&benched))?)
        }
    }
}

/// What the options ask for.
fn of_words(args: &ViewArgs) -> Outcome<Start> {
    // It notes the file's state before the file is read, so that no change goes by while the world is loaded.
    let reload = reload(args);
    let settings = settings::resolve(&args.shadows)?;
    let scene = open(args, &args.world)?;
    let camera = world::shot(&seen(args), &scene, world::PICTURE)?.camera;
    Ok(Start {
        camera: Some(camera),
        seconds: args.when.time,
        exposure: args.look.exposure(),
        haze: !args.look.no_haze,
        reload,
        ..of_scene(&args.world, scene, settings)
    })
}

/// The settings file, to be read again when it changes.
fn reload(args: &ViewArgs) -> Option<Reload> {
    let path = args.shadows.shadows.clone()?;
    let shadows = args.shadows.clone();
    Some(Reload::new(path, Arc::new(move || settings::resolve(&shadows).map_err(|why| why.to_string()))))
}

/// What a link asks for; the window says what of it was left out.
fn of_link(args: &ViewArgs, text: &str) -> Outcome<Start> {
    let (mut link, mut messages) = Link::parse(text);
    if let Some(address) = link.load.clone() {
        messages.extend(Source::Address(address).load(&|_| ()).err());
        link = link.of_any_world();
    }
    let name = link.world.clone().unwrap_or_else(|| args.world.clone());
    let scene = open(args, &name)?;
    Ok(Start { link: Some(link), messages, ..of_scene(&name, scene, Settings::default()) })
}

/// A world, as the options change it.
fn open(args: &ViewArgs, name: &str) -> Outcome<Scene> {
    let mut scene = world::load(name, 0)?;
    world::let_cast(&mut scene, &args.casting)?;
    world::play(&mut scene, &args.when)?;
    scene.environment = world::environment(&args.look)?;
    Ok(scene)
}

/// Whether `umbrage demo` may open a window.
pub fn is_possible() -> bool {
    native::has_display()
}

/// The window of `umbrage demo`.
pub fn of_demo(args: &DemoArgs, scene: Scene) -> Outcome {
    let start = of_scene(&args.world, scene, Settings::default());
    let options = Options { adapter: args.adapter.adapter.clone(), ..Options::default() };
    native::run(start, &options).map_err(work)
}

fn of_scene(name: &str, scene: Scene, settings: Settings) -> Start {
    let source = Source::Named(name.to_owned());
    Start { scene: Some(Arc::new(scene)), keeps: true, ..Start::new(source, settings) }
}

/// What is seen, as the other commands ask for it.
fn seen(args: &ViewArgs) -> WorldArgs {
    let ViewArgs { world, place, when, casting, .. } = args;
    WorldArgs {
        world: world.clone(),
        place: place.clone(),
        fov: None,
        near: None,
        far: None,
        sun: None,
        light: Vec::new(),
        near_light: None,
        casting: casting.clone(),
        size: None,
        when: when.clone(),
        seed: 0,
        scene: None,
    }
}

fn work(why: String) -> Failure {
    Failure::Work(anyhow::Error::msg(why))
}

fn text(benched: &Benched) -> String {
    let Benched { pairs, size: [width, height], adapter, world, triangles } = benched;
    let of = |pick: fn(&Pair) -> f64| Spread::of(pairs.iter().map(pick).collect());
    let (alone, in_window) = (of(|pair| pair.alone), of(|pair| pair.in_window));
    let ratio = of(|pair| pair.in_window / pair.alone);
    let row = |name: &str, Spread { median, p5, p95 }: &Spread| {
        format!("  {name:<10} {median:9.3} ms  ({p5:.3} to {p95:.3})\n")
    };
    format!(
        "{world}: {triangles} triangles, {width} x {height}, {} frames on {adapter}\n{}{}a frame takes {:.3} times as long in the window ({:.3} to {:.3})\n",
        pairs.len(),
        row("alone", &alone),
        row("in window", &in_window),
        ratio.median,
        ratio.p5,
        ratio.p95,
    )
}
