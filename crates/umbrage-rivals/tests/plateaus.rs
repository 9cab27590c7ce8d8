//! Plateaus are planar shadows with an outer penumbra, whose width grows with height.

mod common;

use common::{above, camera, court, gpu, ground, judge, point, scene, spot, sun};
use glam::{Mat4, Vec3};
use umbrage_rivals::{Family, RivalError};
use umbrage_scene::{Instance, Light};

#[test]
fn of_a_light_without_size_they_are_planar_shadows() {
    let lights = [sun(), spot(), point()];
    let of = |family| judge(family, &court(), &above(), &lights, 0.0).seen.visibility;
    assert!(of(Family::Plateaus { degrees: 0.0 }) == of(Family::Planar {}));
}

#[test]
fn hard_shadows_stay_and_grow_a_penumbra() {
    let lights = [sun(), spot(), point()];
    let soft = judge(Family::Plateaus { degrees: 12.0 }, &court(), &above(), &lights, 0.0);
    let hard = judge(Family::Planar {}, &court(), &above(), &lights, 0.0).seen.visibility;
    for (number, hard) in hard.iter().enumerate() {
        if let Ok(folder) = std::env::var("PICTURES") {
            soft.save(number, &format!("{folder}/plateaus-{}.png", lights[number].name));
        }
        let mut between = 0;
        for (hard, soft) in hard.iter().zip(&soft.seen.visibility[number]) {
            let (Some(hard), Some(soft)) = (hard, soft) else { continue };
            assert!(soft <= hard, "{soft} where {hard} is hard");
            between += usize::from(*soft > 0.0 && *soft < 1.0);
        }
        assert!(between > 100, "{}: {between} between light and shadow", lights[number].name);
    }
}

/// Looks straight down beside a plate.
#[test]
fn a_penumbra_is_as_wide_as_the_light_at_the_height_of_the_edge() {
    const HEIGHT: f32 = 4.0;
    // So wide that half of it is no more its own tangent: 0.785 and 1.
    const DEGREES: f32 = 90.0;
    let plate = Instance::still(2, Mat4::from_translation(Vec3::new(0.0, HEIGHT, 0.0)));
    let scene = scene(vec![ground(), plate]);
    let down = camera(Vec3::new(4.0, 6.0, 0.0), Vec3::new(4.0, 0.0, 0.0));
    let family = Family::Plateaus { degrees: DEGREES };
    let judged = judge(family, &scene, &down, &[Light::sun(Vec3::NEG_Y, 1.0)], 0.0);
    let lamp = Light::point("lamp", Vec3::new(0.0, 8.0, 0.0), 90.0, 1.0);
    let by_lamp = judge(family, &scene, &down, &[lamp], 0.0);
    let radius = (0.5 * DEGREES).to_radians();
    // The edge at x = 1 has its shadow there by the sun, and at 2 by the lamp, as far from the plate as that is from the plane:
    // there the penumbra is as wide as the lamp but for its slope.
    for (judged, edge, width, slack) in
        [(&judged, 1.0, HEIGHT * radius.tan(), 0.02), (&by_lamp, 2.0, radius, 0.07)]
    {
        let mut compared = 0;
        for (receiver, seen) in judged.truths[0].receivers.iter().zip(&judged.seen.visibility[0]) {
            let (Some(receiver), Some(seen)) = (receiver, seen) else { continue };
            let (x, z) = (receiver.position.x as f32, receiver.position.z as f32);
            if receiver.position.y.abs() < 1e-3 && z.abs() < 0.5 && x > edge {
                let wanted = ((x - edge) / width).min(1.0);
                assert!((seen - wanted).abs() < slack, "{seen} at {x}, not {wanted}");
                compared += usize::from(wanted < 1.0);
            }
        }
        assert!(compared > 100, "{compared} pixels of the penumbra beyond {edge}");
    }
}

#[test]
fn an_angle_that_is_none_is_refused() {
    for degrees in [-1.0, 180.0, f32::NAN] {
        let refused = Family::Plateaus { degrees }.ready(&gpu(), &scene(vec![]));
        assert!(matches!(refused, Err(RivalError::Setting { name: "degrees", .. })), "{degrees}");
    }
}
