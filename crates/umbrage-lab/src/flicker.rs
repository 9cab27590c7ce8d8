//! Measures how unsteady shadows are: the visibility of fixed points of the world along a path, frame by frame.
//!
//! Every point asks the shadow maps themselves, through the shaders' own lookup ([`umbrage_render::Renderer::query`]), so
//! that the picture's own pixels add no noise. Points outside the picture or its range of depth are left out for that frame;
//! points that something hides are not, for the maps answer for them all the same.

use std::sync::Arc;

use glam::{Mat4, Vec3};
use umbrage::Settings;
use umbrage_judge::temporal::{Anchor, AnchorResult, Flicker, anchors, visibility};
use umbrage_judge::{Eye, Light};
use umbrage_render::{Point, Show};
use umbrage_scene::{Camera, Instance, LightKind, Scene};

use crate::error::LabError;
use crate::laboratory::Laboratory;
use crate::path::{Motion, Watch};
use crate::shot::Shot;

/// Frames a second, for things that move.
const FRAMES_PER_SECOND: f32 = 60.0;

impl Laboratory<'_> {
    /// Draws the maps of every frame of a path that starts at a shot, and watches points of the world in the maps of the
    /// first light.
    ///
    /// # Errors
    /// As [`Laboratory::judge`]; and when the world has nothing that can move along the path.
    pub fn flicker(
        &mut self,
        shot: &Shot,
        settings: &Settings,
        motion: Motion,
        watch: Watch,
    ) -> Result<Flicker, LabError> {
        self.use_settings(settings)?;
        self.renderer().forget_looks();
        let finest = self.finest_texel(shot)?;
        let shots: Vec<Shot> =
            (0..watch.frames).map(|i| moved(self.scene(), shot, motion, i as f32, finest)).collect();
        let eyes: Vec<Eye> =
            shots.iter().map(|shot| Eye::new(&shot.camera, shot.width, shot.height)).collect();
        let light_of = |shot: &Shot| {
            let missing = || LabError::Missing { what: "light".to_owned(), world: shot.camera.name.clone() };
            Ok::<_, LabError>(Light::at(shot.lights.first().ok_or_else(missing)?, &shot.pose))
        };
        let missing =
            |what: &str| LabError::Missing { what: what.to_owned(), world: self.scene().name.clone() };
        let is_moving = || {
            let scene = self.scene();
            let lights = shot.lights.iter().any(|light| light.motion != umbrage_scene::Motion::Still);
            lights || scene.instances.iter().any(Instance::is_dynamic)
        };
        if motion == Motion::Objects && !is_moving() {
            return Err(missing("moving things"));
        }
        let is_point = |light: &umbrage_scene::Light| matches!(light.kind, LightKind::Point { .. });
        if motion == Motion::Sun && shot.lights.first().is_some_and(is_point) {
            return Err(missing("light that can turn"));
        }
        let world = self.world_in(&shot.pose);
        // Where the camera begins, is half-way, and ends.
        let thirds = [0, watch.frames / 2, watch.frames.saturating_sub(1)];
        let from: Vec<Eye> = thirds.into_iter().filter_map(|i| eyes.get(i).copied()).collect();
        let anchors =
            anchors(&world, &from, &light_of(shot)?, watch.points, |triangle| world.is_still(triangle));
        let (mut result, mut truth): (Vec<_>, Vec<Vec<f32>>) = (Vec::new(), Vec::new());
        for (shot, eye) in shots.iter().zip(&eyes) {
            result.push(self.drawn(shot, settings, eye, &anchors)?);
            let is_same = !matches!(motion, Motion::Sun | Motion::Objects);
            let known = truth.last().filter(|_| is_same).cloned();
            truth.push(match known {
                Some(known) => known,
                None => visibility(&self.world_in(&shot.pose), &light_of(shot)?, &anchors),
            });
        }
        Ok(Flicker::new(&result, &truth))
    }

    /// The result at each anchor, as the maps of a frame have it.
    fn drawn(
        &mut self,
        shot: &Shot,
        settings: &Settings,
        eye: &Eye,
        anchors: &[Anchor],
    ) -> Result<Vec<AnchorResult>, LabError> {
        let drawn = self.renderer().render(&shot.frame(Show::Nothing)?)?.drawn;
        let point =
            |anchor: &Anchor| Point { position: anchor.position.as_vec3(), normal: anchor.normal.as_vec3() };
        let points: Vec<Point> = anchors.iter().map(point).collect();
        let answers = self.renderer().query(&drawn, 0, &points)?;
        let result = |((anchor, point), answer): ((&Anchor, &Point), f32)| {
            let view = umbrage::view_of(drawn.plan(), settings, 0, point.position, point.normal);
            AnchorResult {
                visibility: eye.project(anchor.position).map_or(f32::NAN, |_| answer),
                map: view.map_or(usize::MAX, |view| view.index),
            }
        };
        Ok(anchors.iter().zip(&points).zip(answers).map(result).collect())
    }

    /// The size of the finest view's texels, metres.
    fn finest_texel(&mut self, shot: &Shot) -> Result<f32, LabError> {
        let drawn = self.renderer().render(&shot.frame(Show::Nothing)?)?.drawn;
        Ok(drawn.plan().views().iter().map(|view| view.texel_metres).fold(f32::INFINITY, f32::min))
    }
}

/// The shot as it is in a frame of a path.
fn moved(scene: &Scene, shot: &Shot, motion: Motion, frame: f32, finest_texel: f32) -> Shot {
    let still = shot.clone();
    let camera = |aside: Vec3, yaw_degrees: f32| Shot {
        camera: carried(&shot.camera, aside, yaw_degrees),
        ..shot.clone()
    };
    match motion {
        Motion::Translate => camera(Vec3::X * (0.05 * frame), 0.0),
        Motion::Yaw => camera(Vec3::ZERO, 0.25 * frame),
        // Two steps a second, a few centimetres up and down.
        Motion::Walk => camera(Vec3::new(0.0, 0.03 * (frame * 0.2).sin(), -0.05 * frame), 0.25 * frame),
        Motion::Fast => camera(Vec3::NEG_Z * frame, 0.0),
        Motion::SubTexel => camera(Vec3::X * (finest_texel / 16.0 * frame), 0.0),
        Motion::Sun => {
            let lights = shot.lights.iter().map(|light| turned(light, (0.02 * frame).to_radians())).collect();
            Shot { lights, ..still }
        }
        Motion::Objects => {
            Shot { pose: Arc::new(scene.pose(shot.pose.seconds + frame / FRAMES_PER_SECOND)), ..still }
        }
    }
}

/// A light turned about an axis across it, so that it moves by the whole angle.
fn turned(light: &umbrage_scene::Light, radians: f32) -> umbrage_scene::Light {
    let axis = light.world_from_light.x_axis.truncate();
    let mut turned = light.clone();
    turned.world_from_light = Mat4::from_axis_angle(axis, radians) * light.world_from_light;
    turned.world_from_light.w_axis = light.world_from_light.w_axis;
    turned
}

/// A camera moved along its own axes, but level where it goes ahead, and turned about the vertical.
fn carried(camera: &Camera, aside: Vec3, yaw_degrees: f32) -> Camera {
    let level = |axis: Vec3| Vec3::new(axis.x, 0.0, axis.z).normalize_or(Vec3::X);
    let right = level(camera.world_from_camera.x_axis.truncate());
    let back = right.cross(Vec3::Y);
    let eye = camera.eye() + right * aside.x + Vec3::Y * aside.y + back * aside.z;
    let turn = Mat4::from_rotation_y(yaw_degrees.to_radians());
    let mut moved = camera.clone();
    moved.world_from_camera = turn * camera.world_from_camera;
    moved.world_from_camera.w_axis = eye.extend(1.0);
    moved
}

#[cfg(test)]
mod tests {
    use umbrage_scene::{Lens, Light};

    use super::*;

    #[test]
    fn paths_go_where_they_say() {
        let camera = Camera {
            lens: Lens::Perspective { fov_y: 1.0 },
            ..Camera::looking("c", Vec3::new(0.0, 2.0, 0.0), Vec3::new(0.0, 1.0, -10.0), 1.0, 0.1, 100.0)
        };
        let lights = vec![Light::sun(Vec3::NEG_Y, 1.0)];
        let shot = Shot { camera, lights, pose: Arc::default(), width: 16, height: 9 };
        let eye = |motion| moved(&Scene::default(), &shot, motion, 100.0, 0.16).camera.eye();
        let near = |a: Vec3, b: Vec3| assert!(a.distance(b) < 1e-3, "{a}, not {b}");
        near(eye(Motion::Translate), Vec3::new(5.0, 2.0, 0.0));
        near(eye(Motion::SubTexel), Vec3::new(1.0, 2.0, 0.0));
        near(eye(Motion::Fast), Vec3::new(0.0, 2.0, -100.0));
        near(eye(Motion::Yaw), Vec3::new(0.0, 2.0, 0.0));
        let forward = moved(&Scene::default(), &shot, Motion::Yaw, 360.0, 0.1).camera.forward();
        assert!(forward.x < -0.99, "a quarter turn to the left, forward is {forward}");
        for from in [Vec3::NEG_Y, Vec3::NEG_Z, Vec3::new(0.3, -0.8, 0.4)] {
            let lights = vec![Light::sun(from, 1.0)];
            let sun = moved(&Scene::default(), &Shot { lights, ..shot.clone() }, Motion::Sun, 100.0, 0.1)
                .lights[0]
                .direction();
            assert!((sun.angle_between(from).to_degrees() - 2.0).abs() < 1e-2, "{from} became {sun}");
        }
        assert!(moved(&Scene::default(), &shot, Motion::Objects, 60.0, 0.1).pose.seconds == 1.0, "a second");
    }
}
