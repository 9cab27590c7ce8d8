//! All meshes, as a shader finds them: nodes, triangles, corners, and how much of their place triangles cover.

use std::collections::HashMap;

use glam::{Vec3, Vec3A};
use obvhs::aabb::Aabb;
use rayon::prelude::*;

use crate::coverage::Coverage;
use crate::node::{self, MAX_TRIANGLES, Node, padded};
use crate::refit::Refit;
use crate::source::{AlphaPicture, Mesh};

/// The geometry of all meshes, each with a hierarchy in its own space.
#[derive(Clone, Debug, Default)]
pub struct Geometry {
    /// The nodes of all meshes. Links count from the first of all.
    pub nodes: Vec<Node>,
    /// The triangles in the order of the leaves: three corners, and one more than the surface of one that is not solid.
    pub triangles: Vec<[u32; 4]>,
    /// The corners, each once in its mesh, in mesh space.
    pub corners: Vec<[f32; 3]>,
    /// How much of their place triangles cover that are not solid: see `exact/covered_cut.wgsl`.
    pub coverage: Vec<u32>,
    /// Where each mesh lies, in the order of the meshes; then the copies.
    pub meshes: Vec<MeshRange>,
    /// What it takes to refit the meshes that bend.
    pub refits: Vec<Refit>,
    /// The number of triangles that were left out, as they have no area or corners that are not finite.
    pub left_out: usize,
}

/// Where the nodes of a mesh lie.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MeshRange {
    /// The index of the first node.
    pub first: u32,
    /// The index behind the last one; the same where nothing of the mesh casts.
    pub end: u32,
    /// The least coordinates of the mesh, with a margin.
    pub low: Vec3,
    /// The largest.
    pub high: Vec3,
    /// What to add to the corners of a triangle: 0, but in copies.
    pub corner_offset: u32,
    /// The index of what refits the mesh; `None` for one that does not bend.
    pub refit: Option<usize>,
}

/// One mesh, before it is put behind the others.
struct Built {
    nodes: Vec<Node>,
    triangles: Vec<[u32; 4]>,
    corners: Vec<[f32; 3]>,
    surfaces: Vec<u32>,
    bounds: Aabb,
    refit: Option<Refit>,
    left_out: usize,
}

impl Geometry {
    /// Builds the hierarchies of all meshes, on all cores.
    pub fn build(meshes: &[Mesh<'_>], pictures: &[AlphaPicture]) -> Self {
        let mut coverage = Coverage::new(pictures);
        let welded: Vec<Welded> = meshes.iter().map(|mesh| Welded::of(mesh, &mut coverage)).collect();
        let built: Vec<Built> = welded.into_par_iter().map(Built::of).collect();
        let mut all = Self { coverage: coverage.finish(), ..Self::default() };
        for mesh in built {
            all.add(mesh);
        }
        all
    }

    /// Adds a copy of a mesh that bends, to be bent another way: it has nodes and corners of its own, and the same triangles. Returns
    /// its index among the meshes; `None` where the mesh does not bend, or nothing of it casts.
    pub fn copy(&mut self, mesh: usize) -> Option<usize> {
        let from = *self.meshes.get(mesh)?;
        let refit = self.refits.get(from.refit?)?;
        let (first, corner) = (self.nodes.len() as u32, self.corners.len() as u32);
        let of_mesh = refit.first_corner + from.corner_offset;
        let corners = of_mesh as usize..of_mesh as usize + refit.vertices.len();
        let moved = |node: Node| Node { next: node.next - from.first + first, ..node };
        self.nodes.extend_from_within(from.first as usize..from.end as usize);
        self.nodes[first as usize..].iter_mut().for_each(|node| *node = moved(*node));
        self.corners.extend_from_within(corners);
        let (end, corner_offset) = (self.nodes.len() as u32, corner - refit.first_corner);
        self.meshes.push(MeshRange { first, end, corner_offset, ..from });
        Some(self.meshes.len() - 1)
    }

    fn add(&mut self, built: Built) {
        let Built { nodes, triangles, corners, surfaces, bounds, refit, left_out } = built;
        let [first, triangle, corner] =
            [self.nodes.len(), self.triangles.len(), self.corners.len()].map(|length| length as u32);
        let refit = refit.map(|refit| {
            self.refits.push(Refit { first_corner: corner, ..refit });
            self.refits.len() - 1
        });
        self.nodes.extend(nodes.into_iter().map(|node| Node {
            next: node.next + first,
            leaf: if node.leaf == 0 { 0 } else { node.leaf + 8 * triangle },
            ..node
        }));
        for surface in surfaces {
            Coverage::move_corners(&mut self.coverage, surface, corner);
        }
        let moved = |[a, b, c, surface]: [u32; 4]| [a + corner, b + corner, c + corner, surface];
        self.triangles.extend(triangles.into_iter().map(moved));
        self.corners.extend(corners);
        self.left_out += left_out;
        let end = self.nodes.len() as u32;
        let (low, high) = (bounds.min.into(), bounds.max.into());
        self.meshes.push(MeshRange { first, end, low, high, corner_offset: 0, refit });
    }

    /// Returns the number of triangles.
    pub fn triangles(&self) -> usize {
        self.triangles.len()
    }

    /// Returns the bytes of everything that a device holds of them.
    pub fn bytes(&self) -> usize {
        let Self { nodes, triangles, corners, coverage, .. } = self;
        size_of_val(&nodes[..])
            + size_of_val(&triangles[..])
            + size_of_val(&corners[..])
            + size_of_val(&coverage[..])
    }

    /// Whether some triangles are not solid.
    pub fn has_covers(&self) -> bool {
        self.triangles.iter().any(|triangle| triangle[3] > 0)
    }
}

/// A mesh each of whose corners stands once.
struct Welded {
    corners: Vec<[f32; 3]>,
    triangles: Vec<[u32; 4]>,
    /// The surfaces that are not solid.
    surfaces: Vec<u32>,
    /// The vertex of each corner, where the mesh bends.
    vertices: Option<Vec<u32>>,
    left_out: usize,
}

/// What tells corners apart.
#[derive(PartialEq, Eq, Hash)]
enum CornerKey {
    /// Vertices in one place are one corner.
    Place([u32; 3]),
    /// Vertices of a mesh that bends may part.
    Vertex(u32),
}

impl Welded {
    fn of(mesh: &Mesh<'_>, coverage: &mut Coverage) -> Self {
        let mut all = Self {
            corners: Vec::new(),
            triangles: Vec::new(),
            surfaces: Vec::new(),
            vertices: mesh.bends.then(Vec::new),
            left_out: 0,
        };
        let mut known = HashMap::new();
        for part in &mesh.parts {
            let surface = part.cover.as_ref().map(|cover| coverage.surface(cover));
            all.surfaces.extend(surface);
            for triangle in part.indices.chunks_exact(3) {
                let triangle = [triangle[0], triangle[1], triangle[2]];
                // A vertex that is not there is nowhere.
                let places = triangle.map(|i| mesh.positions.get(i as usize).copied().unwrap_or(Vec3::NAN));
                if !if mesh.bends { may_have_area(triangle, places) } else { has_area(places) } {
                    all.left_out += 1;
                    continue;
                }
                let mut corner = |vertex: u32, place: Vec3, all: &mut Self, coverage: &mut Coverage| {
                    // Vertices of other surfaces have other texture coordinates there.
                    let of = surface.map(|surface| (surface, vertex));
                    *known.entry((all.key(vertex, place), of)).or_insert_with(|| {
                        let corner = all.add_corner(vertex, place);
                        if let (Some(surface), Some(cover)) = (surface, &part.cover) {
                            coverage.add_corner(surface, cover, vertex, corner);
                        }
                        corner
                    })
                };
                let [a, b, c] = [0, 1, 2].map(|i| corner(triangle[i], places[i], &mut all, coverage));
                all.triangles.push([a, b, c, surface.map_or(0, |surface| surface + 1)]);
            }
        }
        all
    }

    fn key(&self, vertex: u32, place: Vec3) -> CornerKey {
        match self.vertices {
            Some(_) => CornerKey::Vertex(vertex),
            None => CornerKey::Place(place.to_array().map(f32::to_bits)),
        }
    }

    fn add_corner(&mut self, vertex: u32, place: Vec3) -> u32 {
        self.corners.push(place.to_array());
        self.vertices.iter_mut().for_each(|vertices| vertices.push(vertex));
        self.corners.len() as u32 - 1
    }
}

/// Whether a triangle can be hit at all.
fn has_area([a, b, c]: [Vec3; 3]) -> bool {
    let [a, b, c] = [a, b, c].map(Vec3::as_dvec3);
    let area = (b - a).cross(c - a);
    area.is_finite() && area != glam::DVec3::ZERO
}

/// Whether a triangle can be hit once it is bent.
fn may_have_area([a, b, c]: [u32; 3], places: [Vec3; 3]) -> bool {
    a != b && b != c && c != a && places.iter().all(|place| place.is_finite())
}

impl Built {
    fn of(Welded { corners, triangles, surfaces, vertices, left_out }: Welded) -> Self {
        let place = |corner: u32| Vec3A::from_array(corners[corner as usize]);
        let boxes: Vec<Aabb> = triangles.iter().map(|[a, b, c, _]| padded([*a, *b, *c].map(place))).collect();
        if boxes.is_empty() {
            let (nodes, bounds) = (Vec::new(), Aabb::empty());
            return Self { nodes, triangles, corners, surfaces, bounds, refit: None, left_out };
        }
        let bvh = node::bvh(&boxes, MAX_TRIANGLES);
        let mut nodes = Vec::with_capacity(bvh.nodes.len());
        node::append(&mut nodes, &bvh, |first, count| 8 * first + count);
        let triangles = bvh.primitive_indices.iter().map(|i| triangles[*i as usize]).collect();
        let refit = vertices.map(|vertices| Refit::of(&nodes, vertices));
        Self { nodes, triangles, corners, surfaces, bounds: node::bounds(&bvh), refit, left_out }
    }
}
