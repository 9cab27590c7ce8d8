//! The node tree: which nodes are in the scene, and where they stand.
//!
//! No recursion: a file may nest its nodes as deep as it likes.

use glam::{Mat3, Mat4, Quat, Vec3};
use gltf::json::{Node, Root};

use crate::error::Fault;

/// How far from unit length and right angles, squared, the axes of a rigid transform may be to be kept as they are.
const RIGID_TOLERANCE: f32 = 1e-3;

/// The nodes of the default scene (the first where none is the default, all where there are no scenes), parents before
/// children and otherwise in the file's order, each with its `world_from_node`.
pub(super) fn walk(root: &Root) -> Result<Vec<(usize, Mat4)>, Fault> {
    let children = |i: usize| root.nodes[i].children.iter().flatten().map(|child| child.value());
    let mut has_parent = vec![false; root.nodes.len()];
    for parent in 0..root.nodes.len() {
        for child in children(parent) {
            if std::mem::replace(&mut has_parent[child], true) {
                return Err(Fault(format!("node {child} has two parents")));
            }
        }
    }
    let tops: Vec<usize> = (0..root.nodes.len()).filter(|&i| !has_parent[i]).collect();
    let mut reached = 0;
    let mut stack = tops.clone();
    while let Some(node) = stack.pop() {
        reached += 1;
        stack.extend(children(node));
    }
    // No node has two parents, so those that no top leads to go round in circles.
    if reached < root.nodes.len() {
        return Err(Fault(format!("{} nodes are their own ancestors", root.nodes.len() - reached)));
    }

    let scene = root.scenes.get(root.scene.map_or(0, |scene| scene.value()));
    let tops = scene.map_or(tops, |scene| scene.nodes.iter().map(|node| node.value()).collect());
    if let Some(inner) = tops.iter().find(|&&i| has_parent[i]) {
        return Err(Fault(format!("node {inner} is in the scene and has a parent")));
    }
    let mut seen = vec![false; root.nodes.len()];
    if let Some(twice) = tops.iter().find(|&&i| std::mem::replace(&mut seen[i], true)) {
        return Err(Fault(format!("node {twice} is in the scene twice")));
    }
    let mut placed = Vec::new();
    let mut stack: Vec<(usize, Option<Mat4>)> = tops.into_iter().rev().map(|i| (i, None)).collect();
    while let Some((i, world_from_parent)) = stack.pop() {
        let parent_from_node = local(&root.nodes[i], i)?;
        // A node without a parent keeps its own matrix to the bit, signs of zeros included.
        let world_from_node = world_from_parent.map_or(parent_from_node, |w| w * parent_from_node);
        if !world_from_node.is_finite() {
            return Err(Fault(format!("node {i} stands where numbers are not finite")));
        }
        placed.push((i, world_from_node));
        let first = stack.len();
        stack.extend(children(i).map(|child| (child, Some(world_from_node))));
        stack[first..].reverse();
    }
    Ok(placed)
}

/// `parent_from_node`: the node's matrix, or its translation, rotation and scale.
fn local(node: &Node, i: usize) -> Result<Mat4, Fault> {
    let matrix = match node.matrix {
        Some(columns) => Mat4::from_cols_array(&columns),
        None => {
            let [x, y, z, w] = node.rotation.map_or([0.0, 0.0, 0.0, 1.0], |rotation| rotation.0);
            let rotation = Quat::from_xyzw(x, y, z, w);
            let length = rotation.length();
            // Also true for NaN.
            if !(length > 1e-6 && length.is_finite()) {
                return Err(Fault(format!("the rotation of node {i} is {rotation}, need a unit quaternion")));
            }
            let scale = node.scale.map_or(Vec3::ONE, Vec3::from);
            let translation = node.translation.map_or(Vec3::ZERO, Vec3::from);
            Mat4::from_scale_rotation_translation(scale, rotation * length.recip(), translation)
        }
    };
    if !matrix.is_finite() {
        return Err(Fault(format!("the matrix of node {i} is not finite")));
    }
    if matrix.row(3).to_array() != [0.0, 0.0, 0.0, 1.0] {
        return Err(Fault(format!(
            "the last row of the matrix of node {i} is {}, need 0 0 0 1",
            matrix.row(3)
        )));
    }
    Ok(matrix)
}

/// The transform without scale, skew and mirroring, for cameras and lights: −Z and the place stay what they are. One
/// that is rigid already is kept to the bit. `None` where there is no direction left.
pub(super) fn rigid(matrix: Mat4) -> Option<Mat4> {
    let axes = Mat3::from_mat4(matrix);
    let error = axes.transpose() * axes - Mat3::IDENTITY;
    let largest = error.to_cols_array().into_iter().fold(0.0, |most: f32, e| most.max(e.abs()));
    if largest <= RIGID_TOLERANCE && axes.determinant() > 0.0 {
        return Some(matrix);
    }
    let z = axes.z_axis.try_normalize()?;
    let x = axes.y_axis.cross(z).try_normalize().unwrap_or_else(|| z.any_orthonormal_vector());
    let y = z.cross(x);
    Some(Mat4::from_cols(x.extend(0.0), y.extend(0.0), z.extend(0.0), matrix.w_axis))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_scaled_and_mirrored_camera_keeps_its_place_and_view() {
        let turned = Mat4::from_rotation_translation(Quat::from_rotation_y(1.0), Vec3::new(1.0, 2.0, 3.0));
        let pose = rigid(turned * Mat4::from_scale(Vec3::new(-2.0, 3.0, 0.5))).unwrap();
        assert!(pose.abs_diff_eq(turned, 1e-5), "{pose} against {turned}");
        assert_eq!(rigid(turned), Some(turned));
        assert_eq!(rigid(Mat4::from_scale(Vec3::ZERO)), None);
    }
}
