//! Which view serves a receiver, and where in its tile does the receiver lie?

use glam::{Vec2, Vec3};

use super::place::Place;
use crate::bias::{RASTER_STEP_TEXELS, STEEPEST_PLANE};
use crate::light::LightKind;
use crate::plan::ShadowPlan;
use crate::settings::{Select, Settings};
use crate::view::ShadowView;

/// A receiver of one light's shadows, and what it is looked up with.
#[derive(Clone, Copy)]
pub(super) struct Receiver<'a> {
    plan: &'a ShadowPlan,
    settings: &'a Settings,
    light: usize,
    position: Vec3,
    /// Unit, geometric.
    normal: Vec3,
    /// From the eye, metres.
    pub depth: f32,
}

impl<'a> Receiver<'a> {
    /// `None` beyond the end of shadows, and for a light that the plan does not have.
    pub fn new(
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
        let receiver = Self { plan, settings, light, position, normal, depth };
        (is_within && light < plan.lights().len()).then_some(receiver)
    }

    /// The views of its light.
    pub fn views(&self) -> impl Iterator<Item = &'a ShadowView> + use<'a> {
        let light = self.light;
        self.plan.views().iter().filter(move |view| view.light == light)
    }

    /// The view that serves it.
    pub fn view(&self) -> Option<&'a ShadowView> {
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
    pub fn next(&self, view: &ShadowView) -> Option<&'a ShadowView> {
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
        inside && (0.0..=1.0).contains(&place.compare_depth)
    }

    /// Where it lies in a view's tile; outside of it where the view's light does not reach it.
    pub fn place(&self, view: &ShadowView) -> Place {
        let Self { settings, position, normal, .. } = *self;
        if view.clip(position).w <= 0.0 {
            let (texel, gradient) = (Vec2::NEG_ONE, Vec2::ZERO);
            return Place { texel, compare_depth: -1.0, gradient, bend: 0.0, texel_metres: Vec2::ONE };
        }
        let to_light = self.plan.lights()[view.light].direction_from(position);
        let texel_basis = view.texel_basis_at(position);
        let bias = settings.bias_metres(&texel_basis, normal, to_light, view.caster_error);
        let clip = view.clip(position + normal * bias.along_normal);
        let ndc = clip.truncate() / clip.w;
        Place {
            texel: Vec2::new(ndc.x * 0.5 + 0.5, ndc.y * -0.5 + 0.5) * view.tile.size as f32,
            compare_depth: ndc.z
                + texel_basis.rise(to_light) * bias.toward_light
                + texel_basis.slope(normal, to_light, STEEPEST_PLANE).abs().element_sum()
                    * RASTER_STEP_TEXELS
                + view.depth_rounding(settings.depth, ndc.z),
            gradient: settings.reference_gradient(&texel_basis, normal, to_light),
            bend: texel_basis.rise(to_light) * bias.bend,
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
