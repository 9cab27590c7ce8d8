//! Where a node stands in its parent, in f64: files put worlds hundreds of kilometres from their origin, and f32 knows
//! only centimetres there.
//!
//! Source: glTF 2.0, section 3.5.3, *Transformations*.

use glam::{DMat4, DQuat, DVec3};
use gltf::json::deserialize;

use super::members::{Members, Raw, plain};
use crate::rig::Place;

/// A rotation shorter than this has no direction.
const MIN_QUATERNION: f64 = 1e-6;

/// How far from unit length a rotation may be that f32 has rounded.
const UNIT_TOLERANCE: f64 = 1e-6;

/// `parent_from_node`, and what of the file's numbers is not in it.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Transform {
    pub parent_from_node: DMat4,
    /// The same in the parts that the file gives.
    pub place: Place,
    /// One sentence for each member that was ignored.
    pub ignored: Vec<String>,
}

/// Takes a node's matrix, or its translation, rotation and scale, out of its members. A node whose place is unknown is
/// an error that says so.
pub(super) fn take(members: &mut Members) -> Result<Transform, String> {
    let matrix = members.remove("matrix");
    let [translation, rotation, scale] =
        ["translation", "rotation", "scale"].map(|name| members.remove(name));
    let mut ignored = Vec::new();
    let (parent_from_node, place) = match matrix {
        Some(raw) => {
            let matrix = affine(numbers::<16>("matrix", &raw)?, &mut ignored);
            (matrix, Place::Matrix(matrix))
        }
        None => {
            let [x, y, z, w] = rotation.map_or(Ok([0.0, 0.0, 0.0, 1.0]), |raw| numbers("rotation", &raw))?;
            let scale = scale.map_or(Ok([1.0; 3]), |raw| numbers("scale", &raw))?;
            let translation = translation.map_or(Ok([0.0; 3]), |raw| numbers("translation", &raw))?;
            let given = DQuat::from_xyzw(x, y, z, w);
            let rotation = unit(given, &mut ignored);
            let (scale, translation) = (DVec3::from(scale), DVec3::from(translation));
            let matrix = DMat4::from_scale_rotation_translation(scale, rotation, translation);
            // What is a unit in f32 keeps its bits.
            let is_unit = (given.length() - 1.0).abs() <= UNIT_TOLERANCE;
            let rotation = if is_unit { given.as_quat() } else { rotation.as_quat() };
            let scale = scale.as_vec3();
            (matrix, Place::Parts { translation, rotation, scale })
        }
    };
    if parent_from_node.is_finite() {
        Ok(Transform { parent_from_node, place, ignored })
    } else {
        Err("numbers that are not finite".to_owned())
    }
}

/// The matrix with the last row that it should have.
fn affine(columns: [f64; 16], ignored: &mut Vec<String>) -> DMat4 {
    let mut matrix = DMat4::from_cols_array(&columns);
    let row = matrix.row(3);
    if row.to_array() != [0.0, 0.0, 0.0, 1.0] {
        ignored.push(format!("the last row of the matrix is {row}, need 0 0 0 1"));
        for (i, w) in [0.0, 0.0, 0.0, 1.0].into_iter().enumerate() {
            matrix.col_mut(i).w = w;
        }
    }
    matrix
}

/// The rotation at unit length; none where it has no direction.
fn unit(rotation: DQuat, ignored: &mut Vec<String>) -> DQuat {
    let length = rotation.length();
    // Also true for NaN.
    if !(length > MIN_QUATERNION && length.is_finite()) {
        ignored.push(format!("the rotation is {rotation}, need a unit quaternion"));
        return DQuat::IDENTITY;
    }
    rotation * length.recip()
}

fn numbers<const N: usize>(name: &str, raw: &Raw) -> Result<[f64; N], String> {
    let numbers: Vec<f64> =
        deserialize::from_str(raw.get()).map_err(|why| format!("{name}: {}", plain(&why)))?;
    let count = numbers.len();
    numbers.try_into().map_err(|_| format!("{name} has {count} numbers, need {N}"))
}

#[cfg(test)]
mod tests {
    use super::super::members;
    use super::*;

    fn of(text: &str) -> Result<Transform, String> {
        take(&mut members::of(text).unwrap())
    }

    #[test]
    fn translations_keep_all_their_digits() {
        let moved = of(r#"{"translation": [100000.0001, 0, -3]}"#).unwrap();
        assert_eq!(moved.parent_from_node.w_axis.x, 100_000.000_1);
    }

    #[test]
    fn rotations_are_normalised_and_those_without_direction_ignored() {
        let turned = of(r#"{"rotation": [0, 2, 0, 2]}"#).unwrap();
        let x = turned.parent_from_node.transform_vector3(DVec3::X);
        assert!(x.abs_diff_eq(DVec3::NEG_Z, 1e-12), "{x}");
        let lost = of(r#"{"rotation": [0, 0, 0, 0], "scale": [2, 2, 2]}"#).unwrap();
        assert_eq!((lost.parent_from_node, lost.ignored.len()), (DMat4::from_scale(DVec3::splat(2.0)), 1));
    }

    #[test]
    fn a_last_row_of_perspective_is_ignored() {
        let flat = of(r#"{"matrix": [1,0,0,1, 0,1,0,0, 0,0,1,0, 5,0,0,2]}"#).unwrap();
        assert_eq!(flat.parent_from_node, DMat4::from_translation(DVec3::X * 5.0));
        assert_eq!(flat.ignored.len(), 1);
    }

    #[test]
    fn a_place_that_is_no_place_is_an_error() {
        for text in
            [r#"{"translation": [1e400, 0, 0]}"#, r#"{"translation": [1, 2]}"#, r#"{"matrix": "here"}"#]
        {
            of(text).unwrap_err();
        }
    }
}
