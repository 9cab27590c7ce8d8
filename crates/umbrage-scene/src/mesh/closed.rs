//! Does a mesh have an inside? Where it has none, its back faces are no substitute for its front.

use std::collections::HashMap;

use glam::Vec3;

use crate::{Mesh, Scene};

impl Mesh {
    /// Whether no edge has one triangle only. Vertices at the same place count as one, since normals and texture
    /// coordinates part them; triangles without an inside do not count. Looks at every triangle.
    pub fn is_closed(&self) -> bool {
        let mut numbers = HashMap::with_capacity(self.positions.len());
        let welded: Vec<u32> = self
            .positions
            .iter()
            .map(|&place| {
                let next = numbers.len() as u32;
                *numbers.entry(key(place)).or_insert(next)
            })
            .collect();
        let mut edges: HashMap<(u32, u32), bool> = HashMap::with_capacity(self.indices.len() / 2);
        for triangle in self.indices.as_chunks().0 {
            let [a, b, c] = (*triangle as [u32; 3]).map(|i| welded[i as usize]);
            if a == b || b == c || c == a {
                continue;
            }
            for (from, to) in [(a, b), (b, c), (c, a)] {
                edges.entry((from.min(to), from.max(to))).and_modify(|alone| *alone = false).or_insert(true);
            }
        }
        edges.values().all(|alone| !alone)
    }
}

impl Scene {
    /// The meshes that are not closed: see [`Mesh::is_closed`].
    pub fn open_meshes(&self) -> impl Iterator<Item = &Mesh> {
        self.meshes.iter().filter(|mesh| !mesh.is_closed())
    }
}

/// The same for the same place; 0 and −0 are one.
fn key(place: Vec3) -> [u32; 3] {
    (place + Vec3::ZERO).to_array().map(f32::to_bits)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::{cuboid, sheet, sphere};
    use crate::{Primitive, worlds};

    fn mesh(primitives: &[Primitive]) -> Mesh {
        Mesh::new("test", primitives)
    }

    #[test]
    fn a_box_is_closed_though_its_faces_share_no_vertex() {
        let painted = cuboid(1.0, 2.0, 3.0).painted(0);
        assert_eq!(painted.positions.len(), 24, "each corner once a face");
        assert!(mesh(&[painted]).is_closed(), "closed");
    }

    #[test]
    fn a_solid_of_two_materials_is_closed_and_either_half_is_open() {
        let whole = sphere(1.0, 12, 8).painted(0);
        let (low, high) = whole.indices.split_at(whole.indices.len() / 6 * 3);
        let [low, high] = [low, high].map(|half| Primitive { indices: half.to_vec(), ..whole.clone() });
        assert!(!mesh(std::slice::from_ref(&low)).is_closed(), "half");
        assert!(mesh(&[low, Primitive { material: 1, ..high }]).is_closed(), "both halves");
    }

    #[test]
    fn one_missing_triangle_opens_a_box_and_one_without_area_does_not_close_it() {
        let mut painted = cuboid(1.0, 1.0, 1.0).painted(0);
        let [a, b, c] = [painted.indices[0], painted.indices[1], painted.indices[2]];
        painted.indices.drain(..3);
        painted.indices.extend([a, b, b, b, c, c, c, a, a]);
        assert!(!mesh(&[painted]).is_closed(), "a hole");
    }

    #[test]
    fn sheets_are_open_and_nothing_at_all_is_closed() {
        assert!(!mesh(&[sheet(1.0, 1.0, 3, 0.2).painted(0)]).is_closed(), "a sheet");
        assert!(mesh(&[]).is_closed(), "nothing");
    }

    #[test]
    fn the_bias_court_has_open_cards_and_washing_on_its_open_ground() {
        let scene = worlds::build("bias-court", 0).expect("a world");
        let names: Vec<&str> = scene.open_meshes().map(|mesh| mesh.name.as_str()).collect();
        assert_eq!(names, ["ground", "house of cards", "washing"]);
    }
}
