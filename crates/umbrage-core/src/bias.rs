//! How far a lookup must stand off its own surface, so that it does not shadow itself.
//!
//! A texel is a square of side t on the map's plane, and stores the depth of one point of it. A flat receiver tilted by
//! θ against that plane differs by up to √2·h·t·tan θ in depth within the reach h (in texels) of a filter's kernel.
//! Moving the receiver along its normal by √2·h·t·sin θ covers exactly that: the gap along the light is the offset
//! divided by cos θ. (Holbert, *Saying "Goodbye" to Shadow Acne*, GDC 2011, has the idea; the length is derived.)

use crate::settings::{Bias, Filter};

/// How far a lookup reaches from its centre, in texels: a nearest lookup half a texel, hardware 2×2 one texel, N×N of
/// those N/2 + ½.
pub fn kernel_half_width_texels(filter: Filter) -> f32 {
    match filter {
        Filter::Hard {} => 0.5,
        Filter::Bilinear {} => 1.0,
        Filter::Pcf { size } => 0.5 * size as f32 + 0.5,
    }
}

/// How far along the normal a receiver is moved, in texels times the sine of the angle between normal and light.
pub fn normal_offset_texels(bias: &Bias, filter: Filter) -> f32 {
    bias.normal * std::f32::consts::SQRT_2 * kernel_half_width_texels(filter)
}

/// How far from a receiver its lookups may end, in texels: the offset and the corner of the kernel.
pub(crate) fn reach_texels(bias: &Bias, filter: Filter) -> f64 {
    let corner = std::f64::consts::SQRT_2 * f64::from(kernel_half_width_texels(filter));
    corner + f64::from(normal_offset_texels(bias, filter))
}

/// What a lookup at one receiver is moved by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BiasMetres {
    /// Along the receiver's normal, metres.
    pub along_normal: f32,
    /// Toward the light, metres.
    pub toward_light: f32,
}

/// The bias at a receiver whose unit normal makes an angle with the unit direction to the light, of which `cosine` is
/// the cosine. `texel_metres` is the view's.
pub fn bias_metres(bias: &Bias, filter: Filter, texel_metres: f32, cosine: f32) -> BiasMetres {
    let cosine = cosine.clamp(0.0, 1.0);
    let sine = (1.0 - cosine * cosine).sqrt();
    let tangent = (sine / cosine.max(1e-6)).min(bias.slope_limit);
    BiasMetres {
        along_normal: normal_offset_texels(bias, filter) * texel_metres * sine,
        toward_light: bias.constant + bias.slope * texel_metres * tangent,
    }
}

/// The largest bias any receiver can get, metres, both directions added.
pub(crate) fn largest_bias(bias: &Bias, filter: Filter, texel_metres: f64) -> f64 {
    f64::from(normal_offset_texels(bias, filter)) * texel_metres
        + f64::from(bias.constant)
        + f64::from(bias.slope) * texel_metres * f64::from(bias.slope_limit)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tutorials_slope_bias_is_reproduced_on_its_own_scene() {
        // opengl-tutorial 16: 0.005 · tan θ, at most 0.01, in depth units of a 30 m range, on 20 m / 1024 texels.
        let texel = 20.0 / 1024.0;
        let bias = Bias { slope: 0.005 * 30.0 / texel, slope_limit: 2.0, ..Bias::NONE };
        for degrees in [0.0f32, 30.0, 45.0, 60.0, 80.0] {
            let tutorial = (0.005 * degrees.to_radians().tan()).clamp(0.0, 0.01) * 30.0;
            let ours = bias_metres(&bias, Filter::Hard {}, texel, degrees.to_radians().cos()).toward_light;
            assert!((ours - tutorial).abs() < 1e-5, "{degrees}°: {ours}, not {tutorial}");
        }
    }

    #[test]
    fn the_normal_offset_covers_the_depth_error_of_a_tilted_plane() {
        let bias = Bias { normal: 1.0, ..Bias::NONE };
        for degrees in [5.0f32, 45.0, 85.0] {
            let (sine, cosine) = degrees.to_radians().sin_cos();
            let gap_along_light = bias_metres(&bias, Filter::Bilinear {}, 0.25, cosine).along_normal / cosine;
            let error = std::f32::consts::SQRT_2 * 0.25 * sine / cosine;
            assert!(
                (gap_along_light / error - 1.0).abs() < 1e-4,
                "{degrees}°: {gap_along_light} against {error}"
            );
        }
    }

    #[test]
    fn surfaces_turned_away_get_a_finite_bias() {
        let bias = Bias { slope: 1.0, ..Bias::default() };
        let metres = bias_metres(&bias, Filter::Pcf { size: 9 }, 1.0, -0.5);
        assert!(metres.along_normal.is_finite() && metres.toward_light.is_finite(), "{metres:?}");
    }
}
