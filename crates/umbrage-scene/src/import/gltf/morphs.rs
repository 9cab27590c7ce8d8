//! The shapes that a primitive can be morphed to.
//!
//! Source: glTF 2.0, section 3.7.2.2, *Morph Targets*. Where neither the primitive nor a target has normals, both are flat,
//! so the target's are the difference between the flat normals of both shapes.

use glam::{DVec3, Vec3};
use gltf::json::mesh::Primitive;
use gltf::json::{Accessor, Index};

use super::accessors::Data;
use crate::MorphTarget;
use crate::error::Fault;
use crate::import::settle::FARTHEST;
use crate::import::warnings::Warnings;

/// A morph target of a primitive, before anyone knows what its vertices are.
#[derive(Clone, Debug, Default)]
pub(super) struct Displaced {
    positions: Vec<Vec3>,
    normals: Option<Vec<Vec3>>,
}

/// Reads the targets of a primitive with `count` vertices. What cannot be read displaces nothing.
pub(super) fn read(
    data: &Data<'_>,
    primitive: &Primitive,
    count: usize,
    mesh: &str,
    warnings: &mut Warnings,
) -> Vec<Displaced> {
    let mut targets = Vec::new();
    for (i, target) in primitive.targets.iter().flatten().enumerate() {
        let mut rows = |accessor: Index<Accessor>| -> Option<Vec<Vec3>> {
            let said = data.said(accessor);
            let rows = if said == count {
                data.vectors::<3>(accessor)
            } else {
                Err(Fault(format!("{count} positions, and {said} rows in accessor {accessor}")))
            };
            match rows {
                Ok(rows) => Some(rows.into_iter().map(Vec3::from).collect()),
                Err(Fault(why)) => {
                    let subject = format!("target {i} of mesh {mesh:?}, {why}");
                    warnings.note("morph targets that cannot be read change nothing", &subject);
                    None
                }
            }
        };
        let mut positions = target.positions.and_then(&mut rows).unwrap_or_else(|| vec![Vec3::ZERO; count]);
        let mut normals = target.normals.and_then(&mut rows);
        let is_usable = |v: &Vec3| v.abs().cmple(Vec3::splat(FARTHEST as f32)).all();
        let all = positions.iter_mut().chain(normals.iter_mut().flatten());
        for v in all.filter(|v| !is_usable(v)) {
            let what = "displacements of morph targets that are not finite or reach too far are left out";
            warnings.note(what, &format!("target {i} of mesh {mesh:?}"));
            *v = Vec3::ZERO;
        }
        targets.push(Displaced { positions, normals });
    }
    targets
}

/// The targets of vertices that have normals of their own.
pub(super) fn shared(targets: Vec<Displaced>) -> Vec<MorphTarget> {
    let of = |Displaced { positions, normals }| {
        let normals = normals.unwrap_or_else(|| vec![Vec3::ZERO; positions.len()]);
        MorphTarget { positions, normals }
    };
    targets.into_iter().map(of).collect()
}

/// The targets of the corners of triangles, each a vertex of its own, whose normals are flat.
pub(super) fn flat(targets: &[Displaced], positions: &[Vec3], corners: &[u32]) -> Vec<MorphTarget> {
    let of = |Displaced { positions: moved, .. }: &Displaced| {
        let normal = |triangle: &[u32; 3]| {
            let before = triangle.map(|i| positions[i as usize].as_dvec3());
            let after = triangle.map(|i| positions[i as usize].as_dvec3() + moved[i as usize].as_dvec3());
            [(flat_normal(after) - flat_normal(before)).as_vec3(); 3]
        };
        MorphTarget {
            positions: corners.iter().map(|&i| moved[i as usize]).collect(),
            normals: corners.as_chunks().0.iter().flat_map(normal).collect(),
        }
    };
    targets.iter().map(of).collect()
}

fn flat_normal([a, b, c]: [DVec3; 3]) -> DVec3 {
    (b - a).cross(c - a).normalize_or_zero()
}
