//! What glTF has no words for: how instances and lights move, and the camera's path. They travel as `extras`, under one key:
//!
//! - of the scene: `{"umbrage": {"path": [[eye, target], …]}}`
//! - of the scene, too: `{"umbrage": {"exposed_for": lux}}`
//! - of the node of an instance or a light that rotates: `{"umbrage": {"turn": {"centre": …, "axis": …,
//!   "radians_per_second": …}}}`
//!
//! Points and directions are lists of three numbers, in world space.

use glam::Vec3;
use gltf::json::extras::RawValue;
use gltf::json::{Extras, Value, deserialize};

use crate::error::Fault;
use crate::{CameraPath, Motion, PathKey};

const KEY: &str = "umbrage";

/// How far from unit length an axis may be.
const UNIT_TOLERANCE: f32 = 1e-3;

/// The extras of a scene with this path and this illuminance to expose for.
pub(crate) fn of_scene(path: &CameraPath, exposed_for: Option<f32>) -> Result<Extras, Fault> {
    let mut members = Vec::new();
    if !path.keys.is_empty() {
        let keys = path.keys.iter();
        let keys = keys.map(|PathKey { eye, target }| Ok(Value::from(vec![list(*eye)?, list(*target)?])));
        members.push(("path", keys.collect::<Result<Vec<_>, Fault>>()?.into()));
    }
    if let Some(lux) = exposed_for {
        members.push(("exposed_for", number(lux)?));
    }
    if members.is_empty() { Ok(None) } else { extras(members) }
}

/// The illuminance to expose for in the extras of a scene; `None` where there is none.
pub(crate) fn exposed_for_of(extras: &Extras) -> Result<Option<f32>, Fault> {
    let Some(lux) = value(extras, "exposed_for") else {
        return Ok(None);
    };
    float(&lux).filter(|lux| *lux > 0.0).map(Some).ok_or_else(|| malformed("exposed_for"))
}

/// The extras of a node that moves so.
pub(crate) fn of_motion(motion: &Motion) -> Result<Extras, Fault> {
    match *motion {
        Motion::Still => Ok(None),
        Motion::Rotation { centre, axis, radians_per_second } => {
            let rotation = [
                ("centre", list(centre)?),
                ("axis", list(axis)?),
                ("radians_per_second", number(radians_per_second)?),
            ];
            extras(vec![("turn", rotation.into_iter().collect())])
        }
    }
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

fn number(x: f32) -> Result<Value, Fault> {
    if x.is_finite() {
        Ok(x.into())
    } else {
        Err(Fault(format!("{x} in a motion or a path, need finite numbers")))
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
        for lux in ["0", "-1", "\"bright\"", "[3]", "1e99", "null"] {
            let text = format!("{{\"umbrage\": {{\"exposed_for\": {lux}}}}}");
            exposed_for_of(&Some(RawValue::from_string(text).unwrap())).unwrap_err();
        }
    }
}
