//! A scene on the GPU: one buffer a vertex stream, one of indices, one of instances, a bind group a material.

use encase::{ShaderType, UniformBuffer};
use glam::Vec4;
use umbrage_scene::{Instance, Scene, Texture};

use crate::error::RenderError;
use crate::gpu::Gpu;
use crate::textures;

/// What is bound once for a whole scene.
#[derive(Debug)]
pub(crate) struct SceneBuffers {
    /// Positions alone: all that caster passes read.
    pub positions: wgpu::Buffer,
    /// Normal and texture coordinates, interleaved.
    pub attributes: wgpu::Buffer,
    pub indices: wgpu::Buffer,
    /// `world_from_mesh` of every instance.
    pub instances: wgpu::Buffer,
    pub materials: Vec<wgpu::BindGroup>,
    pub material_layout: wgpu::BindGroupLayout,
}

#[derive(Clone, Copy, Debug, ShaderType)]
struct BaseColour {
    base_colour: Vec4,
}

impl SceneBuffers {
    pub fn new(gpu: &Gpu, scene: &Scene) -> Result<Self, RenderError> {
        let positions: Vec<u8> = scene
            .meshes
            .iter()
            .flat_map(|mesh| bytemuck::cast_slice::<_, u8>(&mesh.positions))
            .copied()
            .collect();
        let attributes: Vec<[f32; 5]> = scene
            .meshes
            .iter()
            .flat_map(|mesh| mesh.normals.iter().zip(&mesh.uvs).map(|(n, uv)| [n.x, n.y, n.z, uv.x, uv.y]))
            .collect();
        let indices: Vec<u8> = scene
            .meshes
            .iter()
            .flat_map(|mesh| bytemuck::cast_slice::<_, u8>(&mesh.indices))
            .copied()
            .collect();
        let instance_bytes = vec![0; scene.instances.len().max(1) * size_of::<[f32; 16]>()];
        let material_layout = material_layout(&gpu.device);
        let buffers = Self {
            positions: filled(gpu, "positions", &positions, wgpu::BufferUsages::VERTEX)?,
            attributes: filled(
                gpu,
                "normals",
                bytemuck::cast_slice(&attributes),
                wgpu::BufferUsages::VERTEX,
            )?,
            indices: filled(gpu, "indices", &indices, wgpu::BufferUsages::INDEX)?,
            instances: filled(gpu, "instances", &instance_bytes, wgpu::BufferUsages::STORAGE)?,
            materials: materials(gpu, scene, &material_layout)?,
            material_layout,
        };
        buffers.place(gpu, &scene.instances, 0.0);
        Ok(buffers)
    }

    /// Gives a pass the vertices of receivers.
    pub fn bind_receivers(&self, pass: &mut wgpu::RenderPass<'_>, instance_numbers: &wgpu::Buffer) {
        pass.set_vertex_buffer(0, self.positions.slice(..));
        pass.set_vertex_buffer(1, instance_numbers.slice(..));
        pass.set_vertex_buffer(2, self.attributes.slice(..));
        pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint32);
    }

    /// Writes where every instance stands at time `seconds`.
    pub fn place(&self, gpu: &Gpu, instances: &[Instance], seconds: f32) {
        let matrices: Vec<[f32; 16]> =
            instances.iter().map(|instance| instance.world_from_mesh_at(seconds).to_cols_array()).collect();
        gpu.queue.write_buffer(&self.instances, 0, bytemuck::cast_slice(&matrices));
    }
}

/// A buffer with something in it; never of no size, which cannot be bound.
pub(crate) fn filled(
    gpu: &Gpu,
    what: &'static str,
    bytes: &[u8],
    usage: wgpu::BufferUsages,
) -> Result<wgpu::Buffer, RenderError> {
    let limits = gpu.device.limits();
    let most = if usage.contains(wgpu::BufferUsages::STORAGE) {
        limits.max_storage_buffer_binding_size.min(limits.max_buffer_size)
    } else {
        limits.max_buffer_size
    };
    let size = (bytes.len() as u64).max(16);
    if size > most {
        return Err(RenderError::TooLarge { what, bytes: size, most });
    }
    let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some(what),
        size,
        usage: usage | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    gpu.queue.write_buffer(&buffer, 0, bytes);
    Ok(buffer)
}

fn material_layout(device: &wgpu::Device) -> wgpu::BindGroupLayout {
    let entry = |binding, ty| wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::FRAGMENT,
        ty,
        count: None,
    };
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("SceneBuffers::material_layout"),
        entries: &[
            entry(
                0,
                wgpu::BindingType::Buffer {
                    ty: wgpu::BufferBindingType::Uniform,
                    has_dynamic_offset: false,
                    min_binding_size: None,
                },
            ),
            entry(
                1,
                wgpu::BindingType::Texture {
                    sample_type: wgpu::TextureSampleType::Float { filterable: true },
                    view_dimension: wgpu::TextureViewDimension::D2,
                    multisampled: false,
                },
            ),
            entry(2, wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering)),
        ],
    })
}

fn materials(
    gpu: &Gpu,
    scene: &Scene,
    layout: &wgpu::BindGroupLayout,
) -> Result<Vec<wgpu::BindGroup>, RenderError> {
    let most = gpu.device.limits().max_texture_dimension_2d;
    let upload = |texture: &Texture| {
        let Texture { name: _, width, height, rgba } = texture;
        if *width > most || *height > most {
            let bytes = u64::from(*width) * u64::from(*height) * 4;
            return Err(RenderError::TooLarge { what: "textures", bytes, most: u64::from(most) });
        }
        Ok(textures::upload(&gpu.device, &gpu.queue, *width, *height, rgba))
    };
    let textures = scene.textures.iter().map(upload).collect::<Result<Vec<_>, _>>()?;
    let white = textures::upload(&gpu.device, &gpu.queue, 1, 1, &[255; 4]);
    let sampler = gpu.device.create_sampler(&wgpu::SamplerDescriptor {
        label: Some("SceneBuffers::sampler"),
        address_mode_u: wgpu::AddressMode::Repeat,
        address_mode_v: wgpu::AddressMode::Repeat,
        mag_filter: wgpu::FilterMode::Linear,
        min_filter: wgpu::FilterMode::Linear,
        mipmap_filter: wgpu::MipmapFilterMode::Linear,
        anisotropy_clamp: 1,
        ..Default::default()
    });
    let group = |material: &umbrage_scene::Material| {
        let mut uniform = UniformBuffer::new(Vec::new());
        uniform
            .write(&BaseColour { base_colour: material.base_colour })
            .map_err(|e| RenderError::Device(e.to_string()))?;
        let colour = filled(gpu, "materials", &uniform.into_inner(), wgpu::BufferUsages::UNIFORM)?;
        let texture = material.texture.map_or(&white, |index| &textures[index]);
        Ok(gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("SceneBuffers::material"),
            layout,
            entries: &[
                wgpu::BindGroupEntry { binding: 0, resource: colour.as_entire_binding() },
                wgpu::BindGroupEntry { binding: 1, resource: wgpu::BindingResource::TextureView(texture) },
                wgpu::BindGroupEntry { binding: 2, resource: wgpu::BindingResource::Sampler(&sampler) },
            ],
        }))
    };
    scene.materials.iter().map(group).collect()
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
