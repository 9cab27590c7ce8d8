//! Worlds under spot and point lights whose shadows are known in closed form.

mod shapes;

use glam::{DVec3, Vec3};
use proptest::prelude::*;
use shapes::{box_sides, demand, ground, quad, sphere};
use umbrage_judge::temporal::{Anchor, visibility};
use umbrage_judge::{Edges, Error, Eye, Light, Pixel, Receiver, ShadowResult, Truth, World, soft, sub_pixel};
use umbrage_scene::Camera;

/// Where lights stand: 10 m above the ground.
const LIGHTS: [DVec3; 3] =
    [DVec3::new(0.0, 10.0, 0.0), DVec3::new(0.7, 10.0, -0.3), DVec3::new(-4.0, 10.0, 3.0)];

/// Boundless, as a point and as a spot that shines down with a total angle of 179°.
fn lights(position: DVec3) -> [Light; 2] {
    let cos_outer = 89.5f64.to_radians().cos();
    let range = f64::INFINITY;
    [
        Light::Point { position, range, near: 0.0 },
        Light::Spot { position, along: DVec3::NEG_Y, cos_outer, range, near: 0.0 },
    ]
}

fn point(position: DVec3) -> Light {
    Light::Point { position, range: f64::INFINITY, near: 0.0 }
}

/// A horizontal square about a point, `half` metres from its middle to its sides.
fn plate(middle: Vec3, half: f32) -> [[Vec3; 3]; 2] {
    let corner = |x, z| middle + Vec3::new(x, 0.0, z) * half;
    quad(corner(-1.0, -1.0), corner(-1.0, 1.0), corner(1.0, 1.0), corner(1.0, -1.0))
}

/// The ground and some casters.
fn world(casters: &[[Vec3; 3]]) -> World {
    World::of_triangles(ground().into_iter().chain(casters.iter().copied()).collect())
}

/// Points 0.5 m apart on the ground within ±10 m.
fn ground_anchors() -> Vec<Anchor> {
    let place = |i: i32| DVec3::new(f64::from(i % 41 - 20) * 0.5, 0.0, f64::from(i / 41 - 20) * 0.5);
    (0..41 * 41).map(|i| Anchor { position: place(i), normal: DVec3::Y, lift: 0.0 }).collect()
}

/// A camera 9 m above the ground that looks down at it a little aslant.
fn eye() -> Eye {
    let camera = Camera::looking("c", Vec3::new(1.0, 9.0, 8.0), Vec3::new(0.0, 0.0, 0.5), 1.2, 0.1, 1000.0);
    Eye::new(&camera, 160, 120)
}

#[test]
fn a_plates_shadow_is_the_plate_enlarged_by_similar_triangles() {
    for (height, half) in [(2.0, 1.0), (4.0, 0.75), (6.0, 0.75)] {
        let middle = DVec3::new(0.5, height, -0.25);
        let casters = plate(middle.as_vec3(), half as f32);
        for position in LIGHTS {
            // From the light, the ground is so many times as far as the plate.
            let times = 10.0 / (10.0 - height);
            let shadow = position + (middle - position) * times;
            for light in lights(position) {
                demand("plate", &casters, &light, |p, grow| {
                    let aside = (p - shadow).abs();
                    aside.x.max(aside.z) < half * times + grow
                });
            }
        }
    }
}

#[test]
fn a_spheres_shadow_is_the_cone_about_it() {
    let (centre, radius) = (DVec3::new(0.3, 2.0, -0.2), 1.0);
    let casters = sphere(centre, radius, 512);
    for position in LIGHTS {
        let axis = centre - position;
        for light in lights(position) {
            demand("sphere", &casters, &light, |p, grow| {
                let half_angle = ((radius + grow) / axis.length()).asin();
                (p - position).angle_between(axis) < half_angle
            });
        }
    }
}

#[test]
fn things_behind_the_light_cast_nothing_and_things_before_it_do() {
    let world = world(&plate(Vec3::new(0.0, 10.0, 0.0), 50.0));
    for (height, visible) in [(5.0, 1.0), (9.999, 1.0), (10.001, 0.0), (15.0, 0.0)] {
        for light in lights(DVec3::new(0.3, height, 0.2)) {
            let traced = visibility(&world, &light, &ground_anchors());
            assert!(traced.iter().all(|v| *v == visible), "a plate at 10 m and a light at {height} m");
        }
    }
}

#[test]
fn the_plate_that_a_light_stands_on_casts_nothing_anywhere() {
    let slanted = |x: f32, z: f32| Vec3::new(x, 7.3 + 0.1 * x - 0.07 * z, z);
    let plate = quad(slanted(-9.0, -9.0), slanted(-9.0, 9.0), slanted(9.0, 9.0), slanted(9.0, -9.0));
    for (x, z) in [(0.1, 0.7), (-0.9, 0.3), (1.7, -0.6)] {
        let traced = visibility(&world(&plate), &point(slanted(x, z).as_dvec3()), &ground_anchors());
        assert!(traced.iter().all(|v| *v == 1.0), "a light at {x}, {z}");
    }
}

#[test]
fn a_light_in_a_closed_room_lights_its_walls_and_nothing_outside() {
    let (low, high) = (DVec3::new(-4.0, -1.0, -3.0), DVec3::new(4.0, 5.0, 3.0));
    let world = world(&box_sides(low, high));
    let light = point(DVec3::new(0.5, 3.0, -0.4));
    for i in 0..400 {
        let share = |step: f64| (0.5 + step * f64::from(i)).fract();
        let [u, v] = [share(0.754_877_666), share(0.569_840_290)];
        for axis in 0..3 {
            for (side, inward) in [(low, 1.0), (high, -1.0)] {
                let mut position = low + (high - low) * DVec3::new(u, v, share(0.324_717_957));
                position[axis] = side[axis];
                let mut normal = DVec3::ZERO;
                normal[axis] = inward;
                let inside = Anchor { position, normal, lift: 0.0 };
                let outside = Anchor { position, normal: -normal, lift: 0.0 };
                // The ground cuts through the room: what is below is in its shadow.
                let lit = if position.y > 0.0 { 1.0 } else { 0.0 };
                let traced = visibility(&world, &light, &[inside, outside]);
                assert_eq!(traced, [lit, 0.0], "at {position}");
            }
        }
    }
    for (anchor, traced) in ground_anchors().iter().zip(visibility(&world, &light, &ground_anchors())) {
        let (x, z) = (anchor.position.x.abs(), anchor.position.z.abs());
        if x != 4.0 && z != 3.0 {
            assert_eq!(traced == 1.0, x < 4.0 && z < 3.0, "at {}", anchor.position);
        }
    }
}

#[test]
fn a_light_inside_a_wall_lights_nothing() {
    let world = world(&box_sides(DVec3::new(-0.1, 0.0, -50.0), DVec3::new(0.1, 50.0, 50.0)));
    let traced = visibility(&world, &point(DVec3::new(0.0, 3.0, 0.2)), &ground_anchors());
    for (anchor, traced) in ground_anchors().iter().zip(traced) {
        assert!(anchor.position.x == 0.0 || traced == 0.0, "at {}", anchor.position);
    }
}

#[test]
fn pixels_outside_the_cone_or_the_range_are_unreached_and_those_inside_lit() {
    let position = DVec3::new(0.5, 6.0, -0.3);
    let world = world(&[]);
    for (half_angle, range, aslant) in
        [(30.0, 100.0, 0.0), (89.5, 8.0, 0.0), (25.0, 7.5, 0.4), (89.5, 7.0, 1.5)]
    {
        let along = DVec3::new(aslant, -1.0, 0.0).normalize_or_zero();
        let half_angle = f64::to_radians(half_angle);
        let light = Light::Spot { position, along, cos_outer: half_angle.cos(), range, near: 0.0 };
        let truth = Truth::new(&world, &eye(), &light, 500.0);
        for (pixel, receiver) in truth.pixels.iter().zip(&truth.receivers) {
            let Some(Receiver { position: p, .. }) = receiver else { continue };
            let from_light = *p - position;
            let angle = from_light.cross(along).length().atan2(from_light.dot(along));
            let past_edge = (angle - half_angle).max(from_light.length() - range);
            if past_edge.abs() > 1e-9 {
                assert_eq!(*pixel, if past_edge < 0.0 { Pixel::Lit } else { Pixel::Unreached }, "at {p}");
            }
        }
        let (lit, unreached) = (truth.count(Pixel::Lit), truth.count(Pixel::Unreached));
        assert!(lit > 500 && unreached > 500, "{light:?}: {lit} lit, {unreached} not reached");
        assert_eq!(truth.judged(), lit, "what is not reached is not judged");
        assert_eq!(Edges::new(&truth).length(), 0.0, "where the cone ends is no edge of a shadow");
        let smooth = sub_pixel(&world, &truth, 4);
        assert!(
            smooth.visibility.iter().all(|v| *v == 1.0),
            "parts of a pixel outside the cone do not count"
        );
    }
}

#[test]
fn a_light_without_range_reaches_nothing() {
    let light = Light::Point { position: DVec3::Y, range: 0.0, near: 0.0 };
    let truth = Truth::new(&world(&[]), &eye(), &light, 500.0);
    assert_eq!(truth.judged() + truth.count(Pixel::Lit) + truth.count(Pixel::Shadowed), 0);
    assert!(truth.count(Pixel::Unreached) > 1000);
}

#[test]
fn the_soft_shadow_of_an_edge_is_the_share_of_the_disc_that_looks_past_it() {
    // An edge half-way up to the light: moved by e, it hides the disc up to 2 e from its middle.
    let corner = |x, z| Vec3::new(x, 5.0, z);
    for aside in [-0.2f32, -0.125, 0.0, 0.125, 0.2] {
        let half_plane =
            quad(corner(-50.0, -50.0), corner(-50.0, 50.0), corner(aside, 50.0), corner(aside, -50.0));
        let receiver = Receiver {
            position: DVec3::ZERO,
            normal: DVec3::Y,
            depth: 1.0,
            triangle: 0,
            lift: 0.0,
            tilt: 0.0,
        };
        for light in lights(DVec3::new(0.0, 10.0, 0.0)) {
            let truth =
                Truth { eye: eye(), light, receivers: vec![Some(receiver)], pixels: vec![Pixel::Lit] };
            let smooth = soft(&world(&half_plane), &truth, 0.5, 1024);
            // The segment of a unit disc beyond a chord at distance d from its middle: acos d − d √(1 − d²).
            let d = 2.0 * f64::from(aside) / 0.5;
            let wanted = (d.acos() - d * (1.0 - d * d).sqrt()) / std::f64::consts::PI;
            let got = f64::from(smooth.visibility[0]);
            assert!((got - wanted).abs() < 0.01, "edge at {aside} m, {light:?}: {got}, not {wanted}");
        }
    }
}

#[test]
fn a_false_shadow_under_a_point_light_is_acne_whatever_hangs_behind_the_light() {
    let light = point(DVec3::new(0.0, 3.0, 0.0));
    for ceiling in [3.01, 40.0] {
        let world = world(&plate(Vec3::new(0.0, ceiling, 0.0), 5.0));
        let camera = Camera::looking("c", Vec3::new(0.0, 2.0, 4.0), Vec3::ZERO, 0.8, 0.1, 100.0);
        let truth = Truth::new(&world, &Eye::new(&camera, 40, 40), &light, 100.0);
        assert_eq!(truth.judged(), truth.count(Pixel::Lit));
        let pixels = truth.pixels.len();
        let result = ShadowResult { visibility: &vec![0.0; pixels], texel_metres: &vec![0.01; pixels] };
        let error = Error::new(&world, &truth, &Edges::new(&truth), None, &result).unwrap();
        assert!(error.causes.acne > 0.999, "a ceiling at {ceiling} m: {:?}", error.causes);
    }
}

/// Whether the half-line from `p` along `to_light` meets a ball.
fn meets_ball(p: DVec3, to_light: DVec3, centre: DVec3, radius: f64) -> bool {
    let to_centre = centre - p;
    let along = to_centre.dot(to_light);
    along > 0.0 && (to_centre.length_squared() - along * along).max(0.0).sqrt() < radius
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    #[test]
    fn a_point_light_very_far_away_shadows_as_the_sun_from_there_does(
        balls in prop::collection::vec((prop::array::uniform3(-6.0f64..6.0), 0.3f64..1.5), 1..6),
        to_light in prop::array::uniform3(-1.0f64..1.0),
    ) {
        /// How far away the light is, metres.
        const AWAY: f64 = 1e5;
        let to_light = DVec3::new(to_light[0], to_light[1].abs() + 0.3, to_light[2]).normalize_or_zero();
        let balls: Vec<(DVec3, f64)> =
            balls.into_iter().map(|(at, radius)| (DVec3::new(at[0], at[1].abs() + 2.0, at[2]), radius)).collect();
        let world = world(&balls.iter().flat_map(|(at, radius)| sphere(*at, *radius, 96)).collect::<Vec<_>>());
        let by_sun = visibility(&world, &Light::Sun { to_light }, &ground_anchors());
        let by_point = visibility(&world, &point(to_light * AWAY), &ground_anchors());
        // The two directions differ by 15 m / AWAY at the most, and balls are within 50 m along them.
        let near_edge = |p: DVec3| balls.iter().any(|(at, radius)| {
            // Its triangles cut into a ball by up to 2e-3 m.
            let meets = |grow: f64| meets_ball(p, to_light, *at, radius + grow);
            meets(0.01) != meets(-0.01)
        });
        for (anchor, (sun, point)) in ground_anchors().iter().zip(by_sun.into_iter().zip(by_point)) {
            prop_assert!(sun == point || near_edge(anchor.position), "at {}: {sun}, {point}", anchor.position);
        }
    }
}
