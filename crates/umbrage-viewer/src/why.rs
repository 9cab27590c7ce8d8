//! Why one pixel's shadow is as it is: what its map says, what is true, and the cause where the two differ.
//!
//! Everything is measured at the pixel: the place in the map and the depths there as the lookup has them
//! (`umbrage::place_of`), what is in the way by the judge's rays, and how the truth changes from texel to texel around it.
//! Lengths are in metres, and those along the light are measured along the axis of its map.

mod around;
mod cause;
#[cfg(test)]
mod tests;

use glam::Vec2;
use umbrage::{BiasMetres, CompareDepth, LightKind, MapTexels, Place, Settings, ShadowPlan, ShadowView};
use umbrage_judge::{Inspected, Light, Pixel, Receiver, Verdict, World};

pub use cause::Cause;

/// What is asked of a pixel.
#[derive(Clone, Copy, Debug)]
pub struct Question<'a> {
    /// The plan of the picture.
    pub plan: &'a ShadowPlan,
    /// The settings that it was drawn with.
    pub settings: &'a Settings,
    /// Its shadow maps; `None` where they could not be read.
    pub maps: Option<&'a MapTexels>,
    /// The world.
    pub world: &'a World,
    /// The number of the light among those of the plan.
    pub light: usize,
    /// The same light, for rays.
    pub rays: &'a Light,
    /// What is true of the pixel.
    pub inspected: Inspected,
    /// The visibility that the picture has there, 0 to 1.
    pub shown: f32,
}

/// The answer to a question says what map, truth and picture have at the pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct Why {
    /// The visibility that the picture has there, 0 to 1.
    pub shown: f32,
    /// What the map says; `None` where no map serves the pixel.
    pub map: Option<MapSays>,
    /// What is true.
    pub truth: Pixel,
    /// The distance to the nearest caster on the way to the light, metres; `None` where there is none.
    pub blocker: Option<f64>,
    /// Whether the picture is right.
    pub verdict: Verdict,
    /// Why it is wrong, or right.
    pub cause: Cause,
}

/// What a map says of a pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct MapSays {
    /// The view in words, as "split 2 of 4, for 8.1 m to 30.2 m".
    pub view: String,
    /// The place in the view's tile, texels from its upper left corner.
    pub texel: Vec2,
    /// The side of the tile, texels.
    pub side: u32,
    /// The sides of a texel there across the light, metres.
    pub texel_metres: Vec2,
    /// The depth that the texel stores: 1 near the light, 0 far or nothing. `None` where the maps could not be read, or the
    /// place lies outside of the tile.
    pub stored: Option<f32>,
    /// The depth that it is compared with.
    pub compare: f32,
    /// What the settings ask the lookup to stand off.
    pub asked: BiasMetres,
    /// How far the lookup is offset from the surface in all, rounding included, metres toward the light.
    pub bias: f32,
    /// How far in front of the surface the texel's blocker lies, metres; `None` where the texel holds none.
    pub blocker: Option<f32>,
    /// Whether that blocker lies before the map's near plane, where casters are flattened onto it: then it may lie farther away.
    pub is_flattened: bool,
}

/// A view's lookup of the pixel, and depths in metres.
#[derive(Clone, Copy, Debug)]
struct Read<'a> {
    view: &'a ShadowView,
    place: Place,
    /// How far along the light the surface itself lies in the view, 0 to 1.
    surface: f32,
}

impl Question<'_> {
    /// Answers it.
    pub fn answer(&self) -> Why {
        let Self { inspected: Inspected { receiver, truth, blocker }, shown, .. } = *self;
        let verdict = Verdict::new(Some(truth), shown);
        let read = self.read(&receiver);
        let map = read.map(|read| self.map_says(&read, &receiver));
        let cause = self.cause(verdict, read.as_ref(), map.as_ref());
        Why { shown, map, truth, blocker, verdict, cause }
    }

    fn read(&self, receiver: &Receiver) -> Option<Read<'_>> {
        let Self { plan, settings, light, .. } = *self;
        let (position, normal) = (receiver.position.as_vec3(), receiver.normal.as_vec3());
        let (view, place) = umbrage::place_of(plan, settings, light, position, normal)?;
        Some(Read { view, place, surface: linear(view, receiver.position)? })
    }

    fn map_says(&self, read: &Read<'_>, receiver: &Receiver) -> MapSays {
        let Read { view, place, surface } = *read;
        let position = receiver.position.as_vec3();
        let to_light = self.plan.lights()[view.light].direction_from(position);
        let basis = view.texel_basis_at(position);
        let asked = self.settings.bias_metres(&basis, receiver.normal.as_vec3(), to_light, view.caster_error);
        let compared = view.linear_depth(place.texel, place.compare_depth);
        let stored = self.stored(read);
        let centre = place.texel.floor() + 0.5;
        let blocker = stored
            .filter(|stored| *stored > 0.0)
            .map(|stored| (surface - view.linear_depth(centre, stored)) * view.depth_metres);
        MapSays {
            view: words(self.plan, view),
            texel: place.texel,
            side: view.tile.size,
            texel_metres: place.texel_metres,
            stored,
            compare: compare_at(self.settings, &place, centre),
            asked,
            bias: (surface - compared) * view.depth_metres,
            blocker,
            is_flattened: view.unclipped_depth && stored.is_some_and(|stored| stored >= 1.0),
        }
    }

    /// What the texel stores.
    fn stored(&self, Read { view, place, .. }: &Read<'_>) -> Option<f32> {
        let is_inside =
            place.texel.cmpge(Vec2::ZERO).all() && place.texel.max_element() <= view.tile.size as f32;
        let [x, y] = place.texel.floor().to_array().map(|texel| texel as i64);
        self.maps.filter(|_| is_inside).map(|maps| maps.depth(view.tile, x, y))
    }
}

/// The depth that a texel is compared with, under settings that follow the receiver's plane at the texel's centre.
fn compare_at(settings: &Settings, place: &Place, centre: Vec2) -> f32 {
    match settings.compare_depth() {
        CompareDepth::Plane | CompareDepth::Facing => {
            place.compare_depth + place.gradient.dot(centre - place.texel)
        }
        CompareDepth::Own => place.compare_depth,
    }
}

/// How far along the light a point lies in a view, 0 on its near plane and 1 on its far one; `None` behind the light.
fn linear(view: &ShadowView, point: glam::DVec3) -> Option<f32> {
    let clip = view.clip_from_world * point.extend(1.0);
    let ndc = (clip.truncate() / clip.w).as_vec3();
    let texel = Vec2::new(0.5 + 0.5 * ndc.x, 0.5 - 0.5 * ndc.y) * view.tile.size as f32;
    (clip.w > 0.0).then(|| view.linear_depth(texel, ndc.z.max(f32::MIN_POSITIVE)))
}

/// Returns the name of a view in words.
fn words(plan: &ShadowPlan, view: &ShadowView) -> String {
    const FACES: [&str; 6] = ["+X", "−X", "+Y", "−Y", "+Z", "−Z"];
    let count = plan.views().iter().filter(|other| other.light == view.light).count();
    match plan.lights()[view.light].kind() {
        LightKind::Point { .. } => format!("face {} of the point light's cube", FACES[view.split % 6]),
        LightKind::Directional { .. } | LightKind::Spot { .. } if count == 1 => {
            "the light's one map".to_owned()
        }
        LightKind::Directional { .. } | LightKind::Spot { .. } => {
            let (from, to) = (view.depths.start, view.depths.end);
            format!("split {} of {count}, for depths from {from:.2} m to {to:.2} m", view.split + 1)
        }
    }
}
