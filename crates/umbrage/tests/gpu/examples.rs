//! The example programs draw what they say, with filters that compare and filters of moments, with one surface and with two.

#![expect(clippy::duplicate_mod, reason = "each program loads what they share")]

use std::fmt::Debug;
use std::ops::Range;

use umbrage::{Bias, Contact, DepthLayer, Exact, ExponentialVariance, Filter, Settings, Shade};

#[expect(dead_code, reason = "a program's `main`, and what only that calls")]
#[path = "../../examples/alpha.rs"]
mod alpha;
#[expect(dead_code, reason = "a program's `main`, and what only that calls")]
#[path = "../../examples/contact.rs"]
mod contact;
#[expect(dead_code, reason = "a program's `main`, and what only that calls")]
#[path = "../../examples/deferred.rs"]
mod deferred;
#[expect(dead_code, reason = "a program's `main`, and what only that calls")]
#[path = "../../examples/exact.rs"]
mod exact;
#[expect(dead_code, reason = "a program's `main`, and what only that calls")]
#[path = "../../examples/kept_tiles.rs"]
mod kept_tiles;
#[expect(dead_code, reason = "a program's `main`, and what only that calls")]
#[path = "../../examples/lamps.rs"]
mod lamps;
#[expect(dead_code, reason = "a program's `main`, and what only that calls")]
#[path = "../../examples/moments.rs"]
mod moments;
#[expect(dead_code, reason = "a program's `main`, and what only that calls")]
#[path = "../../examples/own_pipeline.rs"]
mod own_pipeline;
#[expect(dead_code, reason = "a program's `main`, and what only that calls")]
#[path = "../../examples/skinned.rs"]
mod skinned;
#[expect(dead_code, reason = "a program's `main`, and what only that calls")]
#[path = "../../examples/window.rs"]
mod window;

/// The settings that pictures are drawn with, with their names.
fn all_settings() -> impl Iterator<Item = (String, Settings)> {
    let moments = Filter::Evsm4(ExponentialVariance::default());
    let filters = [Settings::default().filter, moments];
    let layers = [DepthLayer::First, DepthLayer::Dual];
    filters.into_iter().flat_map(move |filter| {
        layers.map(|depth_layer| {
            let bias = Bias { depth_layer, ..Bias::default() };
            (format!("{} {depth_layer:?}", filter.kind()), Settings { filter, bias, ..Settings::default() })
        })
    })
}

/// The pixels of a picture.
fn pixels(rgb: &[u8]) -> &[[u8; 3]] {
    bytemuck::cast_slice(rgb)
}

/// Pixels of the ground: how many are lit, and how many dark. Both have the ground's hue.
fn ground(rgb: &[u8]) -> [usize; 2] {
    let (mut lit, mut dark) = (0, 0);
    for [r, g, b] in pixels(rgb) {
        let [r, g, b] = [r, g, b].map(|c| f32::from(*c) / 255.0);
        let is_ground = r > g && g > b && g > 0.88 * r && b < 0.9 * g;
        lit += usize::from(is_ground && r > 0.75);
        dark += usize::from(is_ground && r < 0.5);
    }
    [lit, dark]
}

/// The mean difference of two pictures, of 255.
fn difference(a: &[u8], b: &[u8]) -> f64 {
    a.iter().zip(b).map(|(a, b)| f64::from(a.abs_diff(*b))).sum::<f64>() / a.len() as f64
}

/// Draws with all settings: the ground has shadow in such a part of it, and all pictures are alike.
fn draws<E: Debug>(name: &str, draw: impl Fn(Settings) -> Result<Vec<u8>, E>, shadow: Range<f64>) {
    let mut first: Option<Vec<u8>> = None;
    for (with, settings) in all_settings() {
        let picture = draw(settings).expect("a picture");
        let [lit, dark] = ground(&picture);
        let share = dark as f64 / (lit + dark) as f64;
        let differs = difference(first.get_or_insert_with(|| picture.clone()), &picture);
        println!("{name}, {with}: {lit} lit, {share:.4} dark; {differs:.3} of 255 from the first");
        assert!(shadow.contains(&share), "{name}, {with}: {share} of the ground is dark");
        assert!(differs < 2.0, "{name}, {with}: differs from the first by {differs} of 255");
    }
}

#[test]
fn leaves_cast_shadows_with_their_holes() {
    draws("alpha", alpha::draw, 0.06..0.085); // 0.103 of whole cards
}

#[test]
fn a_hosts_own_pipeline_casts_as_the_librarys_does() {
    draws("own_pipeline", own_pipeline::draw, 0.065..0.09);
}

/// How many pixels are darker in one picture than in another, in a hundred.
fn darker(a: &[u8], b: &[u8]) -> f64 {
    let sum = |rgb: &[u8; 3]| rgb.iter().map(|c| i32::from(*c)).sum::<i32>();
    let pairs = pixels(a).iter().zip(pixels(b));
    100.0 * pairs.filter(|(a, b)| sum(b) - sum(a) > 30).count() as f64 / (a.len() / 3) as f64
}

/// Settings with which nothing has a shadow.
fn without_shadows() -> Settings {
    Settings { shade: Shade::Absence { darkness: 0.0 }, ..Settings::default() }
}

/// Leaves a picture where one can look at it.
fn leave(name: &str, rgb: &[u8]) {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("examples");
    std::fs::create_dir_all(&folder).expect("a folder");
    let size = (rgb.len() / 3).isqrt();
    let file = [format!("P6 {size} {size} 255\n").as_bytes(), rgb].concat();
    std::fs::write(folder.join(name).with_extension("ppm"), file).expect("a picture");
}

#[test]
fn several_lamps_have_shadows_each() {
    let picture = lamps::draw(Settings::default()).expect("a picture");
    leave("lamps", &picture);
    let share = darker(&picture, &lamps::draw(without_shadows()).expect("a picture"));
    println!("lamps: {share:.2} % in shadow");
    assert!((10.0..25.0).contains(&share), "{share} % of the picture is in shadow");
}

#[test]
fn blurred_moments_are_softer_and_as_dark() {
    let pictures = [0, 12].map(|blur| moments::draw(moments::my_settings(blur)).expect("a picture"));
    leave("moments", &pictures[1]);
    let lit = moments::draw(without_shadows()).expect("a picture");
    let shares = pictures.each_ref().map(|picture| darker(picture, &lit));
    let differs = difference(&pictures[0], &pictures[1]);
    println!("moments: {shares:?} % in shadow, {differs:.2} of 255 between them");
    assert!(shares.iter().all(|share| (5.0..12.0).contains(share)), "{shares:?} %");
    assert!((0.2..6.0).contains(&differs), "{differs} of 255 between sharp and blurred");
}

#[test]
fn contact_shadows_lie_where_maps_have_none() {
    let picture = contact::draw(Contact { length: 0.3, steps: 24, thickness: 0.1 }).expect("a picture");
    leave("contact", &picture);
    let without = contact::draw(Contact { length: 1e-6, steps: 1, thickness: 1e-6 }).expect("a picture");
    let [more, less] = [darker(&picture, &without), darker(&without, &picture)];
    println!("contact: {more:.2} % darker, {less:.2} % lighter");
    assert!((0.5..10.0).contains(&more), "{more} % are darker with contact shadows");
    assert!(less == 0.0, "{less} % are lighter with contact shadows");
}

#[test]
fn a_deferred_renderer_has_the_shadows_of_a_forward_one() {
    let settings = Settings { resolution: 1024, ..Settings::default() };
    let deferred = deferred::draw(settings.clone()).expect("a picture");
    leave("deferred", &deferred);
    // `moments` draws the same world from the same eye, forward.
    let forward = moments::draw(settings).expect("a picture");
    let is_sky = |rgb: &&[u8; 3]| rgb[2] > rgb[0].saturating_add(20);
    let sky = pixels(&deferred).iter().filter(is_sky).count();
    let others = pixels(&deferred).iter().zip(pixels(&forward));
    let differ =
        others.filter(|(a, b)| !is_sky(a) && a.iter().zip(*b).any(|(a, b)| a.abs_diff(*b) > 8)).count();
    println!("deferred: {sky} of the sky, {differ} differ");
    assert!(differ < 400, "{differ} pixels differ, more than edges of things do");
    let share = darker(&deferred, &deferred::draw(without_shadows()).expect("a picture"));
    assert!((5.0..40.0).contains(&share), "{share} % of the picture is in shadow");
}

#[test]
fn maps_are_drawn_where_something_has_moved() {
    let (drawn, picture) = kept_tiles::draw().expect("a picture");
    leave("kept_tiles", &picture);
    println!("kept_tiles: {drawn:?} maps are drawn");
    assert_eq!(drawn[..3], [4, 0, 0], "all maps, and then none while nothing moves");
    assert!(drawn[3..].iter().all(|maps| (1..=3).contains(maps)), "only some where a box moves: {drawn:?}");
}

#[test]
fn rays_make_edges_of_coarse_maps_exact() {
    let [maps, undecided, always] =
        [Exact::Off, Exact::Undecided, Exact::Always].map(|exact| exact::draw(exact).expect("a picture"));
    leave("exact", &undecided);
    let [off, on] = [difference(&maps, &always), difference(&undecided, &always)];
    println!("exact: {off:.3} of 255 from the truth by maps alone, {on:.3} with rays");
    assert!(off > 0.5 && on < 0.05 * off, "{off} of 255 by maps alone, {on} with rays");
}

#[test]
fn bent_casters_have_the_same_shadows_where_rays_know_their_boxes() {
    let picture =
        skinned::draw(Settings { exact: Exact::Undecided, ..Settings::default() }).expect("a picture");
    leave("skinned", &picture);
    let [maps, lit] =
        [Settings::default(), without_shadows()].map(|it| skinned::draw(it).expect("a picture"));
    let (share, differs) = (darker(&picture, &lit), difference(&picture, &maps));
    println!("skinned: {share:.2} % in shadow, {differs:.3} of 255 from maps alone");
    assert!((1.0..10.0).contains(&share), "{share} % of the picture is in shadow");
    assert!(differs < 0.5, "{differs} of 255 from maps alone");
}

#[test]
fn what_the_window_shows_has_shadows_that_go_around() {
    use window::{off_screen, scene::Scene};
    let (device, queue) = off_screen::device().expect("a device");
    let picture = off_screen::target(&device, off_screen::COLOUR);
    let mut scene = Scene::new(device.clone(), queue.clone(), off_screen::COLOUR).expect("a scene");
    let [first, second] = [0.0, 4.0].map(|seconds| {
        let encoder = scene.draw(&picture, seconds).expect("a frame");
        off_screen::read((&device, &queue), encoder, &picture).expect("a picture")
    });
    leave("window", &second);
    let dark = |rgb: &[u8]| pixels(rgb).iter().filter(|rgb| rgb[0] < 120).count();
    println!("window: {} and {} dark pixels", dark(&first), dark(&second));
    assert!(dark(&first) > 5_000 && dark(&second) > 5_000, "shadows in both");
    assert!(difference(&first, &second) > 5.0, "the sun has moved");
}

/// The program itself, under Xvfb: it opens a window, draws three frames into it, and ends.
#[cfg(target_os = "linux")]
#[test]
fn the_window_opens_draws_and_closes() {
    use std::process::{Command, Stdio};

    let program = program::fresh("window");
    let mut server = Command::new("Xvfb");
    server.args(["-displayfd", "1", "-screen", "0", "640x480x24", "-nolisten", "tcp"]);
    server.stdout(Stdio::piped()).stderr(Stdio::null());
    let mut server = program::Running(server.spawn().expect("Xvfb starts; run scripts/setup"));
    let mut run = Command::new(program);
    run.args(["--frames", "3"]).env("DISPLAY", format!(":{}", server.line())).env_remove("WAYLAND_DISPLAY");
    let mut run = program::Running(run.stderr(Stdio::piped()).spawn().expect("the program starts"));
    let (is_success, said) = run.end();
    assert!(is_success, "{said}");
}

/// Example programs that are run as such.
#[cfg(target_os = "linux")]
mod program {
    use std::io::{BufRead as _, BufReader, Read as _};
    use std::path::{Path, PathBuf};
    use std::process::{Child, Command};
    use std::time::{Duration, Instant};
    use std::{env, fs, thread};

    /// An example's program as its sources are now: `cargo test --test gpu` alone makes none.
    pub fn fresh(name: &str) -> PathBuf {
        let tests = env::current_exe().expect("a program");
        let folder = tests.ancestors().nth(2).expect("target/PROFILE");
        let program = folder.join("examples").join(name);
        if !is_fresh(&program) {
            let mut cargo = Command::new(env!("CARGO"));
            cargo.args(["build", "--package", "umbrage", "--example", name]);
            cargo.args(folder.ends_with("release").then_some("--release"));
            let status = cargo.current_dir(env!("CARGO_MANIFEST_DIR")).status().expect("cargo starts");
            assert!(status.success(), "the example program {name} does not build");
        }
        program
    }

    /// Whether a program is newer than all that cargo says it is made of.
    fn is_fresh(program: &Path) -> bool {
        let time = |path: &Path| fs::metadata(path).and_then(|file| file.modified()).ok();
        let (Some(made), Ok(list)) = (time(program), fs::read_to_string(program.with_extension("d"))) else {
            return false;
        };
        let mut sources = list.split_whitespace().skip(1).map(Path::new);
        sources.all(|path| time(path).is_some_and(|changed| changed <= made))
    }

    /// A program that ends with the test, whatever becomes of that.
    pub struct Running(pub Child);

    impl Running {
        /// The first line that it prints.
        pub fn line(&mut self) -> String {
            let mut line = String::new();
            let out = self.0.stdout.take().expect("a pipe");
            BufReader::new(out).read_line(&mut line).expect("a line");
            line.trim().to_owned()
        }

        /// Waits for its end, a minute at most: whether it succeeded, and what it said.
        pub fn end(&mut self) -> (bool, String) {
            let start = Instant::now();
            while self.0.try_wait().expect("a program").is_none() {
                assert!(start.elapsed() < Duration::from_secs(60), "the program has not ended in a minute");
                thread::sleep(Duration::from_millis(50));
            }
            let mut said = String::new();
            let mut pipe = self.0.stderr.take().expect("a pipe");
            pipe.read_to_string(&mut said).expect("text");
            (self.0.wait().expect("it has ended").success(), said)
        }
    }

    impl Drop for Running {
        fn drop(&mut self) {
            // It may have ended by itself.
            let _ = self.0.kill();
            let _ = self.0.wait();
        }
    }
}
