//! What a file says of lights and of what casts shadows, and what becomes of it where it says nonsense.

mod common;

use common::Doc;
use umbrage_scene::{Imported, LightKind, load_glb_bytes, to_glb};

/// A document of a world, one unit large, with a node a name: the triangle, scaled so many times.
fn nested(nodes: &[(&str, &str, f32)], materials: &str) -> Doc {
    let mut doc = Doc::triangle();
    // A box of some height in every direction.
    let corners = [-1.0, -1.0, -1.0, 1.0, 1.0, 0.0, 0.0, 1.0, 1.0];
    doc.binary = common::floats(&corners);
    doc.primitives = r#"{"attributes": {"POSITION": 0}, "material": 0}"#.to_owned();
    doc.nodes = nodes
        .iter()
        .map(|(name, more, scale)| {
            format!(r#"{{"name": "{name}", "mesh": 0, "scale": [{scale}, {scale}, {scale}]{more}}}"#)
        })
        .collect::<Vec<_>>()
        .join(", ");
    doc.rest = format!(r#", "materials": [{materials}]"#);
    doc
}

const LIT: &str = r#"{"name": "lit"}"#;
const UNLIT: &str = r#"{"name": "sky", "extensions": {"KHR_materials_unlit": {}}}"#;

fn casts(imported: &Imported) -> Vec<bool> {
    imported.scene.instances.iter().map(|instance| instance.casts).collect()
}

/// The same document with a second mesh, of the second material.
fn with_second_mesh(doc: &Doc) -> Vec<u8> {
    let second = r#""meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 1}]}, "#;
    common::glb(&doc.json().replace(r#""meshes": ["#, second), &doc.binary)
}

#[test]
fn extras_say_what_casts_and_nonsense_is_a_warning() {
    for (extras, cast, warnings) in [
        ("", true, 0),
        (r#", "extras": {"umbrage": {"cast": false}}"#, false, 0),
        (r#", "extras": {"umbrage": {"cast": true}}"#, true, 0),
        (r#", "extras": {"umbrage": {"cast": "no"}}"#, true, 1),
        (r#", "extras": {"umbrage": {"cast": 0}}"#, true, 1),
        (r#", "extras": {"umbrage": {"cast": null}}"#, true, 1),
        (r#", "extras": {"umbrage": []}"#, true, 0),
        (r#", "extras": {"cast": false}"#, true, 0),
    ] {
        let imported = nested(&[("thing", extras, 1.0)], LIT).load().unwrap();
        assert_eq!((casts(&imported), imported.warnings.len()), (vec![cast], warnings), "{extras}");
        assert!(imported.warnings.iter().all(|line| line.ends_with("thing")), "{:?}", imported.warnings);
        let material = format!(r#"{{"name": "stuff"{extras}}}"#);
        let imported = nested(&[("thing", "", 1.0)], &material).load().unwrap();
        assert_eq!(
            (imported.scene.materials[0].casts, imported.warnings.len()),
            (cast, warnings),
            "{extras}"
        );
    }
}

#[test]
fn unlit_meshes_around_everything_cast_nothing_and_are_named() {
    for (nodes, cast) in [
        // Mesh 1 is the unlit one.
        (vec![("house", "", 1.0), ("dome", "", 10.0)], vec![true, false]),
        (vec![("dome", "", 10.0), ("house", "", 1.0), ("tree", "", 2.0)], vec![false, true, true]),
        (vec![("stars", "", 10.0), ("house", "", 1.0), ("clouds", "", 9.0)], vec![false, true, false]),
        // A sign of its own light inside the world casts, and so does what is not around all of it.
        (vec![("house", "", 10.0), ("sign", "", 1.0)], vec![true, true]),
    ] {
        let mut doc = nested(&nodes, &format!("{UNLIT}, {LIT}"));
        for name in ["house", "tree"] {
            doc.nodes =
                doc.nodes.replace(&format!(r#"{name}", "mesh": 0"#), &format!(r#"{name}", "mesh": 0.5"#));
        }
        // Of the two meshes the second is the document's own.
        doc.nodes = doc.nodes.replace(r#""mesh": 0,"#, r#""mesh": 1,"#).replace("0.5", "0");
        let imported = load_glb_bytes(&with_second_mesh(&doc), "doc.glb").unwrap();
        assert_eq!(casts(&imported), cast, "{nodes:?}");
        let named = nodes.iter().zip(&cast).filter(|(_, cast)| !**cast).map(|((name, ..), _)| *name);
        for name in named {
            assert!(
                imported.warnings[0].contains("--cast") && imported.warnings[0].contains(name),
                "{imported:?}"
            );
        }
        assert_eq!(imported.warnings.is_empty(), cast.iter().all(|cast| *cast));
    }
}

#[test]
fn a_scan_whose_light_is_in_its_textures_is_no_dome() {
    let alone = nested(&[("scan", "", 1.0)], UNLIT).load().unwrap();
    assert_eq!((casts(&alone), alone.warnings.len()), (vec![true], 0));
    // All is unlit, and the largest is around the rest: it is taken for a dome, with a warning; the rest casts.
    let all = nested(&[("a", "", 1.0), ("b", "", 2.0)], UNLIT).load().unwrap();
    assert_eq!((casts(&all), all.warnings.len()), (vec![true, false], 1));
}

#[test]
fn a_dome_that_is_said_to_cast_does_so_and_still_does_when_read_again() {
    let node = r#", "extras": {"umbrage": {"cast": true}}"#;
    for (extras, cast) in [("", false), (node, true)] {
        let imported = nested(&[("house", "", 1.0), ("dome", extras, 10.0)], UNLIT).load().unwrap();
        assert_eq!(casts(&imported), [true, cast]);
        let again = load_glb_bytes(&to_glb(&imported.scene).unwrap(), "again.glb").unwrap();
        assert_eq!((casts(&again), again.warnings.len()), (vec![true, cast], 0));
        assert!(again.scene.materials[0].unlit && again.scene.instances[1].name == "dome", "{again:?}");
    }
}

/// A triangle and a light of which the JSON says so much, on a node with more members.
fn lit(light: &str, more: &str) -> Doc {
    let mut doc = Doc::triangle();
    doc.nodes = format!(
        r#"{{"mesh": 0}}, {{"name": "lamp", "extensions": {{"KHR_lights_punctual": {{"light": 0}}}}{more}}}"#
    );
    doc.rest = format!(r#", "extensions": {{"KHR_lights_punctual": {{"lights": [{light}]}}}}"#);
    doc
}

#[test]
fn a_lamps_near_distance_is_read_and_nonsense_is_a_warning() {
    for (extras, near, warnings) in [
        ("", 0.0, 0),
        (r#", "extras": {"umbrage": {"near": 0.125}}"#, 0.125, 0),
        (r#", "extras": {"umbrage": {"near": 0}}"#, 0.0, 0),
        (r#", "extras": {"umbrage": {"near": -1}}"#, 0.0, 1),
        (r#", "extras": {"umbrage": {"near": "0.1"}}"#, 0.0, 1),
        (r#", "extras": {"umbrage": {"near": 1e300}}"#, 0.0, 1),
        (r#", "extras": {"umbrage": {"near": {}}}"#, 0.0, 1),
    ] {
        let Imported { scene, warnings: said } = lit(r#"{"type": "point"}"#, extras).load().unwrap();
        assert_eq!((scene.lights[0].near, said.len()), (near, warnings), "{extras}: {said:?}");
        assert!(said.iter().all(|line| line.ends_with("lamp")), "{said:?}");
    }
}

#[test]
fn lights_with_odd_numbers_do_not_refuse_the_world() {
    for numbers in [
        r#""intensity": -1"#,
        r#""intensity": 1e30"#,
        r#""intensity": 0"#,
        r#""range": 0"#,
        r#""range": -4"#,
        r#""color": [-1, 0, 0]"#,
        r#""color": [0, 0, 0]"#,
    ] {
        for kind in ["directional", "point", "spot"] {
            let doc = lit(&format!(r#"{{"type": "{kind}", "spot": {{}}, {numbers}}}"#), "");
            let Imported { scene, warnings } = doc.load().unwrap();
            // Whether the light is kept, and left out by whoever draws, or is left out here: it has a name somewhere.
            let is_kept = scene.lights.iter().any(|light| light.name == "lamp");
            assert!(is_kept || warnings.iter().any(|line| line.contains("lamp")), "{numbers}: {warnings:?}");
            assert_eq!((scene.lights.len(), scene.triangles()), (1, 1), "{numbers}");
        }
    }
}

#[test]
fn spots_that_no_spot_can_be_are_mended_with_a_warning() {
    for (inner, outer) in [(1.0, 0.5), (0.0, 3.0), (-1.0, 0.5), (0.0, 0.0)] {
        let spot = format!(r#"{{"innerConeAngle": {inner}, "outerConeAngle": {outer}}}"#);
        let doc = lit(&format!(r#"{{"type": "spot", "spot": {spot}}}"#), "");
        let Imported { scene, warnings } = doc.load().unwrap();
        let LightKind::Spot { inner, outer, range: _ } = scene.lights[0].kind else {
            panic!("a spot: {scene:?}")
        };
        let is_a_cone = 0.0 <= inner && inner <= outer && 0.0 < outer && outer <= std::f32::consts::FRAC_PI_2;
        assert!(is_a_cone && warnings.len() == 1, "{inner} to {outer}: {warnings:?}");
    }
}

#[test]
fn ten_thousand_lights_are_read_in_a_moment() {
    let mut doc = Doc::triangle();
    let lamps: Vec<String> = (0..10_000)
        .map(|i| {
            format!(
                r#"{{"translation": [{i}, 1, 0], "extensions": {{"KHR_lights_punctual": {{"light": 0}}}}}}"#
            )
        })
        .collect();
    doc.nodes = format!(r#"{{"mesh": 0}}, {}"#, lamps.join(", "));
    doc.rest = r#", "extensions": {"KHR_lights_punctual": {"lights": [{"type": "point"}]}}"#.to_owned();
    let start = std::time::Instant::now();
    assert_eq!(doc.load().unwrap().scene.lights.len(), 10_000);
    assert!(start.elapsed().as_secs() < 10, "{:?}", start.elapsed());
}
