//! How worlds move by a rig: nodes, and curves that begin again where they end.

use std::f32::consts::TAU;

use glam::{Mat4, Quat, Vec3};

use super::stage::Stage;
use crate::curve::{Curve, Keys};
use crate::rig::{Animation, Channel, Node, Place, Track};
use crate::{Between, Instance, Motion};

/// Keys of a curve that swings, for each swing: between them curves are straight.
const KEYS_A_SWING: usize = 8;

/// An animation under construction, of so many seconds.
#[derive(Debug)]
pub(super) struct Moves {
    seconds: f32,
    channels: Vec<Channel>,
}

impl Moves {
    /// Nothing moves yet.
    pub fn new(seconds: f32) -> Self {
        Self { seconds, channels: Vec::new() }
    }

    /// Moves a property of a node.
    pub fn add(&mut self, node: usize, track: Track) {
        self.channels.push(Channel { node, track });
    }

    /// A curve through `at`, which takes the share of a swing, 0 to 1, and is the same at both; `swings` of them fill the
    /// animation.
    pub fn swinging<T: Between>(&self, swings: usize, at: impl Fn(f32) -> T) -> Option<Curve<T>> {
        let count = swings * KEYS_A_SWING;
        let times = (0..=count).map(|key| self.seconds * key as f32 / count as f32).collect();
        let share = |key: usize| (key % KEYS_A_SWING) as f32 / KEYS_A_SWING as f32;
        Curve::new(times, Keys::Linear((0..=count).map(|key| at(share(key))).collect()))
    }

    /// Sways a node about an axis through `rest` by so many radians to both sides.
    pub fn sway(&mut self, node: usize, rest: Quat, axis: Vec3, radians: f32, swings: usize, phase: f32) {
        let turned = |share: f32| {
            let angle = radians * (share * TAU + phase).sin();
            Quat::from_axis_angle(axis.normalize_or(Vec3::X), angle) * rest
        };
        if let Some(curve) = self.swinging(swings, turned) {
            self.add(node, Track::Rotation(curve));
        }
    }

    /// Moves the weights of a node's morph targets.
    pub fn morph(&mut self, node: usize, swings: usize, weights: impl Fn(f32) -> Vec<f32>) {
        if let Some(curve) = self.swinging(swings, weights) {
            self.add(node, Track::Weights(curve));
        }
    }

    /// Shows and hides what hangs on a node: each of `shown` for as long as the others.
    pub fn blink(&mut self, node: usize, shown: &[bool]) {
        let times = (0..shown.len()).map(|i| self.seconds * i as f32 / shown.len() as f32).collect();
        if let Some(curve) = Curve::new(times, Keys::Step(shown.to_vec())) {
            self.add(node, Track::Visible(curve));
        }
    }

    /// Plays the moves in a world, and stands its instances where they are at the start.
    pub fn play(self, name: &str, stage: &mut Stage) {
        let Self { seconds, channels } = self;
        let scene = &mut stage.scene;
        scene.rig.animations.push(Animation { name: name.to_owned(), seconds, channels });
        scene.rig.playing = Some(scene.rig.animations.len() - 1);
        let pose = scene.pose(0.0);
        for instance in &mut scene.instances {
            instance.world_from_mesh = instance.world_from_mesh_in(&pose);
        }
        for light in &mut scene.lights {
            light.world_from_light = light.world_from_light_in(&pose);
        }
    }
}

impl Stage {
    /// Adds a node to the rig, and returns its number.
    pub fn node(
        &mut self,
        name: &str,
        parent: Option<usize>,
        at: Vec3,
        rotation: Quat,
        scale: Vec3,
    ) -> usize {
        let rest = Place::Parts { translation: at.as_dvec3(), rotation, scale };
        self.scene.rig.nodes.push(Node {
            name: name.to_owned(),
            parent,
            rest,
            visible: true,
            weights: Vec::new(),
        });
        self.scene.rig.nodes.len() - 1
    }

    /// Hangs a mesh on a node, at its origin.
    pub fn hang(&mut self, mesh: usize, node: usize) {
        let motion = Motion::Node { node, node_from_thing: Mat4::IDENTITY };
        self.scene.instances.push(Instance {
            motion,
            node: Some(node),
            ..Instance::still(mesh, Mat4::IDENTITY)
        });
    }
}
