//! Does a mesh have an inside? Where it has none, its back faces are no substitute for its front.

use crate::{Mesh, Scene, WeldedMesh};

impl Mesh {
    /// Whether all of the mesh together is [closed](WeldedMesh::closed). Looks at every triangle.
    pub fn is_closed(&self) -> bool {
        WeldedMesh::of(self, |_| true).closed
    }
}

impl Scene {
    /// The meshes that are not closed: see [`Mesh::is_closed`]. Those without triangles are none of them.
    pub fn open_meshes(&self) -> impl Iterator<Item = &Mesh> {
        self.meshes.iter().filter(|mesh| !mesh.indices.is_empty() && !mesh.is_closed())
    }
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
    fn a_sheet_is_open_folded_or_not_and_nothing_is_neither() {
        let once = sheet(1.3, 0.7, 7, 0.2).painted(0);
        assert!(!mesh(std::slice::from_ref(&once)).is_closed(), "a sheet");
        let back = once.indices.as_chunks::<3>().0.iter().flat_map(|[a, b, c]| [*c, *b, *a]);
        let folded = Primitive { indices: once.indices.iter().copied().chain(back).collect(), ..once };
        assert!(!mesh(&[folded]).is_closed(), "its back is its front");
        let scene = Scene { meshes: vec![mesh(&[])], ..Scene::default() };
        assert_eq!(scene.open_meshes().count(), 0, "nothing");
    }

    #[test]
    fn the_bias_court_has_open_cards_and_washing_on_its_open_ground() {
        let scene = worlds::build("bias-court", 0).expect("a world");
        let names: Vec<&str> = scene.open_meshes().map(|mesh| mesh.name.as_str()).collect();
        assert_eq!(names, ["ground", "house of cards", "washing"]);
    }
}
