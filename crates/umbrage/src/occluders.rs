//! What casts, on the device, for rays: made once of meshes, and told where they stand when something moves.
//!
//! It lies in textures of whole numbers: devices that hold 128 MiB in a storage buffer hold 512 MiB in a texture, and software
//! reads them several times faster.

use std::ops::Range;

use umbrage_occluders::{Geometry, InstanceRecord, Node, TopLevel};
use umbrage_wgsl::{FIRST_OCCLUDER_BINDING, OccluderTraits};

use crate::error::ShadowError;

/// Casters that shaders trace rays through, where [`Settings::exact`](umbrage_core::Settings::exact) asks for it:
/// [`Shadows::set_occluders`](crate::Shadows::set_occluders) binds them.
///
/// A copy shares the textures of the original.
#[derive(Clone, Debug, PartialEq)]
pub struct Occluders {
    /// In the order of their bindings: nodes of the top level, instances, nodes of meshes, triangles, corners, coverage.
    tables: [Table; 6],
    traits: OccluderTraits,
    room: usize,
}

/// What there is to be room for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct OccluderRoom {
    /// The number of instances.
    pub instances: usize,
    /// Whether some may be bent, so that rays know only the box around them and leave what is behind it to the maps.
    pub bent: bool,
}

impl Occluders {
    /// Puts casters onto the device. None stands anywhere before [`Self::place`].
    ///
    /// # Errors
    /// When something of them exceeds what a texture of the device holds.
    pub fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        geometry: &Geometry,
        room: OccluderRoom,
    ) -> Result<Self, ShadowError> {
        let top = (2 * room.instances).max(1);
        let corners: Vec<[f32; 4]> = geometry.corners.iter().map(|[x, y, z]| [*x, *y, *z, 0.0]).collect();
        let four = wgpu::TextureFormat::Rgba32Uint;
        let table = |what, format, bytes: usize| Table::new(device, what, format, bytes);
        let tables = [
            table("boxes of instances", four, top * size_of::<Node>())?,
            table("instances", four, room.instances * size_of::<InstanceRecord>())?,
            table("boxes of triangles", four, size_of_val(&geometry.nodes[..]))?,
            table("triangles", four, size_of_val(&geometry.triangles[..]))?,
            table("corners", four, size_of_val(&corners[..]))?,
            table("words of masks", wgpu::TextureFormat::R32Uint, size_of_val(&geometry.coverage[..]))?,
        ];
        tables[2].write(queue, bytemuck::cast_slice(&geometry.nodes));
        tables[3].write(queue, bytemuck::cast_slice(&geometry.triangles));
        tables[4].write(queue, bytemuck::cast_slice(&corners));
        tables[5].write(queue, bytemuck::cast_slice(&geometry.coverage));
        let traits = OccluderTraits { covers: geometry.has_covers(), bent: room.bent };
        let all = Self { tables, traits, room: room.instances };
        all.place(queue, &TopLevel::build(&[], [], glam::DVec3::ZERO))?;
        Ok(all)
    }

    /// Says where instances stand, relative to the origin that is given to [`Shadows::set_origin`](crate::Shadows::set_origin).
    ///
    /// # Errors
    /// When there are more than there is room for, or one is bent where none was to be.
    pub fn place(&self, queue: &wgpu::Queue, top: &TopLevel) -> Result<(), ShadowError> {
        if top.instances() > self.room || top.has_bent && !self.traits.bent {
            return Err(ShadowError::OccluderRoom { got: top.instances(), max: self.room });
        }
        self.tables[0].write(queue, bytemuck::cast_slice(&top.nodes));
        self.tables[1].write(queue, bytemuck::cast_slice(&top.records));
        Ok(())
    }

    /// Bytes of everything.
    pub fn bytes(&self) -> u64 {
        self.tables.iter().map(Table::bytes).sum()
    }

    /// What shader texts depend on.
    pub(crate) fn traits(&self) -> OccluderTraits {
        self.traits
    }

    /// The texture of a binding; `None` where it is another's.
    pub(crate) fn view(&self, binding: u32) -> Option<&wgpu::TextureView> {
        const BINDINGS: Range<u32> = FIRST_OCCLUDER_BINDING..FIRST_OCCLUDER_BINDING + 6;
        BINDINGS.contains(&binding).then(|| &self.tables[(binding - FIRST_OCCLUDER_BINDING) as usize].view)
    }
}

/// A list of texels, in rows of [`WIDTH`].
#[derive(Clone, Debug, PartialEq)]
struct Table {
    texture: wgpu::Texture,
    view: wgpu::TextureView,
}

/// The texels of a row, as `umbrage_texel` of `exact/occluders.wgsl` has it.
const WIDTH: usize = 4096;

impl Table {
    /// Room for so many bytes.
    fn new(
        device: &wgpu::Device,
        what: &'static str,
        format: wgpu::TextureFormat,
        bytes: usize,
    ) -> Result<Self, ShadowError> {
        let texels = bytes.div_ceil(bytes_of(format));
        let max = WIDTH * device.limits().max_texture_dimension_2d as usize;
        if texels > max {
            return Err(ShadowError::OccludersTooLarge { what, texels, max });
        }
        let texture = device.create_texture(&wgpu::TextureDescriptor {
            label: Some("Occluders::table"),
            size: wgpu::Extent3d {
                width: texels.clamp(1, WIDTH) as u32,
                height: texels.div_ceil(WIDTH).max(1) as u32,
                depth_or_array_layers: 1,
            },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format,
            usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
            view_formats: &[],
        });
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        Ok(Self { texture, view })
    }

    /// Writes the first texels: whole rows, and then what is left.
    fn write(&self, queue: &wgpu::Queue, bytes: &[u8]) {
        let of_texel = bytes_of(self.texture.format());
        let (rows, rest) = bytes.split_at(bytes.len() / (WIDTH * of_texel) * (WIDTH * of_texel));
        let whole = rows.len() / (WIDTH * of_texel);
        for (first, rows, bytes) in [(0, whole, rows), (whole, 1, rest)] {
            if bytes.is_empty() {
                continue;
            }
            let width = bytes.len() / of_texel / rows;
            let target = wgpu::TexelCopyTextureInfo {
                texture: &self.texture,
                mip_level: 0,
                origin: wgpu::Origin3d { x: 0, y: first as u32, z: 0 },
                aspect: wgpu::TextureAspect::All,
            };
            let layout = wgpu::TexelCopyBufferLayout {
                offset: 0,
                bytes_per_row: Some((width * of_texel) as u32),
                rows_per_image: None,
            };
            let size = wgpu::Extent3d { width: width as u32, height: rows as u32, depth_or_array_layers: 1 };
            queue.write_texture(target, bytes, layout, size);
        }
    }

    fn bytes(&self) -> u64 {
        let texels = u64::from(self.texture.width()) * u64::from(self.texture.height());
        texels * bytes_of(self.texture.format()) as u64
    }
}

/// The bytes of a texel: four words or one.
fn bytes_of(format: wgpu::TextureFormat) -> usize {
    if format == wgpu::TextureFormat::R32Uint { 4 } else { 16 }
}
