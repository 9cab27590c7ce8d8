//! From a camera, lights, a world and settings to shadow views: pure, and microseconds.

use glam::{DVec3, Mat4};

use crate::bounds::{Aabb, Bounds};
use crate::camera::Camera;
use crate::error::PlanError;
use crate::few::Few;
use crate::fit::{Fitted, Outline, Slice, fit};
use crate::light::Light;
use crate::settings::{MAX_LIGHTS, MAX_SPLITS, Settings};
use crate::split::split_distances;
use crate::view::{MapLayout, ShadowView};

/// The shadow views of one frame, and what a receiver needs to find its own.
#[derive(Clone, Debug)]
pub struct ShadowPlan {
    views: Vec<ShadowView>,
    lights: Vec<Light>,
    splits: Few<f64, { MAX_SPLITS + 1 }>,
    layout: MapLayout,
    camera: Camera,
    /// Room to fit in.
    outline: Outline,
}

/// Plans a frame. The views come light by light, and in a light split by split.
///
/// A slice in which there is nothing gets a finite view that no caster touches. Never NaN, for any finite input.
///
/// # Errors
/// When a setting is out of range, the shadow distance ends before the camera's near, the world's box is not finite
/// (an empty one is allowed), or there are more than [`MAX_LIGHTS`] lights.
pub fn plan(
    camera: &Camera,
    lights: &[Light],
    bounds: &Bounds,
    settings: &Settings,
) -> Result<ShadowPlan, PlanError> {
    let layout = MapLayout::new(settings, 1);
    let mut plan = ShadowPlan {
        views: Vec::new(),
        lights: Vec::new(),
        splits: Few::default(),
        layout,
        camera: *camera,
        outline: Outline::default(),
    };
    plan.replan(camera, lights, bounds, settings)?;
    Ok(plan)
}

impl ShadowPlan {
    /// As [`plan`], into the room that this plan already has. After an error the plan is as it was.
    ///
    /// # Errors
    /// As [`plan`].
    pub fn replan(
        &mut self,
        camera: &Camera,
        lights: &[Light],
        bounds: &Bounds,
        settings: &Settings,
    ) -> Result<(), PlanError> {
        settings.validate()?;
        if lights.len() > MAX_LIGHTS {
            return Err(PlanError::Lights { got: lights.len(), most: MAX_LIGHTS });
        }
        let far = settings.distance.map_or(camera.far(), |distance| distance.min(camera.far()));
        if far <= camera.near() {
            return Err(PlanError::Distance { distance: far, near: camera.near() });
        }
        let empty_or_finite =
            |aabb: &Aabb| aabb.min.is_finite() && aabb.max.is_finite() || *aabb == Aabb::EMPTY;
        if !empty_or_finite(&bounds.world) || !bounds.objects.iter().all(empty_or_finite) {
            return Err(PlanError::Bounds);
        }

        self.camera = *camera;
        self.splits = split_distances(camera.near()..far, settings);
        self.lights.clear();
        self.lights.extend_from_slice(lights);
        self.layout = MapLayout::new(settings, lights.iter().map(|light| light.views(settings.splits)).sum());
        self.views.clear();
        for (light_index, light) in lights.iter().enumerate() {
            let Light::Directional { direction } = *light;
            for split in 0..settings.splits as usize {
                let depths = self.splits[split]..self.splits[split + 1];
                let slice = Slice {
                    camera,
                    depths: depths.clone(),
                    along: direction.as_dvec3().normalize_or(DVec3::NEG_Y),
                    bounds,
                    settings,
                };
                let Fitted { light, min, max, casters, unclipped_depth } = fit(&slice, &mut self.outline);
                let index = self.views.len();
                let size = max - min;
                self.views.push(ShadowView {
                    index,
                    clip_from_world: finite_matrix(light.clip_from_world(min, max)),
                    casters,
                    light: light_index,
                    split,
                    depths: depths.start as f32..depths.end as f32,
                    texel_metres: finite(size.x.max(size.y) / f64::from(settings.resolution)),
                    depth_metres: finite(size.z),
                    tile: self.layout.tile(index as u32),
                    unclipped_depth,
                });
            }
        }
        Ok(())
    }

    /// The views, light by light, and in a light split by split.
    pub fn views(&self) -> &[ShadowView] {
        &self.views
    }

    /// The lights, in the order they were given.
    pub fn lights(&self) -> &[Light] {
        &self.lights
    }

    /// C_0 … C_m, metres.
    pub fn splits(&self) -> &[f64] {
        &self.splits
    }

    /// How the views' tiles lie in one texture.
    pub fn layout(&self) -> MapLayout {
        self.layout
    }

    /// The camera the plan was made for.
    pub fn camera(&self) -> &Camera {
        &self.camera
    }
}

/// The nearest f32, and the largest one instead of infinity.
fn finite(value: f64) -> f32 {
    value.clamp(f64::from(f32::MIN), f64::from(f32::MAX)) as f32
}

/// Entries beyond f32 become its largest: such a map is useless, but not NaN.
fn finite_matrix(matrix: Mat4) -> Mat4 {
    let entries = matrix.to_cols_array().map(|entry| entry.clamp(f32::MIN, f32::MAX));
    Mat4::from_cols_array(&entries)
}
