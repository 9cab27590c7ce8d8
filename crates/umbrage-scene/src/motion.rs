//! How things of a world move with time: instances and lights follow the same law.

use glam::{Mat4, Vec3};

use crate::Pose;

/// The motion of an instance or a light.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Motion {
    /// The thing stands still, the default.
    #[default]
    Still,
    /// The thing rotates about an axis through `centre`: it is a wheel where the centre is its own, and marches in a circle
    /// where the centre is far.
    Rotation {
        /// A point on the axis, in world space and metres.
        centre: Vec3,
        /// The unit direction of the axis, in world space.
        axis: Vec3,
        /// The angular velocity in radians a second, counter-clockwise seen against the axis.
        radians_per_second: f32,
    },
    /// The thing moves with a node of the scene's rig; where it stands at time 0 counts for nothing.
    Node {
        /// The index of the node in [`Rig::nodes`](crate::Rig::nodes).
        node: usize,
        /// Where the thing stands in the node.
        node_from_thing: Mat4,
    },
    /// The thing is a skinned mesh: it stands at the origin of its skin's first joint, unturned, and its joints do the rest
    /// ([`Pose::joints`]).
    Skin {
        /// The index of the first joint in [`Rig::nodes`](crate::Rig::nodes).
        node: usize,
    },
}

impl Motion {
    /// Returns where something stands in a pose, if it begins at `world_from_thing`; exactly there at 0 s, unless it moves
    /// with a rig.
    pub fn moved(&self, world_from_thing: Mat4, pose: &Pose) -> Mat4 {
        let seconds = pose.seconds;
        match *self {
            Self::Node { node, node_from_thing } => {
                (pose.world_from_node(node) * node_from_thing.as_dmat4()).as_mat4()
            }
            Self::Skin { node } => Mat4::from_translation(pose.place(node).as_vec3()),
            Self::Rotation { centre, axis, radians_per_second } if seconds != 0.0 => {
                let rotation = Mat4::from_axis_angle(axis, radians_per_second * seconds);
                Mat4::from_translation(centre) * rotation * Mat4::from_translation(-centre) * world_from_thing
            }
            Self::Rotation { .. } | Self::Still => world_from_thing,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Instance, Light};

    const QUARTER_A_SECOND: Motion = Motion::Rotation {
        centre: Vec3::ZERO,
        axis: Vec3::Y,
        radians_per_second: std::f32::consts::FRAC_PI_2,
    };

    #[test]
    fn a_quarter_rotation_about_the_origin_takes_x_to_minus_z() {
        let start = Mat4::from_translation(Vec3::X);
        assert_eq!(QUARTER_A_SECOND.moved(start, &Pose::at(0.0)), start);
        let moved = QUARTER_A_SECOND.moved(start, &Pose::at(1.0)).transform_point3(Vec3::ZERO);
        assert!((moved - Vec3::NEG_Z).length() < 1e-6, "{moved}");
    }

    #[test]
    fn what_is_still_stays() {
        let start = Mat4::from_translation(Vec3::X);
        assert_eq!(Motion::Still.moved(start, &Pose::at(7.0)), start);
    }

    #[test]
    fn a_light_carried_by_an_instance_stays_with_it() {
        let light = Light {
            motion: QUARTER_A_SECOND,
            ..Light::spot("lamp", Vec3::new(3.0, 2.0, 1.0), Vec3::ZERO, 0.2, 0.4, 9.0, 1.0)
        };
        let carrier = Instance { motion: QUARTER_A_SECOND, ..Instance::still(0, light.world_from_light) };
        for seconds in [0.0, 0.5, 3.0] {
            assert_eq!(
                light.world_from_light_in(&Pose::at(seconds)),
                carrier.world_from_mesh_in(&Pose::at(seconds))
            );
        }
    }
}
