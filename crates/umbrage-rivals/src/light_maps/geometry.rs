//! What a pass draws: surfaces with their places in the atlas, others without, and what moves as it stands in a pose.

use std::ops::Range;

use glam::DVec3;
use umbrage_judge::Triangles;
use umbrage_render::{Gpu, RenderError};
use umbrage_scene::{Aabb, Mesh, Part, Pose, Scene};

use super::resources::filled;
use super::unwrap::{Placed, Unwrapped, receives};

/// Vertices and triangles on the device.
#[derive(Debug)]
pub(super) struct Geometry {
    pub positions: wgpu::Buffer,
    /// Places within a rectangle of the atlas.
    pub places: wgpu::Buffer,
    pub indices: wgpu::Buffer,
    pub pieces: Vec<Piece>,
}

/// A piece is a part of a mesh, drawn where the camera sees its box.
#[derive(Clone, Debug)]
pub(super) struct Piece {
    pub indices: Range<u32>,
    /// The box around the piece, in mesh space; `None` for what is always drawn.
    pub bounds: Option<Aabb>,
    pub has_texels: bool,
}

/// An instance, and where it lies in the atlas.
#[derive(Clone, Debug)]
pub(super) struct Draw {
    /// The index of the geometry.
    pub geometry: usize,
    /// The index of the instance in the scene.
    pub instance: usize,
    /// `None` for what has no texels.
    pub placed: Option<Placed>,
}

/// A scene on the device.
#[derive(Debug, Default)]
pub(super) struct Surfaces {
    pub geometry: Vec<Geometry>,
    pub draws: Vec<Draw>,
}

impl Geometry {
    fn new(
        gpu: &Gpu,
        positions: &[[f32; 3]],
        places: &[[u16; 2]],
        indices: &[u32],
        pieces: Vec<Piece>,
    ) -> Self {
        let (vertices, triangles) = (wgpu::BufferUsages::VERTEX, wgpu::BufferUsages::INDEX);
        Self {
            positions: filled(gpu, "Geometry::positions", bytemuck::cast_slice(positions), vertices),
            places: filled(gpu, "Geometry::places", bytemuck::cast_slice(places), vertices),
            indices: filled(gpu, "Geometry::indices", bytemuck::cast_slice(indices), triangles),
            pieces,
        }
    }

    /// What moves, as it stands in a pose, relative to an origin in the world.
    pub fn moving(gpu: &Gpu, moving: &Scene, pose: &Pose, origin: DVec3) -> Result<Self, RenderError> {
        let triangles = Triangles::of(moving, pose);
        let corners = triangles.corners().iter().flatten();
        let positions: Vec<[f32; 3]> =
            corners.map(|corner| (*corner - origin).as_vec3().to_array()).collect();
        let indices: Vec<u32> = (0..positions.len() as u32).collect();
        let all = Piece { indices: 0..positions.len() as u32, bounds: None, has_texels: false };
        let places = vec![[0; 2]; positions.len()];
        let make = || Ok::<_, RenderError>(Self::new(gpu, &positions, &places, &indices, vec![all]));
        gpu.allocate("what moves", make)
    }
}

impl Surfaces {
    /// Uploads what stands still.
    pub fn new(gpu: &Gpu, scene: &Scene, unwrapped: &Unwrapped) -> Self {
        let mut surfaces = Self::default();
        let mut is_placed = vec![false; scene.instances.len()];
        for shape in &unwrapped.shapes {
            let mesh = &scene.meshes[shape.mesh];
            let (positions, places): (Vec<_>, Vec<_>) = shape
                .vertices
                .iter()
                .map(|(vertex, place)| (mesh.positions[*vertex as usize].to_array(), *place))
                .unzip();
            let geometry = surfaces.geometry.len();
            surfaces.geometry.push(Geometry::new(
                gpu,
                &positions,
                &places,
                &shape.indices,
                pieces(scene, mesh),
            ));
            for placed in &shape.placed {
                is_placed[placed.instance] = true;
                surfaces.draws.push(Draw { geometry, instance: placed.instance, placed: Some(*placed) });
            }
        }
        surfaces.add_others(gpu, scene, &is_placed);
        surfaces
    }

    /// Adds what stands still and has no texels at all.
    fn add_others(&mut self, gpu: &Gpu, scene: &Scene, is_placed: &[bool]) {
        let mut of_mesh = vec![None; scene.meshes.len()];
        for (instance, of) in scene.instances.iter().enumerate() {
            if of.is_dynamic() || is_placed[instance] {
                continue;
            }
            let mesh = &scene.meshes[of.mesh];
            let geometry = *of_mesh[of.mesh].get_or_insert_with(|| {
                let positions: Vec<[f32; 3]> = mesh.positions.iter().map(|place| place.to_array()).collect();
                let places = vec![[0; 2]; positions.len()];
                self.geometry.push(Geometry::new(
                    gpu,
                    &positions,
                    &places,
                    &mesh.indices,
                    pieces(scene, mesh),
                ));
                self.geometry.len() - 1
            });
            self.draws.push(Draw { geometry, instance, placed: None });
        }
    }
}

fn pieces(scene: &Scene, mesh: &Mesh) -> Vec<Piece> {
    let piece = |part: &Part| Piece {
        indices: part.indices.clone(),
        bounds: Some(part.bounds),
        has_texels: receives(scene, part),
    };
    mesh.parts.iter().map(piece).collect()
}

/// A scene of what moves alone, without pictures.
pub(super) fn moving(scene: &Scene) -> Scene {
    let instances: Vec<_> =
        scene.instances.iter().filter(|instance| instance.is_dynamic()).cloned().collect();
    let is_used = |mesh: usize| instances.iter().any(|instance| instance.mesh == mesh);
    let meshes = scene.meshes.iter().enumerate();
    Scene {
        meshes: meshes
            .map(|(i, mesh)| if is_used(i) { mesh.clone() } else { Mesh::new(&mesh.name, &[]) })
            .collect(),
        instances,
        materials: scene.materials.clone(),
        rig: scene.rig.clone(),
        ..Scene::default()
    }
}
