//! A change of settings or lights remakes no more than it needs, and plans of others are refused.

use glam::Vec3;
use umbrage::{
    Bias, Bounds, Camera, CasterFaces, Changed, Disc, Filter, Light, Pcss, Prefilter, Select, Settings,
    Shade, ShadowError, Shadows, Storage, Variance, Warp,
};

use crate::common::{bounds, camera, device, draw, queries, world};

fn view() -> (Camera, Bounds) {
    (camera(Vec3::new(-30.0, 9.0, 38.0), Vec3::ZERO), bounds(&world()))
}

fn sun() -> Light {
    Light::directional(Vec3::new(0.4, -0.8, 0.3)).expect("a sun")
}

fn filtered(filter: Filter) -> Settings {
    Settings { filter, resolution: 256, ..Settings::default() }
}

#[test]
fn what_is_planned_or_in_the_frame_makes_no_object() {
    let (device, _) = device(wgpu::Backends::VULKAN);
    let variance = Filter::Vsm(Variance::default());
    for filter in [Settings::default().filter, Filter::Pcss(Pcss::default()), variance] {
        let settings = Settings { blend: 0.1, ..filtered(filter) };
        let mut shadows = Shadows::new(&device, settings.clone()).expect("valid settings");
        let colour = Shade::Colour { shadow_colour: [0.0, 0.0, 0.3, 0.5], darkness: 0.5 };
        let bias = Bias {
            constant: 0.1,
            slope: 0.5,
            slope_limit: 3.0,
            normal: 2.0,
            terminator: 0.2,
            depth_layer_limit: 0.3,
            ..settings.bias
        };
        for (what, changed) in [
            ("λ", Settings { lambda: 0.3, ..settings.clone() }),
            ("distance", Settings { distance: Some(40.0), ..settings.clone() }),
            ("the constants of the bias", Settings { bias, ..settings.clone() }),
            ("shade", Settings { shade: colour, ..settings.clone() }),
            ("the width of blends", Settings { blend: 0.2, ..settings.clone() }),
            ("nothing", settings.clone()),
        ] {
            let made = shadows.set_settings(&device, changed.clone()).expect("valid settings");
            assert_eq!(made, Changed::default(), "{what} under {filter:?}");
            assert_eq!(*shadows.settings(), changed);
            let _ = shadows.set_settings(&device, settings.clone()).expect("valid settings");
        }
    }
}

#[test]
fn a_change_remakes_what_it_needs_and_says_so() {
    let (device, _) = device(wgpu::Backends::VULKAN);
    let settings = filtered(Settings::default().filter);
    let vsm = |bleed: f32, blur_texels: u32| {
        let prefilter = Prefilter { blur_texels, ..Prefilter::default() };
        filtered(Filter::Vsm(Variance { light_bleed_reduction: bleed, prefilter, ..Variance::default() }))
    };
    let disc = filtered(Filter::Vogel(Disc::default()));
    let casters = Bias { casters: CasterFaces::Back, raster_slope: 1.0, ..Bias::default() };
    let (maps, casters_, receivers) = ((true, false, false), (false, true, false), (false, false, true));
    for (what, from, to, wanted) in [
        ("filter", &settings, &disc, receivers),
        ("to moments", &settings, &vsm(0.2, 2), (true, false, true)),
        ("from moments", &vsm(0.2, 2), &settings, (true, false, true)),
        ("a number of moments", &vsm(0.2, 2), &vsm(0.3, 2), receivers),
        ("the blur of moments", &vsm(0.2, 2), &vsm(0.2, 3), receivers),
        ("select", &settings, &Settings { select: Select::Depth, ..settings.clone() }, receivers),
        ("warp", &settings, &Settings { warp: Warp::Lispsm, ..settings.clone() }, (false, false, false)),
        ("blends or not", &settings, &Settings { blend: 0.1, ..settings.clone() }, receivers),
        ("faces", &settings, &Settings { bias: casters, ..settings.clone() }, casters_),
        ("resolution", &settings, &Settings { resolution: 128, ..settings.clone() }, maps),
        ("splits", &settings, &Settings { splits: 2, ..settings.clone() }, maps),
        ("storage", &settings, &Settings { storage: Storage::Atlas, ..settings.clone() }, maps),
    ] {
        let mut shadows = Shadows::new(&device, from.clone()).expect("valid settings");
        let changed = shadows.set_settings(&device, to.clone()).expect("valid settings");
        assert_eq!((changed.maps, changed.casters, changed.receivers), wanted, "{what}");
        let afresh = Shadows::new(&device, to.clone()).expect("valid settings");
        assert_eq!(shadows.wgsl(1), afresh.wgsl(1), "{what}");
        assert_eq!(shadows.bytes(), afresh.bytes(), "{what}");
        let idle = shadows.set_settings(&device, to.clone()).expect("valid settings");
        assert_eq!(idle, Changed::default(), "{what}, again");
    }
}

#[test]
fn an_allocation_persists_while_lights_and_sizes_do() {
    let (device, _) = device(wgpu::Backends::VULKAN);
    let mut shadows = Shadows::new(&device, filtered(Settings::default().filter)).expect("valid settings");
    let lamp = |x: f32| Light::point(Vec3::new(x, 9.0, 0.0), 30.0).expect("a lamp").with_resolution(64);
    assert_eq!(shadows.allocate(&device, &[sun()]), Ok(Changed::default()), "new ones have room for a sun");
    let more = shadows.allocate(&device, &[sun(), lamp(1.0)]).expect("room");
    assert!(more.maps && more.objects > 0 && !more.casters && !more.receivers, "{more:?}");
    let moved = shadows.allocate(&device, &[sun(), lamp(2.0)]).expect("room");
    assert_eq!(moved, Changed::default(), "a lamp that moves needs no other room");
    let splits = Settings { splits: 2, ..shadows.settings().clone() };
    assert!(shadows.set_settings(&device, splits).expect("valid settings").maps);
    assert_eq!(shadows.allocation().tiles().len(), 2 + 6, "the lights are still those");
    let none = shadows.allocate(&device, &[]).map_err(|error| error.to_string());
    assert_eq!(none, Err("shadows need 1 to 16 lights, got 0".to_owned()));
    assert_eq!(shadows.allocation().tiles().len(), 2 + 6, "a refusal changes nothing");
}

#[test]
fn settings_that_were_changed_draw_as_settings_from_the_start() {
    let (eye, world) = (view().0, world());
    let light = Vec3::new(0.4, -0.8, 0.3);
    let queries = queries(&world, &eye, 20);
    let wanted = filtered(Filter::Vsm(Variance::default()));
    let drawn = draw(device(wgpu::Backends::VULKAN), wanted.clone(), &eye, &[light], &world);
    let expected = drawn.visibility(&queries);
    let other = draw(
        device(wgpu::Backends::VULKAN),
        Settings { splits: 2, ..filtered(Filter::Pcss(Pcss::default())) },
        &eye,
        &[light],
        &world,
    );
    let crate::common::Drawn { device, queue, mut shadows, .. } = other;
    let _ = shadows.set_settings(&device, wanted).expect("valid settings");
    let again = crate::common::draw_again((device, queue), shadows, &eye, &[sun()], &world, &bounds(&world));
    assert!(again.visibility(&queries) == expected, "the same to the bit");
}

#[test]
fn a_plan_of_other_settings_or_of_other_shadows_is_an_error() {
    let (device, queue) = device(wgpu::Backends::VULKAN);
    let (eye, bounds) = view();
    let settings = filtered(Settings::default().filter);
    let mut shadows = Shadows::new(&device, settings.clone()).expect("valid settings");
    let mut encoder = device.create_command_encoder(&Default::default());
    let plan_of = |settings: Settings, lights: &[Light]| {
        let mut other = Shadows::new(&device, settings).expect("valid settings");
        let _ = other.allocate(&device, lights).expect("room");
        other.plan(&eye, lights, &bounds).expect("a plan")
    };
    let other = plan_of(Settings { lambda: 0.25, ..settings.clone() }, &[sun()]);
    let wanted = "the plan was made with `lambda: 0.25`, and these shadows have `lambda: 0.8`; plan with Shadows::plan after the settings have changed";
    assert_eq!(shadows.upload(&queue, &other).map_err(|e| e.to_string()), Err(wanted.to_owned()));
    assert!(matches!(shadows.cast(&mut encoder, &other), Err(ShadowError::OtherSettings { .. })));
    assert!(shadows.finish(&mut encoder, &other).is_err());

    let larger = plan_of(settings.clone(), &[sun().with_resolution(512)]);
    assert!(matches!(shadows.upload(&queue, &larger), Err(ShadowError::View { index: 0, .. })));
    assert!(matches!(shadows.begin(&mut encoder, &larger.views()[0], None), Err(ShadowError::View { .. })));
    let more = plan_of(settings, &[sun(), sun()]);
    let error = shadows.begin(&mut encoder, &more.views()[7], None).map_err(|error| error.to_string());
    let wanted = "view 7 with a tile of 256 texels at 0, 0 in layer 7 does not belong to these shadows, which have 4 views in maps of 256 x 256 texels in 4 layers; upload and draw a plan that they made themselves";
    assert_eq!(error.err(), Some(wanted.to_owned()));
}
