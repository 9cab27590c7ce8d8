//! Kept results: read back exactly, distrusted when anything changed, measured once.

use std::cell::Cell as Counter;
use std::fs;
use std::path::{Path, PathBuf};

use tempfile::TempDir;
use umbrage::Settings;
use umbrage_judge::statistics::Spread;
use umbrage_judge::temporal::Flicker;
use umbrage_judge::{Causes, DepthBand, Deviation, Error};
use umbrage_lab::{
    AreaLight, Entry, LabError, Machine, Measurement, Milliseconds, Motion, Outcome, Pictures, Program, Run,
    SmoothTruth, Store, TruthCounts, Watch,
};

fn run(repeat: u32) -> Run {
    Run {
        world: "bunny".to_owned(),
        world_hash: String::new(),
        seed: 0,
        camera: "main".to_owned(),
        repeat,
        settings: Settings { lambda: 0.1, distance: Some(1.0 / 3.0), ..Settings::default() },
        family: None,
        area: None,
        truths: vec![SmoothTruth::Sun],
        light_points: 64,
        size: [64, 36],
        frames: 3,
        pictures: true,
        motion: Some(Motion::Yaw),
        watch: Watch::default(),
        adapter: "lavapipe".to_owned(),
        program: "f00d".to_owned(),
    }
}

/// Finite numbers of all sizes, the same each time.
fn numbers(count: usize) -> Vec<f64> {
    // Knuth's MMIX generator; its high bits are the good ones, so two steps a number.
    let mut state = 1_u64;
    let mut next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        state >> 32
    };
    std::iter::repeat_with(|| f64::from_bits(next() << 32 | next()))
        .filter(|n| n.is_finite())
        .take(count)
        .collect()
}

/// A result in which every field has something.
fn outcome(run: &Run) -> Outcome {
    let band = DepthBand {
        depths: [0.1 + 0.2, f64::MAX],
        pixels: 7,
        mis_shadowed: 1.0 / 3.0,
        mae: 0.7,
        false_shadow: f64::from_bits(1),
        false_light: -0.0,
        edge_displacement_px: None,
        edge_px: 0.1 + 0.2,
    };
    let spread = Spread { median: 0.1, p5: 1e-300, p95: 2.0 / 3.0 };
    let frames = numbers(8);
    let measurement = Measurement {
        world: run.world.clone(),
        triangles: 1_000_000,
        camera: run.camera.clone(),
        width: 64,
        height: 36,
        adapter: run.adapter.clone(),
        settings: run.settings.clone(),
        texels: u64::MAX,
        bytes: 4,
        occluder_bytes: 0,
        occluder_seconds: None,
        traced_a_pixel: None,
        made_ready: None,
        shadows_milliseconds: Some(1.25),
        truth: TruthCounts {
            pixels: 9,
            ambiguous: 1,
            shadowed: 4,
            partial: 2,
            edge_px: 0.7,
            standard_error: 0.1,
        },
        error: Some(Error {
            mis_shadowed: 0.3,
            false_shadow: 0.1,
            false_light: 0.2,
            rmse: std::f64::consts::PI,
            mae: std::f64::consts::E,
            bias: -1e-17,
            edge_displacement_px: Some(0.1),
            hausdorff_95_px: None,
            causes: Causes { edge: 0.3, ..Causes::default() },
            decades: vec![band.clone()],
        }),
        sub_pixel: None,
        sun: Some(Deviation { rmse: 0.1, mae: 1.0 / 3.0, bias: -0.0, umbra_light: Some(1e-300) }),
        wide_sun: Some(Deviation { rmse: 0.3, mae: 0.2, bias: 0.1, umbra_light: None }),
        lights: Vec::new(),
        aliasing: Default::default(),
        flip: Some(0.07),
        splits: vec![band.clone(), band.clone()],
        around_cuts: vec![[band.clone(), band]],
        milliseconds: Some(Milliseconds {
            plan: spread,
            deform: spread,
            casters: spread,
            filter: spread,
            shade: spread,
            frame: spread,
        }),
        every_frame: frames.chunks_exact(6).map(|f| [f[0], f[1], f[2], f[3], f[4], f[5]]).collect(),
        flicker: Some(Flicker { points: 3, shimmer: 0.123_456_789_012_345_68, ..Flicker::default() }),
    };
    let machine = Machine {
        adapter: "\"lavapipe\", 256 bits\n".to_owned(),
        timestamps: false,
        system: "linux x86_64".to_owned(),
        cores: 2,
        commit: "abc".to_owned(),
    };
    let shaded = vec![0xff, 0xd8, run.repeat as u8];
    Outcome {
        machine,
        measurement,
        pictures: Some(Pictures { shaded, error: b"\x89PNG".to_vec(), exact: vec![0xff, 0xd9] }),
    }
}

fn open(folder: &Path) -> Result<Store, LabError> {
    Store::open(folder, &Program::running().unwrap())
}

/// A folder with a store in it that holds the results of some runs.
fn store_of(runs: &[Run]) -> (TempDir, Store) {
    let folder = tempfile::tempdir().unwrap();
    let store = open(&folder.path().join("a/b")).unwrap();
    for run in runs {
        store.put(run, &outcome(run)).unwrap();
    }
    (folder, store)
}

/// The stored files that end so, sorted.
fn files(folder: &TempDir, extension: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder.path().join("a/b/runs")).unwrap();
    let paths = entries.map(|entry| entry.unwrap().path());
    let mut paths: Vec<_> = paths.filter(|path| path.extension().is_some_and(|e| e == extension)).collect();
    paths.sort();
    paths
}

#[test]
fn a_result_reads_back_bit_for_bit() {
    let (_folder, store) = store_of(&[]);
    let mut written = outcome(&run(0));
    written.measurement.every_frame =
        numbers(5_000).chunks_exact(6).map(|f| [f[0], f[1], f[2], f[3], f[4], f[5]]).collect();
    store.put(&run(0), &written).unwrap();
    let read = store.get(&run(0)).unwrap();
    assert_eq!(read, written);
    assert!(read.measurement.splits[0].false_light.is_sign_negative(), "-0 stays -0");
}

#[test]
fn every_input_has_a_result_of_its_own() {
    let (_folder, store) = store_of(&[run(0)]);
    let text = |s: &str| s.to_owned();
    let others = [
        Run { world: text("dragon"), ..run(0) },
        Run { world_hash: text("1"), ..run(0) },
        Run { seed: 1, ..run(0) },
        Run { camera: text("far"), ..run(0) },
        Run { repeat: 1, ..run(0) },
        Run { settings: Settings { lambda: 0.1f32.next_up(), ..run(0).settings }, ..run(0) },
        Run { area: Some(AreaLight { samples: 16, degrees: 5.0 }), ..run(0) },
        Run { truths: vec![SmoothTruth::WideSun], ..run(0) },
        Run { light_points: 65, ..run(0) },
        Run { watch: Watch { frames: 60, points: 5_000 }, ..run(0) },
        Run { size: [36, 64], ..run(0) },
        Run { frames: 4, ..run(0) },
        Run { pictures: false, ..run(0) },
        Run { motion: None, ..run(0) },
        Run { adapter: text("H200"), ..run(0) },
        Run { program: text("beef"), ..run(0) },
    ];
    for other in &others {
        assert_eq!(store.get(other), None, "{other:?}");
        store.put(other, &Outcome { pictures: None, ..outcome(other) }).unwrap();
    }
    assert_eq!(store.get(&run(0)), Some(outcome(&run(0))), "no other took its place");
    assert!(others.iter().all(|other| store.get(other).is_some()));
}

#[test]
fn any_changed_or_missing_byte_is_noticed() {
    let (folder, store) = store_of(&[run(0)]);
    for extension in ["json", "jpg", "png", "jpeg"] {
        let path = &files(&folder, extension)[0];
        let good = fs::read(path).unwrap();
        // Both ends, with the seal and the run, are tried whole; of the figures between them every eleventh byte.
        for i in (0..good.len()).filter(|i| *i < 200 || *i + 20 > good.len() || i % 11 == 0) {
            let mut bad = good.clone();
            bad[i] ^= 1;
            fs::write(path, &bad).unwrap();
            assert_eq!(store.get(&run(0)), None, "{extension}: byte {i} changed");
            fs::write(path, &good[..i]).unwrap();
            assert_eq!(store.get(&run(0)), None, "{extension}: cut after {i} bytes");
        }
        fs::write(path, [&good[..], b" "].concat()).unwrap();
        assert_eq!(store.get(&run(0)), None, "{extension}: a byte more");
        fs::remove_file(path).unwrap();
        assert_eq!(store.get(&run(0)), None, "{extension}: no file");
        fs::write(path, &good).unwrap();
        assert!(store.get(&run(0)).is_some(), "{extension}: as it was");
    }
}

#[test]
fn a_changed_digit_is_noticed() {
    let (folder, store) = store_of(&[run(0)]);
    let path = &files(&folder, "json")[0];
    let text = fs::read_to_string(path).unwrap();
    assert_eq!(text.matches("\"flip\":0.07").count(), 1);
    fs::write(path, text.replace("\"flip\":0.07", "\"flip\":0.02")).unwrap();
    assert_eq!(store.get(&run(0)), None);
    store.put(&run(0), &outcome(&run(0))).unwrap();
    assert_eq!(store.get(&run(0)), Some(outcome(&run(0))), "made again");
}

#[test]
fn another_runs_file_is_noticed() {
    let (folder, store) = store_of(&[run(0), run(1)]);
    for extension in ["json", "jpg"] {
        let [a, b] = &files(&folder, extension)[..] else { panic!("two results") };
        let good = fs::read(a).unwrap();
        fs::copy(b, a).unwrap();
        let found = [0, 1].map(|repeat| store.get(&run(repeat)).is_some());
        assert_eq!(found.iter().filter(|found| **found).count(), 1, "{extension}: {found:?}");
        fs::write(a, good).unwrap();
    }
    assert!([0, 1].iter().all(|repeat| store.get(&run(*repeat)).is_some()));
}

#[test]
fn pictures_alone_are_no_result() {
    let (folder, store) = store_of(&[]);
    // With a folder where the JSON should go, a run ends between the pictures and it.
    store.put(&run(0), &outcome(&run(0))).unwrap();
    let json = files(&folder, "json").remove(0);
    fs::remove_file(&json).unwrap();
    for extension in ["jpg", "png", "jpeg"] {
        fs::remove_file(&files(&folder, extension)[0]).unwrap();
    }
    fs::create_dir(&json).unwrap();
    assert!(matches!(store.put(&run(0), &outcome(&run(0))), Err(LabError::File { .. })));
    assert_eq!((files(&folder, "jpg").len(), files(&folder, "png").len()), (1, 1), "pictures come first");
    assert_eq!(store.get(&run(0)), None);
}

#[test]
fn a_number_that_json_cannot_hold_is_refused() {
    let (folder, store) = store_of(&[run(1)]);
    for odd in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let mut outcome = outcome(&run(0));
        outcome.measurement.flip = Some(odd);
        let error = store.put(&run(0), &outcome).unwrap_err();
        assert!(error.to_string().contains("not finite"), "{error}");
    }
    assert_eq!(files(&folder, "jpg").len(), 1, "nothing of it is left");
}

#[test]
fn a_folder_that_cannot_be_written_is_known_before_anything_runs() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("file");
    fs::write(&file, b"").unwrap();
    let error = open(&file.join("below")).unwrap_err();
    assert!(matches!(error, LabError::File { action: "write", .. }), "{error}");
    assert!(error.to_string().contains("below") && !error.to_string().contains('\n'), "{error}");
    assert!(open(&file).is_err(), "a file is no folder");
    fs::write(folder.path().join("runs"), b"").unwrap();
    assert!(open(folder.path()).is_err(), "nor is it one of runs");

    let fresh = folder.path().join("fresh");
    open(&fresh).unwrap();
    assert_eq!(fs::read_dir(&fresh).unwrap().count(), 0, "looking leaves nothing");
}

fn entries(count: u32) -> Vec<Entry> {
    (0..count)
        .map(|i| Entry { variant: i as usize % 2, swept: Some(toml::Value::Integer(i.into())), run: run(i) })
        .collect()
}

#[test]
fn a_run_that_was_cut_off_goes_on_where_it_stopped() {
    let (_folder, store) = store_of(&[]);
    let measured = Counter::new(0);
    let measure = |run: &Run| {
        measured.set(measured.get() + 1);
        Ok(outcome(run))
    };
    let cut_off =
        |run: &Run| if run.repeat < 4 { measure(run) } else { Err(LabError::Plot("power cut".into())) };
    let error = umbrage_lab::measure_all(&entries(10), &store, cut_off, |_, _, _| {}).unwrap_err();
    assert!(error.to_string().contains("power cut"), "{error}");
    assert_eq!(measured.replace(0), 4);

    let mut heard = Vec::new();
    let hear = |done, total, was_stored| heard.push((done, total, was_stored));
    let rows = umbrage_lab::measure_all(&entries(10), &store, measure, hear).unwrap();
    assert_eq!(measured.replace(0), 6, "only the rest");
    assert_eq!(heard, (1..=10).map(|done| (done, 10, done <= 4)).collect::<Vec<_>>());

    let again = umbrage_lab::measure_all(&entries(10), &store, measure, |_, _, _| {}).unwrap();
    assert_eq!(measured.get(), 0, "a second run measures nothing");
    assert_eq!(again, rows);
    let (_other, other) = store_of(&[]);
    assert_eq!(
        umbrage_lab::measure_all(&entries(10), &other, measure, |_, _, _| {}).unwrap(),
        rows,
        "as if never cut off"
    );
    assert_eq!((rows[3].variant, &rows[3].swept, &rows[3].run), (1, &Some(toml::Value::Integer(3)), &run(3)));
}

#[test]
fn a_corrupt_result_is_measured_again_and_nothing_else() {
    let (folder, store) = store_of(&[run(0), run(1), run(2)]);
    let path = &files(&folder, "json")[1];
    fs::write(path, &fs::read(path).unwrap()[..100]).unwrap();
    let measured = Counter::new(0);
    let measure = |run: &Run| {
        measured.set(measured.get() + 1);
        Ok(outcome(run))
    };
    let rows = umbrage_lab::measure_all(&entries(3), &store, measure, |_, _, _| {}).unwrap();
    assert_eq!(measured.get(), 1);
    assert!(rows.iter().all(|row| row.outcome == outcome(&row.run)));
}
