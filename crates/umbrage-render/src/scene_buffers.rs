//! A scene on the GPU: one buffer a vertex stream, one of indices, one of instances, a bind group a material.

use encase::{ShaderType, UniformBuffer};
use glam::Vec4;
use umbrage_scene::{Scene, Texture};

use crate::buffers::{binding, filled};
use crate::error::RenderError;
use crate::gpu::Gpu;
use crate::placement::Placement;
use crate::textures;

/// What is bound once for a whole scene.
#[derive(Debug)]
pub(crate) struct SceneBuffers {
    /// Positions alone: all that caster passes read.
    pub positions: wgpu::Buffer,
    /// Normal and texture coordinates, interleaved.
    pub attributes: wgpu::Buffer,
    pub indices: wgpu::Buffer,
    pub placement: Placement,
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
        let material_layout = material_layout(gpu);
        Ok(Self {
            positions: filled(gpu, "positions", &positions, wgpu::BufferUsages::VERTEX)?,
            attributes: filled(
                gpu,
                "normals",
                bytemuck::cast_slice(&attributes),
                wgpu::BufferUsages::VERTEX,
            )?,
            indices: filled(gpu, "indices", &indices, wgpu::BufferUsages::INDEX)?,
            placement: Placement::new(gpu, &scene.instances)?,
            materials: materials(gpu, scene, &material_layout)?,
            material_layout,
        })
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
}

fn material_layout(gpu: &Gpu) -> wgpu::BindGroupLayout {
    let texture = wgpu::BindingType::Texture {
        sample_type: wgpu::TextureSampleType::Float { filterable: true },
        view_dimension: wgpu::TextureViewDimension::D2,
        multisampled: false,
    };
    let sampler = wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering);
    let types = [binding(wgpu::BufferBindingType::Uniform), texture, sampler];
    gpu.layout("SceneBuffers::material_layout", types.map(|ty| (wgpu::ShaderStages::FRAGMENT, ty)))
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
        Ok(textures::upload(gpu, *width, *height, rgba))
    };
    let textures = scene.textures.iter().map(upload).collect::<Result<Vec<_>, _>>()?;
    let white = textures::upload(gpu, 1, 1, &[255; 4]);
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
        let resources = [
            colour.as_entire_binding(),
            wgpu::BindingResource::TextureView(texture),
            wgpu::BindingResource::Sampler(&sampler),
        ];
        Ok(gpu.bind_group("SceneBuffers::material", layout, resources))
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
