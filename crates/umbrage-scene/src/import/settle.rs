//! A draft to a scene: transforms to f32, as the rest of the program wants them, and what cannot be drawn left out.
//!
//! Space: world space, metres, around the draft's origin.

use std::collections::HashMap;

use glam::{DMat4, Mat4};

use super::budget::Budget;
use super::domes;
use super::draft::{Draft, Placed};
use super::extent::Extent;
use super::flatten::{self, Stretch};
use super::recentre::Rebased;
use super::warnings::Warnings;
use crate::error::Fault;
use crate::{Instance, Mesh, MorphTarget, Motion, Scene};

/// Coordinates beyond this, metres, are a mistake, and their cubes would overflow.
pub(super) const FARTHEST: f64 = 1e12;

/// Puts everything of a draft into a scene that has its meshes. Only more than the budget allows stops here.
pub(super) fn settle(
    draft: Draft,
    rebased: &[Rebased],
    scene: &mut Scene,
    budget: &mut Budget,
    warnings: &mut Warnings,
) -> Result<(), Fault> {
    let mut draft = draft;
    let instances = std::mem::take(&mut draft.instances);
    let (mut flattened, mut morphs) = (HashMap::new(), HashMap::new());
    let mut said_to_cast = Vec::new();
    for placed in &instances {
        let rebased = &rebased[placed.what];
        let world_from_mesh = placed.world_from_mesh(rebased, &draft);
        note_coarse(placed, rebased, &world_from_mesh, scene, warnings);
        let mesh = &scene.meshes[placed.what];
        let morphed = morphs.entry(placed.what).or_insert_with(|| displacements(mesh)).as_slice();
        let bounds = Extent::of(mesh.bounds).widened(placed.displacement(morphed, &draft));
        let reach = placed.extent(bounds, rebased, &draft).reach();
        let hangs_near = placed.hang.is_none_or(|hang| hang.node_from_it.abs_diff_eq(DMat4::ZERO, FARTHEST));
        if reach.is_nan() || reach > FARTHEST || !hangs_near {
            let what = "instances that reach too far are left out";
            warnings.note(what, &format!("{} to {reach:e} m, need at most {FARTHEST:e} m", placed.label));
            continue;
        }
        let motion = placed.moves(rebased, &draft.rig);
        let may_be_flat = placed.hang.is_none();
        let (mesh, world_from_mesh) = match flatten::stretch(&world_from_mesh) {
            // What shrinks to nothing may grow again.
            _ if !may_be_flat => (placed.what, world_from_mesh),
            Stretch::Ordinary => (placed.what, world_from_mesh),
            Stretch::Flat => flat(placed.what, &world_from_mesh, &mut flattened, scene, budget)?,
            Stretch::Nothing => {
                warnings.note("instances scaled to a line or a point are left out", &placed.label);
                continue;
            }
        };
        said_to_cast.push(placed.casts == Some(true));
        scene.instances.push(Instance {
            name: placed.name.to_string(),
            mesh,
            world_from_mesh: motion.moved(world_from_mesh.as_mat4(), &draft.pose),
            motion,
            casts: placed.casts.unwrap_or(true),
            node: placed.hang.map(|hang| hang.node),
            skin: placed.skin,
        });
    }
    let Draft { instances: _, cameras, lights, path, exposed_for, origin, rig, pose: at_start } = draft;
    (scene.origin, scene.path, scene.exposed_for, scene.rig) = (origin, path, exposed_for, rig);
    domes::let_cast_nothing(scene, &said_to_cast, warnings);
    let is_near = |pose: &DMat4| pose.w_axis.truncate().abs().max_element() <= FARTHEST;
    for (camera, pose) in cameras {
        if is_near(&pose) {
            scene.cameras.push(crate::Camera { world_from_camera: pose.as_mat4(), ..camera });
        } else {
            warnings.note("cameras that stand too far are left out", &far(&camera.name, &pose));
        }
    }
    for (light, pose) in lights {
        let hangs_near = match light.motion {
            Motion::Node { node_from_thing, .. } => node_from_thing.abs_diff_eq(Mat4::ZERO, FARTHEST as f32),
            Motion::Still | Motion::Rotation { .. } | Motion::Skin { .. } => true,
        };
        if is_near(&pose) && hangs_near {
            let light = crate::Light { world_from_light: pose.as_mat4(), ..light };
            let world_from_light = light.world_from_light_in(&at_start);
            scene.lights.push(crate::Light { world_from_light, ..light });
        } else {
            warnings.note("lights that stand too far are left out", &far(&light.name, &pose));
        }
    }
    Ok(())
}

/// How far each morph target of a mesh moves a vertex at most.
fn displacements(mesh: &Mesh) -> Vec<f64> {
    let most =
        |target: &MorphTarget| target.positions.iter().map(|by| f64::from(by.length())).fold(0.0, f64::max);
    mesh.targets.iter().map(most).collect()
}

fn far(name: &str, pose: &DMat4) -> String {
    let [x, y, z] = pose.w_axis.truncate().to_array();
    format!("{name} at {x:e} {y:e} {z:e}, need at most {FARTHEST:e} m")
}

/// The flat copy of a mesh, made once for each way of flattening it.
fn flat(
    mesh: usize,
    world_from_mesh: &DMat4,
    flattened: &mut HashMap<(usize, [u64; 9]), usize>,
    scene: &mut Scene,
    budget: &mut Budget,
) -> Result<(usize, DMat4), Fault> {
    let axes = glam::DMat3::from_mat4(*world_from_mesh).to_cols_array().map(f64::to_bits);
    if let Some(&known) = flattened.get(&(mesh, axes)) {
        return Ok((known, DMat4::from_translation(world_from_mesh.w_axis.truncate())));
    }
    budget.vertices(scene.meshes[mesh].positions.len())?;
    budget.corners(scene.meshes[mesh].indices.len())?;
    let (baked, rest) = flatten::bake(&scene.meshes[mesh], world_from_mesh);
    scene.meshes.push(baked);
    flattened.insert((mesh, axes), scene.meshes.len() - 1);
    Ok((scene.meshes.len() - 1, rest))
}

/// Vertices that the file itself rounds so much that it shows, in metres of the world.
fn note_coarse(
    placed: &Placed,
    rebased: &Rebased,
    world_from_mesh: &DMat4,
    scene: &Scene,
    warnings: &mut Warnings,
) {
    let Some(apart) = rebased.coarse else {
        return;
    };
    let stretch = [world_from_mesh.x_axis, world_from_mesh.y_axis, world_from_mesh.z_axis]
        .into_iter()
        .fold(0.0, |most: f64, axis| most.max(axis.truncate().length()));
    let what = "vertices far from their mesh's origin are rounded so much that it shows, move them near it and their \
                node away";
    let mesh = &scene.meshes[placed.what].name;
    warnings.note(what, &format!("to {} m in mesh {mesh:?}", crate::error::short(apart * stretch)));
}

#[cfg(test)]
mod tests {
    use glam::{DVec3, Vec3};

    use super::*;
    use crate::Primitive;

    fn scene() -> Scene {
        let positions = vec![Vec3::ZERO, Vec3::X, Vec3::Y];
        let (normals, uvs) = (vec![Vec3::Z; 3], vec![glam::Vec2::ZERO; 3]);
        let mesh = Mesh::new(
            "t",
            &[Primitive { positions, normals, uvs, indices: vec![0, 1, 2], ..Primitive::default() }],
        );
        Scene { meshes: vec![mesh], ..Scene::default() }
    }

    fn settled(transforms: &[DMat4]) -> (Scene, Vec<String>) {
        let placed = |world_from_it: &DMat4| Placed {
            what: 0,
            world_from_it: *world_from_it,
            motion: Motion::Still,
            hang: None,
            skin: None,
            name: "".into(),
            casts: None,
            label: "n".into(),
        };
        let draft = Draft { instances: transforms.iter().map(placed).collect(), ..Draft::default() };
        let (mut scene, mut warnings) = (scene(), Warnings::default());
        settle(draft, &[Rebased::default()], &mut scene, &mut Budget::new(), &mut warnings).unwrap();
        (scene, warnings.into_lines())
    }

    #[test]
    fn what_reaches_too_far_goes_and_the_rest_stays() {
        let (scene, warnings) = settled(&[DMat4::IDENTITY, DMat4::from_translation(DVec3::X * 1e30)]);
        assert_eq!(scene.instances.len(), 1);
        assert_eq!(warnings, ["instances that reach too far are left out: n to 1e30 m, need at most 1e12 m"]);
    }

    #[test]
    fn flat_copies_are_shared() {
        let flat =
            |x: f64| DMat4::from_translation(DVec3::X * x) * DMat4::from_scale(DVec3::new(1.0, 0.0, 1.0));
        let (scene, warnings) = settled(&[flat(0.0), flat(1.0), DMat4::from_scale(DVec3::ZERO)]);
        // The triangle stands upright, and is a line afterwards; but a surface can be flattened so.
        assert_eq!((scene.meshes.len(), scene.instances.len()), (2, 2));
        assert_eq!(scene.instances[1].world_from_mesh.w_axis.x, 1.0);
        assert_eq!(warnings, ["instances scaled to a line or a point are left out: n"]);
    }
}
