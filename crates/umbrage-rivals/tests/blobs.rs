//! Blob shadows are those of ellipsoids.

mod common;

use common::{SIZE, above, at, gpu, ground, judge, point, scene, spot, sun};
use glam::{Mat4, Vec3};
use umbrage_rivals::{Family, RivalError};
use umbrage_scene::{Instance, Light};

const HARD: Family = Family::Blobs { soft: 0.0 };

#[test]
fn the_blob_of_a_ball_is_its_shadow_however_it_is_stretched_and_turned() {
    let place = Mat4::from_translation(Vec3::new(1.0, 2.0, 0.0)) * Mat4::from_rotation_z(0.6);
    let stretched = Instance::still(3, place * Mat4::from_scale(Vec3::new(1.5, -0.5, 0.8)));
    let scene = scene(vec![ground(), stretched, at(3, -3.0, 1.0, 2.0)]);
    for light in [sun(), spot(), point()] {
        let name = light.name.clone();
        let judged = judge(HARD, &scene, &above(), &[light], 0.0);
        let (wrong, pixels, shadowed) = judged.wrong(0);
        println!("{name}: {wrong:.6} of {pixels}, {shadowed:.3} in shadow");
        // A ball of triangles is a little smaller than a ball.
        assert!(
            pixels > 10_000 && shadowed > 0.01 && wrong < 1e-3,
            "{name}: {wrong} of {pixels}, {shadowed}"
        );
    }
}

#[test]
fn a_soft_blob_is_as_large_and_comes_back_to_light_within_itself() {
    let scene = scene(vec![ground(), at(3, 0.0, 1.5, 0.0)]);
    let of = |soft| judge(Family::Blobs { soft }, &scene, &above(), &[sun()], 0.0).seen.visibility.concat();
    let (hard, soft) = (of(0.0), of(0.5));
    let mut between = 0;
    for (hard, soft) in hard.iter().zip(&soft) {
        let (Some(hard), Some(soft)) = (hard, soft) else { continue };
        assert!(soft >= hard, "{soft} in a blob of {hard}");
        between += usize::from(*soft > 0.0 && *soft < 1.0);
    }
    assert!(between > 100, "{between} of {SIZE:?} between light and shadow");
}

#[test]
fn what_lies_flat_on_a_plane_is_no_blob_there() {
    let slab = Mat4::from_translation(Vec3::new(0.0, 0.1, 0.0)) * Mat4::from_scale(Vec3::new(6.0, 0.1, 6.0));
    let judged = judge(HARD, &scene(vec![ground(), Instance::still(0, slab)]), &above(), &[sun()], 0.0);
    assert!(judged.seen.visibility[0].iter().flatten().all(|seen| *seen == 1.0));
    assert_eq!(judged.unknown(0), 0, "all that is seen lies on planes");
}

#[test]
fn a_room_that_holds_the_lamp_is_no_blob() {
    let room = Instance::still(
        0,
        Mat4::from_translation(Vec3::new(0.0, 4.0, 0.0)) * Mat4::from_scale(Vec3::splat(9.0)),
    );
    let lit = Light::point("p", Vec3::new(0.0, 3.0, 0.0), 60.0, 1.0);
    let judged = judge(HARD, &scene(vec![ground(), room]), &above(), &[lit], 0.0);
    assert!(judged.seen.visibility[0].iter().flatten().all(|seen| *seen == 1.0));
    assert_eq!(judged.unknown(0), 0, "all that is seen lies on planes");
}

#[test]
fn a_share_that_is_none_is_refused() {
    for soft in [-0.1, 1.1, f32::NAN] {
        let refused = Family::Blobs { soft }.ready(&gpu(), &scene(vec![]));
        assert!(matches!(refused, Err(RivalError::Setting { name: "soft", .. })), "{soft}");
    }
}
