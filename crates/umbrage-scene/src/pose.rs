//! How a scene stands at one time: where its nodes are, which of them are seen, and how its meshes are bent.

use glam::{DMat4, DVec3, Mat4, Vec3};

use crate::rig::{Channel, Place, Rig, Track};
use crate::{Instance, Scene};

/// A pose is how a scene stands at one time. Whoever draws or traces a scene takes one; poses of different scenes are not to
/// be mixed.
#[derive(Debug, Default, PartialEq)]
pub struct Pose {
    /// The time after the start, seconds.
    pub seconds: f32,
    /// Where each node of the rig stands in the world.
    world_from_node: Vec<DMat4>,
    /// Whether what hangs on each node is seen.
    visible: Vec<bool>,
    /// The weights of morph targets at each node.
    weights: Vec<Vec<f32>>,
}

impl Clone for Pose {
    fn clone(&self) -> Self {
        let Self { seconds, world_from_node, visible, weights } = self;
        let (world_from_node, visible) = (world_from_node.clone(), visible.clone());
        Self { seconds: *seconds, world_from_node, visible, weights: weights.clone() }
    }

    /// Takes on another pose in the room that there is: whoever keeps a pose of a rig takes on one a frame.
    fn clone_from(&mut self, other: &Self) {
        let Self { seconds, world_from_node, visible, weights } = self;
        *seconds = other.seconds;
        world_from_node.clone_from(&other.world_from_node);
        visible.clone_from(&other.visible);
        weights.clone_from(&other.weights);
    }
}

impl Pose {
    /// Returns the pose, `seconds` after the start, of a scene without a rig.
    pub fn at(seconds: f32) -> Self {
        Self { seconds, ..Self::default() }
    }

    /// Returns where a node of the rig stands in the world.
    pub fn world_from_node(&self, node: usize) -> DMat4 {
        self.world_from_node.get(node).copied().unwrap_or(DMat4::IDENTITY)
    }

    /// Returns whether what hangs on a node is seen and casts shadows.
    pub fn is_visible(&self, node: usize) -> bool {
        self.visible.get(node).copied().unwrap_or(true)
    }

    /// Returns the weights of the morph targets of the mesh that hangs on a node; fewer than there are targets where the
    /// others are 0.
    pub fn weights(&self, node: usize) -> &[f32] {
        self.weights.get(node).map_or(&[], Vec::as_slice)
    }

    /// Returns the matrices that take a mesh's vertices to the space of its instance, one for each joint of the skin that
    /// bends it.
    ///
    /// A skinned instance stands where its first joint has its origin, and is not turned
    /// ([`Motion::Skin`](crate::Motion::Skin)), so these are fine however far the skeleton stands from the scene's origin.
    pub fn joints<'a>(&'a self, rig: &'a Rig, skin: usize) -> impl ExactSizeIterator<Item = Mat4> + 'a {
        self.exact_joints(rig, skin).map(|joint| joint.as_mat4())
    }

    /// The same as [`Self::joints`], before they are rounded.
    pub(crate) fn exact_joints<'a>(
        &'a self,
        rig: &'a Rig,
        skin: usize,
    ) -> impl ExactSizeIterator<Item = DMat4> + 'a {
        let joints = rig.skins.get(skin).map_or(&[][..], |skin| &skin.joints);
        let place = joints.first().map_or(DVec3::ZERO, |(node, _)| self.place(*node));
        let instance_from_world = DMat4::from_translation(-place);
        joints.iter().map(move |(node, joint_from_mesh)| {
            instance_from_world * self.world_from_node(*node) * joint_from_mesh.as_dmat4()
        })
    }

    /// Where a node has its origin, as an instance can stand there: rounded to f32.
    pub(crate) fn place(&self, node: usize) -> DVec3 {
        self.world_from_node(node).w_axis.truncate().as_vec3().as_dvec3()
    }
}

/// A scale that is a smaller share of the largest of its node, or of this number, is kept at this share: what has shrunk to
/// nothing keeps an inverse that f32 can hold, and is too thin to be seen.
const LEAST_SCALE: f32 = 1e-4;

/// What stands farther out than this, metres, or is stretched more, is not seen: f32 does not hold the squares.
const FARTHEST: f64 = 1e15;

impl Rig {
    /// Returns how the rig stands `seconds` after the start, as the animation that plays moves it.
    pub fn pose(&self, seconds: f32) -> Pose {
        self.pose_of(self.playing, seconds)
    }

    /// Returns how the rig stands `seconds` after the start of an animation; at rest where `animation` is `None` or there is no
    /// such animation.
    pub fn pose_of(&self, animation: Option<usize>, seconds: f32) -> Pose {
        let mut still = Stand {
            places: self.nodes.iter().map(|node| node.rest).collect(),
            visible: self.nodes.iter().map(|node| node.visible).collect(),
            weights: self.nodes.iter().map(|node| node.weights.clone()).collect(),
        };
        if let Some(animation) = animation.and_then(|index| self.animations.get(index)) {
            let time = animation.local_time(seconds);
            for Channel { node, track } in &animation.channels {
                still.set(*node, track, time);
            }
        }
        let Stand { places, mut visible, weights } = still;
        let mut world_from_node: Vec<DMat4> = Vec::with_capacity(self.nodes.len());
        for (i, node) in self.nodes.iter().enumerate() {
            let parent_from_node = thick(places[i]).matrix();
            let parent = node.parent.filter(|parent| *parent < i);
            let stands = parent.map_or(parent_from_node, |parent| world_from_node[parent] * parent_from_node);
            let is_somewhere = stands.abs_diff_eq(DMat4::ZERO, FARTHEST);
            visible[i] &= is_somewhere && parent.is_none_or(|parent| visible[parent]);
            world_from_node.push(if is_somewhere { stands } else { DMat4::IDENTITY });
        }
        Pose { seconds, world_from_node, visible, weights }
    }
}

/// How each node stands in its parent.
struct Stand {
    places: Vec<Place>,
    visible: Vec<bool>,
    weights: Vec<Vec<f32>>,
}

impl Stand {
    /// Moves a property of a node to where a track has it at a time.
    fn set(&mut self, node: usize, track: &Track, time: f32) {
        let Some(place) = self.places.get_mut(node) else {
            return;
        };
        match (track, place) {
            (Track::Translation(curve), Place::Parts { translation, .. }) => {
                *translation = curve.at_as(time, |at| at.as_dvec3());
            }
            (Track::Rotation(curve), Place::Parts { rotation, .. }) => *rotation = curve.at(time),
            (Track::Scale(curve), Place::Parts { scale, .. }) => *scale = curve.at(time),
            (Track::Translation(_) | Track::Rotation(_) | Track::Scale(_), Place::Matrix(_)) => {}
            (Track::Weights(curve), _) => self.weights[node] = curve.at(time),
            (Track::Visible(curve), _) => self.visible[node] = curve.at(time),
        }
    }
}

/// The place with no scale of nothing.
fn thick(mut place: Place) -> Place {
    if let Place::Parts { scale, .. } = &mut place {
        let least = scale.abs().max_element().max(LEAST_SCALE) * LEAST_SCALE;
        *scale = scale.abs().max(Vec3::splat(least)).copysign(*scale);
    }
    place
}

impl Scene {
    /// Returns how the scene stands `seconds` after the start.
    pub fn pose(&self, seconds: f32) -> Pose {
        self.rig.pose(seconds)
    }
}

impl Instance {
    /// Returns whether the instance is seen, and casts shadows, in a pose.
    pub fn is_visible_in(&self, pose: &Pose) -> bool {
        self.node.is_none_or(|node| pose.is_visible(node))
    }
}

#[cfg(test)]
mod tests {
    use glam::Quat;

    use super::*;
    use crate::curve::{Curve, Keys};
    use crate::rig::{Animation, Node, Skin};
    use crate::{Instance, Motion};

    fn node(parent: Option<usize>, x: f64) -> Node {
        let rest = Place::Parts { translation: DVec3::X * x, rotation: Quat::IDENTITY, scale: Vec3::ONE };
        Node { name: String::new(), parent, rest, visible: true, weights: vec![0.5] }
    }

    /// Two nodes on top of each other; the first rises 1 m a second for two seconds, and hides the second half.
    fn rig() -> Rig {
        let rise = Curve::new(vec![0.0, 2.0], Keys::Linear(vec![Vec3::ZERO, Vec3::Y * 2.0])).unwrap();
        let hide = Curve::new(vec![0.0, 1.0], Keys::Step(vec![true, false])).unwrap();
        let channels = [Track::Translation(rise), Track::Visible(hide)];
        let channels = channels.map(|track| Channel { node: 0, track }).into();
        Rig {
            nodes: vec![node(None, 3.0), node(Some(0), 1.0)],
            skins: vec![Skin { joints: vec![(0, Mat4::IDENTITY), (1, Mat4::from_translation(Vec3::NEG_X))] }],
            animations: vec![Animation { name: "rise".to_owned(), seconds: 2.0, channels }],
            playing: Some(0),
        }
    }

    #[test]
    fn children_follow_and_hide_with_their_parents_and_animations_begin_again() {
        let rig = rig();
        for (seconds, y, visible) in [(0.0, 0.0, true), (0.5, 0.5, true), (1.5, 1.5, false), (2.5, 0.5, true)]
        {
            let pose = rig.pose(seconds);
            assert_eq!(pose.world_from_node(1).w_axis.truncate(), DVec3::new(1.0, y, 0.0), "{seconds} s");
            assert_eq!(pose.is_visible(1), visible, "{seconds} s");
            assert_eq!(pose.weights(1), [0.5]);
        }
        let still = Rig { playing: None, ..rig };
        assert_eq!(still.pose(0.5).world_from_node(1).w_axis.truncate(), DVec3::X * 4.0);
    }

    #[test]
    fn what_shrinks_to_nothing_keeps_an_inverse_and_what_flies_away_is_not_seen() {
        let mut rig = rig();
        for (scale, want) in
            [(Vec3::ZERO, Vec3::splat(1e-8)), (Vec3::new(2.0, 0.0, -1e-6), Vec3::new(2.0, 2e-4, -2e-4))]
        {
            rig.nodes[0].rest = Place::Parts { translation: DVec3::ZERO, rotation: Quat::IDENTITY, scale };
            let stands = rig.pose(0.0).world_from_node(0).as_mat4();
            assert!(stands.inverse().is_finite(), "{scale}");
            let got = Vec3::new(stands.x_axis.x, stands.y_axis.y, stands.z_axis.z);
            assert!(got.abs_diff_eq(want, 1e-9), "{got} of {scale}");
        }
        for away in [DVec3::X * 1e16, DVec3::NAN] {
            rig.nodes[1].rest = Place::Matrix(DMat4::from_translation(away));
            let pose = rig.pose(0.0);
            assert!(
                pose.is_visible(0) && !pose.is_visible(1) && pose.world_from_node(1).is_finite(),
                "{away}"
            );
        }
    }

    #[test]
    fn an_animation_is_found_by_its_name_or_by_its_number() {
        let mut rig = rig();
        rig.animations.push(Animation { name: "0".to_owned(), seconds: 1.0, channels: Vec::new() });
        let found = ["Rise", "0", "1", "2", "", "none"].map(|wanted| rig.find(wanted));
        assert_eq!(found, [Some(0), Some(1), Some(1), None, None, None]);
        let played = ["1", "NONE", "nobody", "rise"].map(|wanted| (rig.play(wanted), rig.playing));
        assert_eq!(played, [(true, Some(1)), (true, None), (false, None), (true, Some(0))]);
        assert_eq!(rig.pose_of(None, 1.5).world_from_node(0).w_axis.y, 0.0);
        assert_eq!(rig.pose_of(Some(0), 1.5).world_from_node(0).w_axis.y, 1.5);
    }

    #[test]
    fn a_skinned_instance_stands_at_its_first_joint_and_its_joints_are_relative_to_that() {
        let rig = rig();
        let pose = rig.pose(0.5);
        let motion = Motion::Skin { node: 0 };
        let instance = Instance { motion, node: Some(0), ..Instance::still(0, Mat4::IDENTITY) };
        assert_eq!(instance.world_from_mesh_in(&pose), Mat4::from_translation(Vec3::new(0.0, 0.5, 0.0)));
        let joints: Vec<Mat4> = pose.joints(&rig, 0).collect();
        assert_eq!(joints, [Mat4::IDENTITY, Mat4::IDENTITY]);
    }
}
