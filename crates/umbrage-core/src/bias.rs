//! How far a lookup must stand off its own surface, so that it does not shadow itself.
//!
//! A texel is a square of side t on the map's plane, and stores the depth of one point of it. A flat receiver tilted by
//! θ against that plane differs by up to √2·h·t·tan θ in depth within the reach h (in texels) of a filter's kernel.
//! Moving the receiver along its normal by √2·h·t·sin θ covers exactly that: the gap along the light is the offset
//! divided by cos θ. (Holbert, *Saying "Goodbye" to Shadow Acne*, GDC 2011, has the idea; the length is derived.)
//!
//! Or each texel is compared with the depth that the receiver's plane has at the texel's centre: then nothing differs on
//! a flat receiver, and only bends within the reach are left to cover. (Dou et al., *Adaptive Depth Bias for Shadow
//! Maps*, I3D 2014, reconstruct that depth; here it follows from the geometric normal.)

use glam::{Vec2, Vec3};

use crate::ShadowView;
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

impl Bias {
    /// The steepest receiver whose plane is followed, as the tangent of the angle between its normal and the light (83°).
    /// Measured: less leaves acne on slopes, and more changes no picture while margins grow with it.
    pub const STEEPEST_PLANE: f32 = 8.0;

    /// How much the depth to compare with grows from one texel of a view to the next, to the right and downward: as the
    /// depth of the receiver's plane does where `receiver_plane` is set, else not at all. `normal` is unit, `cosine` that
    /// of the angle between it and the direction to the light.
    ///
    /// For parallel views. Mirrors `umbrage_gradient` of the shaders, where the formula is derived.
    pub fn plane_gradient(&self, view: &ShadowView, normal: Vec3, cosine: f32) -> Vec2 {
        if !self.receiver_plane || cosine <= 0.0 {
            return Vec2::ZERO;
        }
        let right = view.clip_from_world.row(0).truncate();
        let down = -view.clip_from_world.row(1).truncate();
        let along =
            Vec2::new(normal.dot(right) / right.length_squared(), normal.dot(down) / down.length_squared());
        let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
        let limited = cosine.max(sine / Self::STEEPEST_PLANE);
        along * (2.0 / (view.tile.size as f32 * view.depth_metres * limited))
    }
}

/// How far along the light a receiver's plane may lie from the receiver within its lookups' reach, in texels.
pub(crate) fn plane_reach_texels(bias: &Bias, filter: Filter) -> f64 {
    let corner = std::f64::consts::SQRT_2 * f64::from(kernel_half_width_texels(filter));
    if bias.receiver_plane { corner * f64::from(Bias::STEEPEST_PLANE) } else { 0.0 }
}

/// How far toward the light what is compared may lie from its receiver, at most, metres.
pub(crate) fn largest_bias(bias: &Bias, filter: Filter, texel_metres: f64) -> f64 {
    f64::from(normal_offset_texels(bias, filter)) * texel_metres
        + f64::from(bias.constant)
        + f64::from(bias.slope) * texel_metres * f64::from(bias.slope_limit)
        + plane_reach_texels(bias, filter) * texel_metres
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::fit::LightSpace;
    use crate::{Bounds, Camera, ConvexVolume, Light, Projection, Select, Settings, Tile, plan};

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

    /// A view of 64 × 32 metres and 100 metres of depth on 128² texels, with its axes.
    fn view(along: DVec3) -> (ShadowView, LightSpace) {
        let light = LightSpace::new(along, DVec3::Y);
        let view = ShadowView {
            index: 0,
            clip_from_world: light
                .clip_from_world(DVec3::new(-30.0, -10.0, -40.0), DVec3::new(34.0, 22.0, 60.0)),
            casters: ConvexVolume::default(),
            light: 0,
            split: 0,
            depths: 0.0..100.0,
            texel_metres: 0.5,
            depth_metres: 100.0,
            tile: Tile { layer: 0, x: 0, y: 0, size: 128 },
            unclipped_depth: true,
        };
        (view, light)
    }

    #[test]
    fn the_gradient_is_how_depth_changes_on_the_plane() {
        let bias = Bias { receiver_plane: true, ..Bias::NONE };
        let along = DVec3::new(0.3, -0.8, 0.5).normalize_or_zero();
        let (view, light) = view(along);
        for (x, y) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (-2.0, 3.0), (4.0, -5.0)] {
            // A plane whose depth changes by x and y metres a metre to the right and up on the map.
            let normal = (light.right * x + light.up * y - light.along).normalize_or_zero();
            let gradient = bias.plane_gradient(&view, normal.as_vec3(), -normal.dot(along) as f32);
            // Texels are half a metre by a quarter, and a unit of depth is 100 m.
            let expected = Vec2::new(x as f32 * 0.5, y as f32 * -0.25) / 100.0;
            assert!((gradient - expected).length() < 1e-6, "{x}, {y}: {gradient}, not {expected}");
        }
    }

    #[test]
    fn no_depth_that_is_compared_lies_farther_toward_the_light_than_the_margin() {
        let bias = Bias { receiver_plane: true, ..Bias::default() };
        let filter = Filter::Pcf { size: 5 };
        let (view, light) = view(DVec3::NEG_Y);
        let margin = largest_bias(&bias, filter, f64::from(view.texel_metres)) as f32;
        for degrees in [0.0, 30.0, 60.0, 85.0, 89.9, 95.0f64] {
            for turn in 0..16 {
                let (sine, cosine) = degrees.to_radians().sin_cos();
                let (y, x) = (f64::from(turn) * 0.4).sin_cos();
                let normal = (light.right * x + light.up * y) * sine - light.along * cosine;
                let gradient = bias.plane_gradient(&view, normal.as_vec3(), cosine as f32);
                let toward = bias_metres(&bias, filter, view.texel_metres, cosine as f32);
                let nearest =
                    gradient.abs().element_sum() * kernel_half_width_texels(filter) * view.depth_metres
                        + toward.along_normal
                        + toward.toward_light;
                assert!(nearest <= margin, "{degrees}°, turned by {turn}: {nearest} m, more than {margin} m");
            }
        }
    }

    #[test]
    fn surfaces_turned_away_have_no_gradient_and_grazing_ones_a_finite_one() {
        let bias = Bias { receiver_plane: true, ..Bias::NONE };
        let (view, _) = view(DVec3::NEG_Y);
        assert_eq!(bias.plane_gradient(&view, Vec3::X, 0.0), Vec2::ZERO);
        assert!(bias.plane_gradient(&view, Vec3::X, 1e-30).is_finite(), "grazing");
        assert!(
            Bias::NONE.plane_gradient(&view, Vec3::ONE.normalize_or_zero(), 0.5) == Vec2::ZERO,
            "not asked for"
        );
    }

    #[test]
    fn casters_below_a_receiver_but_before_its_plane_are_kept() {
        let projection = Projection::Perspective { fov_y: 1.0, aspect: 1.5 };
        let camera =
            Camera::looking(Vec3::ZERO, Vec3::NEG_Z, Vec3::Y, projection, 1.0, 200.0).expect("a camera");
        let lights = [Light::directional(Vec3::NEG_Y).expect("a light")];
        let bounds = Bounds::of_world(Vec3::splat(-400.0), Vec3::splat(400.0));
        let kept = |receiver_plane| {
            let bias = Bias { receiver_plane, ..Bias::NONE };
            let select = Select::Depth; // by map, all casters over the map are kept
            let settings = Settings { filter: Filter::Pcf { size: 9 }, bias, select, ..Settings::default() };
            let plan = plan(&camera, &lights, &bounds, &settings).expect("a plan");
            let view = &plan.views()[0];
            // Five texels before a receiver on the lower edge of the picture, and twenty below it: a plane of slope 5
            // is deeper there.
            let depth = 0.5 * (view.depths.start + view.depths.end);
            let receiver = Vec3::new(0.0, -depth * 0.5f32.tan(), -depth);
            view.casters.contains(receiver + Vec3::new(0.0, -20.0, 5.0) * view.texel_metres)
        };
        assert!(kept(true) && !kept(false), "kept with the plane, and not needed without");
    }
}
