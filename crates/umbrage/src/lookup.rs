//! The lookup of the shaders once more, in Rust: the oracle that the GPU is tested against, and a way to ask for
//! visibility without one.
//!
//! Mirrors `shaders/receiver.wgsl` and `texel_basis.wgsl`, and the files of `select/`, `reference/`, `filter/` and `blend/`, in f32
//! as they do.

mod reader;

use glam::{Vec2, Vec3};
use umbrage_core::{LightKind, RASTER_STEP_TEXELS, Select, Settings, ShadowPlan, ShadowView};

use self::reader::Reader;

use crate::maps::MapTexels;

/// Visibility from read-back maps.
#[derive(Clone, Copy, Debug)]
pub struct Lookup<'a> {
    /// The plan that the maps were drawn with.
    pub plan: &'a ShadowPlan,
    /// The settings that the plan was made with.
    pub settings: &'a Settings,
    /// The maps.
    pub maps: &'a MapTexels,
}

/// A place in a tile, and what to compare there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// In texels from the tile's upper left corner.
    pub texel: Vec2,
    /// Depth to compare with.
    pub reference: f32,
    /// How much that grows from a texel to the next, to the right and downward.
    pub gradient: Vec2,
    /// Sides of a texel there across the light, to the right and downward, metres.
    pub texel_metres: Vec2,
}

/// Who asks for visibility.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Query {
    /// World space, metres.
    pub position: Vec3,
    /// Unit, geometric.
    pub normal: Vec3,
    /// Its place on the screen, pixels.
    pub pixel: Vec2,
}

/// A receiver of one light's shadows, and what it is looked up with.
#[derive(Clone, Copy)]
struct Receiver<'a> {
    plan: &'a ShadowPlan,
    settings: &'a Settings,
    light: usize,
    position: Vec3,
    /// Unit, geometric.
    normal: Vec3,
    /// From the eye, metres.
    depth: f32,
    /// Its place on the screen.
    pixel: Vec2,
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
        let receiver = Receiver::new(plan, settings, light, world_position, world_normal);
        let receiver = receiver.map(|receiver| Receiver { pixel, ..receiver });
        let visible =
            receiver.and_then(|receiver| Some(self.blended(&receiver, receiver.view()?))).unwrap_or(1.0);
        visible * smoothstep(cosine / settings.bias.terminator.max(1e-30))
    }

    /// What a view says of a receiver. Points outside the map are lit.
    fn read(&self, view: &ShadowView, place: &Place, receiver: &Receiver<'_>) -> f32 {
        let size = Vec2::splat(view.tile.size as f32);
        let outside = place.texel.cmplt(Vec2::ZERO).any() || place.texel.cmpgt(size).any();
        if outside || place.reference > 1.0 {
            return 1.0;
        }
        self.filter(
            view,
            place,
            &Query { position: receiver.position, normal: receiver.normal, pixel: receiver.pixel },
        )
    }

    /// As `umbrage_blend` of the shaders.
    fn blended(&self, receiver: &Receiver<'_>, view: &ShadowView) -> f32 {
        let place = receiver.place(view);
        let own = self.read(view, &place, receiver);
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
            Some(next) => mix(self.read(next, &receiver.place(next), receiver), own, smoothstep(share)),
            None => own,
        };
        let end = self.plan.splits().last().map_or(0.0, |end| *end as f32);
        let start = receiver.views().last().map_or(end, |last| last.depths.start);
        let left = (end - receiver.depth) / ((end - start) * blend).max(1e-30);
        mix(1.0, mixed, smoothstep(left))
    }

    /// What the filter makes of a place in a view's tile. Who asks matters to filters with noise and to footprints, which
    /// are those of a picture of 1920 × 1080 here. Moments are read at their full size.
    pub fn filter(&self, view: &ShadowView, place: &Place, asker: &Query) -> f32 {
        let Self { plan, settings, maps } = *self;
        Reader { plan, settings, maps, view, place: *place }.visibility(asker)
    }
}

impl<'a> Receiver<'a> {
    /// `None` beyond the end of shadows, and for a light that the plan does not have.
    fn new(
        plan: &'a ShadowPlan,
        settings: &'a Settings,
        light: usize,
        position: Vec3,
        normal: Vec3,
    ) -> Option<Self> {
        let camera = plan.camera();
        let forward = camera.forward();
        let depth = forward.extend(-forward.dot(camera.eye())).dot(position.extend(1.0));
        let is_within = plan.splits().last().is_some_and(|end| depth <= *end as f32);
        let pixel = Vec2::splat(0.5);
        let receiver = Self { plan, settings, light, position, normal, depth, pixel };
        (is_within && light < plan.lights().len()).then_some(receiver)
    }

    fn views(&self) -> impl Iterator<Item = &'a ShadowView> + use<'a> {
        let light = self.light;
        self.plan.views().iter().filter(move |view| view.light == light)
    }

    /// The view that serves it.
    fn view(&self) -> Option<&'a ShadowView> {
        if let LightKind::Point { position, .. } = self.plan.lights()[self.light].kind() {
            return self.views().nth(face(self.position - position));
        }
        let ends = || self.views().take(self.views().count().saturating_sub(1)).map(|view| view.depths.end);
        match self.settings.select {
            Select::Depth => self.views().nth(ends().filter(|end| self.depth >= *end).count()),
            Select::ClipDepth => {
                let camera = self.plan.camera();
                let clip = camera.clip_from_world() * self.position.extend(1.0);
                let is_beyond = |end: &f32| clip.z / clip.w <= camera.clip_depth(*end);
                self.views().nth(ends().filter(is_beyond).count())
            }
            Select::Map => self.views().find(|view| self.is_held_by(view)),
        }
    }

    /// The view that `view` is blended with.
    fn next(&self, view: &ShadowView) -> Option<&'a ShadowView> {
        let mut after = self.views().filter(|other| other.index > view.index);
        match self.settings.select {
            Select::Depth | Select::ClipDepth => after.next(),
            Select::Map => after.find(|view| self.is_held_by(view)),
        }
    }

    /// Whether a view's map holds the whole footprint of the filter.
    fn is_held_by(&self, view: &ShadowView) -> bool {
        let place = self.place(view);
        let low = Vec2::splat(self.settings.filter.reach_texels());
        let high = Vec2::splat(view.tile.size as f32) - low;
        let inside = place.texel.cmpge(low).all() && place.texel.cmple(high).all();
        let plane = self.settings.filter.plane_reach_texels();
        let nearest = place.reference - place.gradient.abs().element_sum() * plane;
        inside && nearest >= 0.0 && place.reference <= 1.0
    }

    fn place(&self, view: &ShadowView) -> Place {
        let Self { settings, position, normal, .. } = *self;
        if (view.clip_from_world * position.extend(1.0)).w <= 0.0 {
            let (texel, gradient) = (Vec2::NEG_ONE, Vec2::ZERO);
            return Place { texel, reference: 2.0, gradient, texel_metres: Vec2::ONE };
        }
        let to_light = self.plan.lights()[view.light].direction_from(position);
        let texel_basis = view.texel_basis_at(position);
        let bias = settings.bias_metres(&texel_basis, normal, to_light);
        let ndc = view.clip_from_world.project_point3(position + normal * bias.along_normal);
        Place {
            texel: Vec2::new(ndc.x * 0.5 + 0.5, ndc.y * -0.5 + 0.5) * view.tile.size as f32,
            reference: ndc.z
                - texel_basis.rise(to_light) * bias.toward_light
                - texel_basis.slope(normal, to_light, settings.filter.steepest_plane()).abs().element_sum()
                    * RASTER_STEP_TEXELS
                - settings.depth.step(),
            gradient: settings.reference_gradient(&texel_basis, normal, to_light),
            texel_metres: Vec2::new(texel_basis.right.length(), texel_basis.down.length()),
        }
    }
}

/// The face of a cube that a direction goes through: that of its largest part.
fn face(direction: Vec3) -> usize {
    let size = direction.abs();
    let (axis, part) = if size.x >= size.y && size.x >= size.z {
        (0, direction.x)
    } else if size.y >= size.z {
        (2, direction.y)
    } else {
        (4, direction.z)
    };
    axis + usize::from(part < 0.0)
}

fn mix(from: f32, to: f32, share: f32) -> f32 {
    from + (to - from) * share
}

/// From 0 to 1, over 0 to 1.
fn smoothstep(share: f32) -> f32 {
    let share = share.clamp(0.0, 1.0);
    share * share * (3.0 - 2.0 * share)
}
