//! The scanned models, each alone on a ground: curved silhouettes over flat and self-shadowed surfaces.
//!
//! The models come from the Stanford Computer Graphics Laboratory.

use glam::Vec3;

use super::stage::{Stage, View, standing};
use crate::Scene;
use crate::paint::Paint;
use crate::shape::plane;

const VIEW: View = View { fov_degrees: 45.0, near: 0.5, far: 100.0 };

pub(super) fn bunny(seed: u64) -> Scene {
    build("bunny", include_bytes!("../../../../assets/bunny.glb"), Paint::Ivory, 3.0, seed)
}

pub(super) fn dragon(seed: u64) -> Scene {
    build("dragon", include_bytes!("../../../../assets/dragon.glb"), Paint::Brass, 4.0, seed)
}

/// A model of 1 m made `height` metres tall; the seed turns it.
fn build(name: &str, bytes: &[u8], paint: Paint, height: f32, seed: u64) -> Scene {
    let mut stage = Stage::new(name, seed, VIEW, Vec3::new(-0.7, -0.45, -0.45));
    let mut scan = crate::load_glb_bytes(bytes, name).expect("the embedded models load").scene;
    stage.ground(&[plane(30.0, 0.0, Paint::Stone as usize, 30.0)]);
    let yaw = if seed == 0 { 0.35 } else { stage.dice.angle() };
    let first = stage.scene.meshes.len();
    scan.meshes.iter_mut().flat_map(|mesh| &mut mesh.parts).for_each(|part| part.material = paint as usize);
    stage.scene.meshes.append(&mut scan.meshes);
    for instance in scan.instances {
        stage.place(first + instance.mesh, standing(Vec3::ZERO, yaw, height) * instance.world_from_mesh);
    }
    cameras(&mut stage, height);
    stage.scene
}

fn cameras(stage: &mut Stage, height: f32) {
    let at = |x: f32, y: f32, z: f32| Vec3::new(x, y, z) * height;
    let middle = at(0.0, 0.45, 0.0);
    stage.look("main", at(-0.9, 1.1, 2.6), at(-0.15, 0.35, 0.0));
    stage.look_far(Vec3::new(0.0, 26.0, 28.0), Vec3::ZERO);
    stage.look("close", at(-1.3, 0.45, 0.9), at(-0.55, 0.0, -0.25));
    stage.look("split", at(-3.0, 0.3, 0.6), at(1.0, 0.2, -0.3));
    stage.look_into_light(at(-1.4, 0.19, -0.86), 11.0);
    stage.fly(&[
        (at(-0.9, 1.1, 2.6), middle),
        (at(1.6, 0.7, 2.0), middle),
        (at(2.3, 0.4, -0.3), middle),
        (at(0.8, 0.9, -2.2), middle),
        (at(-1.8, 0.5, -1.6), middle),
        (at(-2.4, 0.8, 0.9), middle),
        (at(-0.9, 1.1, 2.6), middle),
    ]);
}
