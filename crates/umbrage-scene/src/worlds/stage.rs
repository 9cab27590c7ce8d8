//! What every built-in world needs: a scene under construction, and room for things that must not overlap.

use glam::{Mat4, Quat, Vec2, Vec3};

use crate::dice::Dice;
use crate::paint::Paint;
use crate::shape::Model;
use crate::{
    Alpha, Camera, CameraPath, Instance, Light, LightKind, Material, Mesh, Motion, PathKey, Primitive, Scene,
    Texture,
};

/// What worlds are exposed for, lux. Their paints are darker than those of life, and are shown brighter for it: by day for
/// less than half of the sun's 3 lux, and by lamps that give 1 to 3 lux for the lower end.
const SUNNY: f32 = 1.385;
const LAMPLIT: f32 = 1.2;

/// How all cameras of a world see.
#[derive(Clone, Copy, Debug)]
pub(crate) struct View {
    /// The whole vertical field of view, in degrees.
    pub fov_degrees: f32,
    /// The view depth of the nearest thing that is visible, in metres.
    pub near: f32,
    /// The view depth of the farthest thing that is visible, in metres.
    pub far: f32,
}

/// A scene under construction.
#[derive(Debug)]
pub(crate) struct Stage {
    pub scene: Scene,
    pub dice: Dice,
    view: View,
}

impl Stage {
    /// An empty world whose sun shines along `sun_along` (any length).
    pub fn new(name: &str, seed: u64, view: View, sun_along: Vec3) -> Self {
        let mut stage = Self::dark(name, seed, view);
        stage.scene.lights.push(Light::sun(sun_along, 3.0));
        stage.scene.exposed_for = Some(SUNNY);
        stage
    }

    /// An empty world without a sun; lights are still to come.
    pub fn dark(name: &str, seed: u64, view: View) -> Self {
        let (name, materials) = (name.to_owned(), Paint::materials());
        let scene = Scene { name, materials, exposed_for: Some(LAMPLIT), ..Scene::default() };
        Self { scene, dice: Dice::new(seed), view }
    }

    /// Adds a mesh of paints; nothing is placed yet.
    pub fn mesh(&mut self, name: &str, model: &Model) -> usize {
        self.add(model.mesh(name))
    }

    /// Adds a mesh; nothing is placed yet.
    pub fn add(&mut self, mesh: Mesh) -> usize {
        self.scene.meshes.push(mesh);
        self.scene.meshes.len() - 1
    }

    /// Adds a ground, which stands where it is.
    pub fn ground(&mut self, primitives: &[Primitive]) {
        let mesh = self.add(Mesh::new("ground", primitives));
        self.place(mesh, Mat4::IDENTITY);
    }

    /// Adds a material with a picture.
    pub fn textured(&mut self, texture: Texture) -> usize {
        self.scene.materials.push(Material {
            texture: Some(self.scene.textures.len()),
            ..Material::plain(&texture.name, 1.0, 1.0, 1.0)
        });
        self.scene.textures.push(texture);
        self.scene.materials.len() - 1
    }

    /// Adds a material that is cut out of a picture where its alpha is at least one half.
    pub fn masked(&mut self, texture: Texture) -> usize {
        let material = self.textured(texture);
        self.scene.materials[material].alpha = Alpha::Mask { cutoff: 0.5 };
        material
    }

    /// Adds a material.
    pub fn material(&mut self, material: Material) -> usize {
        self.scene.materials.push(material);
        self.scene.materials.len() - 1
    }

    /// Places a mesh that stands still.
    pub fn place(&mut self, mesh: usize, world_from_mesh: Mat4) {
        self.scene.instances.push(Instance::still(mesh, world_from_mesh));
    }

    /// Places a mesh that rotates about `axis` through `centre`.
    pub fn place_rotating(
        &mut self,
        mesh: usize,
        at: Mat4,
        centre: Vec3,
        axis: Vec3,
        radians_per_second: f32,
    ) {
        let motion = Motion::Rotation { centre, axis, radians_per_second };
        self.scene.instances.push(Instance { motion, ..Instance::still(mesh, at) });
    }

    /// Places a mesh that marches around `centre` at `metres_per_second`, counter-clockwise seen from above where that
    /// is positive, at `angle` of the circle to begin with.
    pub fn place_marching(
        &mut self,
        mesh: usize,
        centre: Vec3,
        radius: f32,
        angle: f32,
        size: f32,
        pace: f32,
    ) {
        let out = Vec3::new(angle.cos(), 0.0, -angle.sin());
        let ahead = if pace >= 0.0 { angle + std::f32::consts::PI } else { angle };
        self.place_rotating(
            mesh,
            standing(centre + out * radius, ahead, size),
            centre,
            Vec3::Y,
            pace / radius,
        );
    }

    /// Adds a camera; the first is the main one.
    pub fn look(&mut self, name: &str, eye: Vec3, target: Vec3) {
        self.look_through(self.view, name, eye, target);
    }

    /// Adds a camera that sees in its own way.
    pub fn look_through(&mut self, view: View, name: &str, eye: Vec3, target: Vec3) {
        let View { fov_degrees, near, far } = view;
        self.scene.cameras.push(Camera::looking(name, eye, target, fov_degrees.to_radians(), near, far));
    }

    /// Adds the overview: as [`Self::look`], but sees as far as the world is wide.
    pub fn look_far(&mut self, eye: Vec3, target: Vec3) {
        self.look("far", eye, target);
        if let Some(camera) = self.scene.cameras.last_mut() {
            camera.far = camera.far.max(eye.distance(target) * 2.5);
        }
    }

    /// Adds the dueling camera at `eye`: it looks into the first light, but `dip_degrees` lower, so that land is in view.
    pub fn look_into_light(&mut self, eye: Vec3, dip_degrees: f32) {
        let light = &self.scene.lights[0];
        let to_light = match light.kind {
            LightKind::Directional => -light.direction(),
            LightKind::Spot { .. } | LightKind::Point { .. } => (light.position() - eye).normalize_or_zero(),
        };
        let level = Vec3::new(to_light.x, 0.0, to_light.z).normalize_or_zero();
        let elevation = to_light.y.asin() - dip_degrees.to_radians();
        self.look("dueling", eye, eye + level * elevation.cos() + Vec3::Y * elevation.sin());
    }

    /// The flight through the world, as (eye, target) keys.
    pub fn fly(&mut self, keys: &[(Vec3, Vec3)]) {
        self.scene.path =
            CameraPath { keys: keys.iter().map(|&(eye, target)| PathKey { eye, target }).collect() };
    }
}

/// Stands at `feet`, turned from facing +Z by `yaw` radians towards +X, `size` times as large.
pub(crate) fn standing(feet: Vec3, yaw: f32, size: f32) -> Mat4 {
    Mat4::from_scale_rotation_translation(Vec3::splat(size), Quat::from_rotation_y(yaw), feet)
}

/// Circles on the ground that are taken.
#[derive(Debug, Default)]
pub(crate) struct Room(Vec<(Vec2, f32)>);

impl Room {
    /// Takes a circle, whether free or not.
    pub fn take(&mut self, x: f32, z: f32, radius: f32) {
        self.0.push((Vec2::new(x, z), radius));
    }

    /// The first free circle of `radius` among the places that `propose` comes up with; it is taken from now on.
    pub fn find(&mut self, radius: f32, mut propose: impl FnMut() -> Vec2) -> Vec2 {
        /// Crowded worlds need some tens of tries; a proposal that is never free must still end.
        const TRIES: usize = 4096;
        let mut place = propose();
        for _ in 0..TRIES {
            if self.0.iter().all(|(other, r)| other.distance(place) >= r + radius) {
                break;
            }
            place = propose();
        }
        self.0.push((place, radius));
        place
    }
}
