//! What a scene's rays go through, where settings ask for some: its meshes made ready beside the frames, and where its instances
//! stand.

use std::collections::HashSet;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use glam::DVec3;
use umbrage::casters::{
    AlphaMode, AlphaPicture, Cover, Geometry, Mesh, MeshRange, Part, Placed, Shape, TopLevel,
};
use umbrage::{BentMesh, OccluderRoom, Occluders};
use umbrage_scene::{Alpha, DeformedBounds, Instance, Material, Pose, Scene};

use crate::cover::{Cover as How, Covers};
use crate::error::RenderError;
use crate::gpu::Gpu;
use crate::palette::Palette;
use crate::shapes::Shapes;

/// The casters of a scene, made ready for rays. Making them takes about a second a million triangles, and needs no device.
#[derive(Debug)]
pub struct RayCasters {
    geometry: Geometry,
    known: Known,
}

/// What rays know of the instances of a scene.
#[derive(Clone, Debug)]
struct Known {
    /// Of each instance, what rays know of it.
    kinds: Vec<Kind>,
    shapes: Shapes,
    /// Of each shape, its mesh among those that rays go through; `None` where nothing of it casts.
    of_shapes: Vec<Option<BentCaster>>,
    /// Whether a pose may move some instances.
    moves: bool,
}

/// What rays know of an instance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// It casts nothing.
    Nothing,
    /// It is as its mesh is.
    Rigid,
    /// It has this shape.
    Bent(usize),
}

/// A shape that casts.
#[derive(Clone, Debug)]
struct BentCaster {
    /// The index of its mesh in the geometry.
    mesh: usize,
    bounds: Arc<DeformedBounds>,
}

impl RayCasters {
    /// Makes the casters of a scene ready.
    pub fn of(scene: &Scene) -> Self {
        let shapes = Shapes::of(scene);
        let (pictures, picture_of) = pictures(scene);
        let alphas: Vec<Vec<f32>> =
            scene.meshes.iter().map(|mesh| mesh.colours.iter().map(|colour| colour.w).collect()).collect();
        let mut covers = Covers::new(scene);
        let mut meshes: Vec<Mesh<'_>> = scene
            .meshes
            .iter()
            .zip(&alphas)
            .map(|(mesh, alphas)| {
                let casts = |part: &&umbrage_scene::Part| {
                    scene.materials.get(part.material).is_none_or(|material| material.casts)
                };
                let parts = mesh.parts.iter().filter(casts).map(|part| {
                    let material = scene.materials.get(part.material);
                    let material = material.filter(|_| covers.of(mesh, part) != How::Solid);
                    Part {
                        indices: &mesh.indices[part.indices.start as usize..part.indices.end as usize],
                        cover: material.map(|material| cover(material, &mesh.uvs, alphas, &picture_of)),
                    }
                });
                Mesh { positions: &mesh.positions, parts: parts.collect(), bends: false }
            })
            .collect();
        shapes.all.iter().for_each(|shape| meshes[shape.mesh].bends = true);
        let mut geometry = Geometry::build(&meshes, &pictures);
        let of_scene = geometry.meshes.clone();
        let known = Known::of(scene, shapes, &of_scene, |mesh| geometry.copy(mesh));
        Self { geometry, known }
    }

    /// Writes what takes long to make as bytes, for [`Self::from_bytes`] of the same program: a web page's worker shares no memory
    /// with it.
    pub fn to_bytes(&self) -> Vec<u8> {
        self.geometry.to_bytes()
    }

    /// Reads what [`Self::to_bytes`] made of the casters of a scene; `None` for any other bytes, and for those of a scene of other
    /// meshes.
    pub fn from_bytes(scene: &Scene, bytes: &[u8]) -> Option<Self> {
        let geometry = Geometry::from_bytes(bytes)?;
        let mut copies = scene.meshes.len()..geometry.meshes.len();
        let of_scene = geometry.meshes.get(..scene.meshes.len())?;
        let known = Known::of(scene, Shapes::of(scene), of_scene, |_| copies.next());
        copies.is_empty().then_some(Self { geometry, known })
    }

    /// Returns the number of triangles, those of each mesh once.
    pub fn triangles(&self) -> usize {
        self.geometry.triangles()
    }

    /// Returns the bytes that meshes take on a device, without their instances.
    pub fn bytes(&self) -> usize {
        self.geometry.bytes()
    }

    /// Returns the number of triangles that were left out, as they have no area or corners that are nowhere.
    pub fn left_out(&self) -> usize {
        self.geometry.left_out
    }
}

impl Known {
    /// What rays know of a scene whose meshes lie so, with a mesh for each shape that casts: `copy` makes one of a mesh.
    fn of(
        scene: &Scene,
        shapes: Shapes,
        meshes: &[MeshRange],
        mut copy: impl FnMut(usize) -> Option<usize>,
    ) -> Self {
        let kinds = scene.instances.iter().zip(&shapes.of_instance).map(|(instance, shape)| match shape {
            _ if !instance.casts => Kind::Nothing,
            None => Kind::Rigid,
            Some(shape) => Kind::Bent(*shape as usize),
        });
        let kinds: Vec<Kind> = kinds.collect();
        // A mesh that nobody needs at rest is the first shape's.
        let mut is_taken = vec![false; scene.meshes.len()];
        let rigid = scene.instances.iter().zip(&kinds).filter(|(_, kind)| **kind == Kind::Rigid);
        rigid.for_each(|(instance, _)| is_taken[instance.mesh] = true);
        let bent =
            kinds.iter().filter_map(|kind| if let Kind::Bent(shape) = kind { Some(*shape) } else { None });
        let casts: HashSet<usize> = bent.collect();
        let mut bounds = vec![None; scene.meshes.len()];
        let of_shapes = shapes.all.iter().enumerate().map(|(number, shape)| {
            if !casts.contains(&number) || meshes[shape.mesh].refit.is_none() {
                return None;
            }
            let is_first = !std::mem::replace(&mut is_taken[shape.mesh], true);
            let mesh = if is_first { shape.mesh } else { copy(shape.mesh)? };
            let of_mesh = || Arc::new(DeformedBounds::of(&scene.meshes[shape.mesh]));
            let bounds = Arc::clone(bounds[shape.mesh].get_or_insert_with(of_mesh));
            Some(BentCaster { mesh, bounds })
        });
        let of_shapes = of_shapes.collect();
        Self { kinds, of_shapes, shapes, moves: scene.instances.iter().any(Instance::is_dynamic) }
    }

    /// The meshes that bend, with their vertices counted from the first of all shapes.
    fn bent_meshes(&self) -> Vec<BentMesh> {
        let first = self.shapes.all.first().map_or(0, |shape| shape.first_vertex);
        let shapes = self.shapes.all.iter().zip(&self.of_shapes);
        let bent = shapes.filter_map(|(shape, of)| {
            let first_vertex = (shape.first_vertex - first) as u32;
            of.as_ref().map(|of| BentMesh { mesh: of.mesh, first_vertex })
        });
        bent.collect()
    }

    /// Where instances stand in a pose, those that cast.
    fn placed(&self, instances: &[Instance], pose: &Pose) -> Vec<Placed> {
        let mut palette = Palette::default();
        palette.take(&self.shapes, pose);
        let bent = self.shapes.all.iter().zip(&self.of_shapes).map(|(shape, of)| {
            let BentCaster { mesh, bounds } = of.as_ref()?;
            let around = bounds.whole(palette.joints(shape.joints), palette.weights(shape.weights));
            Some((*mesh, Shape::Refitted([around.min, around.max])))
        });
        let bent: Vec<_> = bent.collect();
        let placed = instances.iter().zip(&self.kinds).filter_map(|(instance, kind)| {
            let (mesh, shape) = match kind {
                Kind::Nothing => None,
                Kind::Rigid => Some((instance.mesh, Shape::Rigid)),
                Kind::Bent(number) => bent[*number],
            }?;
            let is_visible = instance.is_visible_in(pose);
            is_visible.then(|| Placed { mesh, world_from_mesh: instance.world_from_mesh_in(pose), shape })
        });
        placed.collect()
    }
}

/// The pictures of alpha of a scene that are not 1 everywhere, and which texture's each is.
fn pictures(scene: &Scene) -> (Vec<AlphaPicture>, Vec<Option<usize>>) {
    let mut pictures = Vec::new();
    let used: Vec<bool> = (0..scene.textures.len())
        .map(|i| scene.materials.iter().any(|material| !material.is_solid() && material.texture == Some(i)))
        .collect();
    let of = scene.textures.iter().zip(used).map(|(texture, used)| {
        let alpha: Vec<u8> = texture.rgba.iter().skip(3).step_by(4).copied().collect();
        let (width, height) = (texture.width, texture.height);
        let is_picture = alpha.len() as u64 == u64::from(width) * u64::from(height) && !alpha.is_empty();
        (used && is_picture && alpha.iter().any(|alpha| *alpha < 255)).then(|| {
            pictures.push(AlphaPicture { width, height, alpha });
            pictures.len() - 1
        })
    });
    let of = of.collect();
    (pictures, of)
}

fn cover<'a>(
    material: &Material,
    uvs: &'a [glam::Vec2],
    alphas: &'a [f32],
    picture_of: &[Option<usize>],
) -> Cover<'a> {
    Cover {
        mode: match material.alpha {
            Alpha::Opaque => AlphaMode::Opaque,
            Alpha::Mask { cutoff } => AlphaMode::Mask { cutoff },
            Alpha::Blend => AlphaMode::Blend,
        },
        transmission: material.transmission,
        factor: material.base_colour.w,
        uvs,
        alphas,
        picture: material.texture.and_then(|texture| picture_of.get(texture).copied().flatten()),
    }
}

/// The casters of a scene on the device, for all renderers of it.
#[derive(Debug, Default)]
pub(crate) struct SceneOccluders(OnceLock<OnDevice>);

#[derive(Debug)]
struct OnDevice {
    occluders: Occluders,
    meshes: Vec<MeshRange>,
    known: Known,
    /// The origin and the pose that they stand in, once they stand.
    stands: Mutex<Option<(DVec3, Pose)>>,
}

impl SceneOccluders {
    /// Puts casters onto the device, where there are none yet: whether there were none. `positions` are the vertices of shapes, from
    /// the first on, where there are some.
    pub fn set(
        &self,
        gpu: &Gpu,
        casters: &RayCasters,
        positions: Option<wgpu::BufferBinding<'_>>,
    ) -> Result<bool, RenderError> {
        if self.0.get().is_some() {
            return Ok(false);
        }
        let RayCasters { geometry, known } = casters;
        let (device, queue) = (&gpu.device, &gpu.queue);
        let room = OccluderRoom { instances: known.kinds.len(), left_to_maps: false };
        let occluders = gpu.allocate("what rays go through", || {
            let rigid = Occluders::new(device, queue, geometry, room)?;
            match positions {
                Some(positions) => {
                    rigid.with_bent(device, queue, geometry, &known.bent_meshes(), positions.clone())
                }
                None => Ok(rigid),
            }
        })?;
        let (meshes, known) = (geometry.meshes.clone(), known.clone());
        // Whoever else was first has the same.
        Ok(self.0.set(OnDevice { occluders, meshes, known, stands: Mutex::new(None) }).is_ok())
    }

    /// What shadows bind; `None` before there are any.
    pub fn get(&self) -> Option<&Occluders> {
        self.0.get().map(|on_device| &on_device.occluders)
    }

    /// Says where instances stand in a pose, relative to `origin`, as far as they do not stand there.
    pub fn move_to(
        &self,
        gpu: &Gpu,
        instances: &[Instance],
        origin: DVec3,
        pose: &Pose,
    ) -> Result<(), RenderError> {
        let Some(OnDevice { occluders, meshes, known, stands }) = self.0.get() else {
            return Ok(());
        };
        let mut stands = stands.lock().unwrap_or_else(PoisonError::into_inner);
        let is_there = |(at, posed): &(DVec3, Pose)| *at == origin && (!known.moves || posed == pose);
        if stands.as_ref().is_some_and(is_there) {
            return Ok(());
        }
        occluders.place(&gpu.queue, &TopLevel::build(meshes, known.placed(instances, pose), origin))?;
        *stands = Some((origin, pose.clone()));
        Ok(())
    }
}
