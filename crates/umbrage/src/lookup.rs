//! The lookup of the shaders once more, in Rust: the oracle that the GPU is tested against, and a way to ask for
//! visibility without one.
//!
//! Mirrors `shaders/receiver.wgsl`, `shaders/select/`, `shaders/reference/` and `shaders/filter/`, in f32 as they do.

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

/// A place in a tile, in texels, the receiver's depth there, and what to compare: there, and how much more a texel on.
struct Place {
    texel: Vec2,
    depth: f32,
    reference: f32,
    gradient: Vec2,
}

/// The view whose map serves a receiver; `None` where none does, and the receiver counts as lit. `world_normal` is unit
/// and geometric.
pub fn view_of<'a>(
    plan: &'a ShadowPlan,
    settings: &Settings,
    light: usize,
    world_position: Vec3,
    world_normal: Vec3,
) -> Option<&'a ShadowView> {
    served(plan, settings, light, world_position, world_normal).map(|(view, _)| view)
}

impl Lookup<'_> {
    /// How much of a light reaches a point, from 0 to 1. `world_normal` is unit and geometric.
    pub fn visibility(&self, light: usize, world_position: Vec3, world_normal: Vec3) -> f32 {
        match served(self.plan, self.settings, light, world_position, world_normal) {
            Some((view, place)) => self.filter(view, place.texel, place.reference, place.gradient),
            None => 1.0,
        }
    }

    /// What the filter makes of a place in a view's tile, given in texels from its upper left corner. `reference` is the
    /// depth to compare with there, `gradient` how much that grows from a texel to the next, to the right and downward.
    pub fn filter(&self, view: &ShadowView, texel: Vec2, reference: f32, gradient: Vec2) -> f32 {
        let lit = |x: i64, y: i64| {
            let last = i64::from(view.tile.size) - 1;
            let (x, y) = (x.clamp(0, last), y.clamp(0, last));
            let centre = Vec2::new(x as f32, y as f32) + 0.5;
            let reference = (reference + gradient.dot(centre - texel)).min(1.0);
            f32::from(u8::from(reference <= self.maps.depth(view.tile, x, y)))
        };
        match self.settings.filter {
            Filter::Hard {} => lit(texel.x.floor() as i64, texel.y.floor() as i64),
            Filter::Bilinear {} => bilinear(view, texel, lit),
            Filter::Pcf { size } => {
                let reach = (size / 2) as i32;
                let taps = (-reach..=reach)
                    .flat_map(|y| (-reach..=reach).map(move |x| Vec2::new(x as f32, y as f32)));
                taps.map(|tap| bilinear(view, texel + tap, lit)).sum::<f32>() / (size * size) as f32
            }
        }
    }
}

/// Four comparisons around a place in a view's tile, weighted bilinearly.
fn bilinear(view: &ShadowView, texel: Vec2, lit: impl Fn(i64, i64) -> f32) -> f32 {
    let inside = texel.clamp(Vec2::splat(0.5), Vec2::splat(view.tile.size as f32 - 0.5)) - 0.5;
    let (corner, share) = (inside.floor(), inside - inside.floor());
    let (x, y) = (corner.x as i64, corner.y as i64);
    let row = |y| {
        let (left, right) = (lit(x, y), lit(x + 1, y));
        left + (right - left) * share.x
    };
    let (upper, lower) = (row(y), row(y + 1));
    upper + (lower - upper) * share.y
}

/// The view that serves a receiver, and where the receiver looks in it.
fn served<'a>(
    plan: &'a ShadowPlan,
    settings: &Settings,
    light: usize,
    position: Vec3,
    normal: Vec3,
) -> Option<(&'a ShadowView, Place)> {
    let camera = plan.camera();
    let forward = camera.forward();
    let depth = forward.extend(-forward.dot(camera.eye())).dot(position.extend(1.0));
    let beyond = plan.splits().last().is_none_or(|end| depth > *end as f32);
    if beyond || light >= plan.lights().len() {
        return None;
    }
    let view = select(plan, settings, light, depth, position, normal)?;
    let place = place(plan, settings, view, position, normal);
    let Place { texel, depth, reference: _, gradient: _ } = place;
    let outside = texel.cmplt(Vec2::ZERO).any() || texel.cmpgt(Vec2::splat(view.tile.size as f32)).any();
    (!outside && depth <= 1.0).then_some((view, place))
}

fn select<'a>(
    plan: &'a ShadowPlan,
    settings: &Settings,
    light: usize,
    depth: f32,
    position: Vec3,
    normal: Vec3,
) -> Option<&'a ShadowView> {
    let mut views = plan.views().iter().filter(|view| view.light == light);
    let inner = || plan.splits().iter().skip(1).take(plan.splits().len().saturating_sub(2));
    match settings.select {
        Select::Depth => views.nth(inner().filter(|end| depth >= **end as f32).count()),
        Select::ClipDepth => {
            let camera = plan.camera();
            let clip = camera.clip_from_world() * position.extend(1.0);
            views.nth(inner().filter(|end| clip.z / clip.w <= camera.clip_depth(**end as f32)).count())
        }
        Select::Map => views.find(|view| {
            let place = place(plan, settings, view, position, normal);
            let low = Vec2::splat(kernel_half_width_texels(settings.filter));
            let high = Vec2::splat(view.tile.size as f32) - low;
            let inside = place.texel.cmpge(low).all() && place.texel.cmple(high).all();
            let nearest = place.reference - place.gradient.abs().dot(low);
            inside && nearest >= 0.0 && place.depth <= 1.0
        }),
    }
}

fn place(plan: &ShadowPlan, settings: &Settings, view: &ShadowView, position: Vec3, normal: Vec3) -> Place {
    let cosine = normal.dot(plan.lights()[view.light].direction_to_light());
    let bias = bias_metres(&settings.bias, settings.filter, view.texel_metres, cosine);
    let receiver = position + normal * bias.along_normal;
    let ndc = view.clip_from_world.project_point3(receiver);
    Place {
        texel: Vec2::new(ndc.x * 0.5 + 0.5, ndc.y * -0.5 + 0.5) * view.tile.size as f32,
        depth: ndc.z,
        reference: ndc.z - bias.toward_light / view.depth_metres - settings.depth.step(),
        gradient: settings.bias.plane_gradient(view, normal, cosine),
    }
}
