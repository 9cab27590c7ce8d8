//! The node tree: which nodes are in the scene, and where they stand, in f64.
//!
//! No recursion: a file may nest its nodes as deep as it likes. A tree that is none is mended, with a warning: a node is
//! drawn once, under the first parent that names it.

use glam::{DMat3, DMat4, DVec3};
use gltf::json::Root;

use super::transforms::Transform;
use crate::import::warnings::Warnings;

/// The shape of the forest: the children of each node, and whether it has a parent.
struct Forest {
    children: Vec<Vec<usize>>,
    has_parent: Vec<bool>,
}

/// A node that the scene places.
#[derive(Clone, Debug)]
pub(super) struct Walked {
    /// The node's number in the file.
    pub node: usize,
    /// The place of its parent in the walk; `None` for an outermost node.
    pub parent: Option<usize>,
    /// Where the node stands while nothing moves it.
    pub world_from_node: DMat4,
}

/// The nodes of the default scene (the first where none is the default, all where there are no scenes), parents before
/// children and otherwise in the file's order. The world's origin is at `origin` in the file: it is taken from the
/// outermost nodes, before anything is added to them.
pub(super) fn walk(
    root: &Root,
    transforms: &[Result<Transform, String>],
    origin: DVec3,
    warnings: &mut Warnings,
) -> Vec<Walked> {
    let forest = Forest::new(root, warnings);
    let tops = forest.tops(root, warnings);
    let mut placed: Vec<Walked> = Vec::new();
    let mut is_placed = vec![false; root.nodes.len()];
    let top_from_file = DMat4::from_translation(-origin);
    let mut stack: Vec<(usize, Option<usize>)> = tops.into_iter().rev().map(|i| (i, None)).collect();
    while let Some((i, parent)) = stack.pop() {
        if std::mem::replace(&mut is_placed[i], true) {
            continue;
        }
        let world_from_parent = parent.map_or(top_from_file, |parent| placed[parent].world_from_node);
        let world_from_node = match transforms.get(i) {
            Some(Ok(transform)) => {
                for ignored in &transform.ignored {
                    warnings.note("parts of transforms are ignored", &format!("{ignored}, node {i}"));
                }
                then(world_from_parent, transform.parent_from_node)
            }
            Some(Err(why)) => {
                let what = "nodes that stand nowhere are left out, with all that hangs on them";
                warnings.note(what, &format!("node {i}, {why}"));
                continue;
            }
            None => world_from_parent,
        };
        if !world_from_node.is_finite() {
            let what = "nodes that stand nowhere are left out, with all that hangs on them";
            warnings.note(what, &format!("node {i}, numbers that are not finite"));
            continue;
        }
        placed.push(Walked { node: i, parent, world_from_node });
        let (first, own) = (stack.len(), Some(placed.len() - 1));
        stack.extend(forest.children[i].iter().map(|&child| (child, own)));
        stack[first..].reverse();
    }
    placed
}

impl Forest {
    fn new(root: &Root, warnings: &mut Warnings) -> Self {
        let mut has_parent = vec![false; root.nodes.len()];
        let mut children = Vec::with_capacity(root.nodes.len());
        for node in &root.nodes {
            let mut own = Vec::new();
            for child in node.children.iter().flatten().map(|child| child.value()) {
                if std::mem::replace(&mut has_parent[child], true) {
                    let what = "nodes that several nodes list are drawn once, under the first";
                    warnings.note(what, &format!("node {child}"));
                } else {
                    own.push(child);
                }
            }
            children.push(own);
        }
        Self { children, has_parent }
    }

    /// The outermost nodes of the scene, each once, none under another.
    fn tops(&self, root: &Root, warnings: &mut Warnings) -> Vec<usize> {
        let all = 0..root.nodes.len();
        let scene = root.scenes.get(root.scene.map_or(0, |scene| scene.value()));
        let listed: Vec<usize> = match scene {
            Some(scene) if !scene.nodes.is_empty() => scene.nodes.iter().map(|node| node.value()).collect(),
            Some(_) | None => {
                if scene.is_some() && !root.nodes.is_empty() {
                    warnings.note(
                        "a scene that lists no node is drawn with all of the file",
                        "the default scene",
                    );
                }
                return self.roots(all, warnings);
            }
        };
        let mut is_listed = vec![false; root.nodes.len()];
        let mut once = Vec::with_capacity(listed.len());
        for node in listed {
            if std::mem::replace(&mut is_listed[node], true) {
                warnings.note("nodes that the scene lists twice are drawn once", &format!("node {node}"));
            } else {
                once.push(node);
            }
        }
        let below = self.below(&once);
        once.retain(|&node| {
            let label = || root.nodes[node].name.clone().unwrap_or_else(|| format!("node {node}"));
            if below[node] {
                warnings.note("nodes that the scene lists beside their parent are drawn under it", &label());
            } else if self.has_parent[node] {
                let what = "nodes that the scene lists without their parent are drawn without its transform";
                warnings.note(what, &label());
            }
            !below[node]
        });
        once
    }

    /// Whether each node hangs, at any depth, on one of these.
    fn below(&self, tops: &[usize]) -> Vec<bool> {
        let mut below = vec![false; self.children.len()];
        let mut is_open = vec![false; self.children.len()];
        for &top in tops {
            let mut stack = vec![top];
            while let Some(node) = stack.pop() {
                // A node has one parent, so no path is walked twice unless it is a circle or leads to another top.
                if std::mem::replace(&mut is_open[node], true) {
                    continue;
                }
                for &child in &self.children[node] {
                    // In a circle, the listed node is where it begins.
                    below[child] |= child != top;
                    stack.push(child);
                }
            }
        }
        below
    }

    /// The nodes without parents, and one of each circle.
    fn roots(&self, all: std::ops::Range<usize>, warnings: &mut Warnings) -> Vec<usize> {
        let mut roots: Vec<usize> = all.clone().filter(|&i| !self.has_parent[i]).collect();
        let mut reached = vec![false; all.len()];
        let mark = |from: usize, reached: &mut Vec<bool>| {
            let mut stack = vec![from];
            while let Some(node) = stack.pop() {
                if !std::mem::replace(&mut reached[node], true) {
                    stack.extend(&self.children[node]);
                }
            }
        };
        for &root in &roots {
            mark(root, &mut reached);
        }
        for node in all {
            if !reached[node] {
                let what = "nodes that are their own ancestors are drawn as if they had no parent";
                warnings.note(what, &format!("node {node}"));
                roots.push(node);
                mark(node, &mut reached);
            }
        }
        roots
    }
}

/// One transform after the other. Where the outer one only moves, the inner one keeps its bits, signs of zeros included.
pub(super) fn then(outer: DMat4, inner: DMat4) -> DMat4 {
    if DMat3::from_mat4(outer) != DMat3::IDENTITY {
        return outer * inner;
    }
    let moved = |by: f64, from: f64| if by == 0.0 { from } else { by + from };
    let mut sum = inner;
    for axis in 0..3 {
        sum.w_axis[axis] = moved(outer.w_axis[axis], inner.w_axis[axis]);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_only_moves_keeps_bits() {
        let inner = DMat4::from_cols_array(&[
            -0.0, 1.0, 0.0, 0.0, 1.0, -0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, -0.0, 0.1, 3.0, 1.0,
        ]);
        let bits = |m: DMat4| m.to_cols_array().map(f64::to_bits);
        assert_eq!(bits(then(DMat4::IDENTITY, inner)), bits(inner));
        let there = then(DMat4::from_translation(-DVec3::X), then(DMat4::from_translation(DVec3::X), inner));
        assert_eq!(there.w_axis.y.to_bits(), inner.w_axis.y.to_bits());
    }
}
