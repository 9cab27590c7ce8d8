//! Penumbrae: as wide as they are in the world, in every split, along every axis, for every light, and whatever was drawn
//! before. A straight edge over a floor, and the width that a disc of light makes of it.

use glam::{Mat3, Vec3};
use umbrage::{
    Aabb, Bias, Bounds, Camera, Filter, Fit, Light, LightSize, NoiseSource, Pcss, Projection, Settings,
    SoftMoments, Storage, Warp,
};

use crate::common::{Query, device, draw_lit};

/// A floor, and a plate at some height over all of it where x < 0. Turned about the vertical by `turn`, radians.
fn plate(height: f32, turn: f32) -> Vec<[Vec3; 3]> {
    let turned = |p: Vec3| Mat3::from_rotation_y(turn) * p;
    let mut triangles = Vec::new();
    let mut quad = |x: [f32; 2], y: f32| {
        let [a, b, c, d] =
            [(x[0], -9.0), (x[0], 9.0), (x[1], 9.0), (x[1], -9.0)].map(|(x, z)| turned(Vec3::new(x, y, z)));
        triangles.extend([[a, b, c], [a, c, d]]);
    };
    quad([-9.0, 9.0], 0.0);
    quad([-9.0, 0.0], height);
    triangles
}

/// Points of the floor across the plate's edge, from `-reach` to `reach` metres.
fn across(turn: f32, reach: f32, z: f32) -> Vec<Query> {
    let along = |i: i32| -reach + 2.0 * reach * i as f32 / 400.0;
    let at = |x: f32| Mat3::from_rotation_y(turn) * Vec3::new(x, 0.0, z);
    let query = |i| Query { position: at(along(i)), _pad0: 0.0, normal: Vec3::Y, _pad1: 0.0 };
    (0..=400).map(query).collect()
}

/// Looks down on the origin, from a little aside.
fn camera(height: f32) -> Camera {
    let projection = Projection::Perspective { fov_y: 1.0, aspect: 1.0 };
    let eye = Vec3::new(0.3, height, 0.4);
    Camera::looking(eye, Vec3::new(0.3, 0.0, 0.3), Vec3::NEG_Z, projection, 0.1, 3.0 * height)
        .expect("a camera")
}

/// How much of a disc is seen over a straight edge that is `t` radii from its middle.
fn disc_beyond(t: f64) -> f64 {
    let t = t.clamp(-1.0, 1.0);
    0.5 + (t.asin() + t * (1.0 - t * t).sqrt()) / std::f64::consts::PI
}

/// The radius of the disc of light on the floor that explains a row of visibilities best, metres: the one with the least
/// squares, among steps of half a per cent.
fn radius_of(visibility: &[f32], reach: f32, middle: f32) -> f64 {
    let place = |i: usize| f64::from(-reach + 2.0 * reach * i as f32 / 400.0 - middle);
    let misfit = |radius: f64| -> f64 {
        visibility
            .iter()
            .enumerate()
            .map(|(i, v)| (f64::from(*v) - disc_beyond(place(i) / radius)).powi(2))
            .sum()
    };
    let radii = (0..1200).map(|i| 0.002 * 1.005f64.powi(i));
    radii.min_by(|a, b| misfit(*a).total_cmp(&misfit(*b))).unwrap_or_default()
}

fn soft(filter: Filter) -> Settings {
    let bias = Bias { receiver_plane: true, ..Bias::default() };
    Settings { filter, bias, splits: 1, resolution: 2048, ..Settings::default() }
}

fn pcss(sun_degrees: f32) -> Pcss {
    let light = LightSize { sun_degrees, punctual_metres: 0.4 };
    Pcss { light, blockers: 64, taps: 64, max_texels: 200.0, noise: NoiseSource::None }
}

/// The radius that a filter makes of a plate's edge, in metres on the floor.
fn measured(
    settings: &Settings,
    light: Light,
    (height, turn): (f32, f32),
    reach: f32,
    middle: f32,
    eye: f32,
) -> f64 {
    let world = plate(height, turn);
    let bounds = Bounds::of_world(Vec3::new(-13.0, 0.0, -13.0), Vec3::new(13.0, height, 13.0));
    let device = device(wgpu::Backends::VULKAN);
    let drawn = draw_lit(device, settings.clone(), &camera(eye), &[light], &world, &bounds);
    radius_of(&drawn.visibility(&across(turn, reach, 0.0)), reach, middle)
}

fn sun() -> Light {
    Light::directional(Vec3::NEG_Y).expect("a sun")
}

/// Half of w = 2 h tan(α / 2).
fn expected(height: f32, degrees: f32) -> f64 {
    f64::from(height * (0.5 * degrees.to_radians()).tan())
}

#[test]
fn penumbrae_grow_with_the_height_of_the_blocker_and_the_size_of_the_sun() {
    // The widest is 350 texels of the finest maps, which is more than a filter may reach.
    for (height, degrees, resolution) in
        [(1.0, 5.0, 2048), (2.0, 5.0, 2048), (4.0, 5.0, 2048), (6.0, 2.0, 2048), (4.0, 10.0, 1024)]
    {
        let radius = expected(height, degrees);
        let reach = 2.5 * radius as f32;
        let settings = Settings { resolution, ..soft(Filter::Pcss(pcss(degrees))) };
        let got = measured(&settings, sun(), (height, 0.0), reach, 0.0, 2.0);
        println!("{height} m under {degrees}°: {got:.4} m, and {radius:.4} m in the world");
        assert!((got / radius - 1.0).abs() < 0.05, "{height} m under {degrees}°: {got}, not {radius}");
    }
}

#[test]
fn a_light_has_its_own_size() {
    let light = sun().with_size(8f32.to_radians()).expect("a size");
    let radius = expected(2.0, 8.0);
    let got = measured(&soft(Filter::Pcss(pcss(1.0))), light, (2.0, 0.0), 2.5 * radius as f32, 0.0, 2.0);
    assert!((got / radius - 1.0).abs() < 0.05, "{got}, not {radius}");
}

#[test]
fn penumbrae_are_the_same_in_every_split_and_at_every_resolution() {
    let radius = expected(2.0, 6.0);
    for (splits, resolution, eye) in
        [(1, 2048, 2.0), (1, 512, 2.0), (4, 1024, 2.0), (4, 1024, 6.0), (2, 1024, 12.0)]
    {
        let settings =
            Settings { splits, resolution, ..soft(Filter::Pcss(Pcss { max_texels: 100.0, ..pcss(6.0) })) };
        let got = measured(&settings, sun(), (2.0, 0.0), 2.5 * radius as f32, 0.0, eye);
        println!("{splits} splits of {resolution}, from {eye} m: {got:.4} m, and {radius:.4} m in the world");
        assert!(
            (got / radius - 1.0).abs() < 0.05,
            "{splits} splits of {resolution}, from {eye} m: {got}, not {radius}"
        );
    }
}

#[test]
fn penumbrae_are_the_same_along_both_sides_of_long_texels() {
    // A world that is seen much wider than it is deep: texels are long, as with two splits in an atlas of other engines.
    let radius = expected(2.0, 6.0);
    let mut long = 0;
    for turn in [0.0, std::f32::consts::FRAC_PI_2] {
        for (fit, warp) in [(Fit::Scene, Warp::None), (Fit::View, Warp::None), (Fit::View, Warp::Lispsm)] {
            let settings = Settings { fit, warp, ..soft(Filter::Pcss(pcss(6.0))) };
            let world = plate(2.0, turn);
            // Only a strip of it is said to be there.
            let bounds = Bounds::of_world(Vec3::new(-9.0, 0.0, -0.6), Vec3::new(9.0, 2.0, 0.6));
            let projection = Projection::Perspective { fov_y: 0.35, aspect: 4.0 };
            let eye = Vec3::new(0.0, 3.0, 4.0);
            let camera = Camera::looking(eye, Vec3::ZERO, Vec3::Y, projection, 0.5, 40.0).expect("a camera");
            let device = device(wgpu::Backends::VULKAN);
            let drawn = draw_lit(device, settings, &camera, &[sun()], &world, &bounds);
            let texel_basis = drawn.plan.views()[0].texel_basis_at(Vec3::ZERO);
            let ratio = texel_basis.right.length() / texel_basis.down.length();
            let reach = 2.5 * radius as f32;
            let got = radius_of(&drawn.visibility(&across(turn, reach, 0.0)), reach, 0.0);
            println!(
                "turned by {turn:.2}, {fit:?} {warp:?}, texels {ratio:.2} : 1: {got:.4} m of {radius:.4} m"
            );
            long += usize::from(!(0.7..1.4).contains(&ratio));
            assert!(
                (got / radius - 1.0).abs() < 0.05,
                "turned by {turn}, {fit:?} {warp:?}: {got}, not {radius}"
            );
        }
    }
    assert!(long >= 2, "texels are long in {long} of six");
}

#[test]
fn lamps_have_penumbrae_of_their_own_size() {
    let (top, height) = (5.0f32, 2.0f32);
    let lamp = Vec3::new(0.0, top, 0.0);
    let lamps = [Light::spot(lamp, Vec3::NEG_Y, 0.8, 20.0), Light::point(lamp, 20.0)];
    // A disc of 0.2 m around the lamp, seen past an edge: similar triangles.
    let radius = f64::from(0.2 * height / (top - height));
    for light in lamps.map(|lamp| lamp.expect("a lamp")) {
        let filter = Filter::Pcss(Pcss { max_texels: 120.0, ..pcss(1.0) });
        let got = measured(&soft(filter), light, (height, 0.0), 2.5 * radius as f32, 0.0, 3.0);
        println!("{light:?}: {got:.4} m, and {radius:.4} m in the world");
        assert!((got / radius - 1.0).abs() < 0.05, "{light:?}: {got}, not {radius}");
    }
}

#[test]
fn blockers_before_the_near_plane_keep_their_distance() {
    // Objects are what receivers are fitted to: the floor alone, so that the near plane lies just above it. Flattened onto
    // that, the plate would seem to lie there, and cast a narrow penumbra.
    let (height, degrees) = (6.0, 6.0);
    let floor = Aabb { min: Vec3::new(-9.0, 0.0, -9.0), max: Vec3::new(9.0, 0.0, 9.0) };
    let plate_box = Aabb { min: Vec3::new(-9.0, height, -9.0), max: Vec3::new(0.0, height, 9.0) };
    let bounds = Bounds::new(vec![floor, plate_box]);
    // Without the receiver's plane, which would want room before the floor.
    let bias = Bias { receiver_plane: false, ..Bias::default() };
    let filter = Filter::Pcss(Pcss { max_texels: 120.0, ..pcss(degrees) });
    let settings = Settings { bias, resolution: 512, ..soft(filter) };
    assert!(settings.unclipped_depth, "flattening is on for other filters");
    let radius = expected(height, degrees);
    let reach = 2.5 * radius as f32;
    let device = device(wgpu::Backends::VULKAN);
    let drawn = draw_lit(device, settings, &camera(3.0), &[sun()], &plate(height, 0.0), &bounds);
    let view = &drawn.plan.views()[0];
    println!("the map begins {} m before what it ends at", view.depth_metres);
    let got = radius_of(&drawn.visibility(&across(0.0, reach, 0.0)), reach, 0.0);
    assert!((got / radius - 1.0).abs() < 0.05, "{got}, not {radius}");
}

#[test]
fn a_light_without_size_is_hard_and_one_as_large_as_the_sky_is_finite() {
    for (degrees, storage) in [(0.0, Storage::Array), (180.0, Storage::Atlas)] {
        let settings = Settings { storage, ..soft(Filter::Pcss(pcss(degrees))) };
        let world = plate(2.0, 0.0);
        let bounds = Bounds::of_world(Vec3::new(-9.0, 0.0, -9.0), Vec3::new(9.0, 2.0, 9.0));
        let drawn =
            draw_lit(device(wgpu::Backends::VULKAN), settings, &camera(2.0), &[sun()], &world, &bounds);
        let visibility = drawn.visibility(&across(0.0, 0.2, 0.0));
        assert!(visibility.iter().all(|v| (0.0..=1.0).contains(v)), "{degrees}°: {visibility:?}");
        let partly = visibility.iter().filter(|v| **v > 0.02 && **v < 0.98).count();
        // Texels are a millimetre, points a millimetre apart.
        assert_eq!(degrees == 0.0, partly < 8, "{degrees}°: {partly} of 401 are in the penumbra");
    }
}

#[test]
fn penumbrae_of_moments_are_about_as_wide() {
    let light = LightSize { sun_degrees: 6.0, punctual_metres: 0.4 };
    for (height, resolution) in [(1.0, 512), (2.0, 512), (2.0, 1024)] {
        let settings = Settings {
            resolution,
            ..soft(Filter::Mssm(SoftMoments { light, max_texels: 64.0, light_bleed_reduction: 0.0 }))
        };
        let radius = expected(height, 6.0);
        let got = measured(&settings, sun(), (height, 0.0), 2.5 * radius as f32, 0.0, 2.0);
        println!("moments, {height} m at {resolution}: {got:.4} m, and {radius:.4} m in the world");
        // A box for a disc, and a mean that weighs the near edge of a blocker less.
        assert!((got / radius - 1.0).abs() < 0.15, "{height} m at {resolution}: {got}, not {radius}");
    }
}

#[test]
fn what_moments_miss_in_a_wide_box_they_find_in_a_narrow_one() {
    // A step in the floor, 4 m, and a small plate over it. Just beneath the plate, three depths have the moments of the
    // search: the receiver's own, and those of the two floors. None of them is a blocker.
    let mut world = plate(0.0, 0.0);
    world.extend(plate(0.0, 0.0).iter().map(|corners| corners.map(|p| Vec3::new(p.x, -4.0, p.z))));
    world.retain(|corners| corners.iter().all(|p| p.y < 0.0 || p.x <= 0.0));
    let corner = |x: f32, z: f32| Vec3::new(0.15 * x, 2.2, 0.15 * z);
    let [a, b, c, d] = [corner(-1.0, -1.0), corner(-1.0, 1.0), corner(1.0, 1.0), corner(1.0, -1.0)];
    world.extend([[a, b, c], [a, c, d]]);
    // What may cast is as high as 60 m, so the search is as wide as it may be.
    let bounds = Bounds::of_world(Vec3::new(-9.0, -4.0, -9.0), Vec3::new(9.0, 60.0, 9.0));
    let light = LightSize { sun_degrees: 2.0, punctual_metres: 0.4 };
    let filter = Filter::Mssm(SoftMoments { light, ..SoftMoments::default() });
    let settings = Settings { resolution: 512, ..soft(filter) };
    let drawn = draw_lit(device(wgpu::Backends::VULKAN), settings, &camera(6.0), &[sun()], &world, &bounds);
    let beneath = Query { position: Vec3::new(0.0, 2.0, 0.0), _pad0: 0.0, normal: Vec3::Y, _pad1: 0.0 };
    let visibility = drawn.visibility(&[beneath]);
    assert!(visibility[0] < 0.05, "beneath the plate it is dark, not {visibility:?}");
}

#[test]
fn light_fades_in_at_the_terminator_and_surfaces_turned_away_are_dark() {
    let bias = Bias { terminator: 0.3, ..Bias::default() };
    let settings = Settings { bias, ..soft(Filter::Hard {}) };
    let world = plate(2.0, 0.0);
    let bounds = Bounds::of_world(Vec3::new(-9.0, 0.0, -9.0), Vec3::new(9.0, 2.0, 9.0));
    let drawn = draw_lit(device(wgpu::Backends::VULKAN), settings, &camera(2.0), &[sun()], &world, &bounds);
    let maps = drawn.maps();
    // On the open side of the plate, with normals from along the light to against it.
    let normal = |i: i32| Vec3::new((i as f32 * 0.1).sin(), (i as f32 * 0.1).cos(), 0.0);
    let query = |i| Query { position: Vec3::new(0.4, 0.0, 0.2), _pad0: 0.0, normal: normal(i), _pad1: 0.0 };
    let queries: Vec<Query> = (0..31).map(query).collect();
    for (query, gpu) in queries.iter().zip(drawn.visibility(&queries)) {
        let share = (query.normal.y / 0.3).clamp(0.0, 1.0);
        let expected = share * share * (3.0 - 2.0 * share);
        assert!((gpu - expected).abs() < 1e-5, "cosine {}: {gpu}, not {expected}", query.normal.y);
        assert_eq!(gpu == 0.0, query.normal.y <= 0.0, "cosine {}", query.normal.y);
        let rust = drawn.lookup(&maps).visibility(0, query.position, query.normal);
        assert!((rust - gpu).abs() < 1e-5, "cosine {}: {rust} in Rust", query.normal.y);
    }
}
