//! What contact shadows read: the depth that the camera sees, one sample a pixel. Where the target itself has one sample, it is
//! the target's.

use umbrage::{Camera, ContactShadows};

use crate::gpu::Gpu;
use crate::target::{DEPTH_FORMAT, Target};

/// Groups that were made for depths of before stay, as many as there are pictures in flight.
const MOST_GROUPS: usize = 4;

/// Depths, as shaders bind them that march through one.
#[derive(Debug)]
pub(crate) struct ContactDepth {
    contact: ContactShadows,
    /// The depth of one sample a pixel beside targets that have several, with its size.
    beside: Option<([u32; 2], wgpu::TextureView)>,
    groups: Vec<(wgpu::TextureView, wgpu::BindGroup)>,
}

impl ContactDepth {
    pub fn new(gpu: &Gpu) -> Self {
        Self { contact: ContactShadows::new(&gpu.device), beside: None, groups: Vec::new() }
    }

    /// Makes what a target needs and there is not yet. The depth to draw is [`Self::depth`].
    pub fn make_ready(&mut self, gpu: &Gpu, target: &Target) {
        let size = target.shape.size;
        if target.shape.samples > 1 && self.beside.as_ref().is_none_or(|(of, _)| *of != size) {
            self.beside = Some((size, depth(gpu, size)));
        }
        let depth = self.depth(target).clone();
        if self.groups.iter().all(|(of, _)| *of != depth) {
            if self.groups.len() == MOST_GROUPS {
                self.groups.remove(0);
            }
            let group = self.contact.bind_group(&gpu.device, &depth);
            self.groups.push((depth, group));
        }
    }

    /// The depth that is read for a target.
    pub fn depth<'a>(&'a self, target: &'a Target) -> &'a wgpu::TextureView {
        match &self.beside {
            Some((_, depth)) if target.shape.samples > 1 => depth,
            Some(_) | None => &target.depth,
        }
    }

    /// Tells the GPU from where the depth is seen.
    pub fn upload(&self, gpu: &Gpu, camera: &Camera) {
        self.contact.upload(&gpu.queue, camera);
    }

    /// The layout of [`Self::group`].
    pub fn layout(&self) -> &wgpu::BindGroupLayout {
        self.contact.bind_group_layout()
    }

    /// What shaders read that march through the depth of a target, as group 3.
    pub fn group(&self, target: &Target) -> Option<&wgpu::BindGroup> {
        let depth = self.depth(target);
        self.groups.iter().find(|(of, _)| of == depth).map(|(_, group)| group)
    }
}

fn depth(gpu: &Gpu, size: [u32; 2]) -> wgpu::TextureView {
    let texture = gpu.texture(&wgpu::TextureDescriptor {
        label: Some("ContactDepth::beside"),
        size: wgpu::Extent3d { width: size[0], height: size[1], depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: DEPTH_FORMAT,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::TEXTURE_BINDING,
        view_formats: &[],
    });
    texture.create_view(&wgpu::TextureViewDescriptor::default())
}
