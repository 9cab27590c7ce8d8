//! Draws pillars in the evening off screen, into a PNG: `cargo run --release --example pillars -- umbrage.png`, and with
//! `--stock` as Bevy draws them without the plug-in.

use std::path::PathBuf;
use std::time::Duration;

use bevy::app::ScheduleRunnerPlugin;
use bevy::camera::RenderTarget;
use bevy::light::CascadeShadowConfigBuilder;
use bevy::prelude::*;
use bevy::render::RenderPlugin;
use bevy::render::render_resource::{TextureFormat, TextureUsages};
use bevy::render::view::screenshot::{Screenshot, save_to_disk};
use bevy::window::ExitCondition;
use bevy_umbrage::UmbragePlugin;

/// How far there are shadows, metres.
const SHADOWS: f32 = 300.0;
/// The frame that is kept, when pipelines are made, and the one after which the program gives up.
const KEPT: u32 = 30;
const LAST: u32 = 600;

/// Where the picture goes.
#[derive(Resource)]
struct Out(PathBuf);

/// What the camera draws into.
#[derive(Resource)]
struct Target(Handle<Image>);

fn main() -> AppExit {
    let (flags, files): (Vec<String>, Vec<String>) =
        std::env::args().skip(1).partition(|word| word.starts_with("--"));
    let file = files.first().map_or("pillars.png", String::as_str);
    let mut app = App::new();
    app.add_plugins(
        DefaultPlugins
            .set(WindowPlugin { primary_window: None, exit_condition: ExitCondition::DontExit, ..default() })
            .set(RenderPlugin { synchronous_pipeline_compilation: true, ..default() }),
    );
    app.add_plugins(ScheduleRunnerPlugin::run_loop(Duration::ZERO));
    if !flags.iter().any(|flag| flag == "--stock") {
        app.add_plugins(UmbragePlugin::default());
    }
    app.insert_resource(Out(file.into()));
    app.add_systems(Startup, set_up).add_systems(Update, keep).run()
}

/// Sets up the ground, pillars, an evening sun and a camera.
fn set_up(
    mut commands: Commands,
    mut images: ResMut<Assets<Image>>,
    mut meshes: ResMut<Assets<Mesh>>,
    mut materials: ResMut<Assets<StandardMaterial>>,
) {
    let material = materials.add(Color::srgb(0.8, 0.8, 0.8));
    let ground = meshes.add(Plane3d::default().mesh().size(400.0, 400.0));
    commands.spawn((Mesh3d(ground), MeshMaterial3d(material.clone())));
    let pillar = meshes.add(Cylinder::new(0.5, 6.0));
    for (row, column) in (0..20).flat_map(|row| (-6..=6).map(move |column| (row, column))) {
        let place = Vec3::new(column as f32 * 5.0, 3.0, row as f32 * -10.0);
        commands.spawn((
            Mesh3d(pillar.clone()),
            MeshMaterial3d(material.clone()),
            Transform::from_translation(place),
        ));
    }
    commands.spawn((
        DirectionalLight { shadow_maps_enabled: true, ..default() },
        CascadeShadowConfigBuilder { maximum_distance: SHADOWS, ..default() }.build(),
        Transform::default().looking_to(Vec3::new(-0.8, -0.5, -0.4), Vec3::Y),
    ));
    let mut image = Image::new_target_texture(960, 540, TextureFormat::Rgba8UnormSrgb, None);
    image.texture_descriptor.usage |= TextureUsages::COPY_SRC;
    let target = images.add(image);
    commands.spawn((
        Camera3d::default(),
        RenderTarget::Image(target.clone().into()),
        Transform::from_xyz(2.0, 4.0, 14.0).looking_at(Vec3::new(0.0, 1.0, -20.0), Vec3::Y),
    ));
    commands.insert_resource(Target(target));
}

/// Keeps a frame, and ends the program once it is written.
fn keep(
    mut commands: Commands,
    mut frame: Local<u32>,
    target: Res<Target>,
    out: Res<Out>,
    mut exit: MessageWriter<AppExit>,
) {
    *frame += 1;
    if *frame == KEPT {
        // One of an earlier run would be taken for it.
        let _ = std::fs::remove_file(&out.0);
        commands.spawn(Screenshot::image(target.0.clone())).observe(save_to_disk(out.0.clone()));
    } else if *frame > KEPT && out.0.exists() {
        exit.write(AppExit::Success);
    } else if *frame > LAST {
        error!("no picture was written: {}", out.0.display());
        exit.write(AppExit::error());
    }
}
