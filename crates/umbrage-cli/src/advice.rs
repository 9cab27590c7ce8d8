//! What settings do not suit a world, and what would: a line on stderr, and the work goes on.

use umbrage::{CasterFaces, Fit, LightBox, Settings};
use umbrage_lab::Rays;
use umbrage_rivals::Left;
use umbrage_scene::Scene;

/// Warns of what does not suit the world: back faces that cast where some meshes have none behind their front, and a light
/// box that holds nothing of it.
pub fn warn(scene: &Scene, settings: &Settings) {
    for advice in [open_casters(scene, settings), light_box(scene, settings)].into_iter().flatten() {
        eprintln!("warning: {advice}");
    }
}

/// Warns of casters that a family of shadows leaves to maps, in a line that counts them.
pub fn warn_of_left(scene: &Scene, left: &[Left]) {
    let Some(first) = left.first() else { return };
    let named = scene.instances.get(first.instance).map(|instance| {
        let mesh = scene.meshes.get(instance.mesh).map_or("", |mesh| mesh.name.as_str());
        if instance.name.is_empty() { mesh } else { instance.name.as_str() }
    });
    let (count, name) = (left.len(), named.unwrap_or_default());
    let casters = if count == 1 { "caster is" } else { "casters are" };
    eprintln!("warning: {count} {casters} left to shadow maps (`{name}`: {})", first.why);
}

/// Warns of casters for rays that the device refuses.
pub fn warn_of_rays(rays: &Rays) {
    if let Some(advice) = of_rays(rays) {
        eprintln!("warning: {advice}");
    }
}

/// What to say of casters for rays that the device refuses.
pub fn of_rays(rays: &Rays) -> Option<String> {
    let why = rays.refused()?;
    Some(format!("nothing is traced, and shadow maps alone answer: {why}"))
}

fn light_box(scene: &Scene, settings: &Settings) -> Option<String> {
    let light_box = settings.light_box?;
    if settings.fit != Fit::World {
        return Some(
            "a `light_box` is read under `--set fit=world` alone, and this fit makes its own".to_owned(),
        );
    }
    let world = scene.bounds_in(&scene.pose(0.0));
    let LightBox { x, y, z, half_width, half_height, near, depth_range } = light_box;
    let (centre, deep) = (glam::Vec3::new(x, y, z), near.abs().max((near + depth_range).abs()));
    let reach = glam::Vec3::new(half_width, half_height, deep).length();
    let nearest = centre.clamp(world.min, world.max);
    let misses = world.is_empty() || centre.distance(nearest) > reach;
    misses.then(|| {
        let middle = world.centre();
        format!(
            "the light box about ({x}, {y}, {z}) m holds nothing of the world, and all of it is lit; the world's middle is ({}, {}, {}) m",
            middle.x, middle.y, middle.z
        )
    })
}

fn open_casters(scene: &Scene, settings: &Settings) -> Option<String> {
    match settings.bias.casters {
        CasterFaces::Both | CasterFaces::Front => return None,
        CasterFaces::Back => {}
    }
    let names: Vec<&str> = scene.open_meshes().map(|mesh| mesh.name.as_str()).collect();
    let (first, open) = (names.first()?, names.len());
    let (all, are) = (scene.meshes.len(), if open == 1 { "is" } else { "are" });
    Some(format!(
        "{open} of {all} meshes {are} open (`{first}` …), and where their front faces the light they cast nothing; close them, or take `--set bias.casters=both`"
    ))
}

#[cfg(test)]
mod tests {
    use umbrage::Bias;
    use umbrage_scene::worlds;

    use super::*;

    fn advice(casters: CasterFaces) -> Option<String> {
        let scene = worlds::build("bias-court", 0).unwrap();
        open_casters(&scene, &Settings { bias: Bias { casters, ..Bias::default() }, ..Settings::default() })
    }

    #[test]
    fn back_faces_of_open_meshes_are_warned_of_in_one_line_that_counts_them() {
        let text = advice(CasterFaces::Back).unwrap();
        assert!(text.starts_with("3 of 18 meshes are open (`ground` …)") && !text.contains('\n'), "{text}");
        assert!(text.contains("bias.casters=both"), "{text}");
    }

    #[test]
    fn a_light_box_that_misses_the_world_or_is_not_read_is_warned_of() {
        let scene = worlds::build("bias-court", 0).unwrap();
        let advice = |fit, x| {
            let given = Some(LightBox { x, ..LightBox::default() });
            light_box(&scene, &Settings { fit, light_box: given, ..Settings::default() })
        };
        assert_eq!(advice(Fit::World, 0.0), None);
        let text = advice(Fit::World, 1e4).unwrap();
        assert!(text.starts_with("the light box about (10000, 0, 0) m holds nothing of the world"), "{text}");
        assert!(advice(Fit::Scene, 0.0).unwrap().contains("fit=world"));
    }

    #[test]
    fn other_faces_are_not_warned_of() {
        assert_eq!([CasterFaces::Both, CasterFaces::Front].map(advice), [None, None]);
    }
}
