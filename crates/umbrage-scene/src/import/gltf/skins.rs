//! The skins of a file: which nodes are joints, and where each was when the skin was bound to its mesh.
//!
//! Source: glTF 2.0, section 3.7.3, *Skins*.

use glam::{Mat4, Vec4};

use super::accessors::Data;
use super::document::Document;
use crate::error::Fault;
use crate::import::settle::FARTHEST;
use crate::import::warnings::Warnings;

/// A skin of a file.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Skin {
    /// The joints: each a node of the file, and the transform from the mesh to it when it was bound. `None` where the file
    /// lacks one of the two.
    pub joints: Vec<Option<(usize, Mat4)>>,
}

/// What is said of joints that are not where they should be.
const MISSING: &str = "vertices of joints that are missing follow the first joint of their skin";

/// A file may have more matrices than joints, but not so many times more: nothing in it pays for reading them.
const MOST_MATRICES: usize = 4;

/// Reads all skins; where one cannot be read, the reason.
pub(super) fn read(
    document: &Document,
    data: &Data<'_>,
    warnings: &mut Warnings,
) -> Vec<Result<Skin, String>> {
    let skins = &document.root.skins;
    let mut read = Vec::with_capacity(skins.len());
    for (i, skin) in skins.iter().enumerate() {
        if let Some(why) = document.broken.get(&("skins", i)) {
            read.push(Err(format!("skin {i}, {why}")));
            continue;
        }
        let matrices = matrices(skin, data).map_err(|Fault(why)| format!("skin {i}, {why}"));
        read.push(matrices.map(|matrices| {
            let joint = |(k, matrix): (usize, Option<Mat4>)| {
                let node = skin.joints[k].value();
                let is_there = node < document.root.nodes.len();
                let lacks = match (is_there, matrix) {
                    (true, Some(matrix)) => return Some((node, matrix)),
                    (true, None) => "has no inverse bind matrix of finite numbers up to 1e12".to_owned(),
                    (false, _) => format!("is node {node} of {}", document.root.nodes.len()),
                };
                warnings.note(MISSING, &format!("joint {k} of skin {i} {lacks}"));
                None
            };
            Skin { joints: matrices.into_iter().enumerate().map(joint).collect() }
        }));
    }
    read
}

/// A matrix for each joint; the identity where the skin has none at all.
fn matrices(skin: &gltf::json::Skin, data: &Data<'_>) -> Result<Vec<Option<Mat4>>, Fault> {
    let joints = skin.joints.len();
    if joints == 0 {
        return Err(Fault("it has no joints".to_owned()));
    }
    let Some(accessor) = skin.inverse_bind_matrices else {
        return Ok(vec![Some(Mat4::IDENTITY); joints]);
    };
    let said = data.said(accessor);
    if said > joints.saturating_mul(MOST_MATRICES) {
        return Err(Fault(format!("{said} inverse bind matrices for {joints} joints")));
    }
    let mut matrices: Vec<Option<Mat4>> = data.vectors::<16>(accessor)?.iter().map(affine).collect();
    matrices.resize(joints, None);
    Ok(matrices)
}

/// The matrix with the last row that it should have, if its numbers are ones that things are moved by.
fn affine(columns: &[f32; 16]) -> Option<Mat4> {
    let mut matrix = Mat4::from_cols_array(columns);
    for (i, w) in Vec4::W.to_array().into_iter().enumerate() {
        matrix.col_mut(i).w = w;
    }
    matrix.abs_diff_eq(Mat4::ZERO, FARTHEST as f32).then_some(matrix)
}
