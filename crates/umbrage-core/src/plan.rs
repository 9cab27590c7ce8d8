//! From a camera, lights, a world and settings to shadow views: pure, and microseconds.
//!
//! A sun makes a view for each split, a spot likewise (one, unless `spot_splits` says more), and a point light six.

use std::ops::Range;

use glam::{DMat4, DVec3, Mat4, Vec3};

use crate::bounds::{Aabb, Bounds};
use crate::camera::Camera;
use crate::convex::ConvexBody;
use crate::error::PlanError;
use crate::few::ArrayVec;
use crate::fit::{Outline, Slice, fit};
use crate::light::{FACES, Light, LightKind};
use crate::light_frustum::LightFrustum;
use crate::settings::{DepthFormat, MAX_LIGHTS, MAX_SPLITS, Scheme, Settings};
use crate::split::split_distances;
use crate::view::{MAX_VIEWS, MapLayout, ShadowView, Tile, arrange, tile_sizes};

/// The shadow views of one frame, and what a receiver needs to find its own.
#[derive(Clone, Debug)]
pub struct ShadowPlan {
    views: Vec<ShadowView>,
    lights: Vec<Light>,
    splits: ArrayVec<f64, { MAX_SPLITS + 1 }>,
    layout: MapLayout,
    camera: Camera,
    /// Room to fit in.
    outline: Outline,
}

/// Plans a frame. The views come light by light, and in a light split by split or face by face.
///
/// A slice in which there is nothing gets a finite view that no caster touches. Never NaN, for any finite input.
///
/// # Errors
/// When a setting or a light's resolution is out of range, the shadow distance ends before the camera's near, the world's box is not finite
/// (an empty one is allowed), or there are more than [`MAX_LIGHTS`] lights.
pub fn plan(
    camera: &Camera,
    lights: &[Light],
    bounds: &Bounds,
    settings: &Settings,
) -> Result<ShadowPlan, PlanError> {
    let layout = MapLayout { width: 0, height: 0, layers: 0, depth: DepthFormat::F32 };
    let mut plan = ShadowPlan {
        views: Vec::new(),
        lights: Vec::new(),
        splits: ArrayVec::default(),
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
        let sizes = tile_sizes(settings, lights)?;

        let mut tiles = [Tile::default(); MAX_VIEWS];
        self.layout = arrange(settings.storage, settings.depth, &sizes, &mut tiles);
        self.camera = *camera;
        self.splits = split_distances(camera.near()..far, settings);
        self.lights.clear();
        self.lights.extend_from_slice(lights);
        self.views.clear();
        for (index, light) in lights.iter().enumerate() {
            let job = Job { index, light, camera, bounds, settings, tiles: &tiles };
            match light.kind {
                LightKind::Directional { .. } => {
                    let splits = self.splits;
                    self.add_splits(&job, &splits);
                }
                LightKind::Spot { .. } => {
                    let splits = spot_splits(&job, camera.near()..far);
                    self.add_splits(&job, &splits);
                }
                LightKind::Point { .. } => {
                    let depths = f64::from(camera.near())..f64::from(far);
                    (0..FACES as usize)
                        .for_each(|face| self.add_view(&job, face, depths.clone(), depths.clone()));
                }
            }
        }
        Ok(())
    }

    /// One view for each slice between two of the distances.
    fn add_splits(&mut self, job: &Job<'_>, splits: &[f64]) {
        let mut faded = 0.0;
        for (split, ends) in splits.windows(2).enumerate() {
            // What is cross-faded out of the slice before is looked up here too.
            self.add_view(job, split, ends[0] - faded..ends[1], ends[0]..ends[1]);
            faded = f64::from(job.settings.blend) * (ends[1] - ends[0]);
        }
    }

    /// A view that is fitted to some depths and serves others.
    fn add_view(&mut self, job: &Job<'_>, split: usize, fitted: Range<f64>, served: Range<f64>) {
        let index = self.views.len();
        let Job { light, camera, bounds, settings, tiles, .. } = *job;
        let tile = tiles[index];
        let light_frustum = LightFrustum::of(light.kind, split, tile.size, bounds, settings);
        let slice = Slice { camera, depths: fitted, light_frustum, resolution: tile.size, bounds, settings };
        let fitted = fit(&slice, &mut self.outline);
        self.views.push(ShadowView {
            index,
            clip_from_world: finite_matrix(fitted.clip_from_world),
            casters: fitted.casters,
            light: job.index,
            split,
            depths: served.start as f32..served.end as f32,
            texel_metres: finite(fitted.texel_metres),
            depth_metres: finite(fitted.metres.end - fitted.metres.start),
            near_metres: finite(fitted.metres.start),
            spreads: !matches!(light.kind, LightKind::Directional { .. }),
            inverse_weight: finite_vector(fitted.inverse_weight),
            tile,
            unclipped_depth: fitted.unclipped_depth,
        });
    }

    /// The views, light by light, and in a light split by split.
    pub fn views(&self) -> &[ShadowView] {
        &self.views
    }

    /// The lights, in the order they were given.
    pub fn lights(&self) -> &[Light] {
        &self.lights
    }

    /// C_0 … C_m of suns, metres. A spot's are in its views.
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

/// What all views of a light are made from.
struct Job<'a> {
    index: usize,
    light: &'a Light,
    camera: &'a Camera,
    bounds: &'a Bounds,
    settings: &'a Settings,
    tiles: &'a [Tile],
}

/// Cuts the view depths that a spot reaches; all of them where it reaches nothing.
fn spot_splits(job: &Job<'_>, depths: Range<f32>) -> ArrayVec<f64, { MAX_SPLITS + 1 }> {
    let Job { light, camera, bounds, settings, .. } = *job;
    let all = f64::from(depths.start)..f64::from(depths.end);
    let light_frustum = LightFrustum::of(light.kind, 0, settings.resolution, bounds, settings);
    let (eye, forward) = (camera.eye().as_dvec3(), camera.forward().as_dvec3());
    let mut reached = f64::INFINITY..f64::NEG_INFINITY;
    if let LightFrustum::Spread(pyramid) = light_frustum {
        let body = ConvexBody::of_slice(&camera.slice_corners(all)).clipped_by_all(&pyramid.planes());
        for depth in body.corners().map(|corner| forward.dot(corner - eye)) {
            reached = reached.start.min(depth)..reached.end.max(depth);
        }
    }
    let from = (reached.start as f32).clamp(depths.start, depths.end);
    let to = (reached.end as f32).clamp(depths.start, depths.end);
    let reached = if from < to { from..to } else { depths };
    // Distances that were given by hand are a sun's.
    let scheme = if settings.scheme == Scheme::Manual { Scheme::Practical } else { settings.scheme };
    let Settings { lambda, split_bias, near, .. } = *settings;
    let splits = settings.spot_splits;
    split_distances(reached, &Settings { splits, scheme, lambda, split_bias, near, ..Settings::default() })
}

/// The nearest f32, and the largest one instead of infinity.
fn finite(value: f64) -> f32 {
    value.clamp(f64::from(f32::MIN), f64::from(f32::MAX)) as f32
}

/// As [`finite`], and 0 for what is no number.
fn finite_vector(vector: DVec3) -> Vec3 {
    Vec3::from_array(vector.to_array().map(|entry| if entry.is_nan() { 0.0 } else { finite(entry) }))
}

/// Entries beyond f32 become its largest: such a map is useless, but not NaN.
fn finite_matrix(matrix: DMat4) -> Mat4 {
    Mat4::from_cols_array(
        &matrix.to_cols_array().map(|entry| if entry.is_nan() { 0.0 } else { finite(entry) }),
    )
}
