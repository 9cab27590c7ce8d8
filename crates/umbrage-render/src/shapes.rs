//! The shapes that a scene's meshes are bent to: a mesh with the skin and the morph weights that it follows.
//!
//! Each shape has vertices of its own, behind those of all meshes. Instances that are bent alike share one, as all
//! instances of a node do.

use std::collections::HashMap;

use umbrage_scene::{Instance, Mesh, Rig, Scene};

/// A mesh that is bent one way.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Shape {
    /// The index of the mesh in the scene.
    pub mesh: usize,
    /// Its joints in the palette; `None` where no skin bends it.
    pub joints: Option<Entries>,
    /// Its weights in the palette; `None` where it has no morph targets.
    pub weights: Option<Entries>,
    /// Where its vertices start, in the scene's buffers.
    pub first_vertex: u64,
}

/// Entries of a palette that follow each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Entries {
    pub first: usize,
    pub count: usize,
}

/// All shapes of a scene, and what of its rig they follow.
#[derive(Clone, Debug, Default)]
pub(crate) struct Shapes {
    pub all: Vec<Shape>,
    /// The shape of each instance, in the scene's order; `None` for those that are not bent.
    pub of_instance: Vec<Option<u32>>,
    /// The skins alone, which joints are made from.
    pub rig: Rig,
    /// The skins that shapes follow, in the palette's order.
    pub skins: Vec<usize>,
    /// The nodes whose weights shapes follow, in the palette's order, with how many weights they have there.
    pub nodes: Vec<(usize, usize)>,
    /// How many vertices lie between those of meshes and those of shapes, which are nobody's.
    pub padding: usize,
    /// The vertex behind the last of all.
    pub end: u64,
}

/// Shapes begin at a multiple of so many vertices: then both their positions, of 12 bytes, and their other attributes, of 20,
/// begin at a multiple of 256 bytes, which every device can bind.
const ALIGNMENT: u64 = 64;

impl Shapes {
    pub fn of(scene: &Scene) -> Self {
        let mut shapes = Self::default();
        let vertices: u64 = scene.meshes.iter().map(|mesh| mesh.positions.len() as u64).sum();
        shapes.end = vertices.next_multiple_of(ALIGNMENT);
        shapes.padding = (shapes.end - vertices) as usize;
        shapes.rig.skins.clone_from(&scene.rig.skins);
        let (mut known, mut of_skins, mut of_nodes) = (HashMap::new(), HashMap::new(), HashMap::new());
        let mut ends = (0, 0);
        for instance in &scene.instances {
            let mesh = &scene.meshes[instance.mesh];
            let is_bent = instance.is_deformed(mesh) && !mesh.positions.is_empty();
            let found = is_bent.then(|| {
                let (skin, node) = followed(instance, mesh);
                *known.entry((instance.mesh, skin, node)).or_insert_with(|| {
                    let joints = skin.map(|skin| {
                        *of_skins.entry(skin).or_insert_with(|| {
                            shapes.skins.push(skin);
                            let count = scene.rig.skins.get(skin).map_or(0, |skin| skin.joints.len());
                            next(&mut ends.0, count)
                        })
                    });
                    let weights = node.map(|node| {
                        let count = mesh.targets.len();
                        *of_nodes.entry((node, count)).or_insert_with(|| {
                            shapes.nodes.push((node, count));
                            next(&mut ends.1, count)
                        })
                    });
                    let first_vertex = shapes.end;
                    shapes.end += mesh.positions.len() as u64;
                    shapes.all.push(Shape { mesh: instance.mesh, joints, weights, first_vertex });
                    (shapes.all.len() - 1) as u32
                })
            });
            shapes.of_instance.push(found);
        }
        shapes
    }

    pub fn is_empty(&self) -> bool {
        self.all.is_empty()
    }

    /// What buffers of vertices are used for.
    pub fn usage(&self) -> wgpu::BufferUsages {
        let written = wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC;
        wgpu::BufferUsages::VERTEX | if self.is_empty() { wgpu::BufferUsages::empty() } else { written }
    }

    /// Gathers something of each vertex of a scene's buffers in their order: what `add` adds for all meshes, `nothing` for
    /// those that are nobody's, and what it adds for the meshes of all shapes.
    pub fn gather<T: Copy>(&self, scene: &Scene, nothing: T, add: impl Fn(&mut Vec<T>, &Mesh)) -> Vec<T> {
        let mut all = Vec::new();
        scene.meshes.iter().for_each(|mesh| add(&mut all, mesh));
        if !self.is_empty() {
            all.resize(all.len() + self.padding, nothing);
            self.all.iter().for_each(|shape| add(&mut all, &scene.meshes[shape.mesh]));
        }
        all
    }
}

/// The skin and the node that an instance's shape follows.
fn followed(instance: &Instance, mesh: &Mesh) -> (Option<usize>, Option<usize>) {
    let skin = instance.skin.filter(|_| !mesh.influences.is_empty());
    (skin, instance.node.filter(|_| !mesh.targets.is_empty()))
}

fn next(end: &mut usize, count: usize) -> Entries {
    let first = *end;
    *end += count;
    Entries { first, count }
}
