//! What makes a scene move as its file says: a tree of nodes, the animations that move them, and the skins that follow them.
//!
//! Only nodes that something which moves or bends hangs on are here; everything else of a file stands where its instance
//! says. Places are f64, so that a rig that stands far from the origin moves smoothly.
//!
//! Source: glTF 2.0, sections 3.7.3, *Skins*, and 3.11, *Animations*; `KHR_node_visibility`, `KHR_animation_pointer`.

use glam::{DMat4, DVec3, Mat4, Quat, Vec3};

use crate::curve::Curve;

/// A rig is what poses of a scene are made from; most scenes have an empty one.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rig {
    /// The nodes, each after its parent.
    pub nodes: Vec<Node>,
    /// The skins, which instances refer to.
    pub skins: Vec<Skin>,
    /// The animations, in the file's order.
    pub animations: Vec<Animation>,
    /// The index of the animation that plays; `None` where all nodes stand as they are at rest.
    pub playing: Option<usize>,
}

/// A node is a place that moves with its parent.
#[derive(Clone, Debug, PartialEq)]
pub struct Node {
    /// The name that the file gives the node; empty where it gives none.
    pub name: String,
    /// The index of the node that this one moves with, which is less than its own; `None` where it stands in the world.
    pub parent: Option<usize>,
    /// Where the node stands in its parent, or in the world, while nothing moves it.
    pub rest: Place,
    /// Whether what hangs on the node is seen, and casts shadows, while no animation says otherwise. What hangs on a hidden
    /// node is hidden, too.
    pub visible: bool,
    /// The weights of the morph targets of the mesh that hangs on the node, while no animation says otherwise.
    pub weights: Vec<f32>,
}

/// A place is a transform whose parts animations can move one by one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Place {
    /// Scaled, then turned, then moved, in metres.
    Parts {
        /// Where the node's origin is, metres.
        translation: DVec3,
        /// How the node is turned; a unit quaternion.
        rotation: Quat,
        /// How the node's axes are stretched.
        scale: Vec3,
    },
    /// A matrix, which no animation moves.
    Matrix(DMat4),
}

/// A skin says which nodes bend a mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Skin {
    /// The joints: each a node, and the transform from the mesh's space to the node's as they were when the skin was bound.
    pub joints: Vec<(usize, Mat4)>,
}

/// An animation moves nodes for a while, and then begins again.
#[derive(Clone, Debug, PartialEq)]
pub struct Animation {
    /// The name that the file gives the animation; empty where it gives none.
    pub name: String,
    /// The time after which the animation begins again, seconds; 0 where it shows one pose only.
    pub seconds: f32,
    /// The channels, each of which moves one property of one node.
    pub channels: Vec<Channel>,
}

/// A channel moves one property of one node.
#[derive(Clone, Debug, PartialEq)]
pub struct Channel {
    /// The index of the node in [`Rig::nodes`].
    pub node: usize,
    /// What of it moves, and how.
    pub track: Track,
}

/// A track is a property of a node over time.
#[derive(Clone, Debug, PartialEq)]
pub enum Track {
    /// Where the node's origin is in its parent, metres.
    Translation(Curve<Vec3>),
    /// How the node is turned in its parent.
    Rotation(Curve<Quat>),
    /// How the node's axes are stretched.
    Scale(Curve<Vec3>),
    /// The weights of the morph targets of the node's mesh.
    Weights(Curve<Vec<f32>>),
    /// Whether what hangs on the node is seen.
    Visible(Curve<bool>),
}

impl Track {
    /// Returns the times of the keys, seconds.
    pub fn times(&self) -> &[f32] {
        match self {
            Self::Translation(curve) | Self::Scale(curve) => curve.times(),
            Self::Rotation(curve) => curve.times(),
            Self::Weights(curve) => curve.times(),
            Self::Visible(curve) => curve.times(),
        }
    }

    /// Returns whether the track moves its node, rather than hiding what hangs on it or morphing that.
    pub fn is_of_place(&self) -> bool {
        match self {
            Self::Translation(_) | Self::Rotation(_) | Self::Scale(_) => true,
            Self::Weights(_) | Self::Visible(_) => false,
        }
    }
}

impl Place {
    /// The place of a node that stands in its parent's origin.
    pub const HERE: Self =
        Self::Parts { translation: DVec3::ZERO, rotation: Quat::IDENTITY, scale: Vec3::ONE };

    /// Returns the transform as a matrix.
    pub fn matrix(&self) -> DMat4 {
        match *self {
            Self::Parts { translation, rotation, scale } => {
                DMat4::from_scale_rotation_translation(scale.as_dvec3(), rotation.as_dquat(), translation)
            }
            Self::Matrix(matrix) => matrix,
        }
    }
}

impl Rig {
    /// Lets the animation play that someone means: by its name, whatever case its letters have, or else by its number from 0,
    /// or none by the word `none`. Returns whether there is such an animation; if not, the same plays as before.
    pub fn play(&mut self, wanted: &str) -> bool {
        match self.find(wanted) {
            Some(found) => self.playing = Some(found),
            None if wanted.eq_ignore_ascii_case("none") => self.playing = None,
            None => return false,
        }
        true
    }

    /// Returns the index of the animation that someone means, as [`Self::play`] does; `None` where there is no such one.
    pub fn find(&self, wanted: &str) -> Option<usize> {
        let is_meant =
            |animation: &Animation| !animation.name.is_empty() && animation.name.eq_ignore_ascii_case(wanted);
        let number = || wanted.parse().ok().filter(|number| *number < self.animations.len());
        self.animations.iter().position(is_meant).or_else(number)
    }
}

impl Animation {
    /// Returns the animation's own time `seconds` after the start: it begins again when it is over.
    pub fn local_time(&self, seconds: f32) -> f32 {
        if self.seconds > 0.0 && seconds.is_finite() { seconds.rem_euclid(self.seconds) } else { 0.0 }
    }
}
