//! What one shadow map is: a matrix, a tile and a share of the scene.

use std::ops::Range;

use glam::{DMat4, DVec3, DVec4, Mat4, Vec2, Vec3, Vec4};

use crate::allocation::Tile;
use crate::cull::ConvexVolume;
use crate::finite::{finite_matrix, finite_vector};
use crate::samples::SampleRegion;
use crate::settings::DepthFormat;
use crate::space::Rays;
use crate::view_key::ViewKey;

/// One shadow map, or one tile of an atlas. Everything after planning only ever sees these.
#[derive(Clone, Debug, PartialEq)]
pub struct ShadowView {
    /// The view's place in the plan, and in the GPU's list of views.
    pub index: usize,
    /// The name of what the view shows: a tile that shows it already is not drawn again. `None` says that it is new in each
    /// frame, as plans do until [`ShadowPlan::set_key`](crate::ShadowPlan::set_key) is called.
    pub key: Option<ViewKey>,
    /// The matrix from world space to the clip space of this view alone: x and y in −1…1 over the tile, and reversed depth:
    /// 1 near the light, 0 far from it. It is in f64; [`Self::clip_from_local`] is what f32 can hold of it.
    pub clip_from_world: DMat4,
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
    /// This says how its rays run, and so how depth is stored and where its [local space](Self::clip_from_local) begins.
    pub rays: Rays,
    /// A warp scales stored depth by a factor that is constant along each light ray; this is that factor as a linear
    /// function of NDC: at x, y it is dot(this, (x, y, 1)), at most 1 on the map, and 1 everywhere without a warp.
    pub depth_scale: Vec3,
    /// The tile of the maps that the view is drawn to.
    pub tile: Tile,
    /// Whether casters before the near plane must be flattened onto it.
    pub unclipped_depth: bool,
    /// Under [`Fit::Sample`](crate::Fit::Sample), the region within which a compute pass chooses what the view covers: its matrix
    /// and texels are then those of all that may be chosen, and finer ones take their place on the GPU. `None` where the plan
    /// says what is covered.
    pub samples: Option<SampleRegion>,
    /// How far the casters that are drawn may lie from those that are meant, metres: 0, unless
    /// [`ShadowPlan::set_caster_error`](crate::ShadowPlan::set_caster_error) says otherwise. Lookups stand off their surface
    /// by as much more.
    pub caster_error: f32,
}

impl ShadowView {
    /// Returns where the view's local space begins, relative to `origin`: at the apex of a punctual light, and at `origin`
    /// itself for a sun.
    ///
    /// Shaders are given positions relative to an origin near the eye, and subtract this. So no translation of kilometres
    /// stands in a matrix of f32, where it would cost the metres behind it.
    pub fn local_origin(&self, origin: DVec3) -> Vec3 {
        match self.rays {
            Rays::Parallel => Vec3::ZERO,
            Rays::FromApex { apex } => finite_vector(apex - origin),
        }
    }

    /// Returns the matrix from local space to clip space, for positions relative to `origin`: see [`Self::local_origin`].
    ///
    /// Where the rays are parallel and there is no warp, the translation is a whole number of the rasteriser's steps (1/256
    /// texel): then what was rounded to that grid before it is added stays on it.
    pub fn clip_from_local(&self, origin: DVec3) -> Mat4 {
        let m = self.clip_from_world;
        let mut local = m;
        match self.rays {
            Rays::Parallel => {
                local.w_axis = m * origin.extend(1.0);
                if m.row(3) == DVec4::W {
                    let grid = 128.0 * f64::from(self.tile.size);
                    local.w_axis.x = (local.w_axis.x * grid).round() / grid;
                    local.w_axis.y = (local.w_axis.y * grid).round() / grid;
                }
            }
            Rays::FromApex { apex } => local.w_axis = m * apex.extend(1.0),
        }
        finite_matrix(local)
    }

    /// Returns the clip position of a point of the world, in f32, as shaders find it.
    pub fn clip(&self, point: Vec3) -> Vec4 {
        self.clip_from_local(DVec3::ZERO) * (point - self.local_origin(DVec3::ZERO)).extend(1.0)
    }

    /// Returns where the tile's upper left texel lies in the lattice of the light's own texels, x right and y down, modulo 2³². The
    /// lattice begins at the world's origin for a sun, and on the axis of a punctual light.
    ///
    /// Where the camera moves a map by whole texels, or not at all, a place of the world stays in the same texel of the lattice:
    /// of suns and spots under [`Fit::Stable`](crate::Fit::Stable) and [`Fit::World`](crate::Fit::World), and of a point light's
    /// faces under every fit.
    pub fn lattice(&self) -> [u32; 2] {
        let m = self.clip_from_world;
        let begin = match self.rays {
            Rays::Parallel => DVec3::ZERO,
            Rays::FromApex { apex } => apex + m.row(3).truncate(),
        };
        let ndc = m.project_point3(begin);
        let half = 0.5 * f64::from(self.tile.size);
        // Whole numbers, or halves where a side is odd: neither may be rounded both ways. What is no number becomes 0.
        let whole = |texels: f64| (texels * half + 0.25).floor().rem_euclid(2f64.powi(32)) as u32;
        [-1.0 - ndc.x, ndc.y - 1.0].map(whole)
    }

    /// Returns how much rounding may make of a stored depth and of the one that it is compared with, in maps of a format.
    ///
    /// Mirrors `umbrage_depth_rounding` of the shaders.
    pub(crate) fn depth_rounding(&self, format: DepthFormat, stored: f32) -> f32 {
        let rounded = match self.rays {
            Rays::Parallel => 1.0 + self.clip_from_local(DVec3::ZERO).w_axis.z.abs(),
            Rays::FromApex { .. } => stored.abs(),
        };
        format.step() + format.rounding() * rounded
    }

    /// Whether the map covers `point`, give or take `slack` in clip units; what lies before the near plane counts as
    /// covered where depth is unclipped.
    pub fn covers(&self, point: DVec3, slack: f64) -> bool {
        let clip = self.clip_from_world * point.extend(1.0);
        if clip.w <= 0.0 {
            return false;
        }
        let clip = clip / clip.w;
        let near = if self.unclipped_depth { f64::INFINITY } else { 1.0 + slack };
        clip.x.abs() <= 1.0 + slack && clip.y.abs() <= 1.0 + slack && clip.z >= -slack && clip.z <= near
    }

    /// Returns how far along the light's axis a depth lies that is stored at a place of the tile, given in texels: 0 on the
    /// near plane, 1 on the far one, and linear between.
    pub fn linear_depth(&self, texel: Vec2, stored: f32) -> f32 {
        // Nothing was drawn. A warp would make a place of that beyond its line at infinity.
        if stored <= 0.0 {
            return 1.0;
        }
        let ndc = texel / self.tile.size as f32 * Vec2::new(2.0, -2.0) + Vec2::new(-1.0, 1.0);
        // What was flattened onto the near plane of a warped map lies before it.
        let straight = (stored / self.depth_scale.dot(ndc.extend(1.0))).min(1.0);
        match self.rays {
            Rays::Parallel => 1.0 - straight,
            Rays::FromApex { .. } => {
                // 1 / d is linear in it, from 1 / far to 1 / near.
                let Self { near_metres, depth_metres, .. } = *self;
                (1.0 - straight) * near_metres / (near_metres + straight * depth_metres)
            }
        }
    }
}
