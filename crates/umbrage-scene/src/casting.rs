//! Some things cast no shadow because someone said so: instances, meshes and materials by their names.

use crate::Scene;

/// A name that nothing in a scene has.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NoSuchName {
    /// The name that was asked for.
    pub wanted: String,
    /// The names most like it, the likest first, eight at most.
    pub near: Vec<String>,
}

impl Scene {
    /// Says of everything with a name, whatever case its letters have, whether it casts shadows: of the instance, of all
    /// instances of the mesh, and of the material. Where several are called so, it is said of all of them.
    ///
    /// # Errors
    /// When nothing is called so; the error lists names that are like it. The scene is as before then.
    pub fn set_casts(&mut self, name: &str, casts: bool) -> Result<(), NoSuchName> {
        let is_meant = |other: &str| !other.is_empty() && other.eq_ignore_ascii_case(name);
        let mut found = false;
        for instance in &mut self.instances {
            if is_meant(&instance.name) || is_meant(&self.meshes[instance.mesh].name) {
                instance.casts = casts;
                found = true;
            }
        }
        for material in self.materials.iter_mut().filter(|material| is_meant(&material.name)) {
            material.casts = casts;
            found = true;
        }
        if found { Ok(()) } else { Err(self.no_such_name(name)) }
    }

    fn no_such_name(&self, wanted: &str) -> NoSuchName {
        let instances = self.instances.iter().map(|instance| &instance.name);
        let meshes = self.meshes.iter().map(|mesh| &mesh.name);
        let materials = self.materials.iter().map(|material| &material.name);
        let names: std::collections::BTreeSet<&String> =
            instances.chain(meshes).chain(materials).filter(|name| !name.is_empty()).collect();
        let mut near: Vec<(usize, &String)> =
            names.into_iter().map(|name| (unlikeness(wanted, name), name)).collect();
        near.sort();
        let near = near.into_iter().take(8).map(|(_, name)| crate::error::one_line(name)).collect();
        NoSuchName { wanted: wanted.to_owned(), near }
    }
}

/// How many letters must be changed, added or taken away to make one word of another (Levenshtein, 1966), whatever their
/// case; a word within the other is nearer than any other.
fn unlikeness(a: &str, b: &str) -> usize {
    /// No name that is typed is longer; files may hold names as long as they like.
    const MAX_CHARS: usize = 64;
    let letters =
        |word: &str| word.chars().take(MAX_CHARS).flat_map(char::to_lowercase).collect::<Vec<char>>();
    let (a, b) = (letters(a), letters(b));
    let (short, long) = if a.len() < b.len() { (&a, &b) } else { (&b, &a) };
    if !short.is_empty() && long.windows(short.len()).any(|part| part == &short[..]) {
        return 0;
    }
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.iter().enumerate() {
        let mut corner = std::mem::replace(&mut row[0], i + 1);
        for (j, y) in b.iter().enumerate() {
            let least = (corner + usize::from(x != y)).min(row[j] + 1).min(row[j + 1] + 1);
            corner = std::mem::replace(&mut row[j + 1], least);
        }
    }
    row[b.len()]
}

#[cfg(test)]
mod tests {
    use glam::Mat4;

    use super::*;
    use crate::{Instance, Material, Mesh};

    fn scene() -> Scene {
        let named =
            |name: &str, mesh| Instance { name: name.to_owned(), ..Instance::still(mesh, Mat4::IDENTITY) };
        Scene {
            meshes: vec![Mesh::new("bulb", &[]), Mesh::new("table", &[])],
            instances: vec![named("", 0), named("Lamp", 0), named("desk", 1), named("", 1)],
            materials: vec![Material::plain("glass", 1.0, 1.0, 1.0), Material::plain("wood", 0.5, 0.3, 0.1)],
            ..Scene::default()
        }
    }

    #[test]
    fn instances_meshes_and_materials_are_meant_by_their_names() {
        for (name, instances, materials) in [
            ("lamp", [true, false, true, true], [true, true]),
            ("bulb", [false, false, true, true], [true, true]),
            ("GLASS", [true; 4], [false, true]),
        ] {
            let mut scene = scene();
            scene.set_casts(name, false).unwrap();
            assert_eq!(scene.instances.iter().map(|of| of.casts).collect::<Vec<_>>(), instances, "{name}");
            assert_eq!(scene.materials.iter().map(|of| of.casts).collect::<Vec<_>>(), materials, "{name}");
            scene.set_casts(name, true).unwrap();
            assert!(scene.instances.iter().all(|of| of.casts) && scene.materials.iter().all(|of| of.casts));
        }
    }

    #[test]
    fn a_name_that_nothing_has_is_answered_with_those_like_it() {
        for (wanted, first) in [("lamb", "Lamp"), ("bul", "bulb"), ("glas wood", "wood"), ("tabel", "table")]
        {
            let mut scene = scene();
            let error = scene.set_casts(wanted, false).unwrap_err();
            assert_eq!((error.wanted.as_str(), error.near[0].as_str()), (wanted, first));
            assert_eq!(error.near.len(), 6);
            assert!(scene.instances.iter().all(|of| of.casts), "nothing is changed");
        }
        assert!(scene().set_casts("", false).is_err(), "what has no name is not meant by no name");
        assert!(Scene::default().set_casts(&"x".repeat(1 << 20), false).unwrap_err().near.is_empty());
    }
}
