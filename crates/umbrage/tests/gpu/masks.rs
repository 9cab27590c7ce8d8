//! Casters with holes: what the maps hold of them is what rays find, texel by texel, in every storage, layer, kind of light and
//! family of filters.

use glam::{DVec2, Vec3};
use umbrage::{Bias, Camera, DepthLayer, Filter, Light, LightKind, Settings, ShadowView, Storage};

use crate::common::{Drawn, Query, camera};
use crate::sheets::{Corner, MASKED, depths_at, draw_sheets, sheet};

const RESOLUTION: u32 = 96;

/// A ground of two layers, and two sheets with holes over it.
fn world() -> Vec<[Corner; 3]> {
    let ground =
        (-4..4).flat_map(|x| (-4..4).map(move |z| Vec3::new(x as f32 + 0.5, 0.0, z as f32 + 0.5) * 5.0));
    let ground = ground.flat_map(|centre| sheet(centre, 2.5, 0.0, 0, false));
    let lower = sheet(Vec3::new(1.0, 4.0, 0.0), 5.0, 1.0, 1, true);
    let upper = sheet(Vec3::new(-2.0, 7.0, 1.0), 4.0, -0.7, 2, true);
    let cellar = sheet(Vec3::NEG_Y, 20.0, 0.0, 0, false);
    ground.chain(cellar).chain(lower).chain(upper).collect()
}

fn eye() -> Camera {
    camera(Vec3::new(-14.0, 9.0, 17.0), Vec3::new(0.0, 1.0, 0.0))
}

/// A sun, a spot, a point light, and one within a bulb whose maps clip what others flatten.
fn lights() -> [Light; 4] {
    let lamp = Vec3::new(0.5, 11.0, 0.0);
    [
        Light::directional(Vec3::new(0.3, -1.0, 0.2)).expect("a sun"),
        Light::spot(lamp, Vec3::new(0.1, -1.0, 0.0), 0.7, 60.0).expect("a spot"),
        Light::point(lamp, 60.0).expect("a lamp"),
        Light::point(lamp - Vec3::Y, 60.0).expect("a lamp").with_near(4.0).expect("a bulb"),
    ]
}

fn settings(storage: Storage, depth_layer: DepthLayer, filter: Filter) -> Settings {
    let bias = Bias { depth_layer, depth_layer_limit: 0.3, ..Bias::default() };
    Settings { storage, bias, filter, resolution: RESOLUTION, splits: 2, ..Settings::default() }
}

/// The least and the most that a texel may hold by rays through its middle and around it; `None` where they meet other surfaces.
fn expected(view: &ShadowView, texel: DVec2, layer: DepthLayer, world: &[[Corner; 3]]) -> Option<(f64, f64)> {
    let world_from_clip = view.clip_from_world.inverse();
    // The rasteriser rounds corners to a 256th of a texel.
    let around = [(0.0, 0.0), (0.02, 0.02), (-0.02, 0.02), (0.02, -0.02), (-0.02, -0.02)];
    let all = around.map(|(x, y)| depths_at(view, world_from_clip, texel + DVec2::new(x, y), world));
    let stored = |depths: &Vec<f64>| match (layer, depths.as_slice()) {
        (_, []) => Some(0.0),
        (DepthLayer::First, [first, ..]) => Some(*first),
        // What is flattened is not told apart.
        (DepthLayer::Midpoint, [first, ..]) if *first >= 1.0 => Some(1.0),
        (DepthLayer::Midpoint, [first, second, ..]) => Some(0.5 * (first + second)),
        // How far behind the first, would be the shader's formula again.
        (DepthLayer::Midpoint, [_]) => None,
        (DepthLayer::Second | DepthLayer::Dual, _) => unreachable!("not asked for"),
    };
    if all.iter().any(|depths| depths.len() != all[0].len()) {
        return None;
    }
    let stored: Option<Vec<f64>> = all.iter().map(stored).collect();
    let stored = stored?;
    Some((stored.iter().copied().fold(f64::INFINITY, f64::min), stored.iter().copied().fold(0.0, f64::max)))
}

/// Whether the camera sees a point, and a light reaches it.
fn is_asked(point: Vec3, light: usize) -> bool {
    let clip = eye().clip_from_world() * point.extend(1.0);
    let is_seen = clip.x.abs() < clip.w && clip.y.abs() < clip.w;
    is_seen
        && match lights()[light].kind() {
            LightKind::Directional { .. } | LightKind::Point { .. } => true,
            LightKind::Spot { position, direction, half_angle, .. } => {
                direction.angle_between(point - position) < half_angle
            }
        }
}

/// That every texel of every view holds what rays find there.
fn holds_what_rays_find(drawn: &Drawn, layer: DepthLayer, world: &[[Corner; 3]]) {
    let maps = drawn.maps();
    let (mut compared, mut all, mut lit) = (0, 0, 0);
    for view in drawn.plan.views() {
        let size = view.tile.size;
        for (index, depth) in (0..size * size).zip(maps.tile(view.tile)) {
            all += 1;
            let texel = DVec2::new(f64::from(index % size), f64::from(index / size)) + 0.5;
            let Some((least, most)) = expected(view, texel, layer, world) else { continue };
            compared += 1;
            lit += usize::from(depth > 0.0);
            let depth = f64::from(depth);
            assert!(
                depth >= least - 2e-5 && depth <= most + 2e-5,
                "view {}, light {}, texel {texel}: {depth}, and by rays {least} to {most}",
                view.index,
                view.light
            );
        }
    }
    println!("{layer:?}: {compared} of {all} texels are compared, {lit} of them drawn");
    assert!(compared * 10 > all * 9 && lit > 20_000, "{compared} of {all} texels, {lit} drawn");
}

#[test]
fn maps_hold_of_casters_with_holes_what_rays_find_in_every_texel() {
    let world = world();
    for storage in [Storage::Array, Storage::Atlas] {
        for layer in [DepthLayer::First, DepthLayer::Midpoint] {
            let settings = settings(storage, layer, Filter::Optimised { size: 3 });
            let drawn = draw_sheets(settings, &eye(), &lights(), &world, MASKED);
            assert!(drawn.plan.views().iter().any(|view| !view.unclipped_depth), "some are clipped");
            holds_what_rays_find(&drawn, layer, &world);
        }
    }
}

/// Whether a point of the ground is lit by rays to the light, and is so within a distance around it.
fn is_lit(point: Vec3, light: usize, around: f32, world: &[[Corner; 3]]) -> Option<bool> {
    let toward = |point: Vec3| match lights()[light].kind() {
        LightKind::Directional { direction } => -direction * 100.0,
        LightKind::Spot { position, .. } | LightKind::Point { position, .. } => position - point,
    };
    let lit = |x: f32, z: f32| {
        let point = point + Vec3::new(x, 0.0, z) * around;
        !crate::sheets::is_between(point, toward(point), world)
    };
    let at = [
        (-1.0, -1.0),
        (1.0, -1.0),
        (-1.0, 1.0),
        (1.0, 1.0),
        (0.0, 1.0),
        (0.0, -1.0),
        (1.0, 0.0),
        (-1.0, 0.0),
    ];
    let all = at.map(|(x, z)| lit(x, z));
    all.iter().all(|one| *one == all[0]).then_some(all[0])
}

/// Points of the ground with what rays say of them, away from edges.
fn known(light: usize, world: &[[Corner; 3]]) -> Vec<(Vec3, bool)> {
    let points = (0..60).flat_map(|x| (0..60).map(move |z| Vec3::new(x as f32, 0.0, z as f32)));
    let points = points.map(|p| p * 0.25 - Vec3::new(7.4, 0.0, 7.4)).filter(|p| is_asked(*p, light));
    points.filter_map(|p| Some((p, is_lit(p, light, 0.22, world)?))).collect()
}

#[test]
fn every_family_of_filters_sees_the_holes() {
    let world = world();
    for name in ["hard", "optimised", "vogel", "pcss", "evsm4", "msm", "savsm"] {
        for layer in [DepthLayer::First, DepthLayer::Dual] {
            let filter = Filter::of_kind(name).expect("a filter");
            let settings = Settings { resolution: 512, ..settings(Storage::Array, layer, filter) };
            let drawn = draw_sheets(settings, &eye(), &lights()[..3], &world, MASKED);
            for light in 0..3 {
                let known = known(light, &world);
                let query = |position| Query { position, _pad0: 0.0, normal: Vec3::Y, _pad1: 0.0 };
                let queries: Vec<Query> = known.iter().map(|(point, _)| query(*point)).collect();
                let answers = drawn.light_visibility(light as u32, &queries);
                for ((point, lit), answer) in known.iter().zip(&answers) {
                    let agrees = *lit == (*answer > 0.5);
                    assert!(agrees, "{name} {layer:?}, light {light}: {point} is {answer}, by rays {lit}");
                }
                let through = known.iter().filter(|(p, lit)| *lit && p.abs().max_element() < 3.0).count();
                assert!(through > 50, "light {light}: {through} places are lit through holes");
            }
        }
    }
}
