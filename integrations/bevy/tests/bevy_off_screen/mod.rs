//! Bevy without a window, which draws the boxes into a picture that is read back.
//!
//! Bevy reads its shaders in the background, and draws nothing with those that are not there: a picture waits for all of them.

use std::time::Duration;

use bevy::app::{PluginsState, SubApp};
use bevy::camera::RenderTarget;
use bevy::core_pipeline::tonemapping::{DebandDither, Tonemapping};
use bevy::ecs::schedule::SingleThreadedExecutor;
use bevy::light::{
    CascadeShadowConfig, CascadeShadowConfigBuilder, DirectionalLightShadowMap, GlobalAmbientLight,
};
use bevy::prelude::*;
use bevy::render::pipelined_rendering::PipelinedRenderingPlugin;
use bevy::render::render_resource::{PipelineCache, TextureFormat, TextureUsages};
use bevy::render::view::screenshot::{Screenshot, ScreenshotCaptured};
use bevy::render::{RenderApp, RenderPlugin};
use bevy::window::ExitCondition;
use bevy_umbrage::{UmbragePlugin, UmbrageShadows};

use crate::boxes::{FAR, SIZE, SUN, boxes, camera, fov};

/// Frames after a change until it is in the picture, once no pipeline waits for a shader.
const SETTLE: u32 = 8;
/// Shaders, and a picture, are waited for so many frames at most, each followed by a pause of [`TURN`].
const MOST_FRAMES: u32 = 10_000;
const TURN: Duration = Duration::from_millis(5);

/// Bevy, with the boxes, a camera and a sun.
pub struct Drawn {
    app: App,
    target: Handle<Image>,
    sun: Entity,
    /// The cascades that the sun was given.
    pub config: CascadeShadowConfig,
}

/// A picture that came back.
#[derive(Resource)]
struct Captured(Image);

impl Drawn {
    /// Starts Bevy, with the plug-in or without.
    pub fn new(plugin: Option<UmbragePlugin>) -> Self {
        let mut app = started(plugin);
        let config = CascadeShadowConfigBuilder { maximum_distance: FAR, ..default() }.build();
        let world = app.world_mut();
        let material = world.resource_mut::<Assets<StandardMaterial>>().add(StandardMaterial {
            perceptual_roughness: 1.0,
            reflectance: 0.0,
            ..Color::srgb(0.7, 0.7, 0.7).into()
        });
        for (middle, half) in boxes() {
            let mesh = world.resource_mut::<Assets<Mesh>>().add(Cuboid { half_size: half });
            world.spawn((
                Mesh3d(mesh),
                MeshMaterial3d(material.clone()),
                Transform::from_translation(middle),
            ));
        }
        let mut image = Image::new_target_texture(SIZE[0], SIZE[1], TextureFormat::Rgba8UnormSrgb, None);
        image.texture_descriptor.usage |= TextureUsages::COPY_SRC;
        let target = world.resource_mut::<Assets<Image>>().add(image);
        let lens = PerspectiveProjection { fov: fov(), aspect_ratio: 16.0 / 9.0, far: FAR, ..default() };
        world.spawn((
            Camera3d::default(),
            Projection::Perspective(lens),
            RenderTarget::Image(target.clone().into()),
            camera(),
            (Tonemapping::None, DebandDither::Disabled, Msaa::Off),
        ));
        let sun = (
            DirectionalLight { illuminance: 2600.0, shadow_maps_enabled: true, ..default() },
            config.clone(),
            Transform::default().looking_to(SUN, Vec3::Y),
        );
        let sun = world.spawn(sun).id();
        let mut drawn = Self { app, target, sun, config };
        drawn.settle();
        drawn
    }

    /// How much sunlight reaches each pixel, 0 to 1; `None` where the sun does next to nothing.
    pub fn visibility(&mut self) -> Vec<Option<f32>> {
        let lit = self.picture(true);
        let unshadowed = self.picture(false);
        lit.into_iter().zip(unshadowed).map(|(lit, all)| (all > 0.02).then(|| lit / all)).collect()
    }

    /// Gives the sun other cascades.
    pub fn edit(&mut self, config: CascadeShadowConfig) {
        self.mark(config);
        self.settle();
    }

    /// Changes what the plug-in is to do.
    pub fn choose(&mut self, shadows: UmbrageShadows) {
        self.app.insert_resource(shadows);
        self.settle();
    }

    /// Gives the sun a component.
    pub fn mark(&mut self, bundle: impl Bundle) {
        self.app.world_mut().entity_mut(self.sun).insert(bundle);
    }

    /// Where the cascades end, metres.
    pub fn bounds(&self) -> Vec<f32> {
        let config = self.app.world().get::<CascadeShadowConfig>(self.sun);
        config.map(|config| config.bounds.clone()).unwrap_or_default()
    }

    /// The green of each pixel, linear.
    fn picture(&mut self, with_shadows: bool) -> Vec<f32> {
        if let Some(mut sun) = self.app.world_mut().get_mut::<DirectionalLight>(self.sun) {
            sun.shadow_maps_enabled = with_shadows;
        }
        self.settle();
        let screenshot = Screenshot::image(self.target.clone());
        self.app.world_mut().remove_resource::<Captured>();
        self.app.world_mut().spawn(screenshot).observe(
            |captured: On<ScreenshotCaptured>, mut commands: Commands| {
                commands.insert_resource(Captured(captured.image.clone()));
            },
        );
        for _ in 0..MOST_FRAMES {
            self.app.update();
            if let Some(Captured(image)) = self.app.world_mut().remove_resource() {
                return greens(&image);
            }
            std::thread::sleep(TURN);
        }
        panic!("no picture came back in {MOST_FRAMES} frames");
    }

    /// Draws until what was changed is in the picture.
    fn settle(&mut self) {
        let mut ready = 0;
        for _ in 0..MOST_FRAMES {
            self.app.update();
            if self.is_waiting() {
                ready = 0;
                std::thread::sleep(TURN);
            } else {
                ready += 1;
            }
            if ready == SETTLE {
                return;
            }
        }
        panic!("pipelines still wait for shaders after {MOST_FRAMES} frames");
    }

    /// Whether a pipeline waits for a shader.
    fn is_waiting(&self) -> bool {
        let cache = self.app.sub_app(RenderApp).world().resource::<PipelineCache>();
        cache.waiting_pipelines().next().is_some()
    }
}

/// Bevy without a window.
fn started(plugin: Option<UmbragePlugin>) -> App {
    let mut app = App::new();
    app.add_plugins(
        DefaultPlugins
            .build()
            .disable::<PipelinedRenderingPlugin>()
            .set(WindowPlugin { primary_window: None, exit_condition: ExitCondition::DontExit, ..default() })
            .set(RenderPlugin { synchronous_pipeline_compilation: true, ..default() })
            .disable::<bevy::log::LogPlugin>(),
    );
    if let Some(plugin) = plugin {
        app.add_plugins(plugin);
    }
    app.insert_resource(DirectionalLightShadowMap { size: 512 });
    app.insert_resource(GlobalAmbientLight { brightness: 0.0, ..default() });
    while app.plugins_state() == PluginsState::Adding {
        bevy::tasks::tick_global_task_pools_on_main_thread();
    }
    app.finish();
    app.cleanup();
    run_in_turn(app.main_mut());
    app.get_sub_app_mut(RenderApp).map(run_in_turn);
    app
}

/// Lets systems run one after another: on a busy machine, threads would wait long for each other.
fn run_in_turn(app: &mut SubApp) {
    for (_, schedule) in app.world_mut().resource_mut::<Schedules>().iter_mut() {
        schedule.set_executor(SingleThreadedExecutor::new());
    }
}

/// The green of each pixel of a picture, linear.
fn greens(image: &Image) -> Vec<f32> {
    let linear = |byte: u8| Color::srgb_u8(byte, byte, byte).to_linear().green;
    image.data.iter().flatten().skip(1).step_by(4).map(|byte| linear(*byte)).collect()
}
