//! What a scene's rays go through, where settings ask for some: its meshes made ready beside the frames, and where its instances
//! stand.

use std::sync::{Mutex, OnceLock, PoisonError};

use glam::{DVec3, Mat4};
use umbrage::casters::{AlphaMode, AlphaPicture, Cover, Geometry, Mesh, MeshRange, Part, Placed, TopLevel};
use umbrage::{OccluderRoom, Occluders};
use umbrage_scene::{Alpha, DeformedBounds, Instance, Material, Pose, Rig, Scene};

use crate::cover::{Cover as How, Covers};
use crate::error::RenderError;
use crate::gpu::Gpu;

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
    /// The boxes of the meshes that are bent.
    bent: Vec<DeformedBounds>,
    /// The skins that bend them.
    rig: Rig,
    /// Whether a pose may move some of them.
    moves: bool,
}

/// What rays know of an instance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// It casts nothing.
    Nothing,
    /// All its triangles.
    Rigid,
    /// The box around it, by the number of its mesh among those that are bent, and its skin.
    Bent(usize, Option<usize>),
}

impl RayCasters {
    /// Makes the casters of a scene ready.
    pub fn of(scene: &Scene) -> Self {
        let (pictures, picture_of) = pictures(scene);
        let alphas: Vec<Vec<f32>> =
            scene.meshes.iter().map(|mesh| mesh.colours.iter().map(|colour| colour.w).collect()).collect();
        let mut covers = Covers::new(scene);
        let meshes: Vec<Mesh<'_>> = scene
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
                Mesh { positions: &mesh.positions, parts: parts.collect() }
            })
            .collect();
        Self { geometry: Geometry::build(&meshes, &pictures), known: Known::of(scene) }
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
        let is_of_scene = geometry.meshes.len() == scene.meshes.len();
        is_of_scene.then(|| Self { geometry, known: Known::of(scene) })
    }

    /// Returns the number of triangles, those of each mesh once.
    pub fn triangles(&self) -> usize {
        self.geometry.triangles()
    }

    /// Returns the number of triangles that were left out, as they have no area or corners that are nowhere.
    pub fn left_out(&self) -> usize {
        self.geometry.left_out
    }
}

impl Known {
    fn of(scene: &Scene) -> Self {
        let (mut bent, mut numbers) = (Vec::new(), vec![None; scene.meshes.len()]);
        let kinds = scene.instances.iter().map(|instance| {
            let mesh = &scene.meshes[instance.mesh];
            if !instance.casts {
                return Kind::Nothing;
            }
            if !instance.is_deformed(mesh) {
                return Kind::Rigid;
            }
            let number = *numbers[instance.mesh].get_or_insert_with(|| {
                bent.push(DeformedBounds::of(mesh));
                bent.len() - 1
            });
            Kind::Bent(number, instance.skin.filter(|_| !mesh.influences.is_empty()))
        });
        let kinds = kinds.collect();
        let rig = Rig { skins: scene.rig.skins.clone(), ..Rig::default() };
        Self { kinds, bent, rig, moves: scene.instances.iter().any(Instance::is_dynamic) }
    }

    /// Where an instance stands in a pose; `None` where it casts nothing.
    fn placed(&self, instance: &Instance, kind: Kind, pose: &Pose) -> Option<Placed> {
        if !instance.is_visible_in(pose) {
            return None;
        }
        let rigid = Placed::rigid(instance.mesh, instance.world_from_mesh_in(pose));
        match kind {
            Kind::Nothing => None,
            Kind::Rigid => Some(rigid),
            Kind::Bent(number, skin) => {
                let joints: Vec<Mat4> =
                    skin.map_or_else(Vec::new, |skin| pose.joints(&self.rig, skin).collect());
                let weights = instance.node.map_or(&[][..], |node| pose.weights(node));
                let around = self.bent[number].whole(&joints, weights).transformed(&rigid.world_from_mesh);
                Some(Placed { bent: Some([around.min, around.max]), ..rigid })
            }
        }
    }

    /// Whether some instances are bent.
    fn has_bent(&self) -> bool {
        !self.bent.is_empty()
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
    /// Puts casters onto the device, where there are none yet.
    pub fn set(&self, gpu: &Gpu, casters: &RayCasters) -> Result<(), RenderError> {
        if self.0.get().is_some() {
            return Ok(());
        }
        let RayCasters { geometry, known } = casters;
        let room = OccluderRoom { instances: known.kinds.len(), bent: known.has_bent() };
        let make = || Occluders::new(&gpu.device, &gpu.queue, geometry, room);
        let occluders = gpu.allocate("what rays go through", make)?;
        let (meshes, known) = (geometry.meshes.clone(), known.clone());
        // Whoever else was first has the same.
        let _ = self.0.set(OnDevice { occluders, meshes, known, stands: Mutex::new(None) });
        Ok(())
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
        let kinds = instances.iter().zip(&known.kinds);
        let placed = kinds.filter_map(|(instance, kind)| known.placed(instance, *kind, pose));
        occluders.place(&gpu.queue, &TopLevel::build(meshes, placed, origin))?;
        *stands = Some((origin, pose.clone()));
        Ok(())
    }
}
