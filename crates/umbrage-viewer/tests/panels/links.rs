//! Links in the whole program: what they open, what they leave out, and what the button copies.

use eframe::egui;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use umbrage::{Filter, Settings};
use umbrage_render::Mark;
use umbrage_viewer::link::Link;
use umbrage_viewer::load::Source;
use umbrage_viewer::view_state::{PictureMode, ViewState};
use umbrage_viewer::{Start, Viewer};

use crate::{settled, whole, with};

/// The program as a link begins it.
fn of_link(world: &str, text: &str) -> Harness<'static, Viewer> {
    let (link, messages) = Link::parse(text);
    with(world, Start { messages, ..Start::of_link(link) })
}

fn view(harness: &mut Harness<'_, Viewer>) -> ViewState {
    harness.state_mut().view().expect("a world").clone()
}

/// What the button copies.
fn copied(harness: &mut Harness<'_, Viewer>) -> String {
    harness.get_by_label("Copy link").click();
    let mut copied = None;
    for _ in 0..4 {
        harness.step();
        let commands = &harness.output().platform_output.commands;
        copied = copied.or(commands.iter().find_map(|command| match command {
            egui::OutputCommand::CopyText(text) => Some(text.clone()),
            _ => None,
        }));
    }
    copied.expect("the button copies")
}

#[test]
fn a_link_opens_as_it_says_and_the_button_copies_it() {
    let text = "?world=primitives&eye=3,4,9&target=0,1,0&hour=9.5&exposure=1&preset=soft&set=splits=3&right.preset=default&right.set=filter.kind=pcf&divider=0.25&show=splits&lines=slices";
    let mut harness = of_link("primitives", text);
    harness.run_steps(4);
    assert_eq!(harness.state().messages(), [""; 0]);
    let shown = view(&mut harness);
    assert_eq!((shown.settings[0].splits, shown.compare, shown.divider), (3, true, 0.25));
    assert_eq!(Some(&shown.settings[1].filter), Filter::of_kind("pcf").as_ref());
    assert_eq!(
        (shown.mode, shown.hour, shown.exposure.stops),
        (PictureMode::Marked(Mark::Splits), Some(9.5), 1.0)
    );
    assert!(shown.camera().eye().distance(glam::Vec3::new(3.0, 4.0, 9.0)) < 1e-5);
    assert_eq!(copied(&mut harness), text);
}

#[test]
fn a_link_to_the_first_camera_says_little_and_one_from_elsewhere_says_where() {
    let mut harness = whole("primitives");
    assert_eq!(copied(&mut harness), "?world=primitives");
    harness.state_mut().view().expect("a world").flight.eye += glam::Vec3::X;
    let text = copied(&mut harness);
    let (link, messages) = Link::parse(&text);
    let [eye, target] = link.place.expect("a place of one's own");
    assert_eq!(messages, [""; 0]);
    let flight = view(&mut harness).flight;
    let off = eye.distance(flight.eye).max(target.distance(flight.target()));
    assert!(off < 2e-5 * flight.distance, "{text}: {off} m");
}

#[test]
fn what_the_world_does_not_have_is_said_and_the_rest_of_the_link_holds() {
    let mut harness =
        of_link("primitives", "?world=primitives&camera=moon&animation=dance&set=splits=2&colour=red");
    harness.run_steps(4);
    let messages = harness.state().messages();
    for (message, wanted) in messages.iter().zip(["colour=red", "camera=moon", "animation=dance"]) {
        assert!(message.contains(wanted), "{messages:?}");
    }
    assert_eq!((messages.len(), view(&mut harness).settings[0].splits), (3, 2));
}

#[test]
fn a_link_without_a_world_of_its_own_shows_in_the_one_that_is_open_and_another_world_is_loaded() {
    let mut harness = whole("primitives");
    let context = harness.ctx.clone();
    harness.state_mut().follow(&context, "?set=lambda=0.25");
    harness.run_steps(4);
    assert_eq!(view(&mut harness).settings[0], Settings { lambda: 0.25, ..Settings::default() });
    harness.state_mut().follow(&context, "?world=bunny&set=splits=1&truth");
    settled(&mut harness, "bunny");
    let shown = view(&mut harness);
    assert_eq!((shown.settings[0].splits, shown.settings[0].lambda, shown.truth), (1, 0.8, true));
    // A window fetches nothing: it says so, and shows the rest here.
    harness.state_mut().follow(&context, "?load=https://example.org/a.glb&set=splits=2");
    for _ in 0..400 {
        harness.step();
        if !harness.state().is_loading() {
            break;
        }
    }
    harness.run_steps(4);
    let [message] = harness.state().messages() else { panic!("{:?}", harness.state().messages()) };
    assert!(message.contains("load=https://example.org/a.glb") && message.contains("download"), "{message}");
    assert_eq!(view(&mut harness).settings[0].splits, 2);
    assert_eq!(harness.state().world_name(), "bunny");
}

#[test]
fn where_the_first_world_cannot_be_loaded_the_default_one_is_with_the_rest_of_the_link() {
    let default = umbrage_scene::worlds::DEFAULT;
    let mut harness = of_link(default, "?load=https://example.org/a.glb&camera=there&set=splits=2");
    harness.run_steps(4);
    assert_eq!(harness.state().messages().len(), 1, "{:?}", harness.state().messages());
    assert_eq!(view(&mut harness).settings[0].splits, 2);
}

#[test]
fn a_link_from_a_file_of_ones_own_says_that_it_has_no_world() {
    let scene = umbrage_scene::worlds::build("primitives", 0).expect("a built-in world");
    let source = Source::Bytes { name: "mine.glb".to_owned(), bytes: Vec::new() };
    let start = Start { scene: Some(std::sync::Arc::new(scene)), ..Start::new(source, Settings::default()) };
    let mut harness = with("primitives", start);
    assert_eq!(copied(&mut harness), "?");
    let [message] = harness.state().messages() else { panic!("{:?}", harness.state().messages()) };
    assert!(message.contains("file of yours"), "{message}");
}
