//! The casters of a scene on the device, and their draws onto the planes of a view.

use glam::{DMat4, DVec3, DVec4, UVec4, Vec3};
use umbrage_render::Gpu;
use umbrage_scene::{Aabb, Instance, Pose};

use super::record::Flat;
use crate::buffers::{Held, bind, module, storage_bytes};
use crate::casters::Casters;
use crate::error::RivalError;
use crate::eye::Eye;
use crate::floors::{Floor, Marks, VISIBILITY};
use crate::shell::Shell;
use crate::shining::Shining;
use crate::shot::{RECEIVERS, SHOT};

/// A way to draw what is flat.
#[derive(Debug)]
pub(crate) struct Way {
    pipeline: wgpu::RenderPipeline,
    /// The vertices that a caster takes.
    vertices: fn(&Shell) -> usize,
    /// The bindings that its shaders read.
    reads: &'static [u32],
}

/// What is flattened.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Thing {
    /// The meshes of casters, in their own space.
    Meshes,
    /// The boxes of casters, in a space where each is from −1 to 1.
    Boxes,
}

/// What all ways draw from.
#[derive(Debug)]
pub(crate) struct Draws {
    instances: Vec<(Instance, usize)>,
    shells: Vec<Shell>,
    thing: Thing,
    /// Where each shell begins in the buffers.
    firsts: Vec<Flat>,
    mesh: [wgpu::Buffer; 3],
    flats: Option<wgpu::Buffer>,
    /// The shell of each flat caster of the next picture.
    listed: Vec<usize>,
}

const FLAT: &str = include_str!("../../shaders/flat.wgsl");
const MESH: &str = include_str!("../../shaders/mesh.wgsl");
const EDGES: &str = "@group(0) @binding(8) var<storage, read> edges: array<vec4u>;\n";

impl Way {
    /// Makes the pipeline of a shader that has a vertex stage `flatten` and a fragment stage `shadow`. Of several answers at a
    /// pixel the darkest counts. `constants` are its overrides.
    pub fn new(
        gpu: &Gpu,
        text: &str,
        constants: &[(&str, f64)],
        vertices: fn(&Shell) -> usize,
        reads: &'static [u32],
    ) -> Self {
        let shader = module(gpu, "Way::shader", &[SHOT, RECEIVERS, FLAT, MESH, EDGES, text]);
        let darkest = wgpu::BlendComponent {
            src_factor: wgpu::BlendFactor::One,
            dst_factor: wgpu::BlendFactor::One,
            operation: wgpu::BlendOperation::Min,
        };
        let target = wgpu::ColorTargetState {
            format: VISIBILITY,
            blend: Some(wgpu::BlendState { color: darkest, alpha: darkest }),
            write_mask: wgpu::ColorWrites::ALL,
        };
        let pipeline = gpu.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some("Way::pipeline"),
            layout: None,
            vertex: wgpu::VertexState {
                module: &shader,
                entry_point: Some("flatten"),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                buffers: &[],
            },
            primitive: wgpu::PrimitiveState::default(),
            depth_stencil: None,
            multisample: wgpu::MultisampleState::default(),
            fragment: Some(wgpu::FragmentState {
                module: &shader,
                entry_point: Some("shadow"),
                compilation_options: wgpu::PipelineCompilationOptions { constants, ..Default::default() },
                targets: &[Some(target)],
            }),
            multiview_mask: None,
            cache: None,
        });
        Self { pipeline, vertices, reads }
    }
}

impl Thing {
    /// The space that a mesh's thing is in, and the box around it there.
    fn of(self, shell: &Shell) -> (DMat4, Aabb) {
        let origin = DVec3::from(shell.origin.map(f64::from));
        match self {
            Self::Meshes => (DMat4::from_translation(origin), shell.bounds),
            Self::Boxes => {
                let [least, most] = [shell.bounds.min, shell.bounds.max].map(|corner| corner.as_dvec3());
                let unit = Aabb { min: Vec3::NEG_ONE, max: Vec3::ONE };
                // Something flat has no inverse; it is given a little thickness.
                let half = (0.5 * (most - least)).max(DVec3::splat(FLATTEST * least.distance(most)));
                let centre = origin + 0.5 * (least + most);
                (DMat4::from_translation(centre) * DMat4::from_scale(half), unit)
            }
        }
    }
}

/// Whether an ellipsoid may stand for what is in a box from −1 to 1: not for a room that holds the lamp, nor for what lies on a
/// plane and is much wider than high.
fn stands_out(eye_from_box: DMat4, light: DVec4, plane: DVec4) -> bool {
    let holds_lamp = light.w > 0.0 && (eye_from_box.inverse() * light).truncate().abs().max_element() <= 1.0;
    let half = [eye_from_box.x_axis, eye_from_box.y_axis, eye_from_box.z_axis];
    let highest = plane.dot(eye_from_box.w_axis) + half.map(|axis| plane.dot(axis).abs()).iter().sum::<f64>();
    let diagonal = 2.0 * half.map(DVec4::length_squared).iter().sum::<f64>().sqrt();
    !holds_lamp && highest >= LEAST_HEIGHT * diagonal
}

/// The least height above a plane of what has a blob on it, as a share of its diagonal.
const LEAST_HEIGHT: f64 = 0.125;

/// The least thickness of a box, as a share of its diagonal.
const FLATTEST: f64 = 1e-4;

impl Draws {
    pub fn new(held: &mut Held, casters: Casters, thing: Thing) -> Result<Self, RivalError> {
        let (mut positions, mut triangles, mut edges) = (Vec::new(), Vec::new(), Vec::new());
        let mut firsts = Vec::new();
        for shell in &casters.shells {
            firsts.push(Flat {
                first_vertex: (positions.len() / 3) as u32,
                first_triangle: (triangles.len() / 3) as u32,
                first_edge: edges.len() as u32,
                ..Flat::default()
            });
            positions.extend(shell.positions.iter().flatten().copied());
            triangles.extend(shell.triangles.iter().flatten().copied());
            edges.extend(shell.edges.iter().copied().map(UVec4::from));
        }
        let mesh = [
            held.filled::<f32>("vertices of flat casters", &positions)?,
            held.filled::<u32>("triangles of flat casters", &triangles)?,
            held.filled("edges of flat casters", &edges)?,
        ];
        let Casters { shells, served, left: _ } = casters;
        Ok(Self { instances: served, shells, thing, firsts, mesh, flats: None, listed: Vec::new() })
    }

    /// Lists what is before each plane in the next picture.
    pub fn list(
        &mut self,
        gpu: &Gpu,
        held: &mut Held,
        (eye, light, pose): (&Eye, &Shining, &Pose),
        floors: &[Floor],
    ) -> Result<(), RivalError> {
        let mut flats: Vec<Flat> = Vec::new();
        self.listed.clear();
        for (instance, number) in self.instances.iter().filter(|(of, _)| of.is_visible_in(pose)) {
            let shell = &self.shells[*number];
            let (mesh_from_thing, bounds) = self.thing.of(shell);
            let world_from_thing = instance.world_from_mesh_in(pose).as_dmat4() * mesh_from_thing;
            let eye_from_thing = DMat4::from_translation(-eye.place) * world_from_thing;
            let is_blob = |floor: &&Floor| match self.thing {
                Thing::Meshes => true,
                Thing::Boxes => stands_out(eye_from_thing, light.from(eye.place), floor.plane),
            };
            let floors = floors.iter().filter(is_blob);
            let on = |floor| self.firsts[*number].of(eye_from_thing, bounds, eye, light, floor);
            flats.extend(floors.filter_map(on));
            self.listed.resize(flats.len(), *number);
        }
        let bytes = storage_bytes(&flats);
        if self.flats.as_ref().is_none_or(|buffer| buffer.size() < bytes.len() as u64) {
            self.flats = Some(held.outgrown("flat casters", self.flats.take(), bytes.len() as u64)?);
        }
        if let Some(buffer) = self.flats.as_ref().filter(|_| !flats.is_empty()) {
            gpu.queue.write_buffer(buffer, 0, &bytes);
        }
        Ok(())
    }

    /// Draws all of them in one way.
    pub fn draw(
        &self,
        gpu: &Gpu,
        pass: &mut wgpu::RenderPass<'_>,
        way: &Way,
        (shot, seen, marks): (&wgpu::Buffer, &wgpu::TextureView, &Marks),
    ) {
        let Some(flats) = &self.flats else { return };
        let [positions, triangles, edges] = &self.mesh;
        let texture = wgpu::BindingResource::TextureView;
        let bound = [
            (0, shot.as_entire_binding()),
            (1, texture(seen)),
            (3, flats.as_entire_binding()),
            (4, texture(&marks.numbers.view)),
            (6, positions.as_entire_binding()),
            (7, triangles.as_entire_binding()),
            (8, edges.as_entire_binding()),
        ];
        let bound: Vec<_> = bound.into_iter().filter(|(number, _)| way.reads.contains(number)).collect();
        pass.set_pipeline(&way.pipeline);
        pass.set_bind_group(0, &bind(gpu, &way.pipeline.get_bind_group_layout(0), &bound), &[]);
        for (which, shell) in (0..).zip(&self.listed) {
            pass.draw(0..(way.vertices)(&self.shells[*shell]) as u32, which..which + 1);
        }
    }
}
