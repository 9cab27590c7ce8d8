//! A place of the world stays in the same texel of a light's lattice, wherever the camera goes.

use glam::{DVec3, Vec3};
use proptest::prelude::*;
use umbrage_core::{Camera, Fit, Light, Projection, Settings, ShadowView, plan};

use crate::any::{direction, point_in, share, world};

/// Where a point lies in the lattice, texels; `None` outside of the map.
fn place(view: &ShadowView, point: DVec3) -> Option<[f64; 2]> {
    let clip = view.clip_from_world * point.extend(1.0);
    let ndc = clip / clip.w;
    let is_seen = clip.w > 0.0 && ndc.x.abs() < 1.0 && ndc.y.abs() < 1.0;
    let half = 0.5 * f64::from(view.tile.size);
    let [x, y] = view.lattice().map(|texels| f64::from(texels as i32));
    is_seen.then_some([(1.0 + ndc.x) * half + x, (1.0 - ndc.y) * half + y])
}

/// How many points two views see both; none of them may have moved.
fn seen_by_both(before: &ShadowView, after: &ShadowView, points: &[Vec3]) -> usize {
    let mut seen = 0;
    for point in points {
        let places = place(before, point.as_dvec3()).zip(place(after, point.as_dvec3()));
        if let Some((before, after)) = places {
            seen += 1;
            let moved = (before[0] - after[0]).abs().max((before[1] - after[1]).abs());
            assert!(moved < 1e-3, "{point} moves by {moved} texels");
        }
    }
    seen
}

proptest! {
    #[test]
    fn no_camera_moves_the_lattice_of_a_light(
        sun in direction(), eyes in proptest::collection::vec((share(), direction()), 6),
        points in proptest::collection::vec(share(), 60),
    ) {
        let bounds = world();
        let points: Vec<Vec3> = points.iter().map(|share| point_in(&bounds.world(), *share)).collect();
        let lamp = 0.5 * (bounds.world().min + bounds.world().max);
        let lights = [
            Light::directional(sun).unwrap(),
            Light::spot(lamp, sun, 0.6, 500.0).unwrap(),
            Light::point(lamp, 500.0).unwrap(),
        ];
        let projection = Projection::Perspective { fov_y: 1.0, aspect: 1.6 };
        for (fit, resolution) in [
            (Fit::Stable, 256),
            (Fit::Stable, 333),
            (Fit::World, 256),
            (Fit::Scene, 256),
            (Fit::Scene, 333),
        ] {
            let settings = Settings { fit, resolution, splits: 3, ..Settings::default() };
            let mut before: Option<Vec<ShadowView>> = None;
            let mut seen = 0;
            for (share, forward) in &eyes {
                let eye = point_in(&bounds.world(), *share);
                let camera = Camera::looking(eye, eye + *forward, Vec3::Y, projection, 0.1, 300.0).unwrap();
                let plan = plan(&camera, &lights, &bounds, &settings).unwrap();
                // Only faces of point lights lie still under a fit to the scene.
                let kept = match fit {
                    Fit::Stable | Fit::World => plan.views(),
                    Fit::Scene | Fit::View | Fit::Sample => &plan.views()[4..],
                };
                for (before, after) in before.iter().flatten().zip(kept) {
                    seen += seen_by_both(before, after, &points);
                }
                before = Some(kept.to_vec());
            }
            prop_assert!(seen > 100, "{fit:?}: {seen} places are compared");
        }
    }
}

#[test]
fn a_lattice_is_a_number_whatever_the_view_is() {
    let bounds = world();
    let camera = Camera::looking(
        Vec3::ZERO,
        Vec3::X,
        Vec3::Y,
        Projection::Perspective { fov_y: 1.0, aspect: 1.0 },
        0.1,
        9.0,
    )
    .unwrap();
    let lights = [Light::directional(Vec3::NEG_Y).unwrap()];
    let mut view = plan(&camera, &lights, &bounds, &Settings::default()).unwrap().views()[0].clone();
    view.clip_from_world.w_axis.x = f64::NAN;
    assert_eq!(view.lattice()[0], 0);
    view.clip_from_world.w_axis.x = -1e18;
    assert!(view.lattice()[0] < u32::MAX);
}
