//! What glTF has no words for: how instances and lights move, and the camera's path. They travel as `extras`, under one key:
//!
//! - of the scene: `{"umbrage": {"path": [[eye, target], …], "origin": …}}`; the origin is where the scene's own origin
//!   lies in the file, and is chosen by the importer where it is left out; with it, everything stays as it is
//! - of the node of an instance or a light that rotates: `{"umbrage": {"turn": {"centre": …, "axis": …,
//!   "radians_per_second": …}}}`
//!
//! Points and directions are lists of three numbers, in metres of the file: its origin is not the scene's.

use glam::{DVec3, Vec3};
use gltf::json::extras::RawValue;
use gltf::json::{Extras, Value, deserialize};

use crate::error::Fault;
use crate::import::FARTHEST_ORIGIN;
use crate::{CameraPath, Motion, PathKey};

const KEY: &str = "umbrage";

/// How far from unit length an axis may be.
const UNIT_TOLERANCE: f32 = 1e-3;

/// The extras of a scene with this path, and with its origin there in the file; they say so where `is_fixed`.
pub(crate) fn of_scene(path: &CameraPath, origin: DVec3, is_fixed: bool) -> Result<Extras, Fault> {
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
    if members.is_empty() { Ok(None) } else { extras(members) }
}

/// The extras of a node that moves so, in a scene with its origin there in the file.
pub(crate) fn of_motion(motion: &Motion, origin: DVec3) -> Result<Extras, Fault> {
    match *motion {
        Motion::Still => Ok(None),
        Motion::Rotation { centre, axis, radians_per_second } => {
            let rotation = [
                ("centre", list(origin, centre)?),
                ("axis", list(DVec3::ZERO, axis)?),
                ("radians_per_second", number(radians_per_second.into())?),
            ];
            extras(vec![("turn", rotation.into_iter().collect())])
        }
    }
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

fn malformed(what: &str) -> Fault {
    Fault(format!("malformed extras {what:?} of {KEY:?}"))
}

fn extras(members: Vec<(&str, Value)>) -> Result<Extras, Fault> {
    let outer: Value = [(KEY, members.into_iter().collect::<Value>())].into_iter().collect();
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
        Err(Fault(format!("{x} in a motion, a path or an origin, need finite numbers")))
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
    }

    #[test]
    fn points_move_with_the_origin_and_directions_do_not() {
        let origin = DVec3::new(100_000.0, 0.0, -3.0);
        let turn =
            Motion::Rotation { centre: Vec3::new(0.1, -0.0, 2.0), axis: Vec3::Y, radians_per_second: 1.0 };
        let extras = of_motion(&turn, origin).unwrap();
        assert!(extras.as_ref().unwrap().get().contains("100000.1"), "{extras:?}");
        assert_eq!(motion_of(&extras, origin).unwrap(), turn);
        let path = CameraPath { keys: vec![PathKey { eye: Vec3::ONE, target: Vec3::NEG_X }] };
        let extras = of_scene(&path, origin, true).unwrap();
        assert_eq!(path_of(&extras, origin).unwrap(), path);
        assert_eq!(origin_of(&extras).unwrap(), Some(origin));
        assert!(of_scene(&CameraPath::default(), DVec3::ZERO, false).unwrap().is_none(), "nothing to say");
        let wrong = Some(RawValue::from_string("{\"umbrage\": {\"origin\": 3}}".to_owned()).unwrap());
        origin_of(&wrong).unwrap_err();
    }
}
