//! Materials on the GPU: a bind group each, as `shaders/material.wgsl` and `shaders/material_maps.wgsl` read it.

use std::collections::HashMap;

use encase::{ShaderType, UniformBuffer};
use glam::{Affine2, Vec2, Vec3, Vec4};
use umbrage_scene::{Alpha, Maps, Material, Scene, Texture};

use crate::buffers::{binding, filled};
use crate::error::RenderError;
use crate::gpu::Gpu;
use crate::textures::{self, Numbers};

/// The bind groups of a scene's materials, in its order.
#[derive(Debug)]
pub(crate) struct Materials {
    pub groups: Vec<wgpu::BindGroup>,
    pub layout: wgpu::BindGroupLayout,
}

#[derive(Clone, Copy, Debug, ShaderType)]
struct GpuPlace {
    columns: Vec4,
    offset: Vec2,
}

#[derive(Clone, Copy, Debug, ShaderType)]
struct GpuMaterial {
    base_colour: Vec4,
    emission: Vec3,
    metallic: f32,
    roughness: f32,
    specular: f32,
    normal_scale: f32,
    occlusion_strength: f32,
    places: [GpuPlace; 4],
    unlit: u32,
    is_mask: u32,
    cutoff: f32,
    solidity: f32,
}

impl Materials {
    pub fn new(gpu: &Gpu, scene: &Scene) -> Result<Self, RenderError> {
        let layout = layout(gpu);
        let mut pictures = Pictures::new(gpu, &scene.textures);
        let sampler = sampler(gpu);
        let group = |material: &Material| {
            let Maps { metallic_roughness, normal, occlusion, emission } = material.maps;
            let [normal, occlusion] = [normal, occlusion].map(|of| of.map(|(map, _)| map));
            let views = [
                pictures.view(material.texture, base_numbers(material))?,
                pictures.view(metallic_roughness.map(|map| map.texture), Numbers::Linear)?,
                pictures.view(normal.map(|map| map.texture), Numbers::Linear)?,
                pictures.view(occlusion.map(|map| map.texture), Numbers::Linear)?,
                pictures.view(emission.map(|map| map.texture), Numbers::Srgb)?,
            ];
            let [base, metallic_roughness, normal, occlusion, emission] =
                views.each_ref().map(wgpu::BindingResource::TextureView);
            let alpha = pictures.alpha(material);
            let mut uniform = UniformBuffer::new(Vec::new());
            uniform.write(&gpu_material(material)).map_err(|e| RenderError::Device(e.to_string()))?;
            let numbers = filled(gpu, "materials", &uniform.into_inner(), wgpu::BufferUsages::UNIFORM)?;
            let resources = [
                numbers.as_entire_binding(),
                base,
                wgpu::BindingResource::Sampler(&sampler),
                metallic_roughness,
                normal,
                occlusion,
                emission,
                wgpu::BindingResource::TextureView(&alpha),
            ];
            Ok(gpu.bind_group("Materials::group", &layout, resources))
        };
        let groups = scene.materials.iter().map(group).collect::<Result<_, RenderError>>()?;
        Ok(Self { groups, layout })
    }
}

fn layout(gpu: &Gpu) -> wgpu::BindGroupLayout {
    let texture = wgpu::BindingType::Texture {
        sample_type: wgpu::TextureSampleType::Float { filterable: true },
        view_dimension: wgpu::TextureViewDimension::D2,
        multisampled: false,
    };
    let sampler = wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering);
    let numbers = binding(wgpu::BufferBindingType::Uniform);
    let types = [numbers, texture, sampler, texture, texture, texture, texture, texture];
    gpu.layout("Materials::layout", types.map(|ty| (wgpu::ShaderStages::FRAGMENT, ty)))
}

fn sampler(gpu: &Gpu) -> wgpu::Sampler {
    gpu.device.create_sampler(&wgpu::SamplerDescriptor {
        label: Some("Materials::sampler"),
        address_mode_u: wgpu::AddressMode::Repeat,
        address_mode_v: wgpu::AddressMode::Repeat,
        mag_filter: wgpu::FilterMode::Linear,
        min_filter: wgpu::FilterMode::Linear,
        mipmap_filter: wgpu::MipmapFilterMode::Linear,
        anisotropy_clamp: 1,
        ..Default::default()
    })
}

fn gpu_material(material: &Material) -> GpuMaterial {
    let Material {
        name: _,
        base_colour,
        texture: _,
        metallic,
        roughness,
        specular,
        emission,
        alpha,
        transmission,
        unlit,
        casts: _,
        maps,
    } = material;
    let Maps { metallic_roughness, normal, occlusion, emission: emission_map } = *maps;
    let maps = [metallic_roughness, normal.map(|of| of.0), occlusion.map(|of| of.0), emission_map];
    GpuMaterial {
        base_colour: *base_colour,
        emission: *emission,
        metallic: *metallic,
        roughness: *roughness,
        specular: *specular,
        // Without a picture the normal stays as it is, whatever white means.
        normal_scale: normal.map_or(0.0, |(_, scale)| scale),
        occlusion_strength: occlusion.map_or(0.0, |(_, strength)| strength),
        places: maps.map(|map| place(map.map_or(Affine2::IDENTITY, |map| map.picture_from_uv))),
        unlit: u32::from(*unlit),
        is_mask: u32::from(!matches!(alpha, Alpha::Blend)),
        cutoff: match *alpha {
            Alpha::Opaque => f32::MIN,
            Alpha::Mask { cutoff } => cutoff,
            Alpha::Blend => 0.0,
        },
        solidity: 1.0 - transmission.clamp(0.0, 1.0),
    }
}

/// What the numbers of the base colour's picture mean: its smaller levels depend on what alpha does.
fn base_numbers(material: &Material) -> Numbers {
    match material.alpha {
        Alpha::Opaque => Numbers::Srgb,
        Alpha::Blend => Numbers::Veil,
        // The cut-off of the texture's own alpha.
        Alpha::Mask { cutoff } => {
            let own = (255.0 * cutoff / material.base_colour.w).ceil();
            if (1.0..=255.0).contains(&own) { Numbers::Mask(own as u8) } else { Numbers::Veil }
        }
    }
}

fn place(picture_from_uv: Affine2) -> GpuPlace {
    let columns = Vec4::from_array(picture_from_uv.matrix2.to_cols_array());
    GpuPlace { columns, offset: picture_from_uv.translation }
}

/// The textures of a scene on the device, each uploaded when it is first used, and once for each meaning of its numbers.
struct Pictures<'a> {
    gpu: &'a Gpu,
    textures: &'a [Texture],
    uploaded: HashMap<(usize, Numbers), wgpu::TextureView>,
    /// The alphas of textures that were asked for them.
    alphas: HashMap<usize, wgpu::TextureView>,
    /// Where there is no picture: it changes nothing.
    white: wgpu::TextureView,
}

impl<'a> Pictures<'a> {
    fn new(gpu: &'a Gpu, textures: &'a [Texture]) -> Self {
        let white = textures::upload(gpu, 1, 1, &[255; 4], Numbers::Linear);
        Self { gpu, textures, uploaded: HashMap::new(), alphas: HashMap::new(), white }
    }

    fn view(&mut self, texture: Option<usize>, numbers: Numbers) -> Result<wgpu::TextureView, RenderError> {
        let Some((i, texture)) = texture.and_then(|i| Some((i, self.textures.get(i)?))) else {
            return Ok(self.white.clone());
        };
        if let Some(view) = self.uploaded.get(&(i, numbers)) {
            return Ok(view.clone());
        }
        let Texture { name: _, width, height, rgba } = texture;
        let most = self.gpu.device.limits().max_texture_dimension_2d;
        if *width > most || *height > most {
            let bytes = u64::from(*width) * u64::from(*height) * 4;
            return Err(RenderError::TooLarge { what: "textures", bytes, most: u64::from(most) });
        }
        let view = textures::upload(self.gpu, *width, *height, rgba, numbers);
        self.uploaded.insert((i, numbers), view.clone());
        Ok(view)
    }

    /// The alpha of a material's picture, where alpha counts for something; its size was checked with the colours.
    fn alpha(&mut self, material: &Material) -> wgpu::TextureView {
        let counts = !matches!(material.alpha, Alpha::Opaque);
        let picture = material.texture.filter(|_| counts).and_then(|i| Some((i, self.textures.get(i)?)));
        let Some((i, Texture { name: _, width, height, rgba })) = picture else { return self.white.clone() };
        let upload = || textures::upload_alpha(self.gpu, *width, *height, rgba);
        self.alphas.entry(i).or_insert_with(upload).clone()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shader_and_rust_agree_where_every_field_lies() {
        let text = include_str!("../shaders/material.wgsl");
        let structs = &text[text.find("/// Where on").unwrap()..text.find("@group").unwrap()];
        let module = naga::front::wgsl::parse_str(structs).unwrap();
        let members = |name: &str| {
            let (_, found) = module.types.iter().find(|(_, t)| t.name.as_deref() == Some(name)).unwrap();
            let naga::TypeInner::Struct { members, .. } = &found.inner else { panic!("{name} is a struct") };
            members.iter().map(|m| u64::from(m.offset)).collect::<Vec<_>>()
        };
        assert_eq!(members("Place"), (0..2).map(|i| GpuPlace::METADATA.offset(i)).collect::<Vec<_>>());
        assert_eq!(members("Material"), (0..12).map(|i| GpuMaterial::METADATA.offset(i)).collect::<Vec<_>>());
    }
}
