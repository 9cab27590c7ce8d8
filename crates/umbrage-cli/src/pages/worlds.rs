//! `docs/worlds.md`: every built-in world, with its picture, its size, its lights and its cameras.

use std::f32::consts::TAU;

use umbrage_scene::worlds::{self, World};
use umbrage_scene::{LightKind, Motion, Scene};

use super::{opening, thousands};

/// The whole page.
pub fn markdown() -> String {
    let worlds: Vec<(&World, Scene)> = worlds::ALL.iter().map(|world| (world, world.build(0))).collect();
    let about = format!(
        "A world is what Umbrage draws: one of these names, or a `.glb`, `.gltf` or `.obj` file of yours.\n\
         `umbrage render {0} -o a.png` draws one, `umbrage view {0}` opens a window on it, and `umbrage worlds export {0} \
         a.glb` writes it as a file.\n\
         All but the two scans are grown from a seed: `--seed N` grows another of the same kind, and 0 is the one in the \
         pictures.\n\
         Most are modelled after the worlds of publications, with their triangle counts, extents and depth ranges.\n\
         The extent is width × height × depth in metres, at the start.",
        worlds::DEFAULT
    );
    let mut page = opening("Worlds", "umbrage worlds --markdown", &about);
    page += "\n| world | triangles | extent | lights | moving things |\n|---|---:|---|---|---:|\n";
    for (world, scene) in &worlds {
        page += &row(world, scene);
    }
    for (world, scene) in &worlds {
        page += &chapter(world, scene);
    }
    page
}

fn row(world: &World, scene: &Scene) -> String {
    let size = scene.bounds_in(&scene.pose(0.0)).size();
    let moving = scene.instances.iter().filter(|instance| instance.is_dynamic()).count();
    format!(
        "| [`{0}`](#{0}) | {1} | {2} × {3} × {4} | {5} | {moving} |\n",
        world.name,
        thousands(scene.triangles()),
        metres(size.x),
        metres(size.y),
        metres(size.z),
        lights(scene)
    )
}

fn chapter(world: &World, scene: &Scene) -> String {
    let World { name, summary, source, .. } = world;
    let is_default = if *name == worlds::DEFAULT { " It is the default world." } else { "" };
    let mut text = format!(
        "\n## {name}\n\n![{summary}](pictures/{name}.png)\n\n{}{}.\nSource: {source}.{is_default}\n\n",
        summary[..1].to_uppercase(),
        &summary[1..]
    );
    for animation in &scene.rig.animations {
        text += &format!("Animation `{}`: {} s.\n\n", animation.name, metres(animation.seconds));
    }
    text += "| camera | number | eye, metres | sees from | to, metres |\n|---|---:|---|---:|---:|\n";
    for (number, camera) in scene.cameras.iter().enumerate() {
        let eye = camera.eye().to_array().map(metres).join(", ");
        text += &format!(
            "| `{}` | {number} | {eye} | {} | {} |\n",
            camera.name,
            metres(camera.near),
            metres(camera.far)
        );
    }
    text
}

/// Says how many lights there are of which kind: `1 sun`, `12 spots`.
fn lights(scene: &Scene) -> String {
    let name = |kind: &LightKind| match kind {
        LightKind::Directional => "sun",
        LightKind::Spot { .. } => "spot",
        LightKind::Point { .. } => "point light",
    };
    let mut counts: Vec<(&str, usize)> = Vec::new();
    for light in &scene.lights {
        let name = name(&light.kind);
        match counts.iter_mut().find(|(counted, _)| *counted == name) {
            Some((_, count)) => *count += 1,
            None => counts.push((name, 1)),
        }
    }
    let text = |(name, count): (&str, usize)| format!("{count} {name}{}", if count == 1 { "" } else { "s" });
    let counts: Vec<String> = counts.into_iter().map(text).collect();
    let turns = scene.lights.iter().find_map(|light| match light.motion {
        Motion::Rotation { radians_per_second, .. } => Some(TAU / radians_per_second.abs()),
        Motion::Still | Motion::Node { .. } | Motion::Skin { .. } => None,
    });
    counts.join(", ") + &turns.map_or_else(String::new, |seconds| format!(", turning in {seconds:.0} s"))
}

/// Metres to a tenth, and without `.0`.
fn metres(length: f32) -> String {
    let rounded = (f64::from(length) * 10.0).round() / 10.0;
    // No −0.
    (rounded + 0.0).to_string()
}
