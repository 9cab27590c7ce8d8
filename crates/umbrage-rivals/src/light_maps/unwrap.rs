//! Which texels of an atlas each surface has: every mesh that stands still is unwrapped, and every instance of it gets a
//! rectangle of texels of its own, all of one density in world space.
//!
//! Instances share an unwrapping where they are scaled alike in all directions, and no more than twice as much as each other,
//! since the gutters between charts grow with them. What casts no shadow that a surface would show, being lit by nothing
//! (`unlit`) or seen through, has no texels.

use std::collections::BTreeMap;

use glam::{Mat3, Vec2};
use umbrage_scene::{Instance, Mesh, Part, Scene};
use uvunwrap::{Atlas, Density, MeshInput, Options, OutputMesh};

use super::{BakeProgress, BakeStep, Tell};
use crate::error::RivalError;

/// The empty texels around each chart: bilinear reading reaches one, and one is left.
pub(super) const GUTTER_TEXELS: u32 = 2;

/// The shortest side of a page: there is a texel within its gutters.
pub(super) const LEAST_SIDE: u32 = 2 * GUTTER_TEXELS + 1;

/// Where the surfaces of a scene lie in the pages of an atlas.
#[derive(Debug)]
pub(super) struct Unwrapped {
    /// The width and height of a page, in texels.
    pub size: [u32; 2],
    pub pages: u32,
    pub texels_per_metre: f32,
    pub charts: u32,
    pub shapes: Vec<Shape>,
}

/// A shape is a mesh's unwrapping, for some of its instances.
#[derive(Debug)]
pub(super) struct Shape {
    /// The index of the mesh in the scene.
    pub mesh: usize,
    /// The mesh's vertex that each vertex is, and where it lies within a rectangle, in 65535ths.
    pub vertices: Vec<(u32, [u16; 2])>,
    /// The corners of the mesh's triangles, in their order, as indices of `vertices`.
    pub indices: Vec<u32>,
    pub placed: Vec<Placed>,
}

/// Where one instance of a shape has its rectangle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Placed {
    /// The index of the instance in the scene.
    pub instance: usize,
    pub page: u32,
    /// The corner with the smallest coordinates, and the size, as shares of a page.
    pub min: Vec2,
    pub size: Vec2,
}

impl Shape {
    /// Where a triangle's corners lie in an instance's page, as shares of it.
    pub fn corners(&self, placed: &Placed, triangle: usize) -> [Vec2; 3] {
        [0, 1, 2].map(|corner| {
            let (_, uv) = self.vertices[self.indices[3 * triangle + corner] as usize];
            placed.min + placed.size * Vec2::from(uv.map(|share| f32::from(share) / f32::from(u16::MAX)))
        })
    }
}

/// Lays out a scene in pages of `side` texels a side, as fine as they allow: one page, if that is possible at all.
pub(super) fn unwrap(scene: &Scene, side: u32, tell: &Tell<'_>) -> Result<Unwrapped, RivalError> {
    let sources = sources(scene);
    if sources.is_empty() {
        let empty =
            Unwrapped { size: [1, 1], pages: 1, texels_per_metre: 0.0, charts: 0, shapes: Vec::new() };
        return Ok(empty);
    }
    let meshes: Vec<MeshInput<'_>> = sources.iter().map(|source| source.input(scene)).collect();
    let density = Density::Auto { page_size: side };
    let options = Options { density, padding: GUTTER_TEXELS, ..Options::default() };
    let told = |progress: uvunwrap::Progress| {
        tell(BakeProgress { step: BakeStep::Unwrap, done: progress.done, total: progress.total, rays: 0 })
    };
    let atlas = uvunwrap::generate_with_progress(&meshes, &options, told).map_err(|error| match error {
        uvunwrap::Error::Cancelled => RivalError::Cancelled,
        other => RivalError::Unwrap(other),
    })?;
    let Atlas { width, height, page_count, texels_per_unit, chart_count, meshes, .. } = atlas;
    Ok(Unwrapped {
        size: [width, height],
        pages: page_count,
        texels_per_metre: texels_per_unit,
        charts: chart_count,
        shapes: sources.iter().zip(meshes).map(|(source, mesh)| source.shape(mesh)).collect(),
    })
}

/// Whether a part of a mesh has texels: where it is solid, and light changes how it looks.
pub(super) fn receives(scene: &Scene, part: &Part) -> bool {
    scene.materials.get(part.material).is_none_or(|material| material.is_solid() && !material.unlit)
}

/// The same of each triangle of a mesh. What has a corner nowhere has no texels.
pub(super) fn has_texels<'a>(scene: &'a Scene, mesh: &'a Mesh) -> impl Iterator<Item = bool> + 'a {
    let is_somewhere = |corner: &u32| mesh.positions[*corner as usize].is_finite();
    mesh.parts.iter().flat_map(move |part| {
        let receives = receives(scene, part);
        let indices = &mesh.indices[part.indices.start as usize..part.indices.end as usize];
        indices.as_chunks::<3>().0.iter().map(move |triangle| receives && triangle.iter().all(is_somewhere))
    })
}

/// What is unwrapped once: a mesh as it is scaled in the world.
struct Source {
    mesh: usize,
    instances: Vec<usize>,
    /// The scale of each instance, as a multiple of the first one's.
    scales: Vec<f32>,
    positions: Vec<[f32; 3]>,
    ignored: Vec<bool>,
}

impl Source {
    fn input<'a>(&'a self, scene: &'a Scene) -> MeshInput<'a> {
        MeshInput {
            ignored_faces: Some(&self.ignored),
            instance_scales: &self.scales,
            ..MeshInput::new(&self.positions, &scene.meshes[self.mesh].indices)
        }
    }

    fn shape(&self, mesh: OutputMesh) -> Shape {
        let share = |uv: f32| (uv.clamp(0.0, 1.0) * f32::from(u16::MAX)).round() as u16;
        let placed = self.instances.iter().zip(&mesh.instances).map(|(instance, rectangle)| {
            let (min, max) = (Vec2::from(rectangle.min), Vec2::from(rectangle.max));
            Placed { instance: *instance, page: rectangle.page, min, size: max - min }
        });
        Shape {
            mesh: self.mesh,
            placed: placed.collect(),
            vertices: mesh.vertices.iter().map(|vertex| (vertex.xref, vertex.uv.map(share))).collect(),
            indices: mesh.indices,
        }
    }
}

/// Instances with one of these in common share an unwrapping.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
struct Likeness {
    mesh: usize,
    /// How the mesh is stretched, in 256ths of its mean scale: the products of the axes of its space with each other.
    stretch: [i32; 6],
    octave: i32,
}

fn sources(scene: &Scene) -> Vec<Source> {
    let mut alike: BTreeMap<Likeness, Vec<(usize, f32)>> = BTreeMap::new();
    for (i, instance) in scene.instances.iter().enumerate().filter(|(_, instance)| !instance.is_dynamic()) {
        if let Some((likeness, scale)) = likeness(instance) {
            alike.entry(likeness).or_default().push((i, scale));
        }
    }
    let sources = alike.into_iter().filter_map(|(Likeness { mesh, .. }, instances)| {
        let shape = &scene.meshes[mesh];
        let ignored: Vec<bool> = has_texels(scene, shape).map(|has| !has).collect();
        let (first, scale) = *instances.first().filter(|_| ignored.contains(&false))?;
        let linear = Mat3::from_mat4(scene.instances[first].world_from_mesh);
        Some(Source {
            mesh,
            scales: instances.iter().map(|(_, other)| other / scale).collect(),
            instances: instances.iter().map(|(i, _)| *i).collect(),
            positions: positions(shape, linear),
            ignored,
        })
    });
    sources.collect()
}

/// A mesh's vertices as they are scaled in the world. Those that are nowhere lie with another: no triangle that has texels has them,
/// and what unwraps wants numbers.
fn positions(mesh: &Mesh, linear: Mat3) -> Vec<[f32; 3]> {
    let scaled = || mesh.positions.iter().map(|position| linear * *position);
    let other = scaled().find(|position| position.is_finite()).unwrap_or_default();
    scaled().map(|position| if position.is_finite() { position } else { other }.to_array()).collect()
}

/// How an instance is scaled; `None` where it has no inside or no end.
fn likeness(instance: &Instance) -> Option<(Likeness, f32)> {
    let linear = Mat3::from_mat4(instance.world_from_mesh);
    let scale = linear.determinant().abs().cbrt();
    if !(scale > 0.0 && scale.is_finite()) {
        return None;
    }
    let [x, y, z] = [linear.x_axis, linear.y_axis, linear.z_axis].map(|axis| axis / scale);
    let products = [x.dot(x), y.dot(y), z.dot(z), x.dot(y), y.dot(z), z.dot(x)];
    let stretch = products.map(|product| (product * 256.0).round() as i32);
    Some((Likeness { mesh: instance.mesh, stretch, octave: scale.log2().floor() as i32 }, scale))
}
