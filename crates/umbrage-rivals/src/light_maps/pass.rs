//! Reads light maps from where they are seen: draws the scene from a camera, and what each pixel shows says which texels are
//! read. What has no texels is drawn too, so that it hides what is behind it.
//!
//! Depth is reversed, and positions are relative to the eye, in f64 until they are uploaded.

use glam::{DMat3, DMat4, DVec4, Vec2};
use umbrage_render::{ComingPicture, Gpu, RenderError};
use umbrage_scene::{Aabb, Instance, Scene};
use web_time::Instant;

use super::geometry::{Draw, Geometry, Piece, Surfaces, moving};
use super::resources::{Targets, atlas, group, pipeline};
use super::unwrap::{Placed, Unwrapped};
use crate::by_light::milliseconds_since;
use crate::error::RivalError;
use crate::rival::{Seen, View};
use crate::stopwatch::Stopwatch;

/// The lights of one picture: the fourth number says what is known.
const LIGHTS_AT_ONCE: usize = 3;

/// What an instance is drawn with: the shader's `Place`, of 24 numbers.
type Place = [f32; 24];

/// The pass, with the scene and its light maps on the device.
#[derive(Debug)]
pub(super) struct Pass {
    gpu: Gpu,
    pipeline: wgpu::RenderPipeline,
    group: wgpu::BindGroup,
    places: wgpu::Buffer,
    lights: wgpu::Buffer,
    surfaces: Surfaces,
    /// The scene's instances, which draws refer to.
    instances: Vec<Instance>,
    moving: Scene,
    pages: u32,
    /// What the last picture was drawn into.
    targets: Option<Targets>,
    stopwatch: Stopwatch,
}

impl Pass {
    /// Uploads a scene and its light maps.
    ///
    /// # Errors
    /// When the device has no room for them.
    pub fn new(gpu: &Gpu, scene: &Scene, unwrapped: &Unwrapped, texels: &[u8]) -> Result<Self, RenderError> {
        gpu.allocate("the light maps", || Self::uploaded(gpu, scene, unwrapped, texels))
    }

    fn uploaded(gpu: &Gpu, scene: &Scene, unwrapped: &Unwrapped, texels: &[u8]) -> Result<Self, RenderError> {
        let surfaces = Surfaces::new(gpu, scene, unwrapped);
        let buffer = |label, size: usize, usage| {
            gpu.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(label),
                size: size as u64,
                usage: usage | wgpu::BufferUsages::COPY_DST,
                mapped_at_creation: false,
            })
        };
        // With texels and without; and what moves.
        let bytes = 2 * (surfaces.draws.len() + 1) * size_of::<Place>();
        let most = gpu.device.limits().max_storage_buffer_binding_size;
        if bytes as u64 > most {
            return Err(RenderError::TooLarge { what: "instances", bytes: bytes as u64, most });
        }
        let places = buffer("Pass::places", bytes, wgpu::BufferUsages::STORAGE);
        let lights = buffer("Pass::lights", 16, wgpu::BufferUsages::UNIFORM);
        let atlas = atlas(gpu, unwrapped, texels);
        let pipeline = pipeline(gpu);
        Ok(Self {
            group: group(gpu, &pipeline, [&places, &lights], &atlas),
            gpu: gpu.clone(),
            pipeline,
            places,
            lights,
            surfaces,
            instances: scene.instances.clone(),
            moving: moving(scene),
            pages: unwrapped.pages,
            targets: None,
            stopwatch: Stopwatch::new(gpu),
        })
    }

    /// The bytes that are held beside the atlas: where vertices and instances lie in it, and the last picture.
    pub fn bytes(&self) -> u64 {
        let places = self.surfaces.geometry.iter().map(|geometry| geometry.places.size()).sum::<u64>();
        places + self.places.size() + self.targets.as_ref().map_or(0, Targets::bytes)
    }

    /// Draws a view, and reads the light of each number; `None` for lights that were not baked.
    pub fn see(&mut self, view: &View<'_>, lights: &[Option<usize>]) -> Result<Seen, RivalError> {
        let [width, height] = view.size;
        let most = self.gpu.device.limits().max_texture_dimension_2d;
        if width == 0 || height == 0 || width > most || height > most {
            return Err(RenderError::PictureSize { width, height, most }.into());
        }
        let start = Instant::now();
        let sights = self.place(view)?;
        let targets = match self.targets.take().filter(|targets| targets.size == view.size) {
            Some(same) => same,
            None => Targets::new(&self.gpu, view.size)?,
        };
        let mut seen = Seen {
            visibility: Vec::with_capacity(lights.len()),
            milliseconds: 0.0,
            listing_milliseconds: milliseconds_since(start),
        };
        for lights in lights.chunks(LIGHTS_AT_ONCE) {
            let [listing, on_device] = self.draw(&targets, &sights, lights)?;
            seen.milliseconds += on_device;
            seen.listing_milliseconds += listing;
            let picture = picture(&self.gpu, &targets.colour)?;
            let of = |channel: usize| {
                let known = |pixel: &[u8; 4]| (pixel[3] == 255).then(|| f32::from(pixel[channel]) / 255.0);
                picture.as_chunks().0.iter().map(known).collect()
            };
            let unknown = || vec![None; picture.len() / 4];
            let all = lights.iter().enumerate();
            seen.visibility.extend(all.map(|(i, light)| if light.is_some() { of(i) } else { unknown() }));
        }
        self.targets = Some(targets);
        Ok(seen)
    }

    /// Writes where everything stands as the camera sees it; what moves comes last.
    fn place(&self, view: &View<'_>) -> Result<Sights, RenderError> {
        let [width, height] = view.size;
        let camera = umbrage_render::camera(view.camera, width as f32 / height as f32)?;
        let eye = camera.eye().as_dvec3();
        let view_from_eye = DMat3::from_mat4(camera.world_from_view().as_dmat4()).transpose();
        let clip_from_eye = camera.clip_from_view().as_dmat4() * DMat4::from_mat3(view_from_eye);
        let clip_from_world = clip_from_eye * DMat4::from_translation(-eye);
        let of_draw =
            |draw: &Draw| clip_from_world * self.instances[draw.instance].world_from_mesh.as_dmat4();
        let clip_from_mesh: Vec<DMat4> =
            self.surfaces.draws.iter().map(of_draw).chain([clip_from_eye]).collect();
        let placed = self.surfaces.draws.iter().map(|draw| draw.placed.as_ref()).chain([None]);
        let places: Vec<Place> = clip_from_mesh
            .iter()
            .zip(placed)
            .flat_map(|(clip_from_mesh, placed)| [placed, None].map(|placed| place(clip_from_mesh, placed)))
            .collect();
        self.gpu.queue.write_buffer(&self.places, 0, bytemuck::cast_slice(&places));
        let moves = !self.moving.instances.is_empty();
        let moving = moves.then(|| Geometry::moving(&self.gpu, &self.moving, view.pose, eye)).transpose()?;
        Ok(Sights { clip_from_mesh, moving })
    }

    /// Draws some lights at once, and waits for it: the milliseconds until that was handed over, and those that it took.
    fn draw(
        &mut self,
        targets: &Targets,
        sights: &Sights,
        lights: &[Option<usize>],
    ) -> Result<[f64; 2], RenderError> {
        let start = Instant::now();
        let layer = |i: usize| match lights.get(i).copied().flatten() {
            Some(light) => (light * self.pages as usize) as f32,
            None => -1.0,
        };
        let layers = [layer(0), layer(1), layer(2), -1.0];
        self.gpu.queue.write_buffer(&self.lights, 0, bytemuck::cast_slice(&layers));
        let view = |texture: &wgpu::Texture| texture.create_view(&wgpu::TextureViewDescriptor::default());
        let label = wgpu::CommandEncoderDescriptor { label: Some("Pass::encoder") };
        let mut encoder = self.gpu.device.create_command_encoder(&label);
        let views = [&view(&targets.colour), &view(&targets.depth)];
        let mut pass = begin(&mut encoder, views, self.stopwatch.times_drawing());
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &self.group, &[]);
        let still = self.surfaces.draws.iter().map(|draw| &self.surfaces.geometry[draw.geometry]);
        let all = still.chain(&sights.moving).zip(&sights.clip_from_mesh);
        for (number, (geometry, clip_from_mesh)) in (0..).step_by(2).zip(all) {
            pass.set_vertex_buffer(0, geometry.positions.slice(..));
            pass.set_vertex_buffer(1, geometry.places.slice(..));
            pass.set_index_buffer(geometry.indices.slice(..), wgpu::IndexFormat::Uint32);
            for Piece { indices, bounds, has_texels } in &geometry.pieces {
                if bounds.is_none_or(|bounds| may_be_seen(clip_from_mesh, bounds)) {
                    let place = number + u32::from(!has_texels);
                    pass.draw_indexed(indices.clone(), 0, place..place + 1);
                }
            }
        }
        drop(pass);
        let times = self.stopwatch.resolve(&self.gpu, &mut encoder);
        self.gpu.queue.submit([encoder.finish()]);
        let listing = milliseconds_since(start);
        if let Some(times) = times {
            return Ok([listing, Stopwatch::read(&self.gpu, times)?]);
        }
        self.gpu.wait()?;
        Ok([listing, milliseconds_since(start) - listing])
    }
}

/// How everything is seen from a camera.
struct Sights {
    /// The transform of each draw, and of what moves.
    clip_from_mesh: Vec<DMat4>,
    /// What moves, relative to the eye.
    moving: Option<Geometry>,
}

fn place(clip_from_mesh: &DMat4, placed: Option<&Placed>) -> Place {
    let mut place = [0.0; 24];
    place[..16].copy_from_slice(&clip_from_mesh.as_mat4().to_cols_array());
    let (min, size) = placed.map_or((Vec2::ZERO, Vec2::ZERO), |placed| (placed.min, placed.size));
    place[16..20].copy_from_slice(&[min.x, min.y, size.x, size.y]);
    place[20] = placed.map_or(-1.0, |placed| placed.page as f32);
    place
}

/// Whether a box is not all on the wrong side of one of the planes of what is seen.
fn may_be_seen(clip_from_mesh: &DMat4, Aabb { min, max }: Aabb) -> bool {
    let corners = [0, 1, 2, 3, 4, 5, 6, 7].map(|i| {
        let pick = |axis: usize| f64::from(if i >> axis & 1 == 0 { min[axis] } else { max[axis] });
        *clip_from_mesh * DVec4::new(pick(0), pick(1), pick(2), 1.0)
    });
    let are_all = |is_out: fn(&DVec4) -> bool| corners.iter().all(is_out);
    !(are_all(|c| c.x < -c.w)
        || are_all(|c| c.x > c.w)
        || are_all(|c| c.y < -c.w)
        || are_all(|c| c.y > c.w)
        || are_all(|c| c.z < 0.0)
        || are_all(|c| c.z > c.w))
}

/// Begins the pass: the sky is lit and known, and far.
fn begin<'e>(
    encoder: &'e mut wgpu::CommandEncoder,
    [colour, depth]: [&wgpu::TextureView; 2],
    timestamp_writes: Option<wgpu::RenderPassTimestampWrites<'_>>,
) -> wgpu::RenderPass<'e> {
    encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        label: Some("Pass::pass"),
        color_attachments: &[Some(wgpu::RenderPassColorAttachment {
            view: colour,
            depth_slice: None,
            resolve_target: None,
            ops: wgpu::Operations {
                load: wgpu::LoadOp::Clear(wgpu::Color::WHITE),
                store: wgpu::StoreOp::Store,
            },
        })],
        depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
            view: depth,
            depth_ops: Some(wgpu::Operations {
                load: wgpu::LoadOp::Clear(0.0),
                store: wgpu::StoreOp::Discard,
            }),
            stencil_ops: None,
        }),
        timestamp_writes,
        occlusion_query_set: None,
        multiview_mask: None,
    })
}

/// The bytes of a picture.
fn picture(gpu: &Gpu, texture: &wgpu::Texture) -> Result<Vec<u8>, RenderError> {
    let coming = gpu.allocate("a copy of the picture", || ComingPicture::of_texture(gpu, texture))?;
    gpu.wait()?;
    let picture =
        coming.take().unwrap_or_else(|| Err(RenderError::Device("the picture did not come".to_owned())));
    Ok(picture?.rgba)
}
