//! Which joints bend the vertices of a primitive, and how much.
//!
//! Source: glTF 2.0, section 3.7.3.3, *Skinned Mesh Attributes*.

use gltf::json::mesh::{Primitive, Semantic};
use gltf::json::validation::Checked;
use gltf::json::{Accessor, Index};

use super::accessors::Data;
use crate::Influences;
use crate::error::Fault;
use crate::import::warnings::Warnings;

/// Joints of a vertex in one set.
const A_SET: usize = 4;

/// Weights whose sum is off by more than this are said to be mended: 8-bit weights round so much, four of them.
const ROUNDING: f32 = 1.0 / 128.0;

/// Weights whose sum is off by no more than this, what f32 rounds, stay as they are.
const EXACT: f32 = 1e-6;

/// The accessors of a primitive's joints and weights, set by set.
pub(super) fn sets(primitive: &Primitive) -> Vec<[Index<Accessor>; 2]> {
    let get = |semantic| primitive.attributes.get(&Checked::Valid(semantic)).copied();
    let set = |number: u32| Some([get(Semantic::Joints(number))?, get(Semantic::Weights(number))?]);
    (0..).map_while(set).collect()
}

/// How many joints each vertex of a primitive has.
pub(super) fn per_vertex(primitive: &Primitive) -> usize {
    A_SET * sets(primitive).len()
}

/// Reads the joints of `count` vertices, which a skin of so many joints bends. Weights sum to 1 afterwards; none where they
/// cannot be read.
pub(super) fn read(
    data: &Data<'_>,
    sets: &[[Index<Accessor>; 2]],
    (count, joints): (usize, usize),
    mesh: &str,
    warnings: &mut Warnings,
) -> Influences {
    let unread = "meshes whose joints and weights cannot be read follow the first joint of their skin";
    let mut read = Vec::with_capacity(sets.len());
    for [joints, weights] in sets {
        let rows = |accessor: &Index<Accessor>| {
            let said = data.said(*accessor);
            if said != count {
                return Err(Fault(format!("{count} positions, and {said} rows in accessor {accessor}")));
            }
            data.vectors::<A_SET>(*accessor)
        };
        match rows(joints).and_then(|joints| Ok((joints, rows(weights)?))) {
            Ok(set) => read.push(set),
            Err(Fault(why)) => warnings.note(unread, &format!("{why}, in mesh {mesh:?}")),
        }
    }
    let mut mended = Mended::default();
    let mut influences = Influences { per_vertex: A_SET * read.len(), ..Influences::default() };
    for vertex in 0..if read.is_empty() { 0 } else { count } {
        let start = influences.weights.len();
        for (of, weights) in &read {
            for (joint, weight) in of[vertex].into_iter().zip(weights[vertex]) {
                let (joint, weight) = mended.one(joint, weight, joints);
                influences.joints.push(joint);
                influences.weights.push(weight);
            }
        }
        mended.sum(&mut influences.joints[start..], &mut influences.weights[start..]);
    }
    mended.note(count, joints, mesh, warnings);
    influences
}

/// How many vertices had to be mended, and why.
#[derive(Debug, Default)]
struct Mended {
    outside: usize,
    negative: usize,
    sums: usize,
    nothing: usize,
}

impl Mended {
    /// A joint that is there, and a weight of at least 0.
    fn one(&mut self, joint: f32, weight: f32, joints: usize) -> (u16, f32) {
        let is_weight = weight >= 0.0 && weight.is_finite();
        self.negative += usize::from(!is_weight);
        let weight = if is_weight { weight } else { 0.0 };
        if joint >= 0.0 && (joint as usize) < joints {
            return (joint as u16, weight);
        }
        self.outside += usize::from(weight > 0.0);
        (0, 0.0)
    }

    /// Makes the weights of a vertex sum to 1; those that are all 0 follow the first joint.
    fn sum(&mut self, joints: &mut [u16], weights: &mut [f32]) {
        let sum: f32 = weights.iter().sum();
        if sum > 0.0 && sum.is_finite() {
            self.sums += usize::from((sum - 1.0).abs() > ROUNDING);
            if (sum - 1.0).abs() > EXACT {
                weights.iter_mut().for_each(|weight| *weight /= sum);
            }
            return;
        }
        self.nothing += 1;
        weights.fill(0.0);
        if let ([joint, ..], [weight, ..]) = (joints, weights) {
            (*joint, *weight) = (0, 1.0);
        }
    }

    fn note(&self, count: usize, joints: usize, mesh: &str, warnings: &mut Warnings) {
        let Self { outside, negative, sums, nothing } = self;
        let mut note = |what: &'static str, how_many: usize, why: &str| {
            if how_many > 0 {
                warnings.note(what, &format!("{how_many} in mesh {mesh:?} of {count} vertices{why}"));
            }
        };
        note("joints that their skin lacks count for nothing", *outside, &format!(", its skin has {joints}"));
        note("weights of joints that are negative or not finite count for nothing", *negative, "");
        note("weights of joints that do not sum to 1 are scaled until they do", *sums, "");
        note("vertices whose joints all have weight 0 follow the first joint of their skin", *nothing, "");
    }
}

/// The joints of the corners of triangles, each a vertex of its own.
pub(super) fn at_corners(of: &Influences, corners: &[u32]) -> Influences {
    let Influences { per_vertex, joints, weights } = of;
    let range = |&i: &u32| i as usize * per_vertex..(i as usize + 1) * per_vertex;
    Influences {
        per_vertex: *per_vertex,
        joints: corners.iter().flat_map(|i| joints[range(i)].iter().copied()).collect(),
        weights: corners.iter().flat_map(|i| weights[range(i)].iter().copied()).collect(),
    }
}
