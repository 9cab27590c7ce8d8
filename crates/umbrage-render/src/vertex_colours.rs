//! Colours of vertices on the GPU, beside their other attributes: few scenes have them, and only shaded pictures read them.

use umbrage_scene::{Mesh, Scene};

use crate::buffers::filled;
use crate::error::RenderError;
use crate::gpu::Gpu;
use crate::shapes::Shapes;

/// Bytes a colour: red, green, blue and alpha of 16 bits each.
const BYTES: wgpu::BufferAddress = 8;

/// The colours of all vertices, or one that is the colour of all.
#[derive(Debug)]
pub(crate) struct VertexColours {
    pub buffer: wgpu::Buffer,
    /// How the buffer is read; a stride of 0 reads the same colour again and again.
    pub stream: wgpu::VertexBufferLayout<'static>,
}

impl VertexColours {
    /// Whether a mesh of a scene has any.
    pub fn are_in(scene: &Scene) -> bool {
        scene.meshes.iter().any(|mesh| !mesh.colours.is_empty())
    }

    pub fn new(gpu: &Gpu, scene: &Scene, shapes: &Shapes) -> Result<Self, RenderError> {
        const WHITE: [u16; 4] = [u16::MAX; 4];
        let number = |number: f32| (number.clamp(0.0, 1.0) * f32::from(u16::MAX)).round() as u16;
        let are_there = Self::are_in(scene);
        let add = |colours: &mut Vec<[u16; 4]>, mesh: &Mesh| {
            let end = colours.len() + mesh.positions.len();
            colours.extend(
                mesh.colours.iter().take(mesh.positions.len()).map(|colour| colour.to_array().map(number)),
            );
            colours.resize(end, WHITE);
        };
        let mut colours = if are_there { shapes.gather(scene, WHITE, add) } else { Vec::new() };
        if colours.is_empty() {
            colours.push(WHITE);
        }
        let bytes = bytemuck::cast_slice(&colours);
        let stream = wgpu::VertexBufferLayout {
            array_stride: if are_there { BYTES } else { 0 },
            step_mode: wgpu::VertexStepMode::Vertex,
            attributes: &wgpu::vertex_attr_array![4 => Unorm16x4],
        };
        Ok(Self { buffer: filled(gpu, "vertex colours", bytes, wgpu::BufferUsages::VERTEX)?, stream })
    }
}
