//! Transforms of what has a place and a direction and no size: cameras and lights.

use glam::{DMat3, DMat4};

/// How far from unit length and right angles, squared, the axes of a rigid transform may be to be kept as they are.
const RIGID_TOLERANCE: f64 = 1e-3;

/// The transform without scale, skew and mirroring, for cameras and lights: −Z and the place stay what they are. One
/// that is rigid already is kept to the bit. `None` where there is no direction left.
pub(crate) fn rigid(matrix: DMat4) -> Option<DMat4> {
    let axes = DMat3::from_mat4(matrix);
    let error = axes.transpose() * axes - DMat3::IDENTITY;
    let largest = error.to_cols_array().into_iter().fold(0.0, |most: f64, e| most.max(e.abs()));
    if largest <= RIGID_TOLERANCE && axes.determinant() > 0.0 {
        return Some(matrix);
    }
    // Flattened along its own view, it still looks across what is left.
    let z = axes.z_axis.try_normalize().or_else(|| axes.x_axis.cross(axes.y_axis).try_normalize())?;
    let x = axes.y_axis.cross(z).try_normalize().unwrap_or_else(|| z.any_orthonormal_vector());
    let y = z.cross(x);
    Some(DMat4::from_cols(x.extend(0.0), y.extend(0.0), z.extend(0.0), matrix.w_axis))
}

#[cfg(test)]
mod tests {
    use glam::{DQuat, DVec3};

    use super::*;

    #[test]
    fn a_scaled_and_mirrored_camera_keeps_its_place_and_view() {
        let turned = DMat4::from_rotation_translation(DQuat::from_rotation_y(1.0), DVec3::new(1.0, 2.0, 3.0));
        let pose = rigid(turned * DMat4::from_scale(DVec3::new(-2.0, 3.0, 0.5))).unwrap();
        assert!(pose.abs_diff_eq(turned, 1e-9), "{pose} against {turned}");
        assert_eq!(rigid(turned), Some(turned));
        assert_eq!(rigid(DMat4::from_scale(DVec3::ZERO)), None);
    }

    #[test]
    fn a_camera_flattened_along_its_view_still_looks_that_way() {
        let turned = DMat4::from_rotation_y(1.0);
        let pose = rigid(turned * DMat4::from_scale(DVec3::new(2.0, 3.0, 0.0))).unwrap();
        assert!(pose.abs_diff_eq(turned, 1e-9), "{pose} against {turned}");
    }
}
