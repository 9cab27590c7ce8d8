//! The panels: how they look, that every widget has a name, and that what people choose is what comes out.
//!
//! References are drawn by lavapipe, in `tests/snapshots`. `UPDATE_SNAPSHOTS=1 cargo test -p umbrage-viewer --test panels`
//! draws them anew: look at them before you keep them.

mod hands;
mod links;

use std::sync::Arc;

use eframe::egui::{self, Vec2};
use eframe::egui_wgpu;
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use glam::Vec3;
use umbrage::schema::{self, Values};
use umbrage::{Contact, Exact, Filter, Settings, Shade, Warp};
use umbrage_render::{Exposure, Gpu};
use umbrage_scene::rig::{Animation, Channel, Node, Place, Rig, Track};
use umbrage_scene::{Curve, Keys};
use umbrage_viewer::load::Source;
use umbrage_viewer::panels::settings::{self as settings_panel, Refused};
use umbrage_viewer::view_state::PathPosition;
use umbrage_viewer::{Start, Viewer, native};

type Panel = Harness<'static, (Settings, Option<Refused>)>;

fn panel(settings: Settings, height: f32) -> Panel {
    let show = |ui: &mut egui::Ui, (settings, refused): &mut (Settings, Option<Refused>)| {
        if let Some(changed) = settings_panel::show(ui, settings, refused) {
            *settings = changed;
        }
    };
    Harness::builder()
        .with_size(Vec2::new(340.0, height))
        .with_max_steps(32)
        .wgpu_setup(native::setup(Some("vulkan".to_owned())))
        .build_ui_state(show, (settings, None))
}

/// Settings of which every group has something to show.
fn rich() -> Settings {
    let filter = Filter::of_kind("evsm4").expect("a filter");
    let shade = Shade::of_kind("colour").expect("a shade");
    Settings {
        filter,
        shade,
        contact: Some(Contact::default()),
        distance: Some(300.0),
        ..Settings::default()
    }
}

#[test]
fn the_panel_of_the_default_looks_as_it_did() {
    let mut panel = panel(Settings::default(), 560.0);
    panel.run();
    panel.snapshot("settings_default");
}

#[test]
fn every_group_opens_and_every_key_that_applies_has_a_widget() {
    let mut panel = panel(rich(), 1500.0);
    panel.run();
    for group in ["bias", "contact", "shade"] {
        panel.get_by_label(group).click();
        panel.run();
    }
    panel.snapshot("settings_rich");
    for key in schema::keys_of(&rich()) {
        let known = panel.query_all_by_label_contains(key.label).count();
        assert!(known > 0, "{} ({}) is nowhere", key.label, key.name);
    }
}

#[test]
fn a_slider_a_menu_and_a_switch_change_just_their_setting() {
    let mut panel = panel(Settings::default(), 900.0);
    panel.run();
    let slider = |panel: &Panel, name: &str| {
        let mut nodes = panel.get_all_by_label(name);
        let is_slider =
            |node: &egui_kittest::Node<'_>| node.accesskit_node().role() == egui::accesskit::Role::Slider;
        nodes.find(is_slider).expect("a slider").set_value_accesskit(2.0);
    };
    slider(&panel, "splits");
    panel.run();
    assert_eq!(panel.state().0, Settings { splits: 2, ..Settings::default() });
    choose(&mut panel, "warp", "TSM");
    assert_eq!(panel.state().0, Settings { splits: 2, warp: Warp::Tsm, ..Settings::default() });
    choose(&mut panel, "kind", "VSM");
    let vsm = Filter::of_kind("vsm").expect("a filter");
    assert_eq!(panel.state().0, Settings { splits: 2, warp: Warp::Tsm, filter: vsm, ..Settings::default() });
    choose(&mut panel, "fit", "stable");
    assert_eq!(panel.state().0.fit, umbrage::Fit::Scene, "a warp excludes it");
    assert!(panel.query_by_label_contains("excludes").is_some(), "and the panel says so");
    panel.get_by_label("reset").click();
    panel.run();
    assert_eq!(panel.state().0, Settings::default());
}

fn choose(panel: &mut Panel, menu: &str, item: &str) {
    let is_menu =
        |node: &egui_kittest::Node<'_>| node.accesskit_node().role() == egui::accesskit::Role::ComboBox;
    panel.get_all_by_label(menu).find(is_menu).expect("a menu").click();
    panel.run();
    panel.get_all_by_label(item).last().expect("an item").click();
    panel.run();
}

#[test]
fn every_choice_says_what_it_does_and_every_number_its_range() {
    for key in schema::keys() {
        assert!(!key.help.is_empty(), "{}", key.name);
        match key.values {
            Values::Choice(choices) => {
                choices.iter().for_each(|choice| assert!(!choice.help.is_empty(), "{}", choice.name));
            }
            _ => assert!(!key.wanted().is_empty(), "{}", key.name),
        }
    }
}

/// The whole program with a world in it, without a window.
fn whole(world: &str) -> Harness<'static, Viewer> {
    with(world, Start::new(Source::Named(world.to_owned()), Settings::default()))
}

/// The whole program as it begins with this.
fn with(world: &str, start: Start) -> Harness<'static, Viewer> {
    on(native::setup(Some("vulkan".to_owned())), world, start)
}

/// The same on a device of one's own.
fn on(setup: egui_wgpu::WgpuSetup, world: &str, start: Start) -> Harness<'static, Viewer> {
    let mut harness = Harness::builder()
        .with_size(Vec2::new(1100.0, 1400.0))
        .with_max_steps(16)
        .wgpu_setup(setup)
        .build_eframe(move |creation| Viewer::new(creation, start).expect("a device"));
    settled(&mut harness, world);
    harness
}

/// Waits until a world is there.
fn settled(harness: &mut Harness<'static, Viewer>, world: &str) {
    for _ in 0..2000 {
        harness.step();
        if !harness.state().is_loading() && !harness.state().world_name().is_empty() {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    assert_eq!(harness.state().world_name(), world);
}

#[test]
fn every_widget_of_the_whole_window_has_a_name() {
    let mut harness = whole("primitives");
    let view = harness.state_mut().view().expect("a world");
    (view.help, view.maps, view.path, view.compare) = (true, true, Some(PathPosition::default()), true);
    harness.run_steps(4);
    harness.check_accessibility();
    for name in [
        "World",
        "Camera",
        "Export",
        "Keys",
        "time of day",
        "exposure",
        "automatic exposure",
        "haze",
        "show errors",
        "the picture",
        "along the path",
        "hold",
    ] {
        assert!(harness.query_all_by_label(name).count() > 0, "{name}");
    }
}

#[test]
fn a_flight_along_the_path_is_held_and_goes_on() {
    let mut harness = whole("primitives");
    let eye = |harness: &mut Harness<'_, Viewer>| harness.state_mut().view().expect("a world").camera().eye();
    let start = eye(&mut harness);
    harness.state_mut().view().expect("a world").path = Some(PathPosition { along: 0.4, held: false });
    harness.run_steps(3);
    let flown = eye(&mut harness);
    assert!(flown.distance(start) > 0.1, "it flies: {start}, {flown}");
    harness.get_by_label("hold").click();
    harness.run_steps(6);
    let held = eye(&mut harness);
    harness.run_steps(3);
    assert_eq!(eye(&mut harness), held, "it is held");
    harness.get_by_label("hold").click();
    harness.run_steps(6);
    assert!(eye(&mut harness).distance(held) > 1e-3, "it goes on");
}

#[test]
fn exposure_stays_where_it_is_put_and_starts_from_what_the_world_asks_for() {
    let mut harness = whole("primitives");
    let view = |harness: &mut Harness<'_, Viewer>| harness.state_mut().view().expect("a world").clone();
    assert_eq!((view(&mut harness).exposure, view(&mut harness).haze), (Exposure::default(), true));
    harness.get_by_label("automatic exposure").click();
    harness.run_steps(4);
    harness.get_by_label("haze").click();
    harness.run_steps(4);
    let lux = view(&mut harness).exposure.lux.expect("it is held");
    assert!((lux - 1.385).abs() < 1e-3 && !view(&mut harness).haze, "the world's own: {lux}");
    harness.get_by_label("automatic exposure").click();
    harness.run_steps(4);
    assert_eq!(view(&mut harness).exposure.lux, None);
}

/// Two animations that move nothing but one node, of 4 s and of 3 s.
fn animated() -> Start {
    let mut scene = umbrage_scene::worlds::build("primitives", 0).expect("a built-in world");
    let animation = |name: &str, seconds: f32| {
        let up = Curve::new(vec![0.0, seconds], Keys::Linear(vec![Vec3::ZERO, Vec3::Y])).expect("a curve");
        let channels = vec![Channel { node: 0, track: Track::Translation(up) }];
        Animation { name: name.to_owned(), seconds, channels }
    };
    scene.rig = Rig {
        nodes: vec![Node {
            name: "lift".to_owned(),
            parent: None,
            rest: Place::HERE,
            visible: true,
            weights: Vec::new(),
        }],
        skins: Vec::new(),
        animations: vec![animation("rise", 4.0), animation("", 3.0)],
        playing: Some(0),
    };
    let source = Source::Named("primitives".to_owned());
    Start { scene: Some(Arc::new(scene)), seconds: 1.0, ..Start::new(source, Settings::default()) }
}

#[test]
fn an_animation_is_chosen_played_and_held_where_it_is_put() {
    let mut harness = with("primitives", animated());
    let view = |harness: &mut Harness<'_, Viewer>| harness.state_mut().view().expect("a world").clone();
    assert_eq!((view(&mut harness).animation, view(&mut harness).seconds), (Some(0), 1.0));
    for (item, chosen) in [("animation 1", Some(1)), ("none", None), ("rise", Some(0))] {
        let is_menu =
            |node: &egui_kittest::Node<'_>| node.accesskit_node().role() == egui::accesskit::Role::ComboBox;
        harness.get_all_by_label("animation").find(is_menu).expect("a menu").click();
        harness.run_steps(4);
        harness.get_all_by_label(item).last().expect("an item").click();
        harness.run_steps(4);
        assert_eq!((view(&mut harness).animation, view(&mut harness).seconds), (chosen, 0.0), "{item}");
    }
    harness.get_by_label("animate").click();
    harness.run_steps(6);
    assert!(view(&mut harness).playing && view(&mut harness).seconds > 0.0, "it plays");
    let is_slider =
        |node: &egui_kittest::Node<'_>| node.accesskit_node().role() == egui::accesskit::Role::Slider;
    let slider = |harness: &Harness<'_, Viewer>| {
        let node = harness.get_all_by_label("along it").find(is_slider).expect("a slider");
        node.focus();
        node.set_value_accesskit(2.5);
    };
    slider(&harness);
    harness.run_steps(4);
    let held = view(&mut harness);
    assert!(!held.playing && (held.seconds - 2.5).abs() < 1e-3, "held at {} s", held.seconds);
}

#[test]
fn rays_are_traced_when_their_casters_are_ready_and_both_sides_share_them() {
    let mut harness = whole("primitives");
    assert!(!harness.state().is_making_casters(), "nobody asked for rays");
    let exact = |harness: &mut Harness<'_, Viewer>, side: usize, exact: Exact| {
        harness.state_mut().view().expect("a world").edited = side;
        harness.run_steps(2);
        let name = format!("{exact:?}").to_lowercase();
        let is_menu =
            |node: &egui_kittest::Node<'_>| node.accesskit_node().role() == egui::accesskit::Role::ComboBox;
        harness.get_all_by_label("exact").find(is_menu).expect("a menu").click();
        harness.run_steps(4);
        harness.get_all_by_label(&name).last().expect("an item").click();
        harness.run_steps(4);
    };
    let memory = |harness: &Harness<'_, Viewer>| {
        harness.query_all_by_label_contains("MiB of casters for rays").count()
    };
    exact(&mut harness, 0, Exact::Undecided);
    assert_eq!(harness.state().settings().expect("a world").exact, Exact::Undecided);
    for _ in 0..2000 {
        harness.step();
        if !harness.state().is_making_casters() {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    harness.run_steps(4);
    assert_eq!(harness.state().messages(), [""; 0]);
    assert_eq!(memory(&harness), 1, "what rays go through is counted");
    harness.get_by_label("compare two settings").click();
    harness.run_steps(4);
    exact(&mut harness, 1, Exact::Always);
    assert!(!harness.state().is_making_casters(), "both sides have the same");
    assert_eq!(memory(&harness), 1, "and the right side shows them too");
}

#[test]
fn a_device_that_takes_no_casters_is_said_so_of_once_and_maps_go_on() {
    let egui_wgpu::WgpuSetup::CreateNew(mut setup) = native::setup(Some("vulkan".to_owned())) else {
        panic!("the window makes its own device");
    };
    setup.device_descriptor = Arc::new(|adapter| {
        let mut wanted = Gpu::wanted_device(adapter);
        wanted.required_limits.max_storage_buffer_binding_size = 16 << 10;
        wanted
    });
    let settings = Settings { exact: Exact::Always, ..Settings::default() };
    let start = Start::new(Source::Named("primitives".to_owned()), settings);
    let mut harness = on(egui_wgpu::WgpuSetup::CreateNew(setup), "primitives", start);
    for _ in 0..400 {
        harness.step();
        if !harness.state().messages().is_empty() {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    harness.run_steps(8);
    let [message] = harness.state().messages() else { panic!("{:?}", harness.state().messages()) };
    assert!(message.contains("maps alone answer") && message.contains("hold 16384"), "{message}");
    assert!(!harness.state().is_making_casters(), "it is not tried again");
    assert_eq!(harness.query_all_by_label_contains("MiB of casters for rays").count(), 0);
    assert!(harness.query_all_by_label_contains("4 maps").count() > 0, "and there is a picture");
}
