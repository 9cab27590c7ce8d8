//! Bevy itself, driven frame by frame without a window.

use std::path::Path;
use std::time::Duration;

use anyhow::{Context as _, bail, ensure};
use bevy::app::{PluginsState, SubApp};
use bevy::asset::{LoadState, RecursiveDependencyLoadState, UnapprovedPathMode};
use bevy::camera::RenderTarget;
use bevy::ecs::schedule::SingleThreadedExecutor;
use bevy::gltf::GltfLoaderSettings;
use bevy::light::{CascadeShadowConfig, DirectionalLightShadowMap, GlobalAmbientLight};
use bevy::log::LogPlugin;
use bevy::prelude::*;
use bevy::render::RenderApp;
use bevy::render::RenderPlugin;
use bevy::render::pipelined_rendering::PipelinedRenderingPlugin;
use bevy::render::render_resource::{TextureFormat, TextureUsages};
use bevy::render::renderer::RenderAdapterInfo;
use bevy::window::ExitCondition;
use bevy::world_serialization::{WorldAsset, WorldAssetRoot};
use bevy_umbrage::UmbragePlugin;

use crate::Args;
use crate::pace::{self, Done};
use crate::stage;
use crate::views::View;

/// Frames that are drawn after a change and not counted: Bevy prepares things over several.
const SETTLE: u32 = 8;
/// Bevy is given so many turns of [`TURN`] to load a world.
const MOST_TURNS: u32 = 60_000;
const TURN: Duration = Duration::from_millis(10);

/// A world in Bevy, with a camera and a sun.
pub struct Peer {
    /// Bevy.
    pub app: App,
    /// What the camera draws into.
    pub target: Handle<Image>,
    /// The sun.
    pub sun: Entity,
    done: Done,
}

impl Peer {
    /// Loads a world, and waits until all of it has come.
    pub fn load(args: &Args, view: View, sun: Vec3) -> anyhow::Result<Self> {
        let scene =
            args.scene.canonicalize().with_context(|| format!("cannot read {}", args.scene.display()))?;
        let done = Done::default();
        let mut app = start(args, &done);
        let mut image =
            Image::new_target_texture(args.width, args.height, TextureFormat::Rgba8UnormSrgb, None);
        image.texture_descriptor.usage |= TextureUsages::COPY_SRC;
        let world = app.world_mut();
        let target = world.resource_mut::<Assets<Image>>().add(image);
        world.spawn(stage::camera(args, &view, RenderTarget::Image(target.clone().into())));
        let sun = world.spawn(stage::sun(sun, stage::cascades(args, &view))).id();
        load(&mut app, &scene)?;
        let mut peer = Self { app, target, sun, done };
        peer.settle();
        Ok(peer)
    }

    /// Times a batch of frames, with shadow maps or without: the mean of one, milliseconds.
    pub fn batch(&mut self, with_shadows: bool, frames: u32) -> anyhow::Result<f64> {
        self.change_sun(|sun| sun.shadow_maps_enabled = with_shadows);
        self.settle();
        self.done.clear();
        // One is done before the first that is counted.
        while self.done.times().len() <= frames as usize {
            self.app.update();
        }
        let times = self.done.times();
        let (first, last) = times.first().zip(times.get(frames as usize)).context("no frame was done")?;
        Ok((*last - *first).as_secs_f64() * 1e3 / f64::from(frames))
    }

    /// Changes the sun.
    pub fn change_sun(&mut self, change: impl FnOnce(&mut DirectionalLight)) {
        if let Some(mut sun) = self.app.world_mut().get_mut::<DirectionalLight>(self.sun) {
            change(&mut sun);
        }
    }

    /// Draws until what was changed is in the picture.
    pub fn settle(&mut self) {
        for _ in 0..SETTLE {
            self.app.update();
        }
    }

    /// Where the cascades end, metres.
    pub fn bounds(&self) -> Vec<f32> {
        let config = self.app.world().get::<CascadeShadowConfig>(self.sun);
        config.map(|config| config.bounds.clone()).unwrap_or_default()
    }

    /// The adapter that draws, with its backend and driver.
    pub fn adapter(&self) -> String {
        let info = self.app.world().resource::<RenderAdapterInfo>();
        format!("{} ({:?}, {} {})", info.name, info.backend, info.driver, info.driver_info)
    }

    /// The triangles of everything that stands in the world.
    pub fn triangles(&mut self) -> usize {
        let mut placed = self.app.world_mut().query::<&Mesh3d>();
        let meshes = self.app.world().resource::<Assets<Mesh>>();
        let corners =
            |mesh: &Mesh| mesh.indices().map_or_else(|| mesh.count_vertices(), |indices| indices.len());
        placed.iter(self.app.world()).filter_map(|mesh| meshes.get(mesh)).map(|mesh| corners(mesh) / 3).sum()
    }
}

/// Starts Bevy without a window.
fn start(args: &Args, done: &Done) -> App {
    let mut app = App::new();
    let mut plugins = DefaultPlugins.build();
    if args.one_thread {
        plugins = plugins.disable::<PipelinedRenderingPlugin>();
    }
    app.add_plugins(
        plugins
            .set(WindowPlugin { primary_window: None, exit_condition: ExitCondition::DontExit, ..default() })
            .set(AssetPlugin { unapproved_path_mode: UnapprovedPathMode::Allow, ..default() })
            // Things whose pipelines are still compiled would be left out of a frame.
            .set(RenderPlugin { synchronous_pipeline_compilation: true, ..default() })
            // What is printed is JSON.
            .set(LogPlugin { filter: "warn,bevy_gltf=error".to_owned(), ..default() }),
    );
    if args.umbrage {
        app.add_plugins(UmbragePlugin::default());
    }
    app.insert_resource(DirectionalLightShadowMap { size: args.resolution });
    app.insert_resource(GlobalAmbientLight { brightness: stage::AMBIENT, ..default() });
    app.insert_resource(ClearColor(Color::BLACK));
    pace::add(&mut app, done);
    while app.plugins_state() == PluginsState::Adding {
        bevy::tasks::tick_global_task_pools_on_main_thread();
    }
    app.finish();
    app.cleanup();
    if args.one_thread {
        run_in_turn(app.main_mut());
        app.get_sub_app_mut(RenderApp).map(run_in_turn);
    }
    app
}

/// Lets the systems of an application run one after another.
fn run_in_turn(app: &mut SubApp) {
    for (_, schedule) in app.world_mut().resource_mut::<Schedules>().iter_mut() {
        schedule.set_executor(SingleThreadedExecutor::new());
    }
}

/// Loads a file with Bevy's loader, without its own cameras and lights, and waits for it.
fn load(app: &mut App, scene: &Path) -> anyhow::Result<()> {
    let server = app.world().resource::<AssetServer>().clone();
    let first = GltfAssetLabel::Scene(0).from_asset(scene.to_path_buf());
    let without_views = |settings: &mut GltfLoaderSettings| {
        settings.load_cameras = false;
        settings.load_lights = false;
    };
    let handle: Handle<WorldAsset> = server.load_builder().with_settings(without_views).load(first);
    app.world_mut().spawn(WorldAssetRoot(handle.clone()));
    for _ in 0..MOST_TURNS {
        app.update();
        if let Some(LoadState::Failed(why)) = server.get_load_state(&handle) {
            bail!("Bevy cannot load the world ({why}): {}", scene.display());
        }
        match server.recursive_dependency_load_state(&handle) {
            RecursiveDependencyLoadState::Loaded => break,
            RecursiveDependencyLoadState::Failed(why) => {
                bail!("Bevy cannot load all of the world ({why}): {}", scene.display())
            }
            RecursiveDependencyLoadState::NotLoaded | RecursiveDependencyLoadState::Loading => {
                std::thread::sleep(TURN)
            }
        }
    }
    ensure!(server.is_loaded_with_dependencies(&handle), "Bevy does not finish loading {}", scene.display());
    Ok(())
}
