//! The lookup of the shaders once more, in Rust: the oracle that the GPU is tested against, and a way to ask for
//! visibility without one.
//!
//! It mirrors the shaders' selection of a view, placing, comparing and blending, in f32 as they do. What a filter makes of
//! a place stands in the filter's own file ([`crate::filter`]).

mod map_texels;
pub(crate) mod place;
pub(crate) mod reader;
mod receiver;
mod view_map;

use glam::{Vec2, Vec3};

use self::reader::Reader;
use self::receiver::Receiver;
use self::view_map::ViewMap;
use crate::bias::CompareDepth;
use crate::light::LightKind;
use crate::plan::ShadowPlan;
use crate::settings::{Select, Settings};
use crate::view::ShadowView;

pub use map_texels::MapTexels;
pub use place::{Place, Query};
pub use view_map::PICTURE_SIZE;

/// Visibility from maps that were read back.
#[derive(Clone, Copy, Debug)]
pub struct Lookup<'a> {
    /// The plan that the maps were drawn with.
    pub plan: &'a ShadowPlan,
    /// The settings that the plan was made with.
    pub settings: &'a Settings,
    /// The maps.
    pub maps: &'a MapTexels,
}

/// The view whose map serves a receiver; `None` where none does, and the receiver counts as lit. `world_normal` is unit
/// and geometric.
pub fn view_of<'a>(
    plan: &'a ShadowPlan,
    settings: &'a Settings,
    light: usize,
    world_position: Vec3,
    world_normal: Vec3,
) -> Option<&'a ShadowView> {
    Receiver::new(plan, settings, light, world_position, world_normal)?.view()
}

/// Returns the view whose map serves a receiver, and the place in its tile with the depth to compare with there; `None` where no view
/// does. `world_normal` is unit and geometric.
pub fn place_of<'a>(
    plan: &'a ShadowPlan,
    settings: &'a Settings,
    light: usize,
    world_position: Vec3,
    world_normal: Vec3,
) -> Option<(&'a ShadowView, Place)> {
    let receiver = Receiver::new(plan, settings, light, world_position, world_normal)?;
    let view = receiver.view()?;
    Some((view, receiver.place(view)))
}

impl Lookup<'_> {
    /// How much of a light reaches a point, from 0 to 1. `world_normal` is unit and geometric, on the side that is seen.
    pub fn visibility(&self, light: usize, world_position: Vec3, world_normal: Vec3) -> f32 {
        self.visibility_at(light, world_position, world_normal, Vec2::splat(0.5))
    }

    /// The same for a pixel of the picture, which filters with noise on the screen ask for.
    pub fn visibility_at(&self, light: usize, world_position: Vec3, world_normal: Vec3, pixel: Vec2) -> f32 {
        let Self { plan, settings, .. } = *self;
        let Some(of) = plan.lights().get(light) else { return 1.0 };
        let cosine = world_normal.dot(of.direction_from(world_position));
        if cosine <= 0.0 {
            return 0.0;
        }
        let query = Query { position: world_position, normal: world_normal, pixel };
        let receiver = Receiver::new(plan, settings, light, world_position, world_normal);
        let visible = receiver
            .and_then(|receiver| Some(self.blended(&receiver, receiver.view()?, &query)))
            .unwrap_or(1.0);
        visible * smoothstep(cosine / settings.bias.terminator.max(1e-30))
    }

    /// What a view says of a receiver. Points outside the map are lit.
    fn read(&self, view: &ShadowView, place: &Place, query: &Query) -> f32 {
        let size = Vec2::splat(view.tile.size as f32);
        let outside = place.texel.cmplt(Vec2::ZERO).any() || place.texel.cmpgt(size).any();
        if outside || place.compare_depth < 0.0 {
            return 1.0;
        }
        self.filter(view, place, query)
    }

    /// As `umbrage_blend` of the shaders.
    fn blended(&self, receiver: &Receiver<'_>, view: &ShadowView, query: &Query) -> f32 {
        let place = receiver.place(view);
        let own = self.read(view, &place, query);
        let blend = self.settings.blend;
        if blend == 0.0 {
            return own;
        }
        let is_cube = matches!(self.plan.lights()[view.light].kind(), LightKind::Point { .. });
        let share = match self.settings.select {
            Select::Depth | Select::ClipDepth => {
                (view.depths.end - receiver.depth) / ((view.depths.end - view.depths.start) * blend)
            }
            Select::Map => {
                let from_middle = (place.texel / view.tile.size as f32 * 2.0 - 1.0).abs();
                (1.0 - from_middle.max_element()) / blend
            }
        };
        let next = if is_cube || share >= 1.0 { None } else { receiver.next(view) };
        let mixed = match next {
            Some(next) => mix(self.read(next, &receiver.place(next), query), own, smoothstep(share)),
            None => own,
        };
        let end = self.plan.splits().last().map_or(0.0, |end| *end as f32);
        let start = receiver.views().last().map_or(end, |last| last.depths.start);
        let left = (end - receiver.depth) / ((end - start) * blend).max(1e-30);
        mix(1.0, mixed, smoothstep(left))
    }

    /// What the filter makes of a place in a view's tile. The query matters to filters with noise, and to footprints, which
    /// are those of a picture of [`PICTURE_SIZE`]. Moments are read at their full size.
    pub fn filter(&self, view: &ShadowView, place: &Place, query: &Query) -> f32 {
        let Self { plan, settings, maps } = *self;
        let taps_four = match settings.compare_depth() {
            CompareDepth::Plane | CompareDepth::Facing => false,
            CompareDepth::Own => true,
        };
        let map = ViewMap { plan, maps, view };
        settings.filter.visibility(&Reader { map: &map, place: *place, taps_four }, query)
    }
}

fn mix(from: f32, to: f32, share: f32) -> f32 {
    from + (to - from) * share
}

/// From 0 to 1, over 0 to 1.
fn smoothstep(share: f32) -> f32 {
    let share = share.clamp(0.0, 1.0);
    share * share * (3.0 - 2.0 * share)
}
