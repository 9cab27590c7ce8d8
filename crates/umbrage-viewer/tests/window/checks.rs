//! What must be true of what was seen.

use std::path::Path;

use eframe::egui::Color32;
use umbrage::Settings;
use umbrage_render::{Frame, Gpu, Renderer, Show};

use crate::script::{Log, Seen};

/// Keeps what was on the screen, to be looked at.
pub fn save(name: &str, seen: &Seen) {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("window");
    std::fs::create_dir_all(&folder).expect("a folder");
    let [width, height] = seen.screen.size.map(|side| side as u32);
    let bytes: Vec<u8> = seen.screen.pixels.iter().flat_map(|pixel| pixel.to_array()).collect();
    image::RgbaImage::from_raw(width, height, bytes)
        .expect("a picture")
        .save(folder.join(format!("{name}.png")))
        .expect("a file");
}

pub fn all(log: &Log) {
    assert!(log.finished || log.seen.contains_key("after"), "the script came to its end");
    let seen = |name: &str| log.seen.get(name).unwrap_or_else(|| panic!("{name} was not seen"));
    let first = seen("first");
    assert!(inside(first).any(|p| p.r() > 180) && inside(first).any(|p| p.r() < 60), "a world is shown");

    let oracle = Oracle::new("primitives");
    for name in ["lambda", "splits", "filter", "warp"] {
        let changed = seen(name);
        assert_ne!(changed.view.settings[0], Settings::default(), "{name}: the widget changed a setting");
        oracle.changes_where_visibility_does(name, first, changed);
    }
    assert_eq!(seen("reset").view.settings[0], Settings::default());
    assert!(same(first, seen("reset")), "what is reset looks as it did");

    let truth = seen("truth");
    assert!(truth.judged > 10_000, "{} pixels are judged", truth.judged);
    let wrong = truth.mis_shadowed.expect("figures");
    assert!((0.0..0.05).contains(&wrong), "{wrong} of them are wrong");
    assert!(!same(seen("reset"), truth));
    assert!(seen("compared").view.compare && !same(truth, seen("compared")));
    for name in ["tinted", "texels", "extents", "maps", "frozen"] {
        assert!(!same(first, seen(name)), "{name} is seen");
    }
    assert!(
        seen("alone").picture.area() > 1.5 * first.picture.area(),
        "without panels the picture is larger"
    );

    let refused = seen("refused");
    assert_eq!(refused.world, "primitives", "what was shown before stays");
    assert_eq!(refused.view.settings[0], Settings::default());
    for wanted in ["not-a-scene", "virtual_pages"] {
        assert!(refused.messages.iter().any(|message| message.contains(wanted)), "{:?}", refused.messages);
    }
    assert!(seen("smaller").screen.size[0] < 900, "the window is smaller");
    let after = seen("after");
    assert_eq!((log.windows, after.world.as_str()), (2, "orbit"), "another window shows the same world");
    assert!(after.messages.iter().any(|message| message.contains("lost")), "{:?}", after.messages);
    memory(&log.memory);
}

/// Worlds that come and go leave nothing behind: after the first rounds memory does not grow with them.
fn memory(resident: &[u64]) {
    let mebibytes: Vec<u64> = resident.iter().map(|bytes| bytes >> 20).collect();
    println!("window: resident MiB after every four worlds: {mebibytes:?}");
    let half = resident.len() / 2;
    let (Some(middle), Some(last)) = (resident.get(half), resident.last()) else { return };
    assert!(*last < middle + (64 << 20), "memory grows: {mebibytes:?}");
}

/// Pixels of the picture, row by row.
fn inside(seen: &Seen) -> impl Iterator<Item = Color32> + '_ {
    let [width, _] = seen.screen.size;
    let (left, right) = (seen.picture.left() as usize, seen.picture.right() as usize);
    let rows = seen.picture.top() as usize..seen.picture.bottom() as usize;
    rows.flat_map(move |y| seen.screen.pixels[y * width + left..y * width + right].iter().copied())
}

fn differs(a: Color32, b: Color32) -> bool {
    a.to_array().iter().zip(b.to_array()).any(|(a, b)| a.abs_diff(b) > 2)
}

fn same(a: &Seen, b: &Seen) -> bool {
    a.picture == b.picture && !inside(a).zip(inside(b)).any(|(a, b)| differs(a, b))
}

/// The same world, drawn without a window.
struct Oracle {
    gpu: Gpu,
    scene: umbrage_scene::Scene,
}

impl Oracle {
    fn new(world: &str) -> Self {
        let gpu = Gpu::new(Some("vulkan")).expect("run scripts/setup");
        Self { gpu, scene: umbrage_scene::worlds::build(world, 0).expect("a built-in world") }
    }

    /// What the maps say of every pixel of a picture that was seen.
    fn visibility(&self, seen: &Seen) -> Vec<u8> {
        let (width, height) = (seen.picture.width().round() as u32, seen.picture.height().round() as u32);
        let camera = seen.view.camera();
        let (lights, show) = (&self.scene.lights[..1], Show::Visibility(0));
        let frame = Frame::of(&camera, lights, &Default::default(), [width, height], show)
            .expect("a camera and a light");
        let settings = seen.view.settings[0].clone();
        let mut renderer = Renderer::new(&self.gpu, &self.scene, settings).expect("a renderer");
        let drawn = renderer.render(&frame).expect("a frame").drawn;
        drawn.picture().expect("a picture").rgba.into_iter().step_by(4).collect()
    }

    /// A change of settings changes the picture where it changes visibility, and nowhere else.
    fn changes_where_visibility_does(&self, name: &str, before: &Seen, after: &Seen) {
        assert_eq!(before.picture, after.picture, "{name}: the picture stays where it is");
        let (was, is) = (self.visibility(before), self.visibility(after));
        let (mut wanted, mut found, mut stray) = (0, 0, 0);
        for (i, (a, b)) in inside(before).zip(inside(after)).enumerate() {
            let should = was[i].abs_diff(is[i]) > 24;
            wanted += usize::from(should);
            found += usize::from(should && differs(a, b));
            stray += usize::from(differs(a, b) && was[i] == is[i]);
        }
        println!("window: {name}: {wanted} pixels should change, {found} of them did, {stray} others did");
        assert!(wanted > 20, "{name}: something changes");
        // Surfaces whose smooth normal is turned from the sun are dark with and without a shadow.
        assert!(found * 4 > wanted * 3, "{name}: {found} of {wanted} changed");
        assert_eq!(stray, 0, "{name}: nothing else changes");
    }
}
