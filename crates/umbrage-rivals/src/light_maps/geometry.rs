//! What a pass draws: surfaces with their places in the atlas, others without, and what moves as it stands in a pose.

use std::ops::Range;

use umbrage_judge::Triangles;
use umbrage_render::Gpu;
use umbrage_scene::{Mesh, Pose, Scene};
use wgpu::util::DeviceExt as _;

use super::unwrap::{Placed, Unwrapped, has_texels};

/// Vertices and triangles on the device.
#[derive(Debug)]
pub(super) struct Geometry {
    pub positions: wgpu::Buffer,
    /// Places within a rectangle of the atlas.
    pub places: wgpu::Buffer,
    pub indices: wgpu::Buffer,
}

/// Some triangles of an instance.
#[derive(Clone, Debug)]
pub(super) struct Draw {
    /// The index of the geometry.
    pub geometry: usize,
    pub indices: Range<u32>,
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
    /// The number of vertices that have a place in the atlas, and of instances that have a rectangle there.
    pub placed: [u64; 2],
}

impl Geometry {
    fn new(gpu: &Gpu, positions: &[[f32; 3]], places: &[[u16; 2]], indices: &[u32]) -> Self {
        let buffer = |label, contents: &[u8], usage| {
            // A buffer of no bytes cannot be bound.
            let contents = if contents.is_empty() { &[0; 16] } else { contents };
            gpu.device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
                label: Some(label),
                contents,
                usage,
            })
        };
        let vertices = wgpu::BufferUsages::VERTEX;
        Self {
            positions: buffer("Geometry::positions", bytemuck::cast_slice(positions), vertices),
            places: buffer("Geometry::places", bytemuck::cast_slice(places), vertices),
            indices: buffer("Geometry::indices", bytemuck::cast_slice(indices), wgpu::BufferUsages::INDEX),
        }
    }

    /// What moves, as it stands in a pose, relative to an origin in the world.
    pub fn moving(gpu: &Gpu, moving: &Scene, pose: &Pose, origin: glam::DVec3) -> (Self, Range<u32>) {
        let triangles = Triangles::of(moving, pose);
        let corners = triangles.corners().iter().flatten();
        let positions: Vec<[f32; 3]> =
            corners.map(|corner| (*corner - origin).as_vec3().to_array()).collect();
        let indices: Vec<u32> = (0..positions.len() as u32).collect();
        (Self::new(gpu, &positions, &vec![[0; 2]; positions.len()], &indices), 0..indices.len() as u32)
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
            surfaces.geometry.push(Geometry::new(gpu, &positions, &places, &shape.indices));
            for placed in &shape.placed {
                is_placed[placed.instance] = true;
                let draws = ranges(scene, mesh).into_iter().map(|(has, indices)| Draw {
                    geometry,
                    indices,
                    instance: placed.instance,
                    placed: has.then_some(*placed),
                });
                surfaces.draws.extend(draws);
            }
            let [vertices, instances] = &mut surfaces.placed;
            *vertices += shape.vertices.len() as u64;
            *instances += shape.placed.len() as u64;
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
                self.geometry.push(Geometry::new(
                    gpu,
                    &positions,
                    &vec![[0; 2]; positions.len()],
                    &mesh.indices,
                ));
                self.geometry.len() - 1
            });
            let indices = 0..mesh.indices.len() as u32;
            self.draws.push(Draw { geometry, indices, instance, placed: None });
        }
    }
}

/// The indices of a mesh's triangles that have texels, or have none, as few ranges as possible.
fn ranges(scene: &Scene, mesh: &Mesh) -> Vec<(bool, Range<u32>)> {
    let mut ranges: Vec<(bool, Range<u32>)> = Vec::new();
    for (triangle, has) in has_texels(scene, mesh).enumerate() {
        let end = 3 * (triangle as u32 + 1);
        match ranges.last_mut().filter(|(of, _)| *of == has) {
            Some((_, range)) => range.end = end,
            None => ranges.push((has, end - 3..end)),
        }
    }
    ranges
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
