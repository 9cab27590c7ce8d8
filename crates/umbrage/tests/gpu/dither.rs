//! Casters that cover in part: the texels that they are drawn in, what panes behind one another let through, and that no camera
//! moves the pattern.

use std::collections::HashMap;

use glam::{DVec2, DVec3, Vec2, Vec3};
use umbrage::{
    Camera, ExponentialVariance, Filter, Fit, Light, Settings, ShadowView, SummedVariance,
    TransparentCasters, shaders::lattice_level,
};

use crate::common::{Drawn, Query, camera};
use crate::sheets::{Corner, draw_sheets, sheet};

/// Leaves out what does not cover; x of the picture coordinates is the coverage.
const DITHERED: &str = "fn is_hole(v: V) -> bool { return !umbrage_caster_covers(v.clip, v.id, v.uv.x); }";

/// A pane that covers so much, with a number by which it is told from others.
fn pane(centre: Vec3, half: f32, coverage: f32, id: u32) -> Vec<[Corner; 3]> {
    let with = |corner: Corner| Corner { uv: Vec2::new(coverage, 0.0), ..corner };
    sheet(centre, half, 0.0, id, false).into_iter().map(|triangle| triangle.map(with)).collect()
}

/// One map of 512² texels of 0.1 m or so, from a sun above; casters are drawn as these settings say.
fn settings(transparent_casters: TransparentCasters) -> Settings {
    let distance = Some(30.0);
    Settings {
        transparent_casters,
        fit: Fit::Stable,
        splits: 1,
        distance,
        resolution: 512,
        ..Settings::default()
    }
}

fn above() -> Camera {
    camera(Vec3::new(0.0, 20.0, 0.1), Vec3::ZERO)
}

fn drawn(settings: Settings, world: &[[Corner; 3]]) -> Drawn {
    let sun = Light::directional(Vec3::new(0.02, -1.0, 0.01)).expect("a sun");
    draw_sheets(settings, &above(), &[sun], world, DITHERED)
}

/// Texels of a view whose rays meet a square about a point, of so many metres to each side, and whether each is drawn.
fn texels(drawn: &Drawn, centre: Vec3, half: f64) -> Vec<([u32; 2], bool)> {
    let (view, maps) = (&drawn.plan.views()[0], drawn.maps());
    let size = view.tile.size;
    let world_from_clip = view.clip_from_world.inverse();
    let is_met = |x: u32, y: u32| {
        let ndc = (DVec2::new(f64::from(x), f64::from(y)) + 0.5) / f64::from(size) * 2.0 - 1.0;
        let [a, b] = [0.0, 1.0].map(|z| world_from_clip.project_point3(DVec3::new(ndc.x, -ndc.y, z)));
        let hit = a + (b - a) * ((f64::from(centre.y) - a.y) / (b.y - a.y)) - centre.as_dvec3();
        hit.x.abs() < half && hit.z.abs() < half
    };
    let all =
        (0..size * size).zip(maps.tile(view.tile)).map(|(i, depth)| ([i % size, i / size], depth > 0.0));
    all.filter(|([x, y], _)| is_met(*x, *y)).collect()
}

/// Of texels, the share that is drawn.
fn share(texels: &[([u32; 2], bool)]) -> f64 {
    texels.iter().filter(|(_, is_drawn)| *is_drawn).count() as f64 / texels.len() as f64
}

/// The place of a texel in the light's lattice.
fn in_lattice(view: &ShadowView, [x, y]: [u32; 2]) -> [u32; 2] {
    let [left, top] = view.lattice();
    [x.wrapping_add(left), y.wrapping_add(top)]
}

#[test]
fn a_pane_is_drawn_in_the_share_of_texels_that_it_covers_and_in_just_those() {
    for (id, coverage) in [(0, 0.0), (1, 0.1), (2, 0.25), (900, 0.4), (4, 0.5), (5, 0.8), (6, 0.95), (7, 1.0)]
    {
        let drawn = drawn(settings(TransparentCasters::Dither), &pane(Vec3::ZERO, 8.0, coverage, id));
        let texels = texels(&drawn, Vec3::ZERO, 7.8);
        assert!(texels.len() >= 64 * 64, "{} texels", texels.len());
        for (texel, is_drawn) in &texels {
            let level = lattice_level(in_lattice(&drawn.plan.views()[0], *texel), id) as f32;
            assert_eq!(*is_drawn, coverage > (level + 0.5) / 256.0, "{texel:?} of {coverage}");
        }
        let share = share(&texels);
        assert!(
            (share - f64::from(coverage)).abs() < 0.01,
            "{share} of the texels, and {coverage} is covered"
        );
        // Any 64 × 64 of them.
        let first = texels[0].0;
        let within = |texel: &[u32; 2]| texel[0] - first[0] < 64 && texel[1] - first[1] < 64;
        let square: Vec<_> = texels.iter().filter(|(t, _)| t[0] >= first[0] && within(t)).copied().collect();
        assert_eq!(square.len(), 64 * 64);
        assert!((self::share(&square) - f64::from(coverage)).abs() < 1.0 / 64.0, "64 × 64 of {coverage}");
    }
}

#[test]
fn panes_behind_one_another_let_through_the_product() {
    for panes in [
        &[(0.5, 0), (0.5, 1)][..],
        &[(0.5, 12), (0.5, 13)],
        &[(0.5, 3), (0.5, 3 << 16)],
        &[(0.25, 8), (0.5, 900)],
        &[(0.75, 1), (0.3, 2)],
        &[(0.5, 1), (0.5, 2), (0.5, 3)],
        &[(0.2, 1), (0.2, 2), (0.2, 3), (0.2, 4)],
    ] {
        let world: Vec<_> = (0..)
            .zip(panes)
            .flat_map(|(i, (coverage, id))| pane(Vec3::Y * i as f32 * 0.5, 8.0, *coverage, *id))
            .collect();
        let drawn = drawn(settings(TransparentCasters::Dither), &world);
        let through = 1.0 - share(&texels(&drawn, Vec3::ZERO, 7.5));
        let product: f64 = panes.iter().map(|(coverage, _)| 1.0 - f64::from(*coverage)).product();
        println!("{panes:?}: {through:.4} of {product:.4}");
        assert!((through - product).abs() < 0.02, "{panes:?} let through {through}, not {product}");
    }
}

#[test]
fn what_covers_in_part_is_solid_or_does_not_cast_where_the_settings_say_so() {
    for (casters, of) in [
        (TransparentCasters::Solid, [(0.0, 0.0), (0.01, 1.0), (0.5, 1.0), (1.0, 1.0)]),
        (TransparentCasters::None, [(0.0, 0.0), (0.5, 0.0), (0.99, 0.0), (1.0, 1.0)]),
        (TransparentCasters::Dither, [(0.0, 0.0), (0.25, 0.25), (0.75, 0.75), (1.0, 1.0)]),
    ] {
        for (coverage, wanted) in of {
            let drawn = drawn(settings(casters), &pane(Vec3::ZERO, 8.0, coverage, 1));
            let share = share(&texels(&drawn, Vec3::ZERO, 7.8));
            assert!((share - wanted).abs() < 0.01, "{casters:?}, {coverage}: {share}");
        }
    }
}

#[test]
fn no_camera_moves_the_pattern_of_a_sun_a_spot_or_a_lamp() {
    let world: Vec<_> = (0..9)
        .flat_map(|i| {
            let at = Vec3::new((i % 3) as f32 - 1.0, 0.3 * i as f32, (i / 3) as f32 - 1.0) * 7.0;
            pane(at, 3.0, 0.1 * (i + 1) as f32, i)
        })
        .collect();
    let lamp = Vec3::new(0.3, 30.0, 0.7);
    let lights = [
        Light::directional(Vec3::new(0.3, -1.0, 0.5)).expect("a sun"),
        Light::spot(lamp, Vec3::NEG_Y, 0.5, 90.0).expect("a spot"),
        Light::point(lamp, 90.0).expect("a lamp"),
    ];
    let settings = Settings { fit: Fit::Stable, splits: 3, resolution: 256, ..Settings::default() };
    let mut kept: HashMap<(usize, [u32; 2]), bool> = HashMap::new();
    let mut seen_again = [0; 3];
    for step in 0..4 {
        let step = step as f32;
        let eye = Vec3::new(-20.0 + 3.137 * step, 9.0 + 0.71 * step, 25.0 - 1.93 * step);
        let camera = camera(eye, Vec3::new(2.0 * step, 0.0, -1.3 * step));
        let drawn = draw_sheets(settings.clone(), &camera, &lights, &world, DITHERED);
        let maps = drawn.maps();
        for view in drawn.plan.views() {
            for (i, depth) in (0..view.tile.size * view.tile.size).zip(maps.tile(view.tile)) {
                let texel = in_lattice(view, [i % view.tile.size, i / view.tile.size]);
                let before = kept.insert((view.index, texel), depth > 0.0);
                assert_eq!(before.unwrap_or(depth > 0.0), depth > 0.0, "light {}, {texel:?}", view.light);
                seen_again[view.light] += usize::from(before == Some(true));
            }
        }
    }
    println!("{seen_again:?} texels are drawn again");
    assert!(seen_again.iter().all(|count| *count > 3000), "{seen_again:?} texels are drawn again");
}

/// What lookups below panes say, and how much they differ from place to place.
fn mean_and_deviation(filter: Filter, panes: &[(f32, u32)]) -> (f32, f32) {
    let panes =
        (1..).zip(panes).flat_map(|(i, (coverage, id))| pane(Vec3::Y * i as f32, 8.0, *coverage, *id));
    let world: Vec<_> = panes.chain(pane(Vec3::NEG_Y, 9.0, 1.0, 0)).collect();
    let points = (0..1600).map(|i| Vec3::new((i % 40) as f32 - 19.5, -6.0, (i / 40) as f32 - 19.5) / 6.0);
    let query = |position| Query { position, _pad0: 0.0, normal: Vec3::Y, _pad1: 0.0 };
    let queries: Vec<Query> = points.map(query).collect();
    let drawn = drawn(Settings { filter, ..settings(TransparentCasters::Dither) }, &world);
    let answers = drawn.visibility(&queries);
    let mean = answers.iter().sum::<f32>() / answers.len() as f32;
    let squares = answers.iter().map(|answer| (answer - mean).powi(2)).sum::<f32>();
    (mean, (squares / answers.len() as f32).sqrt())
}

#[test]
fn lookups_below_panes_find_the_share_of_light_that_gets_through() {
    for name in ["optimised", "pcf", "vogel"] {
        for (panes, product) in [
            (&[(0.25, 1)][..], 0.75),
            (&[(0.5, 2)], 0.5),
            (&[(0.8, 3)], 0.2),
            (&[(0.25, 1), (0.5, 2)], 0.375),
        ] {
            let filter = Filter::of_kind(name).expect("a filter");
            let (mean, deviation) = mean_and_deviation(filter, panes);
            println!("{name} under {panes:?}: {mean:.3} ± {deviation:.3} of {product}");
            assert!((mean - product).abs() < 0.02, "{name}: {mean} gets through {panes:?}");
            // White noise would differ by 0.14 under one pane, and by 0.17 under two.
            let most = if name == "vogel" || panes.len() > 1 { 0.11 } else { 0.06 };
            assert!(deviation < most, "{name}: {mean} ± {deviation} gets through {panes:?}");
        }
    }
    // Moments know one depth of casters, and what they show is darkened a little on purpose.
    for filter in [
        Filter::Evsm4(ExponentialVariance { light_bleed_reduction: 0.0, ..ExponentialVariance::default() }),
        Filter::Savsm(SummedVariance { light_bleed_reduction: 0.0, ..SummedVariance::default() }),
    ] {
        for (coverage, through) in [(0.25, 0.75), (0.5, 0.5), (0.8, 0.2)] {
            let (mean, deviation) = mean_and_deviation(filter, &[(coverage, 1)]);
            println!("{} under {coverage}: {mean:.3} ± {deviation:.3}", filter.kind());
            assert!((mean - through).abs() < 0.04, "{filter:?}: {mean} gets through {coverage}");
        }
    }
}
