//! One view's tile, as filters ask for it.

use glam::{Mat2, Vec2, Vec3, Vec4};

use super::map_texels::MapTexels;
use super::place::Query;
use super::reader::Map;
use crate::filter::LightSize;
use crate::plan::ShadowPlan;
use crate::space::Rays;
use crate::view::ShadowView;

/// How large the picture is that a camera fills until a renderer says otherwise, pixels. Footprints on the CPU are those of
/// such a picture.
pub const PICTURE_SIZE: [u32; 2] = [1920, 1080];

/// A view of a plan, and the maps that were drawn with it.
pub(super) struct ViewMap<'a> {
    pub plan: &'a ShadowPlan,
    pub maps: &'a MapTexels,
    pub view: &'a ShadowView,
}

impl Map for ViewMap<'_> {
    fn side(&self) -> u32 {
        self.view.tile.size
    }

    fn stored(&self, x: i64, y: i64) -> f32 {
        self.maps.depth(self.view.tile, x, y)
    }

    fn linear_depth(&self, texel: Vec2, stored: f32) -> f32 {
        self.view.linear_depth(texel, stored)
    }

    fn depth_metres(&self) -> f32 {
        self.view.depth_metres
    }

    fn penumbra_metres(&self, light: LightSize, receiver: f32, blocker: f32) -> f32 {
        let view = self.view;
        let size = self.plan.lights()[view.light].half_size(light);
        let way = (receiver - blocker).max(0.0) * view.depth_metres;
        match view.rays {
            Rays::Parallel => size * way,
            Rays::FromApex { .. } => {
                size * way / (view.near_metres + blocker * view.depth_metres).max(f32::MIN_POSITIVE)
            }
        }
    }

    fn footprint(&self, Query { position, normal, .. }: &Query) -> Mat2 {
        let clip_from_world = self.plan.camera().clip_from_world();
        let [x, y, w] = [0, 1, 3].map(|i| clip_from_world.row(i));
        let point = position.extend(1.0);
        let depth = w.dot(point);
        let pixels = |row: Vec4, side: u32| {
            (row.truncate() - w.truncate() * (row.dot(point) / depth)) * (0.5 * side as f32 / depth)
        };
        let (right, up) = (pixels(x, PICTURE_SIZE[0]), pixels(y, PICTURE_SIZE[1]));
        let area = normal.dot(right.cross(up));
        let scale = if area.abs() > 1e-30 { 1.0 / area } else { 0.0 };
        let texel_basis = self.view.texel_basis_at(*position);
        let on_map = |step: Vec3| texel_basis.texels(step * scale);
        Mat2::from_cols(on_map(up.cross(*normal)), on_map(normal.cross(right)))
    }
}
