//! `umbrage plan`: where the camera's depth is cut, and what each view covers.

use umbrage::{Light, LightKind, ShadowPlan};
use umbrage_interchange::{Stages, min_storage_factor, storage_factor};
use umbrage_render::Show;
use umbrage_scene::Scene;

use crate::args::PlanArgs;
use crate::failure::{Failure, Outcome};
use crate::plan_json::{About, PlanJson};
use crate::{output, settings, world};

pub fn run(args: &PlanArgs) -> Outcome {
    match &args.json {
        Some(path) => Ok(output::write_text(path, &json(args)?)?),
        None => {
            let Planned { plan, .. } = planned(args)?;
            Ok(output::print(&text(&plan))?)
        }
    }
}

/// A plan, and what it is of.
struct Planned {
    scene: Scene,
    picture: [u32; 2],
    plan: ShadowPlan,
}

fn planned(args: &PlanArgs) -> Outcome<Planned> {
    let settings = settings::resolve(&args.shadows)?;
    let scene = world::open(&args.world)?;
    let frame = world::frame(&world::shot(&args.world, &scene, world::PICTURE)?, Show::World)?;
    let bounds = umbrage_render::bounds(&scene, &frame.pose);
    let lights: Vec<Light> = frame.lights.iter().map(|light| light.light).collect();
    let plan = umbrage::plan(&frame.camera, &lights, &bounds, &settings).map_err(Failure::usage)?;
    Ok(Planned { scene, picture: [frame.width, frame.height], plan })
}

/// The plan that is asked for, as JSON.
pub fn json(args: &PlanArgs) -> Outcome<String> {
    let Planned { scene, picture, plan } = planned(args)?;
    let about =
        About { world: &scene.name, triangles: scene.triangles(), origin: scene.origin.to_array(), picture };
    let stages = Stages::new(plan.settings(), args.textures);
    Ok(output::json(&PlanJson::new(&about, &plan, &stages))?)
}

/// Split distances in metres: the ends as given, the cuts to a micrometre.
pub fn splits_text(splits: &[f64]) -> String {
    let last = splits.len().saturating_sub(1);
    let text = |(i, split): (usize, &f64)| {
        if i == 0 || i == last { (*split as f32).to_string() } else { format!("{split:.6}") }
    };
    splits.iter().enumerate().map(text).collect::<Vec<_>>().join(", ")
}

fn text(plan: &ShadowPlan) -> String {
    let mut text = format!("splits {} m\n", splits_text(plan.splits()));
    for view in plan.views() {
        text += &format!(
            "light {} split {}: view depths {:.3} to {:.3} m, texel {:.4} m, depth range {:.1} m\n",
            view.light, view.split, view.depths.start, view.depths.end, view.texel_metres, view.depth_metres
        );
    }
    let layout = plan.layout();
    text += &format!("{} texels, {} bytes\n", layout.texels(), layout.bytes());
    if plan.lights().iter().any(|light| matches!(light.kind(), LightKind::Directional { .. })) {
        text += &format!(
            "under a sun overhead, {:.0} texels a pixel at worst; the least there is are {:.1}\n",
            storage_factor(plan),
            min_storage_factor(plan)
        );
    }
    text
}

#[cfg(test)]
mod tests {
    use umbrage::Settings;

    use super::*;

    #[test]
    fn splits_are_printed_as_they_were_asked_for() {
        let settings = Settings { splits: 5, lambda: 0.75, ..Settings::default() };
        let splits = umbrage::split_distances(0.5..300.0, &settings);
        assert_eq!(splits_text(&splits), "0.5, 16.447912, 34.919978, 62.464941, 122.621820, 300");
    }
}
