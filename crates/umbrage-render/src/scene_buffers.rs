//! A scene on the GPU: one buffer a vertex stream, one of indices, one of instances, a bind group a material.

use glam::{DVec3, Vec3};
use umbrage_scene::{Material, Pose, Scene};

use crate::buffers::filled;
use crate::caster_geometry::CasterLevels;
use crate::cover::Cover;
use crate::deformation::Deformation;
use crate::error::RenderError;
use crate::gpu::Gpu;
use crate::materials::Materials;
use crate::occluders::{RayCasters, SceneOccluders};
use crate::placement::Placement;
use crate::shaders::Finish;
use crate::shapes::Shapes;
use crate::surroundings::Surroundings;
use crate::timing::PassTimer;
use crate::vertex_colours::VertexColours;

/// What is bound once for a whole scene.
#[derive(Debug)]
pub(crate) struct SceneBuffers {
    /// Positions alone: all that caster passes read.
    pub positions: wgpu::Buffer,
    /// Normal and texture coordinates, interleaved.
    pub attributes: wgpu::Buffer,
    pub indices: wgpu::Buffer,
    pub placement: Placement,
    /// `None` where nothing is bent.
    pub deformation: Option<Deformation>,
    pub materials: Materials,
    pub colours: VertexColours,
    pub surroundings: Surroundings,
    pub finish: Finish,
    /// What meshes cast with, as soon as it is made.
    pub levels: CasterLevels,
    /// What rays go through, once settings ask for some.
    pub occluders: SceneOccluders,
    /// The covers that the scene's surfaces have.
    pub covers: Vec<Cover>,
}

impl SceneBuffers {
    pub fn new(
        gpu: &Gpu,
        scene: &Scene,
        covers: Vec<Cover>,
        levels: CasterLevels,
    ) -> Result<Self, RenderError> {
        let shapes = Shapes::of(scene);
        let positions = shapes.gather(scene, Vec3::ZERO, |all, mesh| all.extend_from_slice(&mesh.positions));
        let attributes = shapes.gather(scene, [0.0; 5], |all: &mut Vec<[f32; 5]>, mesh| {
            all.extend(mesh.normals.iter().zip(&mesh.uvs).map(|(n, uv)| [n.x, n.y, n.z, uv.x, uv.y]));
        });
        let indices: Vec<u8> = scene
            .meshes
            .iter()
            .flat_map(|mesh| bytemuck::cast_slice::<_, u8>(&mesh.indices))
            .copied()
            .collect();
        let is_matte = scene.materials.iter().all(Material::is_matte) && !VertexColours::are_in(scene);
        let vertices = |what, bytes: &[u8]| filled(gpu, what, bytes, shapes.usage());
        let positions = vertices("positions", bytemuck::cast_slice(&positions))?;
        let attributes = vertices("normals", bytemuck::cast_slice(&attributes))?;
        Ok(Self {
            colours: VertexColours::new(gpu, scene, &shapes)?,
            deformation: Deformation::new(gpu, scene, shapes, &positions, &attributes)?,
            positions,
            attributes,
            indices: filled(gpu, "indices", &indices, wgpu::BufferUsages::INDEX)?,
            placement: Placement::new(gpu, &scene.instances)?,
            materials: Materials::new(gpu, scene)?,
            surroundings: Surroundings::new(gpu, scene),
            finish: if is_matte { Finish::Matte } else { Finish::Glossy },
            levels,
            occluders: SceneOccluders::default(),
            covers,
        })
    }

    /// Takes what rays go through, where there is nothing yet.
    pub fn set_ray_casters(&self, gpu: &Gpu, casters: &RayCasters) -> Result<(), RenderError> {
        let positions =
            self.deformation.as_ref().map(|deformation| deformation.positions(gpu, &self.positions));
        let is_first = self.occluders.set(gpu, casters, positions.transpose()?)?;
        self.deformation.iter().filter(|_| is_first).for_each(Deformation::forget);
        Ok(())
    }

    /// Moves and bends everything as it is in a pose, relative to `origin`, as far as it is not so.
    pub fn move_to(
        &self,
        gpu: &Gpu,
        timer: &PassTimer,
        origin: DVec3,
        pose: &Pose,
    ) -> Result<(), RenderError> {
        self.placement.move_to(gpu, origin, pose);
        if let Some(deformation) = &self.deformation {
            deformation.move_to(gpu, timer, pose, self.occluders.get());
        }
        self.occluders.move_to(gpu, &self.placement.instances, origin, pose)
    }

    /// Gives a pass the vertices of casters.
    pub fn bind_casters(&self, pass: &mut wgpu::RenderPass<'_>, instance_numbers: &wgpu::Buffer) {
        pass.set_vertex_buffer(0, self.positions.slice(..));
        pass.set_vertex_buffer(1, instance_numbers.slice(..));
        pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint32);
    }

    /// Gives a pass the vertices of receivers.
    pub fn bind_receivers(&self, pass: &mut wgpu::RenderPass<'_>, instance_numbers: &wgpu::Buffer) {
        self.bind_casters(pass, instance_numbers);
        pass.set_vertex_buffer(2, self.attributes.slice(..));
    }

    /// Gives a pass the vertices of receivers whose materials are read.
    pub fn bind_surfaces(&self, pass: &mut wgpu::RenderPass<'_>, instance_numbers: &wgpu::Buffer) {
        self.bind_receivers(pass, instance_numbers);
        pass.set_vertex_buffer(3, self.colours.buffer.slice(..));
    }
}

/// Positions, and numbers of instances: what casters read.
pub(crate) const CASTER_BUFFERS: [Option<wgpu::VertexBufferLayout<'static>>; 2] = [
    Some(wgpu::VertexBufferLayout {
        array_stride: 12,
        step_mode: wgpu::VertexStepMode::Vertex,
        attributes: &wgpu::vertex_attr_array![0 => Float32x3],
    }),
    Some(wgpu::VertexBufferLayout {
        array_stride: 4,
        step_mode: wgpu::VertexStepMode::Instance,
        attributes: &wgpu::vertex_attr_array![3 => Uint32],
    }),
];

/// The same, and normals with texture coordinates: what receivers read.
pub(crate) const RECEIVER_BUFFERS: [Option<wgpu::VertexBufferLayout<'static>>; 3] = {
    let [positions, instances] = CASTER_BUFFERS;
    [
        positions,
        instances,
        Some(wgpu::VertexBufferLayout {
            array_stride: 20,
            step_mode: wgpu::VertexStepMode::Vertex,
            attributes: &wgpu::vertex_attr_array![1 => Float32x3, 2 => Float32x2],
        }),
    ]
};
