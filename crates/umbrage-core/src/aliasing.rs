//! This module says how far one texel of a shadow map reaches on screen, in pixels.
//!
//! Source: Lloyd et al., *Warping and Partitioning for Low Error Shadow Maps*, EGSR 2006, and *Logarithmic Perspective
//! Shadow Maps*, 2008: m is the largest extent of a texel's image in pixels. 1 is one to one, more is too coarse.
//! Here it is one 2×2 matrix: A = J_c · J_s⁻¹, pixels a texel, from the Jacobians J_c of pixels and J_s of texels over
//! the receiver's plane (derived). m is A's larger singular value.
//!
//! Space: world, metres. The closed forms for a light from above are in `overhead`.
//!
//! This does not ask whether the map covers the point, or the picture shows it.

mod overhead;
mod raster;
#[cfg(test)]
mod tests;
#[cfg(test)]
mod v29;

use glam::{DMat2, DMat4, DVec3};

pub use overhead::{
    PerspectiveError, balanced_warp_near, ideal_storage_factor, largest_perspective_error, perspective_error,
    storage_factor,
};

use self::raster::Raster;
use crate::camera::Camera;
use crate::view::ShadowView;

/// Sines smaller than this are taken for zero: f64 would answer with rounding errors.
const SMALLEST_SINE: f64 = 1e-9;

/// The image of one texel on screen, an ellipse for a round texel. All of it is finite and more than zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TexelExtent {
    /// The image reaches so far where it reaches farthest, in pixels a texel, above 0: this is Lloyd's m. More than 1 is
    /// under-sampled.
    pub largest: f64,
    /// The image reaches so far across that, in pixels a texel, above 0. Less than 1 is over-sampled.
    pub smallest: f64,
    /// The image covers so much, in square pixels a texel, above 0: `largest` times `smallest`.
    pub area: f64,
}

/// Returns the extent in a picture of `width` by `height` pixels of a texel of a square map, on a flat receiver.
///
/// `clip_from_world` is the shadow view's, parallel, perspective or warped, with clip x and y from −1 to 1 over the map.
/// `resolution` is the map's side in texels. `position` is the receiver's, in world space, and `normal` is across its
/// plane, of any length.
///
/// The answer is `None` where there is no extent: the plane is edge-on to the eye or to the light, the point is not before both, or
/// something is not finite.
pub fn texel_extent(
    camera: &Camera,
    width: u32,
    height: u32,
    clip_from_world: &DMat4,
    resolution: f64,
    position: DVec3,
    normal: DVec3,
) -> Option<TexelExtent> {
    let tangents = normal.try_normalize()?.any_orthonormal_pair();
    let pixels_per_metre = Raster::of_camera(camera, width, height).jacobian(position, tangents)?;
    let texels_per_metre = Raster::of_view(clip_from_world, resolution).jacobian(position, tangents)?;
    extent(pixels_per_metre, texels_per_metre)
}

/// Returns what [`texel_extent`] does but for the receiver's tilt: the part of the extent that a better projection can
/// mend.
///
/// Zhang et al. 2006, eq. 1 without cos φ / cos θ. The eye sees a plane that is parallel to the picture, and the light
/// sees the same plane rotated until it faces the light, about the line that both have in common. On the axis of view
/// that is the extent on the plane halfway between the two (derived). One plane alone will not do: the picture's own is
/// edge-on to a light from above. Where the light shines along the view, the common line is the camera's right.
pub fn perspective_texel_extent(
    camera: &Camera,
    width: u32,
    height: u32,
    clip_from_world: &DMat4,
    resolution: f64,
    position: DVec3,
) -> Option<TexelExtent> {
    let picture = Raster::of_camera(camera, width, height);
    let map = Raster::of_view(clip_from_world, resolution);
    let world_from_view = camera.world_from_view().as_dmat4();
    let toward_eye = world_from_view.inverse().row(2).truncate().try_normalize()?;
    let toward_light = map.direction_to_light(clip_from_world.row(2), position)?;
    let cross = toward_light.cross(toward_eye);
    let common = if cross.length() > SMALLEST_SINE { cross } else { world_from_view.x_axis.truncate() };
    let common = common.try_normalize()?;
    extent(
        picture.jacobian(position, (common, toward_eye.cross(common)))?,
        map.jacobian(position, (common, toward_light.cross(common)))?,
    )
}

impl ShadowView {
    /// Returns the extent of one of its texels in a picture of `width` by `height` pixels: see [`texel_extent`].
    pub fn texel_extent(
        &self,
        camera: &Camera,
        width: u32,
        height: u32,
        position: DVec3,
        normal: DVec3,
    ) -> Option<TexelExtent> {
        let resolution = f64::from(self.tile.size);
        texel_extent(camera, width, height, &self.clip_from_world, resolution, position, normal)
    }

    /// Returns the same without the receiver's tilt: see [`perspective_texel_extent`].
    pub fn perspective_texel_extent(
        &self,
        camera: &Camera,
        width: u32,
        height: u32,
        position: DVec3,
    ) -> Option<TexelExtent> {
        let resolution = f64::from(self.tile.size);
        perspective_texel_extent(camera, width, height, &self.clip_from_world, resolution, position)
    }
}

fn extent(pixels_per_metre: DMat2, texels_per_metre: DMat2) -> Option<TexelExtent> {
    if is_edge_on(pixels_per_metre) || is_edge_on(texels_per_metre) {
        return None;
    }
    let pixels_per_texel = pixels_per_metre * texels_per_metre.inverse();
    let largest = largest_stretch(pixels_per_texel);
    let area = pixels_per_metre.determinant().abs() / texels_per_metre.determinant().abs();
    let smallest = area / largest;
    let is_fine = |value: f64| value.is_finite() && value > 0.0;
    [largest, smallest, area].into_iter().all(is_fine).then_some(TexelExtent { largest, smallest, area })
}

/// Whether a plane is seen as a line. What is not a number is.
fn is_edge_on(per_metre: DMat2) -> bool {
    let stretch = largest_stretch(per_metre);
    let is_open = per_metre.determinant().abs() > SMALLEST_SINE * stretch * stretch;
    !is_open
}

/// The larger singular value. A 2×2 matrix is a scaled rotation plus a scaled reflection, and the scales add up.
fn largest_stretch(matrix: DMat2) -> f64 {
    let [a, c, b, d] = matrix.to_cols_array();
    0.5 * ((a + d).hypot(b - c) + (a - d).hypot(b + c))
}
