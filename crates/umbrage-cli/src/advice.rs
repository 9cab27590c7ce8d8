//! What settings do not suit a world, and what would: a line on stderr, and the work goes on.

use umbrage::{CasterFaces, Settings};
use umbrage_scene::Scene;

/// Warns where back faces cast and some meshes have none behind their front.
pub fn warn_of_open_casters(scene: &Scene, settings: &Settings) {
    if let Some(advice) = open_casters(scene, settings) {
        eprintln!("warning: {advice}");
    }
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
    fn other_faces_are_not_warned_of() {
        assert_eq!([CasterFaces::Both, CasterFaces::Front].map(advice), [None, None]);
    }
}
