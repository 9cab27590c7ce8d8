//! What glTF has no words for: how instances and lights move, what casts no shadow, and the camera's path. They travel as
//! `extras`, under one key:
//!
//! - of the scene: `{"umbrage": {"path": [[eye, target], …]}}`
//! - of the node of an instance or a light that rotates: `{"umbrage": {"turn": {"centre": …, "axis": …,
//!   "radians_per_second": …}}}`
//! - of the node of an instance, or of a material, whether it casts shadows: `{"umbrage": {"cast": false}}`
//! - of the node of a lamp, nearer than how many metres nothing casts a shadow: `{"umbrage": {"near": 0.1}}`
//!
//! Points and directions are lists of three numbers, in world space.

use glam::Vec3;
use gltf::json::extras::RawValue;
use gltf::json::{Extras, Value, deserialize};

use crate::error::Fault;
use crate::{CameraPath, Motion, PathKey};

const KEY: &str = "umbrage";
const CAST: &str = "cast";
const NEAR: &str = "near";

/// How far from unit length an axis may be.
const UNIT_TOLERANCE: f32 = 1e-3;

/// The extras of a scene with this path.
pub(crate) fn of_path(path: &CameraPath) -> Result<Extras, Fault> {
    if path.keys.is_empty() {
        return Ok(None);
    }
    let keys =
        path.keys.iter().map(|PathKey { eye, target }| Ok(Value::from(vec![list(*eye)?, list(*target)?])));
    extras([("path", keys.collect::<Result<Vec<_>, Fault>>()?.into())])
}

/// The extras of a node that moves so, and of which so much is to be said beside.
pub(crate) fn of_node(motion: &Motion, beside: Option<(&'static str, Value)>) -> Result<Extras, Fault> {
    let turn = match *motion {
        Motion::Still => None,
        Motion::Rotation { centre, axis, radians_per_second } => {
            let rotation = [
                ("centre", list(centre)?),
                ("axis", list(axis)?),
                ("radians_per_second", number(radians_per_second)?),
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
    if near == 0.0 { Ok(None) } else { Ok(Some((NEAR, number(near)?))) }
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

/// The path in the extras of a scene; without keys where there is none.
pub(crate) fn path_of(extras: &Extras) -> Result<CameraPath, Fault> {
    let Some(path) = value(extras, "path") else {
        return Ok(CameraPath::default());
    };
    let key = |key: &Value| Some(PathKey { eye: vector(key.get(0)?)?, target: vector(key.get(1)?)? });
    let keys: Option<Vec<_>> = path.as_array().and_then(|keys| keys.iter().map(key).collect());
    keys.map(|keys| CameraPath { keys }).ok_or_else(|| malformed("path"))
}

/// The motion in the extras of a node; still where there is none.
pub(crate) fn motion_of(extras: &Extras) -> Result<Motion, Fault> {
    let Some(rotation) = value(extras, "turn") else {
        return Ok(Motion::Still);
    };
    let read = || {
        let axis =
            vector(rotation.get("axis")?).filter(|axis| (axis.length() - 1.0).abs() <= UNIT_TOLERANCE)?;
        let radians_per_second = float(rotation.get("radians_per_second")?)?;
        Some(Motion::Rotation { centre: vector(rotation.get("centre")?)?, axis, radians_per_second })
    };
    read().ok_or_else(|| malformed("turn"))
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

fn number(x: f32) -> Result<Value, Fault> {
    if x.is_finite() {
        Ok(x.into())
    } else {
        Err(Fault(format!("{x} in a motion, a path or a near distance, need finite numbers")))
    }
}

fn list(v: Vec3) -> Result<Value, Fault> {
    v.to_array().into_iter().map(number).collect::<Result<Vec<_>, _>>().map(Value::from)
}

fn float(value: &Value) -> Option<f32> {
    value.as_f64().map(|x| x as f32).filter(|x| x.is_finite())
}

fn vector(value: &Value) -> Option<Vec3> {
    match value.as_array()?.as_slice() {
        [x, y, z] => Some(Vec3::new(float(x)?, float(y)?, float(z)?)),
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
            assert_eq!(path_of(&extras).unwrap(), CameraPath::default(), "{text}");
            assert_eq!(motion_of(&extras).unwrap(), Motion::Still, "{text}");
        }
    }

    #[test]
    fn what_casts_and_how_near_are_written_and_read_together_with_motion() {
        let turn = Motion::Rotation { centre: Vec3::X, axis: Vec3::Y, radians_per_second: 2.0 };
        for motion in [Motion::Still, turn] {
            let lamp = of_node(&motion, near(0.25).unwrap()).unwrap();
            assert_eq!((near_of(&lamp).unwrap(), motion_of(&lamp).unwrap()), (0.25, motion));
            assert_eq!(casts(&lamp).unwrap(), None);
            for (said, read) in
                [(cast(true), None), (cast(false), Some(false)), (Some(cast_after_all()), Some(true))]
            {
                let node = of_node(&motion, said).unwrap();
                assert_eq!((casts(&node).unwrap(), motion_of(&node).unwrap()), (read, motion));
                assert_eq!(near_of(&node).unwrap(), 0.0);
            }
        }
        assert!(of_node(&Motion::Still, near(0.0).unwrap()).unwrap().is_none(), "nothing to say");
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
            path_of(&extras).unwrap_err();
        }
        for axis in ["[0,0,0]", "[0,2,0]", "[0,1]", "0"] {
            let turn = format!("{{\"centre\": [0,0,0], \"axis\": {axis}, \"radians_per_second\": 1}}");
            let extras =
                Some(RawValue::from_string(format!("{{\"umbrage\": {{\"turn\": {turn}}}}}")).unwrap());
            motion_of(&extras).unwrap_err();
        }
    }
}
