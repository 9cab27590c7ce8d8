//! What people do beside changing a setting: ask a pixel why, undo, keep cameras, save pictures, move lights, follow lessons.

use eframe::egui::{self, Key, Modifiers, Pos2, Rect, Vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use umbrage::Settings;
use umbrage_judge::Verdict;
use umbrage_viewer::Viewer;
use umbrage_viewer::lessons::LESSONS;
use umbrage_viewer::pick::Answer;
use umbrage_viewer::view_state::ViewState;

use crate::{settled, whole};

fn view<'h>(harness: &'h mut Harness<'static, Viewer>) -> &'h mut ViewState {
    harness.state_mut().view().expect("a world")
}

/// Steps until something holds.
#[track_caller]
fn until(harness: &mut Harness<'static, Viewer>, what: &str, holds: impl Fn(&Viewer) -> bool) {
    for _ in 0..3000 {
        harness.step();
        if holds(harness.state()) {
            return;
        }
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    panic!("{what} did not come; messages: {:?}", harness.state().messages());
}

fn picture(harness: &Harness<'static, Viewer>) -> Rect {
    harness.get_by_label("the picture").rect()
}

/// Clicks on a place of the screen.
fn click_at(harness: &mut Harness<'static, Viewer>, place: Pos2, modifiers: Modifiers) {
    harness.input_mut().events.push(egui::Event::PointerMoved(place));
    harness.step();
    for pressed in [true, false] {
        let button = egui::PointerButton::Primary;
        harness.input_mut().events.push(egui::Event::ModifiersChanged(modifiers));
        harness.input_mut().events.push(egui::Event::PointerButton {
            pos: place,
            button,
            pressed,
            modifiers,
        });
        harness.step();
    }
    harness.input_mut().events.push(egui::Event::ModifiersChanged(Modifiers::NONE));
}

/// Presses a button, moves the pointer in steps, and lets go.
fn drag(harness: &mut Harness<'static, Viewer>, from: Pos2, by: Vec2) {
    let modifiers = Modifiers::NONE;
    let button = |pos, pressed| egui::Event::PointerButton {
        pos,
        button: egui::PointerButton::Primary,
        pressed,
        modifiers,
    };
    harness.input_mut().events.push(egui::Event::PointerMoved(from));
    harness.step();
    harness.input_mut().events.push(button(from, true));
    harness.step();
    for i in 1..=5 {
        harness.input_mut().events.push(egui::Event::PointerMoved(from + by * (i as f32 / 5.0)));
        harness.step();
    }
    harness.input_mut().events.push(button(from + by, false));
    harness.run_steps(3);
}

#[test]
fn a_pixel_says_why_and_another_picture_forgets_it() {
    let mut harness = whole("primitives");
    let context = harness.ctx.clone();
    harness
        .state_mut()
        .follow(&context, "?world=primitives&set=splits=1&set=resolution=128&set=filter.kind=hard");
    harness.run_steps(4);
    let rect = picture(&harness);
    // Most of the lower half is ground.
    let mut answers = Vec::new();
    for i in 0..12 {
        let share = Vec2::new(0.3 + 0.035 * i as f32, 0.62 + 0.015 * i as f32);
        let place = rect.min + rect.size() * share;
        if i == 0 {
            click_at(&mut harness, place, Modifiers::COMMAND);
        } else {
            view(&mut harness).asks = true;
            click_at(&mut harness, place, Modifiers::NONE);
        }
        until(&mut harness, "an answer", |viewer| viewer.answer().is_some());
        answers.extend(harness.state().answer().cloned());
    }
    harness.run_steps(3);
    assert!(harness.query_by_label_contains("stored depth").is_some(), "the window has its figures");
    let whys: Vec<_> = answers
        .iter()
        .filter_map(|answer| match answer {
            Answer::Why(why) => Some(why),
            Answer::Sky | Answer::NoShadows => None,
        })
        .collect();
    assert!(whys.len() >= 8, "{answers:?}");
    for why in &whys {
        let map = why.map.as_ref().expect("a map serves the ground");
        assert!(map.stored.is_some() && map.texel_metres.min_element() > 0.0, "{why:?}");
        // The map's own answer is the picture's, where nothing is filtered.
        let is_shadow = map.stored.is_some_and(|stored| stored > map.compare);
        assert!(why.verdict == Verdict::NotJudged || is_shadow == (why.shown < 0.5), "{why:?}");
    }
    view(&mut harness).flight.eye += glam::Vec3::X;
    harness.run_steps(3);
    assert_eq!(harness.state().answer(), None, "the pixel was one of another picture");
}

#[test]
fn while_something_moves_a_pixel_is_not_asked_and_that_is_said() {
    let mut harness = whole("primitives");
    view(&mut harness).playing = true;
    harness.run_steps(2);
    let middle = picture(&harness).center();
    click_at(&mut harness, middle, Modifiers::COMMAND);
    harness.run_steps(2);
    let [message] = harness.state().messages() else { panic!("{:?}", harness.state().messages()) };
    assert!(message.contains("stop the animation"), "{message}");
    assert!(!harness.state().is_answering());
}

#[test]
fn settings_before_a_link_to_another_world_are_undone_there() {
    let mut harness = whole("primitives");
    let context = harness.ctx.clone();
    let lambda = |harness: &Harness<'static, Viewer>| harness.state().settings().expect("a world").lambda;
    harness.state_mut().follow(&context, "?set=lambda=0.1");
    harness.run_steps(2);
    harness.state_mut().follow(&context, "?world=bunny");
    settled(&mut harness, "bunny");
    harness.run_steps(2);
    assert_eq!(lambda(&harness), Settings::default().lambda);
    for wanted in [0.1, Settings::default().lambda] {
        harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
        harness.run_steps(2);
        assert_eq!(lambda(&harness), wanted);
    }
}

#[test]
fn a_step_that_the_device_refuses_is_not_taken() {
    let mut harness = whole("primitives");
    let context = harness.ctx.clone();
    // The right side, which is not shown yet, has maps that no device holds.
    view(&mut harness).settings[1].resolution = 1 << 20;
    harness.state_mut().follow(&context, "?set=lambda=0.1&right.preset=default");
    harness.run_steps(2);
    assert_eq!(harness.state().messages(), [""; 0]);
    for _ in 0..2 {
        harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
        harness.run_steps(2);
        let [message] = harness.state().messages() else { panic!("{:?}", harness.state().messages()) };
        assert!(message.contains("these settings cannot be used here"), "{message}");
        let shown = view(&mut harness);
        assert_eq!((shown.settings[0].lambda, shown.compare), (0.1, true));
    }
    // With one side the same step is there still.
    harness.key_press(Key::C);
    harness.run_steps(2);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    harness.run_steps(2);
    assert_eq!(harness.state().settings(), Some(&Settings::default()));
}

#[test]
fn settings_are_undone_and_redone_by_keys_and_buttons() {
    let mut harness = whole("primitives");
    let context = harness.ctx.clone();
    let lambda = |harness: &Harness<'static, Viewer>| harness.state().settings().expect("a world").lambda;
    for link in ["?set=lambda=0.1", "?set=lambda=0.2"] {
        harness.state_mut().follow(&context, link);
        harness.run_steps(2);
    }
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    harness.run_steps(2);
    assert_eq!(lambda(&harness), 0.1);
    harness.get_by_label("undo").click();
    harness.run_steps(2);
    assert_eq!(harness.state().settings(), Some(&Settings::default()));
    harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
    harness.run_steps(2);
    assert_eq!(lambda(&harness), 0.1);
    harness.get_by_label("redo").click();
    harness.run_steps(2);
    assert_eq!(lambda(&harness), 0.2);
}

#[test]
fn a_camera_is_saved_under_a_name_found_again_and_deleted() {
    let mut harness = whole("primitives");
    view(&mut harness).flight.eye += glam::Vec3::new(1.0, 2.0, 3.0);
    let there = view(&mut harness).camera().eye();
    let open = |harness: &mut Harness<'static, Viewer>| {
        harness.get_by_label("Camera").click();
        harness.run_steps(3);
    };
    open(&mut harness);
    let field = harness.get_all_by_label("bookmark").last().expect("a field").rect().center();
    click_at(&mut harness, field, Modifiers::NONE);
    harness.run_steps(3);
    // The menu is still open, and the field has the focus.
    harness.get_all_by_label("bookmark").last().expect("a field").type_text("by the cone");
    harness.run_steps(3);
    harness.key_press(Key::Enter);
    harness.run_steps(3);
    view(&mut harness).flight.eye = glam::Vec3::new(0.0, 9.0, 9.0);
    harness.run_steps(2);
    if harness.query_by_label("by the cone").is_none() {
        open(&mut harness);
    }
    harness.get_by_label("by the cone").click();
    harness.run_steps(3);
    let back = view(&mut harness).camera().eye();
    assert!(back.distance(there) < 1e-3, "{back} {there}");
    if harness.query_by_label("delete by the cone").is_none() {
        open(&mut harness);
    }
    harness.get_by_label("delete by the cone").click();
    harness.run_steps(3);
    assert!(harness.query_by_label("by the cone").is_none(), "it is gone");
}

#[test]
fn a_sun_is_dragged_by_its_handle_and_reset() {
    let mut harness = whole("primitives");
    let sun = |harness: &mut Harness<'static, Viewer>| {
        let scene = std::sync::Arc::clone(&harness.state().world().expect("a world").scene);
        view(harness).lights(&scene)[0].direction()
    };
    let before = sun(&mut harness);
    harness.get_by_label("move lights").click();
    harness.run_steps(3);
    let handle = harness.get_by_label("direction of sun").rect().center();
    drag(&mut harness, handle, Vec2::new(40.0, 25.0));
    let after = sun(&mut harness);
    assert!(before.dot(after) < 0.999, "{before} {after}");
    assert_eq!(view(&mut harness).moved_lights.len(), 1);
    harness.get_by_label("reset lights").click();
    harness.run_steps(3);
    assert_eq!(sun(&mut harness), before);
}

#[test]
fn every_lesson_opens_and_draws() {
    let mut harness = whole("primitives");
    for (i, lesson) in LESSONS.iter().enumerate() {
        harness.get_by_label("Lessons").click();
        harness.run_steps(3);
        harness.get_by_label(&format!("{} {}", i + 1, lesson.title)).click();
        harness.run_steps(2);
        let world = lesson.link.split(['=', '&']).nth(1).expect("a world").to_owned();
        settled(&mut harness, &world);
        harness.run_steps(3);
        assert_eq!(harness.state().messages(), [""; 0], "{}", lesson.title);
        assert!(harness.query_all_by_label_contains(lesson.title).count() > 0, "{}", lesson.title);
        let image = harness.render().expect("a picture");
        let area = picture(&harness);
        let colours: std::collections::BTreeSet<[u8; 4]> = (0..400)
            .map(|j| {
                let share = Vec2::new((j % 20) as f32 / 20.0, (j / 20) as f32 / 20.0);
                let place = area.min + area.size() * share;
                image.get_pixel(place.x as u32, place.y as u32).0
            })
            .collect();
        assert!(colours.len() > 40, "{}: {} colours", lesson.title, colours.len());
    }
}
