//! A tree over boxes, which finds those that matter to a question without looking at all of them, and is refitted where boxes
//! move.
//!
//! It is binary, all leaves are equally deep, and each has as many boxes as any other, give or take one. So children, and the
//! boxes below a node, are arithmetic, and nothing but a box is kept of a node: node n has the children 2n and 2n + 1, and the
//! k-th node of the 2^d at a depth d holds the places from ⌊k · boxes / 2^d⌋ to ⌊(k + 1) · boxes / 2^d⌋ of the order. The order
//! is that of the boxes' middles along a curve that fills space (Morton 1966), so that building it is sorting.

use std::ops::Range;

use arrayvec::ArrayVec;
use glam::Vec3;

use crate::bounds::Aabb;

/// A leaf has at most so many boxes.
const LEAF: usize = 8;
/// Trees are less deep than this: there are no more than 2^32 boxes.
const DEEPEST: usize = 34;
/// Where nodes have grown to so many times the surface that they were built with, a new tree is better.
const OUTGROWN: f64 = 2.0;

/// A tree over boxes that somebody else keeps. Boxes that hold nothing are in it, and are never found.
#[derive(Clone, Debug, Default)]
pub(crate) struct Tree {
    depth: u32,
    /// The box around all below each node. The root is 1.
    nodes: Vec<Aabb>,
    /// The numbers of all boxes, leaf by leaf.
    order: Vec<u32>,
    /// Room to sort them in.
    sorted: Vec<(u64, u32)>,
    /// The node that each box is a leaf's of.
    leaves: Vec<u32>,
    /// The surface of all nodes when it was built, in half square metres.
    built: f64,
    /// How many boxes moved since it was last compared with that.
    moved: usize,
    /// Nodes to be refitted, children before parents, and whether each is among them.
    stale: Vec<u32>,
    is_stale: Vec<bool>,
}

/// What is to be done below a node.
pub(crate) enum Below<State> {
    /// Nothing there matters.
    Nothing,
    /// Its children are to be looked at, knowing this.
    Some(State),
    /// All boxes there are to be taken, knowing this.
    All(State),
}

/// Somebody who looks for boxes.
pub(crate) trait Search {
    /// What is known of a node and holds for all below it.
    type State: Copy;

    /// Looks at the box around all below a node.
    fn node(&mut self, around: &Aabb, state: Self::State) -> Below<Self::State>;

    /// Takes boxes, by their numbers; some of them may hold nothing.
    fn boxes(&mut self, numbers: &[u32], state: Self::State);
}

impl Tree {
    /// The tree over some boxes.
    pub fn of(boxes: &[Aabb]) -> Self {
        let mut tree = Self::default();
        tree.build(boxes);
        tree
    }

    /// The box around all.
    pub fn root(&self) -> Aabb {
        self.nodes.get(1).copied().unwrap_or(Aabb::EMPTY)
    }

    /// Shows a search what may matter to it, beginning with this state.
    pub fn search<S: Search>(&self, search: &mut S, state: S::State) {
        let mut open = ArrayVec::<(usize, S::State), DEEPEST>::new();
        if !self.nodes.is_empty() {
            open.push((1, state));
        }
        while let Some((node, state)) = open.pop() {
            let around = &self.nodes[node];
            if around.is_empty() {
                continue;
            }
            match search.node(around, state) {
                Below::Nothing => {}
                Below::All(state) => search.boxes(&self.order[self.places(node)], state),
                Below::Some(state) if node >> self.depth != 0 => {
                    search.boxes(&self.order[self.places(node)], state);
                }
                Below::Some(state) => {
                    open.push((2 * node + 1, state));
                    open.push((2 * node, state));
                }
            }
        }
    }

    /// Notes that a box has moved; [`Self::refit`] must follow.
    pub fn note(&mut self, number: usize) {
        let leaf = self.leaves[number];
        self.moved += 1;
        note(&mut self.stale, &mut self.is_stale, leaf);
    }

    /// Fits the tree to boxes of which those that were noted have moved. What has become too loose is built anew.
    pub fn refit(&mut self, boxes: &[Aabb]) {
        let mut next = 0;
        while let Some(&node) = self.stale.get(next) {
            next += 1;
            self.is_stale[node as usize] = false;
            self.nodes[node as usize] = self.around(node as usize, boxes);
            if node > 1 {
                note(&mut self.stale, &mut self.is_stale, node / 2);
            }
        }
        self.stale.clear();
        // Looking at all nodes costs less than half of the boxes did.
        if 2 * self.moved >= boxes.len() {
            self.moved = 0;
            if self.surface() > OUTGROWN * self.built {
                self.build(boxes);
            }
        }
    }

    /// Builds the tree anew, in the room that it has.
    fn build(&mut self, boxes: &[Aabb]) {
        self.nodes.clear();
        self.order.clear();
        sort(boxes, &mut self.sorted);
        self.order.extend(self.sorted.iter().map(|(_, number)| *number));
        if boxes.is_empty() {
            return;
        }
        self.depth = boxes.len().div_ceil(LEAF).next_power_of_two().ilog2();
        self.nodes.resize(2 << self.depth, Aabb::EMPTY);
        self.is_stale.resize(self.nodes.len(), false);
        self.leaves.resize(boxes.len(), 0);
        for node in (1..self.nodes.len()).rev() {
            self.nodes[node] = self.around(node, boxes);
            if node >> self.depth != 0 {
                for place in self.places(node) {
                    self.leaves[self.order[place] as usize] = node as u32;
                }
            }
        }
        self.built = self.surface();
    }

    /// Where the boxes below a node are in the order.
    fn places(&self, node: usize) -> Range<usize> {
        let depth = node.ilog2();
        let at = |k: usize| ((k as u64 * self.order.len() as u64) >> depth) as usize;
        let k = node - (1 << depth);
        at(k)..at(k + 1)
    }

    /// The box around what is below a node whose children are right.
    fn around(&self, node: usize, boxes: &[Aabb]) -> Aabb {
        if node >> self.depth == 0 {
            return self.nodes[2 * node].union(self.nodes[2 * node + 1]);
        }
        let below = self.order[self.places(node)].iter().map(|number| boxes[*number as usize]);
        below.filter(|aabb| !aabb.is_empty()).fold(Aabb::EMPTY, Aabb::union)
    }

    /// The surface of all nodes, in half square metres.
    fn surface(&self) -> f64 {
        let filled = self.nodes.iter().filter(|aabb| !aabb.is_empty());
        let half = filled.map(|aabb| {
            let side = (aabb.max - aabb.min).as_dvec3();
            side.x * side.y + side.y * side.z + side.z * side.x
        });
        half.sum()
    }
}

/// Puts a node behind the others that are to be refitted, once.
fn note(stale: &mut Vec<u32>, is_stale: &mut [bool], node: u32) {
    if !std::mem::replace(&mut is_stale[node as usize], true) {
        stale.push(node);
    }
}

/// Sorts boxes by their middles' places on the curve. Those that hold nothing come last.
fn sort(boxes: &[Aabb], sorted: &mut Vec<(u64, u32)>) {
    let middles = || boxes.iter().map(|aabb| aabb.middle());
    let around = |(min, max): (Vec3, Vec3), p| (min.min(p), max.max(p));
    let (min, max) = middles().flatten().fold((Vec3::INFINITY, Vec3::NEG_INFINITY), around);
    // As fine along all axes: a flat world is cut where it is wide.
    let scale = CELLS / (max - min).max_element();
    sorted.clear();
    sorted.extend((0..).zip(middles()).map(|(number, middle)| {
        let code = middle.map_or(u64::MAX, |middle| {
            let [x, y, z] = ((middle - min) * scale).to_array().map(|cell| spread(cell as u64));
            x | y << 1 | z << 2
        });
        (code, number)
    }));
    sorted.sort_unstable();
}

/// The cells along an axis.
const CELLS: f32 = 2_097_151.0;

/// The 21 lowest bits of a number, with two of nothing behind each.
fn spread(number: u64) -> u64 {
    let steps = [
        (32, 0x1f_0000_0000_ffff),
        (16, 0x1f_0000_ff00_00ff),
        (8, 0x100f_00f0_0f00_f00f),
        (4, 0x10c3_0c30_c30c_30c3),
        (2, 0x1249_2492_4924_9249),
    ];
    steps.into_iter().fold(number & 0x1f_ffff, |bits, (by, mask)| (bits | bits << by) & mask)
}

#[cfg(test)]
impl Tree {
    /// A tree of one leaf, in the order of the boxes.
    pub(crate) fn flat(boxes: &[Aabb]) -> Self {
        let mut tree = Self {
            nodes: vec![Aabb::EMPTY; 2],
            order: (0..boxes.len() as u32).collect(),
            leaves: vec![1; boxes.len()],
            is_stale: vec![false; 2],
            ..Self::default()
        };
        tree.nodes[1] = tree.around(1, boxes);
        tree
    }
}
