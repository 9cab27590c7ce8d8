//! What one shadow map is: a matrix, a tile and a share of the scene.

use std::ops::Range;

use glam::{DVec3, Mat4, Vec2, Vec3};

use crate::allocation::Tile;
use crate::cull::ConvexVolume;
use crate::space::Rays;

/// One shadow map, or one tile of an atlas. Everything after planning only ever sees these.
#[derive(Clone, Debug, PartialEq)]
pub struct ShadowView {
    /// The view's place in the plan, and in the GPU's list of views.
    pub index: usize,
    /// What the view shows. Two views with equal keys show the same casters through the same matrix, so the one may be
    /// read where the other was drawn; `None` says that what it shows is new in each frame. Plans say `None`.
    pub key: Option<ViewKey>,
    /// The matrix from world space to the clip space of this view alone: x and y in −1…1 over the tile, depth from 0 near
    /// the light to 1.
    pub clip_from_world: Mat4,
    /// The casters that can shadow this view's receivers touch this volume.
    pub casters: ConvexVolume,
    /// The light of the plan that the view belongs to.
    pub light: usize,
    /// The split that the view serves, or the face of a point light's cube: +X, −X, +Y, −Y, +Z, −Z.
    pub split: usize,
    /// The view depths that the view serves, metres.
    pub depths: Range<f32>,
    /// The longer side of its largest texel on a receiver that faces the light, metres. Texels are all as large where
    /// there is neither a warp nor an apex; [`Self::texel_basis_at`] knows them one by one.
    pub texel_metres: f32,
    /// The distance from its near plane to its far one along the light's axis, metres.
    pub depth_metres: f32,
    /// Where its near plane lies along the light's axis, metres: from the apex of a punctual light, and from the world's
    /// origin for a sun.
    pub near_metres: f32,
    /// How its rays run, and so how depth is stored.
    pub rays: Rays,
    /// A warp scales stored depth by a factor that is constant along each light ray; this is its inverse as a linear
    /// function of NDC: at x, y it is dot(this, (x, y, 1)).
    pub inverse_weight: Vec3,
    /// The tile of the maps that the view is drawn to.
    pub tile: Tile,
    /// Whether casters before the near plane must be flattened onto it.
    pub unclipped_depth: bool,
}

/// Says what a view shows: two views with equal keys show the same casters through the same matrix.
///
/// Who makes keys answers for that: a key changes with the matrix, the casters, and everything that moves among them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ViewKey(pub u64);

impl ShadowView {
    /// Whether the map covers `point`, give or take `slack` in clip units; what lies before the near plane counts as
    /// covered where depth is unclipped.
    pub fn covers(&self, point: DVec3, slack: f64) -> bool {
        let clip = self.clip_from_world.as_dmat4() * point.extend(1.0);
        if clip.w <= 0.0 {
            return false;
        }
        let clip = clip / clip.w;
        let near = if self.unclipped_depth { f64::NEG_INFINITY } else { -slack };
        clip.x.abs() <= 1.0 + slack && clip.y.abs() <= 1.0 + slack && clip.z >= near && clip.z <= 1.0 + slack
    }

    /// Returns how far along the light's axis a depth lies that is stored at a place of the tile, given in texels: 0 on the
    /// near plane, 1 on the far one, and linear between.
    pub fn linear_depth(&self, texel: Vec2, stored: f32) -> f32 {
        // Nothing was drawn. A warp would make a place of that: beside its receivers, and beyond its line at infinity, the
        // far plane is not at 1.
        if stored >= 1.0 {
            return 1.0;
        }
        let ndc = texel / self.tile.size as f32 * Vec2::new(2.0, -2.0) + Vec2::new(-1.0, 1.0);
        // A warped map also shows what lies behind its far plane. A punctual light would take that for something behind
        // itself.
        let straight = (stored / self.inverse_weight.dot(ndc.extend(1.0))).min(1.0);
        match self.rays {
            Rays::Parallel => straight,
            Rays::FromApex => {
                // 1 / d is linear in it, from 1 / near to 1 / far.
                let Self { near_metres, depth_metres, .. } = *self;
                straight * near_metres / (near_metres + depth_metres - straight * depth_metres)
            }
        }
    }
}
