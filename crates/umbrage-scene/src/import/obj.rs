//! Wavefront OBJ to a scene, with `tobj`: a mesh for every object or group, all of them where they stand.
//!
//! `tobj` believes its input, and panics on some; so the text is checked before, in `checked.rs`, and the result after.

mod checked;
mod dissolve;
mod library;
mod materials;
mod picture_options;

use std::collections::HashMap;
use std::path::Path;

use glam::{DMat4, Vec2, Vec3};

use super::budget::Budget;
use super::draft::{Draft, Placed};
use super::files::Files;
use super::recentre::Rebased;
use super::warnings::Warnings;
use super::{normals, recentre, settle};
use crate::error::Fault;
use crate::{Material, Mesh, Motion, Scene};

/// One index a vertex, triangles only.
const OPTIONS: tobj::LoadOptions =
    tobj::LoadOptions { single_index: true, triangulate: true, ignore_points: true, ignore_lines: true };

/// Reads a whole file and its material libraries.
pub(super) fn read(
    bytes: &[u8],
    name: &str,
    files: Files<'_>,
    warnings: &mut Warnings,
) -> Result<Scene, Fault> {
    let checked::Text { text, libraries, corners, origin } = checked::object(bytes, warnings);
    let mut budget = Budget::new();
    budget.corners(corners)?;
    let libraries = read_libraries(&libraries, files, warnings);
    let library = |path: &Path| {
        // Every library was read before; what is not there could not be read.
        let text = libraries.get(&*path.to_string_lossy()).ok_or(tobj::LoadError::OpenFileFailed)?;
        tobj::load_mtl_buf(&mut text.as_bytes())
    };
    let (models, materials) = tobj::load_obj_buf(&mut text.as_bytes(), &OPTIONS, library)
        .map_err(|why| Fault(format!("not a Wavefront OBJ file, {why}")))?;

    let mut scene = Scene { name: name.to_owned(), ..Scene::default() };
    materials::read(&materials.unwrap_or_default(), files, &mut budget, &mut scene, warnings);
    let mut plain = None;
    for model in models.iter().filter(|model| !model.mesh.indices.is_empty()) {
        let material = model.mesh.material_id.unwrap_or_else(|| {
            *plain.get_or_insert_with(|| {
                scene.materials.push(Material::plain("default", 1.0, 1.0, 1.0));
                scene.materials.len() - 1
            })
        });
        budget.vertices(model.mesh.positions.len() / 3)?;
        // A change of material makes a new model of the same object.
        let name = if model.name == checked::NO_NAME { name } else { model.name.as_str() };
        if scene.meshes.last().is_none_or(|mesh| mesh.name != name) {
            scene.meshes.push(Mesh::empty(name));
        }
        if let Some(mesh) = scene.meshes.last_mut() {
            add(mesh, &model.mesh, material, warnings)?;
        }
    }
    let rebased: Vec<Rebased> = scene.meshes.iter_mut().map(recentre::rebase).collect();
    let placed = |(what, mesh): (usize, &Mesh)| Placed {
        what,
        world_from_it: DMat4::IDENTITY,
        motion: Motion::Still,
        hang: None,
        skin: None,
        name: "".into(),
        casts: None,
        label: mesh.name.as_str().into(),
    };
    let instances = scene.meshes.iter().enumerate().map(placed).collect();
    let draft = Draft { instances, origin, ..Draft::default() };
    settle::settle(draft, &rebased, &mut scene, &mut budget, warnings)?;
    Ok(scene)
}

/// Appends a model's vertices and triangles to the mesh they belong to.
fn add(mesh: &mut Mesh, model: &tobj::Mesh, material: usize, warnings: &mut Warnings) -> Result<(), Fault> {
    let positions: Vec<Vec3> = model.positions.as_chunks().0.iter().map(|&p: &[f32; 3]| p.into()).collect();
    let count = positions.len();
    if let Some(p) = positions.iter().find(|p| !p.is_finite()) {
        return Err(Fault(format!("a vertex at {p}, need finite coordinates, in mesh {:?}", mesh.name)));
    }
    if let Some(index) = model.indices.iter().find(|&&i| i as usize >= count) {
        return Err(Fault(format!("index {index} of a mesh with {count} vertices, in mesh {:?}", mesh.name)));
    }
    // Where only some faces have them, they belong to nobody knows which vertex.
    let mut normals: Vec<Vec3> = model.normals.as_chunks().0.iter().map(|&n: &[f32; 3]| n.into()).collect();
    if normals.len() == count {
        normals::repair(&positions, &model.indices, &mut normals);
    } else {
        if !normals.is_empty() {
            warnings.note("normals of some faces only are ignored", &mesh.name);
        }
        normals = normals::smooth(&positions, &model.indices);
    }
    // OBJ counts v upwards.
    let mut uvs: Vec<Vec2> =
        model.texcoords.as_chunks().0.iter().map(|&[u, v]: &[f32; 2]| Vec2::new(u, 1.0 - v)).collect();
    if uvs.len() != count || !uvs.iter().all(|uv| uv.is_finite()) {
        if !uvs.is_empty() {
            warnings.note("texture coordinates of some faces only, or not finite, are ignored", &mesh.name);
        }
        uvs = vec![Vec2::ZERO; count];
    }
    let base = mesh.positions.len() as u32;
    mesh.positions.extend(positions);
    mesh.normals.extend(normals);
    mesh.uvs.extend(uvs);
    mesh.add_triangles(model.indices.as_chunks().0.iter().map(|t: &[u32; 3]| t.map(|i| base + i)), material);
    Ok(())
}

/// The text of each library that can be read, by its name in the file.
fn read_libraries(names: &[String], files: Files<'_>, warnings: &mut Warnings) -> HashMap<String, String> {
    let mut libraries = HashMap::new();
    for name in names {
        match files.read(name) {
            Ok(bytes) => {
                libraries.insert(name.clone(), library::library(&bytes, name, warnings));
            }
            Err(Fault(why)) => {
                warnings
                    .note("material libraries that cannot be read are left out", &format!("{name:?}, {why}"));
            }
        }
    }
    libraries
}
