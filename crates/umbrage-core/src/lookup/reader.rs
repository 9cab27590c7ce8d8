//! What may a filter ask of the map around a place? Texels, comparisons, and how wide a penumbra is there.

use glam::{Mat2, Vec2};

use super::place::{Place, Query};
use crate::bias::OWN_TEXEL;
use crate::filter::light_size::LightSize;

/// No receiver is nearer than this: see `UMBRAGE_NEAREST_COMPARED` of the shaders.
const NEAREST_COMPARED: f32 = 0.9999;

/// The tile of one view.
pub(crate) trait Map {
    /// Texels a side.
    fn side(&self) -> u32;

    /// The depth that is stored at a texel; that of the outermost one for texels outside.
    fn stored(&self, x: i64, y: i64) -> f32;

    /// How far along the light a depth is that is stored at a place of the tile: 0 on the near plane, 1 on the far one, and
    /// linear between.
    fn linear_depth(&self, texel: Vec2, stored: f32) -> f32;

    /// From the near plane to the far one, metres.
    fn depth_metres(&self) -> f32;

    /// The radius of the disc at the receiver's linear depth through which the view's light is seen past a blocker at
    /// another, metres. Lights that say no size are as large as `light`.
    fn penumbra_metres(&self, light: LightSize, receiver: f32, blocker: f32) -> f32;

    /// How the place on the map changes from a pixel to the next, to the right and upward, texels.
    fn footprint(&self, query: &Query) -> Mat2;
}

/// A place of a map, with what filters have in common.
pub(crate) struct Reader<'a> {
    pub map: &'a dyn Map,
    pub place: Place,
    /// Whether a comparison beside the place weighs four texels, with the place's own depth for all of them; otherwise it
    /// is one texel's.
    pub taps_four: bool,
}

impl Reader<'_> {
    /// Texels a side.
    pub fn side(&self) -> i64 {
        i64::from(self.map.side())
    }

    /// How far along the light the place's own depth lies.
    pub fn depth(&self) -> f32 {
        self.map.linear_depth(self.place.texel, self.place.compare_depth)
    }

    /// How far along the light what is stored at a texel lies, which is given by its upper left corner.
    pub fn linear_depth(&self, corner: Vec2) -> f32 {
        self.map.linear_depth(corner + 0.5, self.stored(corner))
    }

    /// The upper left corner of the texel at a place; of the nearest one inside, for places outside.
    pub fn corner_inside(&self, texel: Vec2) -> Vec2 {
        texel.floor().clamp(Vec2::ZERO, Vec2::splat((self.side() - 1) as f32))
    }

    /// Whether a texel, given by its upper left corner, leaves the receiver lit: 1 or 0.
    pub fn lit(&self, corner: Vec2) -> f32 {
        let inside = corner.clamp(Vec2::ZERO, Vec2::splat((self.side() - 1) as f32));
        let Place { texel, compare_depth, gradient, bend, .. } = self.place;
        let beside = inside + 0.5 - texel;
        let plane = compare_depth + gradient.dot(beside);
        let compared = (plane + bend * (beside.abs().max_element() - OWN_TEXEL).max(0.0))
            .clamp(0.0, compare_depth.max(NEAREST_COMPARED));
        f32::from(u8::from(compared >= self.stored(inside)))
    }

    fn stored(&self, corner: Vec2) -> f32 {
        self.map.stored(corner.x as i64, corner.y as i64)
    }

    /// Four comparisons around a place, weighted bilinearly.
    pub fn bilinear(&self, texel: Vec2) -> f32 {
        let inside = texel.clamp(Vec2::splat(0.5), Vec2::splat(self.side() as f32 - 0.5)) - 0.5;
        let (corner, share) = (inside.floor(), inside - inside.floor());
        let row = |y: f32| {
            let lit = |x: f32| self.lit(corner + Vec2::new(x, y));
            lit(0.0) + (lit(1.0) - lit(0.0)) * share.x
        };
        row(0.0) + (row(1.0) - row(0.0)) * share.y
    }

    /// A comparison beside the place, texels away.
    pub fn tap(&self, offset: Vec2) -> f32 {
        if self.taps_four {
            self.bilinear(self.place.texel + offset)
        } else {
            self.lit((self.place.texel + offset).floor())
        }
    }

    /// The radius of the disc on the map through which the light is seen past a blocker at a linear depth, texels.
    pub fn penumbra(&self, light: LightSize, max_texels: f32, blocker: f32) -> Vec2 {
        let metres = self.map.penumbra_metres(light, self.depth(), blocker);
        (metres / self.place.texel_metres).clamp(Vec2::splat(0.5), Vec2::splat(max_texels))
    }
}
