use glam::Vec3;
use proptest::prelude::*;

use super::*;
use crate::{Bounds, Camera, Fit, Light, Projection, Settings, ShadowPlan, Warp, plan};

fn planned(yaw: f32, light: Vec3) -> ShadowPlan {
    let projection = Projection::Perspective { fov_y: 1.0, aspect: 1.6 };
    let eye = Vec3::new(3.0, 12.0, 5.0);
    let ahead = Vec3::new(yaw.sin(), -0.2, -yaw.cos());
    let camera = Camera::looking(eye, eye + ahead, Vec3::Y, projection, 0.5, 150.0).unwrap();
    let bounds = Bounds::of_world(Vec3::new(-90.0, 0.0, -90.0), Vec3::new(90.0, 7.0, 90.0));
    let settings = Settings { fit: Fit::Sample, ..Settings::default() };
    plan(&camera, &[Light::directional(light).unwrap()], &bounds, &settings).unwrap()
}

proptest! {
    #[test]
    fn all_that_may_be_chosen_lies_within_the_plan(yaw in -3.2f32..3.2, (x, z) in (-0.9f32..0.9, -0.9f32..0.9)) {
        let plan = planned(yaw, Vec3::new(x, -1.0, z));
        for view in plan.views() {
            let samples = view.samples.as_ref().unwrap();
            for turn in &samples.turns {
                prop_assert!(turn.right.dot(turn.up).abs() < 1e-9 && (turn.right.length() - 1.0).abs() < 1e-9);
                for corner in [turn.min, turn.max, DVec2::new(turn.min.x, turn.max.y)] {
                    let point = turn.right * corner.x + turn.up * corner.y;
                    let ndc = view.clip_from_world.project_point3(point).truncate();
                    prop_assert!(ndc.abs().max_element() < 1.0 + 1e-9, "{ndc}");
                }
            }
        }
    }

    #[test]
    fn a_turn_is_the_same_rotation_whatever_the_camera(yaw in -3.2f32..3.2) {
        let turns = |yaw| -> Vec<Turn> {
            planned(yaw, Vec3::new(0.4, -1.0, 0.2)).views().iter().flat_map(|v| v.samples.as_ref().unwrap().turns).collect()
        };
        for turn in turns(yaw) {
            for other in turns(0.0).iter().filter(|other| other.steps == turn.steps) {
                prop_assert!(turn.right.distance(other.right) < 1e-9 && turn.up.distance(other.up) < 1e-9);
            }
        }
    }
}

#[test]
fn a_chosen_rectangle_is_what_the_view_covers() {
    let mut plan = planned(0.3, Vec3::new(0.4, -1.0, 0.2));
    let turn = plan.views()[1].samples.as_ref().unwrap().turns[0];
    let depth = plan.views()[1].clip_from_world.project_point3(DVec3::ONE).z;
    let (centre, sides) = ((turn.min + turn.max) * 0.5, DVec2::new(8.0, 4.0));
    plan.set_rectangle(1, &ChosenRectangle { right: turn.right, up: turn.up, centre, sides });
    let view = &plan.views()[1];
    let corner = turn.right * (centre.x + 4.0) + turn.up * (centre.y + 2.0);
    let ndc = view.clip_from_world.project_point3(corner);
    assert!((ndc.truncate() - DVec2::ONE).length() < 1e-9, "{ndc}");
    assert!((view.clip_from_world.project_point3(DVec3::ONE).z - depth).abs() < 1e-12, "depth stays");
    assert_eq!(view.texel_metres, 8.0 / view.tile.size as f32);
}

#[test]
fn a_map_that_is_fitted_to_samples_cannot_be_warped() {
    let settings = Settings { fit: Fit::Sample, warp: Warp::Tsm, ..Settings::default() };
    assert!(settings.validate().unwrap_err().to_string().contains("`fit = \"sample\"` excludes a `warp`"));
}
