use glam::{Mat4, Vec3};
use umbrage_core::{Bounds, Camera, Light, Projection, Settings, ShadowPlan, plan};

use super::*;

/// The plan of two splits, whose views have these keys.
fn plan_with(keys: [Option<ViewKey>; 2]) -> ShadowPlan {
    let camera = Camera::new(Mat4::IDENTITY, Projection::Perspective { fov_y: 1.0, aspect: 1.0 }, 0.1, 100.0)
        .expect("a camera");
    let sun = Light::directional(Vec3::NEG_Y).expect("a sun");
    let bounds = Bounds::of_world(Vec3::splat(-50.0), Vec3::splat(50.0));
    let settings = Settings { splits: 2, ..Settings::default() };
    let mut plan = plan(&camera, &[sun], &bounds, &settings).expect("a plan");
    keys.into_iter().enumerate().for_each(|(i, key)| plan.set_key(i, key));
    plan
}

fn key(still: u64, moving: Option<u64>) -> Option<ViewKey> {
    Some(ViewKey { still, moving })
}

/// What a plan draws, as letters: A all, S what stands, M what moves, R restored and nothing drawn; each with its view.
fn drawn(kept: &mut Kept, keys: [Option<ViewKey>; 2], still_maps: Option<u64>) -> (String, bool) {
    let (plan, mut steps) = (plan_with(keys), Vec::new());
    let would_save = kept.decide(plan.views(), still_maps, &mut steps);
    let letter = |step: &Step| match step.share {
        Some(Share::All) => 'A',
        Some(Share::Still) => 'S',
        Some(Share::Moving) => 'M',
        None => 'R',
    };
    let text =
        steps.iter().map(|step| format!("{}{}", letter(step), step.view)).collect::<Vec<_>>().join(" ");
    steps.iter().for_each(|step| kept.record(step, &plan.views()[step.view], still_maps));
    (text, would_save)
}

#[test]
fn what_has_no_name_is_drawn_each_time() {
    let mut kept = Kept::default();
    for _ in 0..3 {
        assert_eq!(drawn(&mut kept, [None, None], Some(4)), ("A0 A1".into(), false));
    }
}

#[test]
fn a_tile_that_shows_what_is_asked_is_not_drawn_again() {
    let mut kept = Kept::default();
    let keys = [key(1, None), key(2, Some(7))];
    assert_eq!(drawn(&mut kept, keys, None), ("A0 A1".into(), false));
    assert_eq!(drawn(&mut kept, keys, None), (String::new(), false));
    assert_eq!(drawn(&mut kept, [key(1, None), key(3, Some(7))], None), ("A1".into(), false));
    assert_eq!(drawn(&mut kept, [key(1, Some(1)), key(3, Some(7))], None), ("A0".into(), true));
    kept.forget();
    assert_eq!(drawn(&mut kept, [key(1, Some(1)), key(3, Some(7))], None).0, "A0 A1");
}

#[test]
fn what_stands_is_drawn_once_where_what_moves_goes_on() {
    let mut kept = Kept::default();
    let frame = |kept: &mut Kept, moving| drawn(kept, [key(1, moving), key(2, None)], Some(4)).0;
    assert_eq!(frame(&mut kept, Some(1)), "A0 A1", "it may never be asked for again");
    assert_eq!(frame(&mut kept, Some(2)), "S0 M0");
    assert_eq!(frame(&mut kept, Some(3)), "M0");
    assert_eq!(frame(&mut kept, Some(3)), "");
    assert_eq!(frame(&mut kept, None), "R0", "what moved has left");
    assert_eq!(frame(&mut kept, None), "");
}

#[test]
fn a_change_forgets_the_tiles_whose_casters_it_touches() {
    let mut kept = Kept::default();
    let keys = [key(1, None), key(2, None)];
    drawn(&mut kept, keys, None);
    let far = Vec3::splat(1e6);
    kept.forget_touching(&Aabb { min: far, max: far + 1.0 });
    assert_eq!(drawn(&mut kept, keys, None).0, "");
    kept.forget_touching(&Aabb { min: Vec3::splat(-50.0), max: Vec3::splat(50.0) });
    assert_eq!(drawn(&mut kept, keys, None).0, "A0 A1");
}

#[test]
fn tiles_that_lie_otherwise_belong_to_another_plan() {
    let mut kept = Kept::default();
    let keys = [key(1, None), key(2, None)];
    drawn(&mut kept, keys, None);
    let mut views = plan_with(keys).views().to_vec();
    views[1].tile.size /= 2;
    let mut steps = Vec::new();
    kept.decide(&views, None, &mut steps);
    assert_eq!(steps.len(), 2, "the first may lie across the second's old tile");
}

#[test]
fn boxes_that_changed_under_a_kept_tile_are_found() {
    let mut kept = Kept::default();
    let keys = [key(1, None), None];
    let view = plan_with(keys).views()[0].clone();
    assert!(!kept.is_stale(&view, 5), "nothing is drawn");
    drawn(&mut kept, keys, None);
    assert!(!kept.is_stale(&view, 5));
    assert!(kept.is_stale(&view, 6));
    kept.forget_touching(&Aabb { min: Vec3::splat(-50.0), max: Vec3::splat(50.0) });
    assert!(!kept.is_stale(&view, 6), "it was said");
}

#[test]
fn what_stands_in_the_maps_of_another_copy_is_drawn_anew() {
    let mut kept = Kept::default();
    let mut frame = |moving, maps| drawn(&mut kept, [key(1, Some(moving)), None], Some(maps)).0;
    assert_eq!(frame(1, 4), "A0 A1");
    assert_eq!(frame(2, 4), "S0 M0 A1");
    assert_eq!(frame(3, 5), "S0 M0 A1", "another texture");
    assert_eq!(frame(4, 5), "M0 A1");
}
