//! What drawn pictures look like: exposure, haze, surroundings, and sheets of many files.

mod common;
#[path = "common/refusals.rs"]
mod refusals;

use std::path::Path;

use common::{stdout, text, umbrage};
use refusals::{folder, refused};

/// The mean of a picture's bytes.
fn brightness(path: &Path) -> f64 {
    let picture = image::open(path).expect("a picture").into_rgb8();
    picture.iter().map(|level| f64::from(*level)).sum::<f64>() / picture.len() as f64
}

#[test]
fn exposure_haze_and_surroundings_change_the_picture_and_not_its_visibility() {
    let folder = folder();
    let file = |name: &str| folder.path().join(name);
    let sky = file("sky.png");
    image::RgbImage::from_pixel(8, 4, image::Rgb([0, 0, 255])).save(&sky).expect("a picture");
    let draw = |name: &str, more: &[&str]| {
        let (picture, visibility) = (file(&format!("{name}.png")), file(&format!("{name}-v.png")));
        let mut args = vec!["render", "primitives", "--size", "80x45", "-o", text(&picture)];
        args.extend(["--visibility", text(&visibility)]);
        args.extend(more);
        stdout(&args);
        (brightness(&picture), std::fs::read(&visibility).expect("a picture"))
    };
    let (plain, visibility) = draw("plain", &[]);
    // How bright the picture is then, from and to.
    let cases: [(&[&str], [f64; 2]); 6] = [
        (&["--exposure", "1"], [plain + 10.0, 255.0]),
        (&["--exposure", "-2"], [5.0, plain - 30.0]),
        (&["--exposure", "100"], [254.0, 255.0]),
        (&["--exposure", "-100"], [0.0, 0.0]),
        (&["--exposed-for", "100000"], [0.0, 5.0]),
        (&["--environment", text(&sky), "--no-haze"], [20.0, plain - 1.0]),
    ];
    for (more, [from, to]) in cases {
        let (other, same) = draw("other", more);
        assert!((from..=to).contains(&other), "{more:?}: {other} instead of {from} to {to}");
        assert!(same == visibility, "{more:?}: visibility stays");
    }
}

#[test]
fn exposures_and_surroundings_that_cannot_be_are_refused_in_a_line() {
    let folder = folder();
    let picture = folder.path().join("a.png");
    let no_picture = folder.path().join("b.hdr");
    std::fs::write(&no_picture, "#?RADIANCE").expect("a file");
    let base = ["render", "primitives", "-o", text(&picture)];
    let wrong: [(&str, &str, &str); 6] = [
        ("--exposure", "101", "-100 to 100"),
        ("--exposure", "nan", "-100 to 100"),
        ("--exposure", "bright", "-100 to 100"),
        ("--exposed-for", "0", "1e-6 to 1e9"),
        ("--environment", "nowhere.hdr", "nowhere.hdr"),
        ("--environment", text(&no_picture), "b.hdr"),
    ];
    for (flag, value, named) in wrong {
        refused(&[base.as_slice(), &[flag, value]].concat(), 2, named, Some(&picture));
    }
}

#[test]
fn a_sheet_has_every_file_and_a_bad_one_spoils_no_other() {
    let folder = folder();
    let (sheet, broken) = (folder.path().join("sheet.png"), folder.path().join("broken.glb"));
    std::fs::write(&broken, b"no glTF").expect("a file");
    let args = ["sheet", "primitives", text(&broken), "-o", text(&sheet), "--size", "64x48"];
    let output = umbrage(&args);
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success() && stderr.contains("broken.glb"), "{stderr}");
    let picture = image::open(&sheet).expect("a picture").into_rgba8();
    assert_eq!(picture.dimensions(), (8 + 2 * 72, 8 + 76));
    refused(&["sheet", text(&broken), "-o", text(&sheet)], 1, "none of 1 files", None);
    refused(&["sheet", "-o", text(&sheet)], 2, "WORLD", None);
}
