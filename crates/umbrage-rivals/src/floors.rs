//! The planes of a view, and the pixels that lie on each: what families share that draw shadows by projection onto planes.
//!
//! A pixel belongs to a plane by where it is, not by what it is of: whatever lies in the plane has the same shadows there. A plane
//! that the eye and the light see from different sides has none: what is seen of it is turned away from the light.

use encase::{ShaderType, UniformBuffer};
use glam::{DVec3, DVec4, Vec3, Vec4};
use umbrage_render::{Gpu, RenderError};

use crate::buffers::{bind, module};
use crate::eye::Eye;
use crate::picture::{Picture, over_all};
use crate::planes::{MOST_PLANES, Plane};
use crate::shining::Shining;
use crate::shot::{self, RECEIVERS, SHOT, WHOLE_PICTURE};

/// A plane of a view by a light, relative to the eye.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Floor {
    /// Its number, from 1.
    pub number: u32,
    /// The unit normal, toward the light, and the distance of the eye along it: times a place it is the height.
    pub plane: DVec4,
    /// The most that a surface lies off the plane, metres.
    pub slack: f64,
    /// How high the light is above the plane, metres; infinite for a sun.
    pub light_height: f64,
    corners: [DVec3; 2],
}

/// A floor as shaders know it.
#[derive(Clone, Copy, Debug, Default, ShaderType)]
struct Marked {
    plane: Vec4,
    least: Vec3,
    slack: f32,
    most: Vec3,
    is_there: u32,
}

impl Floor {
    /// The planes that the eye and the light see from the same side.
    pub fn of(planes: &[Plane], eye: &Eye, light: &Shining) -> Vec<Self> {
        let light = light.from(eye.place);
        let floor = |(number, plane): (u32, &Plane)| {
            let relative = plane.normal.extend(plane.normal.dot(eye.place) - plane.offset);
            let side = relative.dot(light);
            let toward_light = relative * side.signum();
            let sees = side != 0.0 && (eye.is_parallel || toward_light.w > 0.0);
            sees.then(|| Self {
                number,
                plane: toward_light,
                slack: plane.slack,
                light_height: if light.w == 0.0 { f64::INFINITY } else { side.abs() },
                corners: plane.corners.map(|corner| corner - eye.place),
            })
        };
        (1..).zip(planes).filter_map(floor).collect()
    }
}

/// Marks pixels by their planes, and holds what is drawn onto them.
#[derive(Debug)]
pub(crate) struct Marker {
    /// What shaders know of the picture.
    pub shot: wgpu::Buffer,
    floors: wgpu::Buffer,
    pipeline: wgpu::RenderPipeline,
}

/// The textures of a picture.
#[derive(Debug)]
pub(crate) struct Marks {
    pub size: [u32; 2],
    /// The number of each pixel's plane.
    pub numbers: Picture,
    visibility: Picture,
}

/// The mark of what nothing can shadow: see `floors.wgsl`.
const LIT: u8 = 255;

const NUMBERS: wgpu::TextureFormat = wgpu::TextureFormat::R8Uint;
pub(crate) const VISIBILITY: wgpu::TextureFormat = wgpu::TextureFormat::R8Unorm;

impl Marker {
    pub fn new(gpu: &Gpu) -> Self {
        let floors = include_str!("../shaders/floors.wgsl");
        let shader = module(gpu, "Marker::floors", &[SHOT, WHOLE_PICTURE, RECEIVERS, floors]);
        let floors = gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("Marker::floors"),
            size: <[Marked; MOST_PLANES]>::min_size().get(),
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let pipeline = over_all(gpu, &shader, "mark", None, &[Some(NUMBERS.into())]);
        Self { shot: shot::buffer(gpu), floors, pipeline }
    }

    /// Makes the textures of a picture.
    pub fn marks(&self, gpu: &Gpu, size: [u32; 2]) -> Result<Marks, RenderError> {
        gpu.allocate("the picture", || {
            let numbers = Picture::new(gpu, "Marks::numbers", size, NUMBERS);
            let visibility = Picture::new(gpu, "Marks::visibility", size, VISIBILITY);
            Ok::<_, RenderError>(Marks { size, numbers, visibility })
        })
    }

    /// Says which planes there are in the next picture.
    pub fn upload(&self, gpu: &Gpu, floors: &[Floor]) {
        let mut marked = [Marked::default(); MOST_PLANES];
        for floor in floors {
            let [least, most] = floor.corners.map(|corner| corner.as_vec3());
            let (plane, slack) = (floor.plane.as_vec4(), floor.slack as f32);
            marked[floor.number as usize - 1] = Marked { plane, least, slack, most, is_there: 1 };
        }
        let mut bytes = UniformBuffer::new(Vec::new());
        // What is in memory fits into memory.
        if bytes.write(&marked).is_ok() {
            gpu.queue.write_buffer(&self.floors, 0, &bytes.into_inner());
        }
    }

    /// Marks every pixel with the number of its plane.
    pub fn mark(
        &self,
        gpu: &Gpu,
        encoder: &mut wgpu::CommandEncoder,
        marks: &Marks,
        seen: &wgpu::TextureView,
        timestamp_writes: Option<wgpu::RenderPassTimestampWrites<'_>>,
    ) {
        let resources = [
            (0, self.shot.as_entire_binding()),
            (1, wgpu::BindingResource::TextureView(seen)),
            (2, self.floors.as_entire_binding()),
        ];
        let group = bind(gpu, &self.pipeline.get_bind_group_layout(0), &resources);
        let mut pass = begin(encoder, &marks.numbers, wgpu::Color::TRANSPARENT, timestamp_writes);
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &group, &[]);
        pass.draw(0..3, 0..1);
    }
}

impl Marks {
    /// The bytes that the textures hold, with the depth of what is seen, which is of the same size.
    pub fn bytes(&self) -> u64 {
        let a_pixel = 4 + 1 + 1;
        u64::from(self.size[0]) * u64::from(self.size[1]) * a_pixel
    }

    /// Begins a pass over visibility, all of which is lit.
    pub fn draw<'e>(
        &self,
        encoder: &'e mut wgpu::CommandEncoder,
        timestamp_writes: Option<wgpu::RenderPassTimestampWrites<'_>>,
    ) -> wgpu::RenderPass<'e> {
        begin(encoder, &self.visibility, wgpu::Color::WHITE, timestamp_writes)
    }

    /// Copies of what was drawn, for [`Self::read`].
    pub fn copy(
        &self,
        gpu: &Gpu,
        encoder: &mut wgpu::CommandEncoder,
    ) -> Result<[wgpu::Buffer; 2], RenderError> {
        Ok([self.numbers.copy(gpu, encoder)?, self.visibility.copy(gpu, encoder)?])
    }

    /// The visibility of every pixel that lies on a plane, or shows the sky, waited for.
    pub fn read(
        &self,
        gpu: &Gpu,
        [numbers, visibility]: [wgpu::Buffer; 2],
    ) -> Result<Vec<Option<f32>>, RenderError> {
        let numbers = self.numbers.read(gpu, numbers)?;
        let visibility = self.visibility.read(gpu, visibility)?;
        let known = |(number, visibility): (u8, u8)| match number {
            0 => None,
            LIT => Some(1.0),
            _ => Some(f32::from(visibility) / 255.0),
        };
        Ok(numbers.into_iter().zip(visibility).map(known).collect())
    }
}

/// Begins a pass over a picture that is of one colour.
fn begin<'e>(
    encoder: &'e mut wgpu::CommandEncoder,
    picture: &Picture,
    colour: wgpu::Color,
    timestamp_writes: Option<wgpu::RenderPassTimestampWrites<'_>>,
) -> wgpu::RenderPass<'e> {
    encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        label: Some("floors"),
        color_attachments: &[Some(wgpu::RenderPassColorAttachment {
            view: &picture.view,
            depth_slice: None,
            resolve_target: None,
            ops: wgpu::Operations { load: wgpu::LoadOp::Clear(colour), store: wgpu::StoreOp::Store },
        })],
        timestamp_writes,
        ..Default::default()
    })
}
