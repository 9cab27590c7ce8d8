//! A lookup must stand off its own surface, so that it does not shadow itself; this file says how far.
//!
//! A texel stores the depth of one point of it. Within the reach h (in texels) of a filter's kernel, a flat receiver
//! differs in depth along the light by up to h (|N·a_u| + |N·a_v|) / cos θ, where a_u and a_v are the texel's sides
//! ([`crate::TexelBasis`]), N is the receiver's normal, and θ lies between it and the light. Moving the receiver by
//! h (|N·a_u| + |N·a_v|) along N covers exactly that. (Holbert, *Saying "Goodbye" to Shadow Acne*, GDC 2011, has the idea;
//! the length is derived. For square texels of side t it is at most √2 h t sin θ.)
//!
//! Or each texel is compared with the depth that the receiver's plane has at the texel's centre: then nothing differs on
//! a flat receiver, and only bends within the reach are left to cover. (Dou et al., *Adaptive Depth Bias for Shadow
//! Maps*, I3D 2014, reconstruct that depth; here it follows from the geometric normal.) Beside it Dou has an epsilon that
//! grows with perspective depth z: ½ (1 − A − 2z)² s / B. With A and B of a GL projection, z = ½ (1 − A + B / d) at depth d,
//! so dz/dd = −½ B / d² = −½ (1 − A − 2z)² / B: it is what s metres toward the light change z by. `constant` is s.

#[cfg(test)]
mod tests;

use glam::{Vec2, Vec3};

use crate::reach::Reach;
use crate::settings::Settings;
use crate::texel_basis::TexelBasis;
use crate::warp::Warp;

/// A lookup is moved so far away from its receiver.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BiasMetres {
    /// The distance along the receiver's normal, metres.
    pub along_normal: f32,
    /// The distance toward the light, metres.
    pub toward_light: f32,
    /// A comparison is moved so much farther toward the light for each texel that it lies beyond 0.7 texels from the
    /// receiver, metres, 0 or more.
    pub bend: f32,
}

/// What is compared within so many texels of a receiver, along either axis, counts as its own texel, which stores what lies
/// half a diagonal from its centre.
pub(crate) const OWN_TEXEL: f32 = 0.7;

/// The depth that each texel around a receiver is compared with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum CompareDepth {
    /// It is the depth that the receiver's own plane has at the texel's centre.
    Plane,
    /// It is the depth there of a plane through the receiver that faces the light. Under a sun without a warp that is the
    /// receiver's own depth; where a warp or a cone scales depth from texel to texel, it is what stays the same.
    Facing,
    /// It is the receiver's own depth, as it is stored: one comparison for four texels, which samplers do at once.
    Own,
}

impl Settings {
    /// The depth that texels are compared with under these settings.
    pub fn compare_depth(&self) -> CompareDepth {
        if !self.filter.compares_depths() {
            CompareDepth::Own
        } else if self.bias.receiver_plane {
            CompareDepth::Plane
        } else if self.warp != Warp::None || !self.filter.is_bilinear() {
            CompareDepth::Facing
        } else {
            CompareDepth::Own
        }
    }

    /// Returns the bias at a receiver with a unit normal and a unit direction to the light. `texel_basis` is that of its
    /// view there, whose casters may lie `caster_error` metres from those that are meant.
    pub fn bias_metres(
        &self,
        texel_basis: &TexelBasis,
        normal: Vec3,
        to_light: Vec3,
        caster_error: f32,
    ) -> BiasMetres {
        let bias = &self.bias;
        let cosine = normal.dot(to_light).clamp(0.0, 1.0);
        let sine = (1.0 - cosine * cosine).sqrt();
        let tangent = (sine / cosine.max(1e-6)).min(bias.slope_limit);
        let texel_metres = texel_basis.texel_metres();
        // What lies so far off across the surface lies so many times farther along the light. Bends and levels of detail are
        // seldom at their farthest together, so their squares are added.
        let along_light = (1.0 + tangent * tangent).sqrt();
        let bend = bias.bend * texel_metres * along_light;
        let texels = bias.normal * self.filter.offset_reach_texels(texel_metres);
        BiasMetres {
            along_normal: match self.compare_depth() {
                CompareDepth::Plane | CompareDepth::Facing => texel_basis.normal_offset(normal, texels),
                CompareDepth::Own => texel_basis.normal_offset_over_stored(normal, to_light, texels),
            },
            toward_light: bias.constant
                + bias.slope * texel_metres * tangent
                + (OWN_TEXEL * bend).hypot(caster_error * along_light),
            bend,
        }
    }

    /// Returns how much the depth to compare with grows from one texel of a view to the next, to the right and downward.
    ///
    /// Mirrors `umbrage_gradient` of the shaders.
    pub fn reference_gradient(&self, texel_basis: &TexelBasis, normal: Vec3, to_light: Vec3) -> Vec2 {
        match self.compare_depth() {
            CompareDepth::Plane => texel_basis.slope(normal, to_light, STEEPEST_PLANE),
            CompareDepth::Facing => texel_basis.slope(to_light, to_light, STEEPEST_PLANE),
            CompareDepth::Own => Vec2::ZERO,
        }
    }
}

/// The steepest receiver whose plane is followed, as the tangent of the angle between its normal and the light: 89.7°. On
/// what is steeper, the next triangle of a bent surface is more often wrong than the plane is right.
pub const STEEPEST_PLANE: f32 = 200.0;

/// Rasterisers round corners to a grid of 256 steps a texel: stored depth may be that of a place so many texels away.
pub const RASTER_STEP_TEXELS: f32 = 1.0 / 256.0;

/// Returns how far lookups reach from their receiver.
pub(crate) fn reach(Settings { filter, bias, caster_error, .. }: &Settings) -> Reach {
    // The smaller the texel, the more of them a width in metres is, up to its limit.
    let offset_texels = f64::from(bias.normal * filter.offset_reach_texels(f32::MIN_POSITIVE));
    Reach {
        lookup_texels: std::f64::consts::SQRT_2 * (f64::from(filter.reach_texels()) + offset_texels),
        plane_depth_texels: if bias.receiver_plane {
            std::f64::consts::SQRT_2 * f64::from(filter.plane_depth_texels())
        } else {
            0.0
        },
        offset_texels,
        constant: f64::from(bias.constant),
        slope: f64::from(bias.slope),
        slope_limit: f64::from(bias.slope_limit),
        bend: f64::from(bias.bend * filter.reach_texels().max(OWN_TEXEL) + caster_error),
        raster_texels: 2.0 * f64::from(RASTER_STEP_TEXELS * STEEPEST_PLANE),
    }
}
