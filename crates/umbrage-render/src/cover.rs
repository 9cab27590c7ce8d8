//! Passes draw a surface by how much of its place it covers: solid surfaces need no fragment stage in depth passes, masks
//! are cut out there, and veils are blended over what lies behind them.

use std::collections::HashMap;

use umbrage_scene::{Alpha, Material, Mesh, Part, Scene};

/// What passes do with a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Cover {
    /// The surface covers all of its place.
    Solid,
    /// The surface covers its place or does not, as its mask says.
    Cut,
    /// The surface covers a share of its place, and what lies behind it shows through.
    Veil,
}

/// Says the covers of a scene's parts. Many files call materials blended or masked whose alpha is 1 everywhere: these are solid.
#[derive(Debug)]
pub struct Covers<'a> {
    scene: &'a Scene,
    /// The least alpha of textures that were looked at.
    least: HashMap<usize, f32>,
}

impl<'a> Covers<'a> {
    /// Makes the covers of a scene, of which no texture was looked at yet.
    pub fn new(scene: &'a Scene) -> Self {
        Self { scene, least: HashMap::new() }
    }

    /// Returns the cover of a part of one of the scene's meshes.
    pub fn of(&mut self, mesh: &Mesh, part: &Part) -> Cover {
        let Some(material) = self.scene.materials.get(part.material).filter(|material| !material.is_solid())
        else {
            return Cover::Solid;
        };
        let least = material.base_colour.w * self.least_of_texture(material) * least_of_vertices(mesh, part);
        if material.coverage(least) >= 1.0 {
            return Cover::Solid;
        }
        match material.alpha {
            Alpha::Mask { .. } if material.transmission <= 0.0 => Cover::Cut,
            Alpha::Mask { .. } | Alpha::Opaque | Alpha::Blend => Cover::Veil,
        }
    }

    fn least_of_texture(&mut self, material: &Material) -> f32 {
        let Some((i, texture)) = material.texture.and_then(|i| Some((i, self.scene.textures.get(i)?))) else {
            return 1.0;
        };
        *self.least.entry(i).or_insert_with(|| {
            let least = texture.rgba.iter().skip(3).step_by(4).min();
            least.map_or(1.0, |alpha| f32::from(*alpha) / 255.0)
        })
    }
}

fn least_of_vertices(mesh: &Mesh, part: &Part) -> f32 {
    if mesh.colours.is_empty() {
        return 1.0;
    }
    let indices = &mesh.indices[part.indices.start as usize..part.indices.end as usize];
    indices
        .iter()
        .filter_map(|i| mesh.colours.get(*i as usize))
        .fold(1.0, |least, colour| colour.w.min(least))
}

#[cfg(test)]
mod tests {
    use glam::{Vec2, Vec3, Vec4};
    use umbrage_scene::{Primitive, Texture};

    use super::*;

    fn cover(change: impl Fn(&mut Material), texture: [u8; 8], vertex_alpha: Option<f32>) -> Cover {
        let mut material = Material::plain("m", 1.0, 1.0, 1.0);
        material.texture = Some(0);
        change(&mut material);
        let primitive = Primitive {
            positions: vec![Vec3::ZERO, Vec3::X, Vec3::Y],
            normals: vec![Vec3::Z; 3],
            uvs: vec![Vec2::ZERO; 3],
            colours: vertex_alpha
                .map_or(Vec::new(), |alpha| vec![Vec4::ONE, Vec4::ONE, Vec3::ONE.extend(alpha)]),
            indices: vec![0, 1, 2],
            ..Primitive::default()
        };
        let texture = Texture { name: String::new(), width: 2, height: 1, rgba: texture.to_vec() };
        let meshes = vec![Mesh::new("t", &[primitive])];
        let scene = Scene { materials: vec![material], textures: vec![texture], meshes, ..Scene::default() };
        Covers::new(&scene).of(&scene.meshes[0], &scene.meshes[0].parts[0])
    }

    #[test]
    fn only_what_lets_something_through_is_no_solid() {
        const FULL: [u8; 8] = [255; 8];
        const HOLED: [u8; 8] = [255, 255, 255, 255, 255, 255, 255, 0];
        let mask = |cutoff| move |m: &mut Material| m.alpha = Alpha::Mask { cutoff };
        let blend = |m: &mut Material| m.alpha = Alpha::Blend;
        let pane = |m: &mut Material| m.transmission = 0.5;
        assert_eq!(cover(|_| (), HOLED, Some(0.0)), Cover::Solid, "alpha counts for nothing");
        assert_eq!(cover(mask(0.5), FULL, None), Cover::Solid);
        assert_eq!(cover(mask(0.5), HOLED, None), Cover::Cut);
        assert_eq!(cover(mask(0.0), HOLED, None), Cover::Solid);
        assert_eq!(cover(mask(1.1), FULL, None), Cover::Cut);
        assert_eq!(cover(mask(0.5), FULL, Some(0.25)), Cover::Cut);
        assert_eq!(cover(blend, FULL, None), Cover::Solid);
        assert_eq!(cover(blend, HOLED, None), Cover::Veil);
        assert_eq!(cover(blend, FULL, Some(0.9)), Cover::Veil);
        assert_eq!(cover(pane, FULL, None), Cover::Veil);
        let faded = |m: &mut Material| {
            blend(m);
            m.base_colour.w = 0.5;
        };
        assert_eq!(cover(faded, FULL, None), Cover::Veil);
    }
}
