//! What the shaders know of a picture: its camera, and the light whose shadows it shows.

use encase::{ShaderType, UniformBuffer};
use glam::{Vec3, Vec4};
use umbrage_render::Gpu;

use crate::eye::Eye;
use crate::shining::Shining;

/// What the shaders know of a picture, as `shot.wgsl` has it.
#[derive(Clone, Copy, Debug, ShaderType)]
pub(crate) struct Shot {
    right: Vec3,
    is_parallel: u32,
    up: Vec3,
    near: f32,
    forward: Vec3,
    far: f32,
    light: Vec4,
    axis: Vec3,
    cos_outer: f32,
    range: f32,
    corners: u32,
    /// The tangent of half the angle that a sun is seen under, or the radius of a lamp in metres; 0 of a point.
    size: f32,
}

impl Shot {
    pub fn new(eye: &Eye, light: &Shining) -> Self {
        Self {
            right: eye.right.as_vec3(),
            is_parallel: u32::from(eye.is_parallel),
            up: eye.up.as_vec3(),
            near: eye.depths[0] as f32,
            forward: eye.forward.as_vec3(),
            far: eye.depths[1] as f32,
            light: light.from(eye.place).as_vec4(),
            axis: light.axis.as_vec3(),
            cos_outer: light.cos_outer as f32,
            // Shaders know no infinity.
            range: light.range.min(f64::from(f32::MAX)) as f32,
            corners: if light.is_sun() && !eye.is_parallel { 3 } else { 6 },
            size: 0.0,
        }
    }
}

/// What all shaders begin with that know what is seen.
pub(crate) const SHOT: &str = include_str!("../shaders/shot.wgsl");
/// What knows what the camera sees.
pub(crate) const RECEIVERS: &str = include_str!("../shaders/receivers.wgsl");
/// A vertex shader that covers the picture.
pub(crate) const WHOLE_PICTURE: &str = include_str!("../shaders/whole_picture.wgsl");

/// Makes the buffer that shaders read it from.
pub(crate) fn buffer(gpu: &Gpu) -> wgpu::Buffer {
    gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("shot"),
        size: Shot::min_size().get(),
        usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    })
}

impl Shot {
    /// The same by a light of some size: the tangent of half the angle that a sun is seen under, or a radius in metres.
    pub fn with_size(self, size: f32) -> Self {
        Self { size, ..self }
    }

    /// Says what the next picture shows.
    pub fn write(&self, gpu: &Gpu, buffer: &wgpu::Buffer) {
        let mut bytes = UniformBuffer::new(Vec::new());
        // What is in memory fits into memory.
        if bytes.write(self).is_ok() {
            gpu.queue.write_buffer(buffer, 0, &bytes.into_inner());
        }
    }
}
