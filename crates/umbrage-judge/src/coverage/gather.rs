//! Finds the triangles of a scene that are not solid, with the pictures of their alpha, each once.

use std::collections::HashMap;

use umbrage_scene::{Material, Mesh, Part, Scene, Texture};

use super::alpha_picture::AlphaPicture;
use super::{Coverages, SOLID, Surface};

/// What was found so far.
pub(crate) struct Gathering<'a> {
    scene: &'a Scene,
    found: Coverages,
    /// The index of the surface of each instance and material.
    surfaces: HashMap<(usize, usize), u32>,
    /// The index of the picture of each texture; `None` where its alpha is 1 everywhere.
    pictures: HashMap<usize, Option<u32>>,
}

impl<'a> Gathering<'a> {
    pub fn new(scene: &'a Scene) -> Self {
        Self { scene, found: Coverages::default(), surfaces: HashMap::new(), pictures: HashMap::new() }
    }

    /// Adds a part of an instance's mesh, whose triangles are the world's from `first` on.
    pub fn add(&mut self, instance: usize, mesh: &Mesh, part: &Part, first: usize) {
        let scene = self.scene;
        let Some(material) = scene.materials.get(part.material).filter(|material| !material.is_solid())
        else {
            return;
        };
        let index = self.surface(instance, part.material, material);
        let surface = self.found.surfaces[index as usize];
        let alpha = |i: u32| mesh.colours.get(i as usize).map_or(1.0, |colour| colour.w);
        let uv = |i: u32| mesh.uvs.get(i as usize).copied().filter(|uv| uv.is_finite()).unwrap_or_default();
        let indices = &mesh.indices[part.indices.start as usize..part.indices.end as usize];
        for (i, corners) in indices.as_chunks::<3>().0.iter().enumerate() {
            let alphas = corners.map(alpha);
            if surface.is_whole(alphas) {
                continue;
            }
            let found = &mut self.found;
            found.places.resize(first + i, SOLID);
            found.places.push(found.uvs.len() as u32);
            found.uvs.push(corners.map(uv));
            found.alphas.push(alphas);
            found.surface_of.push(index);
        }
    }

    pub fn finish(self) -> Coverages {
        self.found
    }

    fn surface(&mut self, instance: usize, index: usize, material: &Material) -> u32 {
        if let Some(known) = self.surfaces.get(&(instance, index)) {
            return *known;
        }
        let Material { alpha, transmission, base_colour, texture, .. } = material;
        let picture = texture.and_then(|texture| self.picture(texture));
        let surface = Surface { alpha: *alpha, transmission: *transmission, factor: base_colour.w, picture };
        self.found.surfaces.push(surface);
        let new = self.found.surfaces.len() as u32 - 1;
        self.surfaces.insert((instance, index), new);
        new
    }

    fn picture(&mut self, texture: usize) -> Option<u32> {
        if let Some(known) = self.pictures.get(&texture) {
            return *known;
        }
        let Texture { name: _, width, height, rgba } = self.scene.textures.get(texture)?;
        let (width, height) = (*width, *height);
        let alpha: Vec<u8> = rgba.as_chunks::<4>().0.iter().map(|pixel| pixel[3]).collect();
        let is_picture = width > 0 && alpha.len() as u64 == u64::from(width) * u64::from(height);
        let new = (is_picture && alpha.iter().any(|alpha| *alpha < 255)).then(|| {
            self.found.pictures.push(AlphaPicture { width, height, alpha });
            self.found.pictures.len() as u32 - 1
        });
        self.pictures.insert(texture, new);
        new
    }
}
