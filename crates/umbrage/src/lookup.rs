//! The lookup of the shaders once more, in Rust: the oracle that the GPU is tested against, and a way to ask for
//! visibility without one.
//!
//! Mirrors `shaders/receiver.wgsl`, `shaders/select/` and `shaders/filter/`, in f32 as they do.

use glam::{Vec2, Vec3};
use umbrage_core::{Filter, Select, Settings, ShadowPlan, ShadowView, bias_metres, kernel_half_width_texels};

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

/// A place in a tile, in texels, the receiver's depth there, and what to compare.
struct Place {
    texel: Vec2,
    depth: f32,
    reference: f32,
}

impl Lookup<'_> {
    /// How much of a light reaches a point, from 0 to 1. `world_normal` is unit and geometric.
    pub fn visibility(&self, light: usize, world_position: Vec3, world_normal: Vec3) -> f32 {
        let camera = self.plan.camera();
        let forward = camera.forward();
        let depth = forward.extend(-forward.dot(camera.eye())).dot(world_position.extend(1.0));
        let beyond = self.plan.splits().last().is_none_or(|end| depth > *end as f32);
        let is_known = light < self.plan.lights().len();
        let view =
            if beyond || !is_known { None } else { self.select(light, depth, world_position, world_normal) };
        let Some(view) = view else { return 1.0 };
        let Place { texel, depth, reference } = self.place(view, light, world_position, world_normal);
        let size = view.tile.size as f32;
        if texel.cmplt(Vec2::ZERO).any() || texel.cmpgt(Vec2::splat(size)).any() || depth > 1.0 {
            return 1.0;
        }
        self.filter(view, texel, reference)
    }

    /// What the filter makes of a place in a view's tile, given in texels from its upper left corner.
    pub fn filter(&self, view: &ShadowView, texel: Vec2, reference: f32) -> f32 {
        match self.settings.filter {
            Filter::Hard {} => {
                let texel = texel.floor();
                self.lit(view, texel.x as i64, texel.y as i64, reference)
            }
            Filter::Bilinear {} => self.bilinear(view, texel, reference),
            Filter::Pcf { size } => {
                let reach = (size / 2) as i32;
                let taps = (-reach..=reach)
                    .flat_map(|y| (-reach..=reach).map(move |x| Vec2::new(x as f32, y as f32)));
                taps.map(|tap| self.bilinear(view, texel + tap, reference)).sum::<f32>()
                    / (size * size) as f32
            }
        }
    }

    fn select(&self, light: usize, depth: f32, position: Vec3, normal: Vec3) -> Option<&ShadowView> {
        let views = self.plan.views().iter().filter(|view| view.light == light);
        let inner = || self.plan.splits().iter().skip(1).take(self.plan.splits().len().saturating_sub(2));
        match self.settings.select {
            Select::Depth => {
                let split = inner().filter(|end| depth >= **end as f32).count();
                views.into_iter().nth(split)
            }
            Select::ClipDepth => {
                let camera = self.plan.camera();
                let clip = camera.clip_from_world() * position.extend(1.0);
                let split = inner().filter(|end| clip.z / clip.w <= camera.clip_depth(**end as f32)).count();
                views.into_iter().nth(split)
            }
            Select::Map => views.into_iter().find(|view| {
                let place = self.place(view, light, position, normal);
                let low = Vec2::splat(kernel_half_width_texels(self.settings.filter));
                let high = Vec2::splat(view.tile.size as f32) - low;
                let inside = place.texel.cmpge(low).all() && place.texel.cmple(high).all();
                inside && place.reference >= 0.0 && place.depth <= 1.0
            }),
        }
    }

    fn place(&self, view: &ShadowView, light: usize, position: Vec3, normal: Vec3) -> Place {
        let cosine = normal.dot(self.plan.lights()[light].direction_to_light());
        let bias = bias_metres(&self.settings.bias, self.settings.filter, view.texel_metres, cosine);
        let receiver = position + normal * bias.along_normal;
        let ndc = view.clip_from_world.project_point3(receiver);
        Place {
            texel: Vec2::new(ndc.x * 0.5 + 0.5, ndc.y * -0.5 + 0.5) * view.tile.size as f32,
            depth: ndc.z,
            reference: ndc.z - bias.toward_light / view.depth_metres - self.settings.depth.step(),
        }
    }

    fn bilinear(&self, view: &ShadowView, texel: Vec2, reference: f32) -> f32 {
        let inside = texel.clamp(Vec2::splat(0.5), Vec2::splat(view.tile.size as f32 - 0.5)) - 0.5;
        let (corner, share) = (inside.floor(), inside - inside.floor());
        let (x, y) = (corner.x as i64, corner.y as i64);
        let row = |y| {
            let (left, right) = (self.lit(view, x, y, reference), self.lit(view, x + 1, y, reference));
            left + (right - left) * share.x
        };
        let (upper, lower) = (row(y), row(y + 1));
        upper + (lower - upper) * share.y
    }

    fn lit(&self, view: &ShadowView, x: i64, y: i64, reference: f32) -> f32 {
        f32::from(u8::from(reference <= self.maps.depth(view.tile, x, y)))
    }
}
