//! What glTF has no words for: how instances and lights move, what casts no shadow, and the camera's path. They travel as
//! `extras`, under one key:
//!
//! - of the scene: `{"umbrage": {"path": [[eye, target], …], "origin": …, "exposed_for": lux}}`; the origin is where the
//!   scene's own origin lies in the file, and is chosen by the importer where it is left out; with it, everything stays
//!   as it is
//! - of the node of an instance or a light that rotates: `{"umbrage": {"turn": {"centre": …, "axis": …,
//!   "radians_per_second": …}}}`
//! - of the node of an instance, or of a material, whether it casts shadows: `{"umbrage": {"cast": false}}`
//! - of the scene, the number of the animation that plays, or `"none"`: `{"umbrage": {"playing": 2}}`
//! - of an animation, when it begins again, seconds, where that is not with its last key: `{"umbrage": {"seconds": 4}}`
//! - of the node of a lamp, nearer than how many metres nothing casts a shadow: `{"umbrage": {"near": 0.1}}`
//!
//! Points and directions are lists of three numbers, in metres of the file: its origin is not the scene's.

use glam::{DVec3, Vec3};
use gltf::json::extras::RawValue;
use gltf::json::{Extras, Value, deserialize};

use crate::error::Fault;
use crate::import::FARTHEST_ORIGIN;
use crate::{CameraPath, Motion, PathKey};

const KEY: &str = "umbrage";
const CAST: &str = "cast";
const NEAR: &str = "near";
const PLAYING: &str = "playing";
const SECONDS: &str = "seconds";

/// How far from unit length an axis may be.
const UNIT_TOLERANCE: f32 = 1e-3;

/// The extras of a scene with this path, with its origin there in the file, and with this illuminance to expose for; they
/// say where the origin is where `is_fixed`, and so much beside.
pub(crate) fn of_scene(
    path: &CameraPath,
    origin: DVec3,
    is_fixed: bool,
    exposed_for: Option<f32>,
    beside: Option<(&'static str, Value)>,
) -> Result<Extras, Fault> {
    let mut members = Vec::new();
    if !path.keys.is_empty() {
        let point = |p: Vec3| list(origin, p);
        let key = |PathKey { eye, target }: &PathKey| Ok(Value::from(vec![point(*eye)?, point(*target)?]));
        let keys: Result<Vec<_>, Fault> = path.keys.iter().map(key).collect();
        members.push(("path", Value::from(keys?)));
    }
    if is_fixed {
        members.push(("origin", list(origin, Vec3::ZERO)?));
    }
    if let Some(lux) = exposed_for {
        members.push(("exposed_for", number(lux.into())?));
    }
    members.extend(beside);
    extras(members)
}

/// What extras say of the animation that plays of so many, unless it is the first there is: its number, or that there is
/// none.
pub(crate) fn playing(playing: Option<usize>, count: usize) -> Option<(&'static str, Value)> {
    let first = (count > 0).then_some(0);
    (playing != first).then(|| (PLAYING, playing.map_or(Value::from("none"), Value::from)))
}

/// The animation that plays, of so many, as the extras of a scene say; the first where they do not.
pub(crate) fn playing_of(extras: &Extras, count: usize) -> Result<Option<usize>, Fault> {
    let Some(said) = value(extras, PLAYING) else {
        return Ok((count > 0).then_some(0));
    };
    let number = || said.as_u64().and_then(|number| usize::try_from(number).ok());
    match number().filter(|number| *number < count) {
        Some(number) => Ok(Some(number)),
        None if said == "none" => Ok(None),
        None => Err(malformed(PLAYING)),
    }
}

/// The extras of an animation that begins again after so many seconds, whenever its last key is.
pub(crate) fn seconds(seconds: f32) -> Result<Value, Fault> {
    let inner: Value = [(SECONDS, number(seconds.into())?)].into_iter().collect();
    Ok([(KEY, inner)].into_iter().collect())
}

/// The time after which an animation begins again, seconds, in the extras of its JSON; `None` where there is none.
pub(crate) fn seconds_of(animation: &Value) -> Option<f32> {
    let seconds = animation.get("extras")?.get(KEY)?.get(SECONDS)?;
    float(seconds).filter(|seconds| *seconds >= 0.0)
}

/// The illuminance to expose for in the extras of a scene; `None` where there is none.
pub(crate) fn exposed_for_of(extras: &Extras) -> Result<Option<f32>, Fault> {
    let Some(lux) = value(extras, "exposed_for") else {
        return Ok(None);
    };
    float(&lux).filter(|lux| *lux > 0.0).map(Some).ok_or_else(|| malformed("exposed_for"))
}

/// The extras of a node that moves so, in a scene with its origin there in the file, and of which so much is to be said
/// beside.
pub(crate) fn of_node(
    motion: &Motion,
    origin: DVec3,
    beside: Option<(&'static str, Value)>,
) -> Result<Extras, Fault> {
    let turn = match *motion {
        Motion::Still | Motion::Node { .. } | Motion::Skin { .. } => None,
        Motion::Rotation { centre, axis, radians_per_second } => {
            let rotation = [
                ("centre", list(origin, centre)?),
                ("axis", list(DVec3::ZERO, axis)?),
                ("radians_per_second", number(radians_per_second.into())?),
            ];
            Some(("turn", rotation.into_iter().collect()))
        }
    };
    extras(turn.into_iter().chain(beside))
}

/// The extras of a material that casts shadows, or does not.
pub(crate) fn of_material(casts: bool) -> Result<Extras, Fault> {
    extras(cast(casts))
}

/// What extras say where something casts no shadows.
pub(crate) fn cast(casts: bool) -> Option<(&'static str, Value)> {
    (!casts).then(|| (CAST, casts.into()))
}

/// What extras say where something casts shadows that would cast none without a word.
pub(crate) fn cast_after_all() -> (&'static str, Value) {
    (CAST, true.into())
}

/// What extras say of a lamp nearer to which than `near` metres nothing casts a shadow.
pub(crate) fn near(near: f32) -> Result<Option<(&'static str, Value)>, Fault> {
    if near == 0.0 { Ok(None) } else { Ok(Some((NEAR, number(near.into())?))) }
}

/// Whether something casts shadows, as its extras say; `None` where they do not.
pub(crate) fn casts(extras: &Extras) -> Result<Option<bool>, Fault> {
    let read = |said: Value| said.as_bool().ok_or_else(|| malformed(CAST));
    value(extras, CAST).map(read).transpose()
}

/// Nearer to a lamp than how many metres nothing casts a shadow, as the extras of its node say; 0 where they do not.
pub(crate) fn near_of(extras: &Extras) -> Result<f32, Fault> {
    let read = |said: Value| float(&said).filter(|near| *near >= 0.0).ok_or_else(|| malformed(NEAR));
    value(extras, NEAR).map_or(Ok(0.0), read)
}

/// The origin in the extras of a scene, if there is one.
pub(crate) fn origin_of(extras: &Extras) -> Result<Option<DVec3>, Fault> {
    let origin = value(extras, "origin");
    // Written again, it must fit f32.
    let is_near = |origin: &DVec3| origin.abs().max_element() <= FARTHEST_ORIGIN;
    let read = |origin: Value| vector(&origin).filter(is_near).ok_or_else(|| malformed("origin"));
    origin.map(read).transpose()
}

/// The path in the extras of a scene with its origin there in the file; without keys where there is none.
pub(crate) fn path_of(extras: &Extras, origin: DVec3) -> Result<CameraPath, Fault> {
    let Some(path) = value(extras, "path") else {
        return Ok(CameraPath::default());
    };
    let point = |value: &Value| point(value, origin);
    let key = |key: &Value| Some(PathKey { eye: point(key.get(0)?)?, target: point(key.get(1)?)? });
    let keys: Option<Vec<_>> = path.as_array().and_then(|keys| keys.iter().map(key).collect());
    keys.map(|keys| CameraPath { keys }).ok_or_else(|| malformed("path"))
}

/// The motion in the extras of a node, in a scene with its origin there in the file; still where there is none.
pub(crate) fn motion_of(extras: &Extras, origin: DVec3) -> Result<Motion, Fault> {
    let Some(rotation) = value(extras, "turn") else {
        return Ok(Motion::Still);
    };
    let read = || {
        let axis = point(rotation.get("axis")?, DVec3::ZERO)
            .filter(|axis| (axis.length() - 1.0).abs() <= UNIT_TOLERANCE)?;
        let radians_per_second = rotation.get("radians_per_second")?.as_f64()? as f32;
        let centre = point(rotation.get("centre")?, origin)?;
        radians_per_second.is_finite().then_some(Motion::Rotation { centre, axis, radians_per_second })
    };
    read().ok_or_else(|| malformed("turn"))
}

fn float(said: &Value) -> Option<f32> {
    said.as_f64().map(|x| x as f32).filter(|x| x.is_finite())
}

fn malformed(what: &str) -> Fault {
    Fault(format!("malformed extras {what:?} of {KEY:?}"))
}

/// All that is to be said, under our key; nothing where there is nothing to say.
fn extras(said: impl IntoIterator<Item = (&'static str, Value)>) -> Result<Extras, Fault> {
    let mut said = said.into_iter().peekable();
    if said.peek().is_none() {
        return Ok(None);
    }
    let outer: Value = [(KEY, said.collect::<Value>())].into_iter().collect();
    let raw = RawValue::from_string(outer.to_string()).map_err(|why| Fault(why.to_string()))?;
    Ok(Some(raw))
}

/// What our key holds under `what`. Extras that are somebody else's are none of our business.
fn value(extras: &Extras, what: &str) -> Option<Value> {
    let mut outer: Value = deserialize::from_str(extras.as_ref()?.get()).ok()?;
    outer.get_mut(KEY)?.get_mut(what).map(Value::take)
}

fn number(x: f64) -> Result<Value, Fault> {
    if x.is_finite() {
        Ok(x.into())
    } else {
        Err(Fault(format!(
            "{x} in a motion, a path, an origin, an exposure, an animation or a near distance, need finite numbers"
        )))
    }
}

/// A point of the scene, in the file.
fn list(origin: DVec3, point: Vec3) -> Result<Value, Fault> {
    // Adding nothing would take the sign of zeros.
    let in_file = |axis: usize| {
        let own = f64::from(point[axis]);
        if origin[axis] == 0.0 { own } else { origin[axis] + own }
    };
    (0..3).map(|axis| number(in_file(axis))).collect::<Result<Vec<_>, _>>().map(Value::from)
}

/// A point of the file, in the scene.
fn point(value: &Value, origin: DVec3) -> Option<Vec3> {
    let in_file = vector(value)?;
    let in_scene =
        |axis: usize| if origin[axis] == 0.0 { in_file[axis] } else { in_file[axis] - origin[axis] } as f32;
    Some(Vec3::new(in_scene(0), in_scene(1), in_scene(2))).filter(|p| p.is_finite())
}

fn vector(value: &Value) -> Option<DVec3> {
    match value.as_array()?.as_slice() {
        [x, y, z] => Some(DVec3::new(x.as_f64()?, y.as_f64()?, z.as_f64()?)).filter(|v| v.is_finite()),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn other_peoples_extras_are_left_alone() {
        for text in
            ["null", "3", "\"umbrage\"", "[1]", "{\"path\": 1}", "{\"umbrage\": {}}", "{\"umbrage\": 1}"]
        {
            let extras = Some(RawValue::from_string(text.to_owned()).unwrap());
            assert_eq!(path_of(&extras, DVec3::ZERO).unwrap(), CameraPath::default(), "{text}");
            assert_eq!(motion_of(&extras, DVec3::ZERO).unwrap(), Motion::Still, "{text}");
        }
    }

    #[test]
    fn what_casts_and_how_near_are_written_and_read_together_with_motion() {
        let turn = Motion::Rotation { centre: Vec3::X, axis: Vec3::Y, radians_per_second: 2.0 };
        for motion in [Motion::Still, turn] {
            let lamp = of_node(&motion, DVec3::ZERO, near(0.25).unwrap()).unwrap();
            assert_eq!((near_of(&lamp).unwrap(), motion_of(&lamp, DVec3::ZERO).unwrap()), (0.25, motion));
            assert_eq!(casts(&lamp).unwrap(), None);
            for (said, read) in
                [(cast(true), None), (cast(false), Some(false)), (Some(cast_after_all()), Some(true))]
            {
                let node = of_node(&motion, DVec3::ZERO, said).unwrap();
                assert_eq!((casts(&node).unwrap(), motion_of(&node, DVec3::ZERO).unwrap()), (read, motion));
                assert_eq!(near_of(&node).unwrap(), 0.0);
            }
        }
        assert!(
            of_node(&Motion::Still, DVec3::ZERO, near(0.0).unwrap()).unwrap().is_none(),
            "nothing to say"
        );
        near(f32::NAN).unwrap_err();
    }

    #[test]
    fn what_casts_is_a_boolean_and_a_near_distance_no_less_than_nothing() {
        let of = |text: &str| Some(RawValue::from_string(format!("{{\"umbrage\": {text}}}")).unwrap());
        for text in ["0", "\"false\"", "null", "[]", "{}"] {
            casts(&of(&format!("{{\"cast\": {text}}}"))).unwrap_err();
        }
        for text in ["-1", "\"1\"", "null", "[]", "true", "1e300"] {
            near_of(&of(&format!("{{\"near\": {text}}}"))).unwrap_err();
        }
    }

    #[test]
    fn malformed_extras_of_ours_are_faults() {
        for path in ["1", "[1]", "[[[0,0,0]]]", "[[[0,0,0],[0,0]]]", "[[[0,0,0],[0,0,1e99]]]", "null"] {
            let extras =
                Some(RawValue::from_string(format!("{{\"umbrage\": {{\"path\": {path}}}}}")).unwrap());
            path_of(&extras, DVec3::ZERO).unwrap_err();
        }
        for axis in ["[0,0,0]", "[0,2,0]", "[0,1]", "0"] {
            let turn = format!("{{\"centre\": [0,0,0], \"axis\": {axis}, \"radians_per_second\": 1}}");
            let extras =
                Some(RawValue::from_string(format!("{{\"umbrage\": {{\"turn\": {turn}}}}}")).unwrap());
            motion_of(&extras, DVec3::ZERO).unwrap_err();
        }
        for lux in ["0", "-1", "\"bright\"", "[3]", "1e99", "null"] {
            let text = format!("{{\"umbrage\": {{\"exposed_for\": {lux}}}}}");
            exposed_for_of(&Some(RawValue::from_string(text).unwrap())).unwrap_err();
        }
    }

    #[test]
    fn points_move_with_the_origin_and_directions_do_not() {
        let origin = DVec3::new(100_000.0, 0.0, -3.0);
        let turn =
            Motion::Rotation { centre: Vec3::new(0.1, -0.0, 2.0), axis: Vec3::Y, radians_per_second: 1.0 };
        let extras = of_node(&turn, origin, None).unwrap();
        assert!(extras.as_ref().unwrap().get().contains("100000.1"), "{extras:?}");
        assert_eq!(motion_of(&extras, origin).unwrap(), turn);
        let path = CameraPath { keys: vec![PathKey { eye: Vec3::ONE, target: Vec3::NEG_X }] };
        let extras = of_scene(&path, origin, true, None, None).unwrap();
        assert_eq!(path_of(&extras, origin).unwrap(), path);
        assert_eq!(origin_of(&extras).unwrap(), Some(origin));
        assert!(
            of_scene(&CameraPath::default(), DVec3::ZERO, false, None, None).unwrap().is_none(),
            "nothing to say"
        );
        let wrong = Some(RawValue::from_string("{\"umbrage\": {\"origin\": 3}}".to_owned()).unwrap());
        origin_of(&wrong).unwrap_err();
    }
}
