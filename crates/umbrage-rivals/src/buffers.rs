//! Buffers and textures of a family, and what they take on the device.

use encase::internal::WriteInto;
use encase::{ShaderType, StorageBuffer};
use umbrage_render::{Gpu, RenderError};

/// Makes buffers on a device, and counts their bytes.
#[derive(Debug)]
pub(crate) struct Held {
    gpu: Gpu,
    bytes: u64,
}

impl Held {
    pub fn new(gpu: &Gpu) -> Self {
        Self { gpu: gpu.clone(), bytes: 0 }
    }

    /// The bytes of all that was made and is still held.
    pub fn bytes(&self) -> u64 {
        self.bytes
    }

    /// Makes a buffer that shaders bind, of 32 bytes at least, since one of no size cannot be bound. A longer one has the length
    /// that was asked for, so that shaders which ask for the length of a list in it hear the number of what is listed.
    pub fn buffer(
        &mut self,
        what: &'static str,
        bytes: u64,
        usage: wgpu::BufferUsages,
    ) -> Result<wgpu::Buffer, RenderError> {
        let (size, most) = (bound(bytes), self.most());
        if size > most {
            return Err(RenderError::TooLarge { what, bytes: size, most });
        }
        let descriptor = wgpu::BufferDescriptor {
            label: Some(what),
            size,
            usage: usage | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        };
        let device = &self.gpu.device;
        let made = self.gpu.allocate(what, || Ok::<_, RenderError>(device.create_buffer(&descriptor)))?;
        self.bytes += size;
        Ok(made)
    }

    /// Makes a buffer that shaders bind in the place of one that was outgrown, if there was one: with room to grow, where the
    /// device has it.
    pub fn outgrown(
        &mut self,
        what: &'static str,
        old: Option<wgpu::Buffer>,
        bytes: u64,
    ) -> Result<wgpu::Buffer, RenderError> {
        self.bytes -= old.map_or(0, |old| old.size());
        self.buffer(what, roomy(bytes, self.most()), wgpu::BufferUsages::STORAGE)
    }

    /// The bytes that a buffer may have.
    fn most(&self) -> u64 {
        let limits = self.gpu.device.limits();
        let most = limits.max_storage_buffer_binding_size.min(limits.max_buffer_size);
        most - most % wgpu::COPY_BUFFER_ALIGNMENT
    }

    /// Makes a buffer that shaders read, with something in it.
    pub fn filled<T>(&mut self, what: &'static str, list: &Vec<T>) -> Result<wgpu::Buffer, RenderError>
    where
        Vec<T>: ShaderType + WriteInto,
    {
        let bytes = storage_bytes(list);
        let buffer = self.buffer(what, bytes.len() as u64, wgpu::BufferUsages::STORAGE)?;
        self.gpu.queue.write_buffer(&buffer, 0, &bytes);
        Ok(buffer)
    }
}

/// The bytes of a buffer for so many bytes.
fn bound(bytes: u64) -> u64 {
    bytes.max(32).next_multiple_of(wgpu::COPY_BUFFER_ALIGNMENT)
}

/// The bytes of a buffer that has room for more than so many, as far as it may have.
fn roomy(bytes: u64, most: u64) -> u64 {
    bytes.next_power_of_two().min(most).max(bytes)
}

/// A list as shaders read it.
pub(crate) fn storage_bytes<T>(list: &Vec<T>) -> Vec<u8>
where
    Vec<T>: ShaderType + WriteInto,
{
    let mut bytes = StorageBuffer::new(Vec::new());
    // A list in memory always fits into memory.
    if bytes.write(list).is_err() {
        return Vec::new();
    }
    bytes.into_inner()
}

/// Makes a shader module of texts that belong together.
pub(crate) fn module(gpu: &Gpu, label: &str, texts: &[&str]) -> wgpu::ShaderModule {
    gpu.device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some(label),
        source: wgpu::ShaderSource::Wgsl(texts.concat().into()),
    })
}

/// Binds resources, each at its number.
pub(crate) fn bind(
    gpu: &Gpu,
    layout: &wgpu::BindGroupLayout,
    resources: &[(u32, wgpu::BindingResource<'_>)],
) -> wgpu::BindGroup {
    let resources = resources.iter().cloned();
    let entry = |(binding, resource)| wgpu::BindGroupEntry { binding, resource };
    let entries: Vec<_> = resources.map(entry).collect();
    gpu.device.create_bind_group(&wgpu::BindGroupDescriptor { label: None, layout, entries: &entries })
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::UVec2;

    #[test]
    fn a_list_of_an_odd_number_of_jobs_has_no_job_more() {
        for jobs in [5, 65_535, 65_537] {
            let bytes = storage_bytes(&vec![UVec2::ONE; jobs]).len() as u64;
            assert_eq!(bound(bytes), 8 * jobs as u64);
        }
        assert_eq!((bound(0), bound(33)), (32, 36), "what can be bound and written");
    }

    #[test]
    fn an_outgrown_buffer_is_not_held_any_more() {
        let mut held = Held::new(&Gpu::new(None).expect("an adapter"));
        let small = held.outgrown("a list", None, 100).unwrap();
        assert_eq!((small.size(), held.bytes()), (128, 128));
        let large = held.outgrown("a list", Some(small), 200).unwrap();
        assert_eq!((large.size(), held.bytes()), (256, 256));
    }

    #[test]
    fn room_to_grow_ends_where_buffers_do() {
        assert_eq!([roomy(100, 1000), roomy(100, 120), roomy(130, 120)], [128, 120, 130]);
    }
}
