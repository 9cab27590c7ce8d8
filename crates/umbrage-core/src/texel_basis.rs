//! How a view's texels lie at one point of the world: how long their sides are there, and how the depth of a surface
//! changes from one to the next. One form for every view, parallel, from an apex or warped.
//!
//! A row r of the matrix gives r·p / w·p; moving p by d changes that by (r − (r·p / w·p) w)·d / w·p. For the rows of x and
//! y these gradients g_u and g_v, in texels a metre, are across the light's ray, as x and y are the same all along it.
//! The sides of a texel are the vectors a_u and a_v across the ray with a_u·g_u = 1, a_u·g_v = 0, and so on:
//! a_u = g_v × c / c², a_v = c × g_u / c², c = g_u × g_v.
//!
//! Mirrors `UmbrageTexelBasis` of the shaders, in f32 as they do.

use glam::{DVec3, Vec2, Vec3};

use crate::view::ShadowView;

/// How the texels of a view lie at a point of the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TexelBasis {
    /// The side of a texel to the right on the map: a vector of world space across the light, metres.
    pub right: Vec3,
    /// The side of a texel downward on the map.
    pub down: Vec3,
    /// How much stored depth grows a metre.
    depth: Vec3,
    right_gradient: Vec3,
    down_gradient: Vec3,
}

impl ShadowView {
    /// Returns how its texels lie at a point of the world, which must lie before the light.
    pub fn texel_basis_at(&self, point: Vec3) -> TexelBasis {
        let m = self.clip_from_local(DVec3::ZERO);
        let [x, y, z, w] = [0, 1, 2, 3].map(|i| m.row(i));
        let clip = m * (point - self.local_origin(DVec3::ZERO)).extend(1.0);
        let gradient =
            |row: glam::Vec4, value: f32| (row.truncate() - w.truncate() * (value / clip.w)) / clip.w;
        let half = 0.5 * self.tile.size as f32;
        let right_gradient = gradient(x, clip.x) * half;
        let down_gradient = gradient(y, clip.y) * -half;
        let across = right_gradient.cross(down_gradient);
        let square = across.length_squared().max(f32::MIN_POSITIVE);
        TexelBasis {
            right: down_gradient.cross(across) / square,
            down: across.cross(right_gradient) / square,
            depth: gradient(z, clip.z),
            right_gradient,
            down_gradient,
        }
    }
}

impl TexelBasis {
    /// Returns the longer side of a texel, metres.
    pub fn texel_metres(&self) -> f32 {
        self.right.length().max(self.down.length())
    }

    /// Returns how far a step in the world goes on the map, in texels to the right and downward.
    pub fn texels(&self, step: Vec3) -> Vec2 {
        Vec2::new(self.right_gradient.dot(step), self.down_gradient.dot(step))
    }

    /// Returns how far along its unit normal a plane must be moved so that its point here comes to lie before all of the plane
    /// within `texels` to every side, as the light sees it: metres. Along the light that is the distance over the cosine.
    pub fn normal_offset(&self, normal: Vec3, texels: f32) -> f32 {
        texels * (normal.dot(self.right).abs() + normal.dot(self.down).abs())
    }

    /// Returns the same where one stored depth is compared with all of these texels, however the view scales depth.
    pub fn normal_offset_over_stored(&self, normal: Vec3, to_light: Vec3, texels: f32) -> f32 {
        let Self { depth, right_gradient, down_gradient, .. } = *self;
        let across = right_gradient.cross(down_gradient).length();
        let grown =
            normal.dot(depth.cross(down_gradient)).abs() + normal.dot(right_gradient.cross(depth)).abs();
        texels * grown / (across * self.rise(to_light)).max(f32::MIN_POSITIVE)
    }

    /// Returns how much stored depth grows a metre toward the light, in its unit direction.
    pub fn rise(&self, to_light: Vec3) -> f32 {
        self.depth.dot(to_light)
    }

    /// Returns how much stored depth grows on a plane from a texel to the next, to the right and downward. `normal` and `to_light`
    /// are unit. Planes whose tangent to the light is more than `steepest` count as that steep, and those turned away as
    /// flat: what they show is the shadow of their other side.
    pub fn slope(&self, normal: Vec3, to_light: Vec3, steepest: f32) -> Vec2 {
        let cosine = normal.dot(to_light);
        if cosine <= 0.0 {
            return Vec2::ZERO;
        }
        let Self { depth, right_gradient, down_gradient, .. } = *self;
        let square = normal.dot(right_gradient.cross(down_gradient));
        let slope =
            Vec2::new(normal.dot(depth.cross(down_gradient)), normal.dot(right_gradient.cross(depth)))
                / square;
        let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
        let slope = slope * (cosine / cosine.max(sine / steepest));
        if slope.is_finite() { slope } else { Vec2::ZERO }
    }
}
