//! From a camera, lights, a world and settings to shadow views: pure, and microseconds.
//!
//! A sun makes a view for each split, a spot likewise (one, unless `spot_splits` says more), and a point light six. Every
//! view takes the same way, [`fitted_map`]: receivers → region → homography → padded rectangle → matrix → casters.

#[cfg(test)]
mod tests;

use std::ops::Range;

use crate::allocation::{Allocation, MapLayout, Tile};
use crate::bias::reach;
use crate::bounds::Bounds;
use crate::camera::Camera;
use crate::cull::ConvexVolume;
use crate::error::PlanError;
use crate::finite::{finite, finite_f64, finite_vector};
use crate::fit::Fit;
use crate::fit::outline::Outline;
use crate::light::{FACES, Light, LightKind};
use crate::light_frustum::{LightFrustum, Limits, Pyramid};
use crate::light_projection::LightProjection;
use crate::reach::Reach;
use crate::receivers::{Asked, Receivers, ViewInput};
use crate::rectangle::Rectangle;
use crate::samples::{ChosenRectangle, SampleRegion};
use crate::settings::{MAX_LIGHTS, Select, Settings};
use crate::split::{Splits, distances_within, split_distances, spot_splits};
use crate::stabilise::quantise_up;
use crate::view::ShadowView;
use crate::view_key::ViewKey;
use crate::warp::Warp;

/// The shadow views of one frame, and what a receiver needs to find its own.
///
/// A plan may be made anew for every frame with [`ShadowPlan::replan`]: it keeps its room, and its [`Allocation`] while
/// that serves.
#[derive(Clone, Debug)]
pub struct ShadowPlan {
    settings: Settings,
    camera: Camera,
    lights: Vec<Light>,
    allocation: Allocation,
    splits: Splits,
    /// Between which view depths something is seen, metres.
    seen: Option<Range<f32>>,
    views: Vec<ShadowView>,
    /// Room to fit in.
    outline: Outline,
}

/// Plans a frame. The views come light by light, and in a light split by split or face by face.
///
/// A slice in which there is nothing gets a finite view that no caster touches. Nothing is NaN, for any finite input.
///
/// # Errors
/// When a setting or a light's resolution is out of range, the shadow distance ends before the camera's near, the world's
/// box is not finite (an empty one is allowed), or there are more than [`MAX_LIGHTS`] lights.
pub fn plan(
    camera: &Camera,
    lights: &[Light],
    bounds: &Bounds,
    settings: &Settings,
) -> Result<ShadowPlan, PlanError> {
    let mut plan = ShadowPlan {
        settings: settings.clone(),
        camera: *camera,
        lights: Vec::new(),
        allocation: Allocation::new(settings, &[])?,
        splits: Splits::default(),
        seen: None,
        views: Vec::new(),
        outline: Outline::default(),
    };
    plan.replan(camera, lights, bounds, settings)?;
    Ok(plan)
}

impl ShadowPlan {
    /// Plans another frame as [`plan`] does, into the room that this plan already has: it allocates nothing while lights
    /// and settings stay the same. After an error the plan is as it was.
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
        let depths = shadowed_depths(camera, lights, bounds, settings)?;
        if !self.allocation.serves(settings, lights) {
            self.allocation = Allocation::new(settings, lights)?;
        }
        if self.settings != *settings {
            self.settings.clone_from(settings);
        }
        self.camera = *camera;
        self.splits = match self.seen.clone().filter(|_| settings.fit == Fit::Sample) {
            Some(seen) => {
                let seen = f64::from(seen.start)..f64::from(seen.end);
                distances_within(depths.clone(), seen, settings)
            }
            None => split_distances(depths.clone(), settings),
        };
        self.lights.clear();
        self.lights.extend_from_slice(lights);
        self.views.clear();
        let reach = reach(settings);
        let shadowed = f64::from(depths.start)..f64::from(depths.end);
        let frame = Frame { camera, bounds, settings, reach, shadowed };
        for (index, light) in lights.iter().enumerate() {
            self.add_light(&frame, index, light, depths.clone());
        }
        Ok(())
    }

    /// Says between which view depths something is seen, metres, for the plans that are made after this: under [`Fit::Sample`]
    /// the inner cuts are placed there. All view depths have shadows whatever is said, so an old answer costs texels and no shadow.
    /// `None` until then.
    pub fn see(&mut self, depths: Option<Range<f32>>) {
        self.seen = depths;
    }

    /// The views of one light over these view depths.
    fn add_light(&mut self, frame: &Frame<'_>, index: usize, light: &Light, depths: Range<f32>) {
        let bounds = frame.bounds;
        let flattens = frame.settings.flattens_casters() && light.near() <= 0.0;
        let limits = |range| Limits { range, near: light.near(), depth: frame.settings.depth, flattens };
        match light.kind() {
            LightKind::Directional { direction } => {
                let splits = self.splits.clone();
                self.add_splits(frame, index, LightFrustum::sun(direction), &splits);
            }
            LightKind::Spot { position, direction, half_angle, range } => {
                let pyramid = Pyramid::spot(position, direction, half_angle, limits(range), bounds);
                let splits = spot_splits(frame.camera, &pyramid, depths, frame.settings);
                self.add_splits(frame, index, LightFrustum::FromApex(pyramid), &splits);
            }
            LightKind::Point { position, range } => {
                let all = f64::from(depths.start)..f64::from(depths.end);
                for face in 0..FACES as usize {
                    let padding = frame.reach.padding(self.allocation.tiles_of(index)[face].size);
                    let pyramid = Pyramid::face(position, face, padding, limits(range), bounds);
                    let light_frustum = LightFrustum::FromApex(pyramid);
                    self.add_view(frame, index, face, light_frustum, all.clone(), all.clone());
                }
            }
        }
    }

    /// One view for each slice between two of the distances.
    fn add_splits(&mut self, frame: &Frame<'_>, light: usize, light_frustum: LightFrustum, splits: &[f64]) {
        let mut faded = 0.0;
        for (split, ends) in splits.windows(2).enumerate() {
            // What is cross-faded out of the slice before is looked up here too.
            let fitted = ends[0] - faded..ends[1];
            self.add_view(frame, light, split, light_frustum, fitted, ends[0]..ends[1]);
            faded = f64::from(frame.settings.blend) * (ends[1] - ends[0]);
        }
    }

    /// A view that is fitted to some view depths and serves others.
    fn add_view(
        &mut self,
        frame: &Frame<'_>,
        light: usize,
        split: usize,
        light_frustum: LightFrustum,
        fitted: Range<f64>,
        served: Range<f64>,
    ) {
        let index = self.views.len();
        let tile = self.allocation.tiles()[index];
        let place = Place { index, light, split, tile, depths: served.start as f32..served.end as f32 };
        let mut input = frame.input(fitted, light_frustum, &self.allocation.tiles_of(light)[..=split]);
        // What is flattened casts; what lies within a bulb does not.
        input.has_bulb = self.lights[light].near() > 0.0;
        input.flattens_casters &= !input.has_bulb;
        let Settings { fit, warp, .. } = *frame.settings;
        self.views.push(shadow_view(fitted_map(fit, warp, &input, &mut self.outline), place));
    }

    /// The settings that the plan was made with.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// The camera that the plan was made for.
    pub fn camera(&self) -> &Camera {
        &self.camera
    }

    /// The lights, in the order they were given.
    pub fn lights(&self) -> &[Light] {
        &self.lights
    }

    /// Which tile each view has. It stays the same from frame to frame while lights and sizes do.
    pub fn allocation(&self) -> &Allocation {
        &self.allocation
    }

    /// How large the texture is that holds the views' tiles.
    pub fn layout(&self) -> MapLayout {
        self.allocation.layout()
    }

    /// The split distances C_0 … C_m of suns, view depths in metres. A spot's are in its views.
    pub fn splits(&self) -> &[f64] {
        &self.splits
    }

    /// Says what a view shows, by the view's place in the plan; nothing where there is no such view. It holds until the plan is
    /// made anew.
    pub fn set_key(&mut self, view: usize, key: Option<ViewKey>) {
        if let Some(view) = self.views.get_mut(view) {
            view.key = key;
        }
    }

    /// Says which rectangle a pass has chosen for a view, by the view's place in the plan: its matrix and the size of its texels are
    /// those that shaders see then. Nothing happens where there is no such view, or nothing is chosen for it.
    pub fn set_rectangle(&mut self, view: usize, chosen: &ChosenRectangle) {
        if let Some(view) = self.views.get_mut(view).filter(|view| view.samples.is_some()) {
            view.clip_from_world = finite_f64(chosen.in_place_of(&view.clip_from_world));
            view.texel_metres = finite(chosen.sides.max_element() / f64::from(view.tile.size));
        }
    }

    /// Says how far the casters that are drawn into a view may lie from those that are meant, metres, by the view's place in
    /// the plan; nothing where there is no such view. What is no number, or less than 0, counts as 0. It must be said before the
    /// plan is uploaded, and holds until the plan is made anew.
    ///
    /// Whoever draws coarser levels of detail than receivers are seen in would see these shadow themselves otherwise.
    pub fn set_caster_error(&mut self, view: usize, metres: f32) {
        if let Some(view) = self.views.get_mut(view) {
            view.caster_error = metres.max(0.0);
        }
    }

    /// The views, light by light, and in a light split by split or face by face.
    pub fn views(&self) -> &[ShadowView] {
        &self.views
    }
}

/// What all views of a frame are made from.
struct Frame<'a> {
    camera: &'a Camera,
    bounds: &'a Bounds,
    settings: &'a Settings,
    reach: Reach,
    /// The view depths that have shadows, metres.
    shadowed: Range<f64>,
}

impl<'a> Frame<'a> {
    /// What one view is made from; its tile is the last of its light's up to it.
    fn input(&self, depths: Range<f64>, light_frustum: LightFrustum, tiles: &[Tile]) -> ViewInput<'a> {
        let Self { camera, bounds, settings, reach, .. } = *self;
        let asked = self.asked(depths.start, &light_frustum, tiles);
        let resolution = tiles.last().map_or(0, |tile| tile.size);
        let flattens_casters = settings.flattens_casters();
        ViewInput {
            camera,
            depths,
            light_frustum,
            resolution,
            bounds,
            reach,
            flattens_casters,
            has_bulb: false,
            asked,
            light_box: settings.light_box,
        }
    }

    /// Which receivers may look into a view whose slice starts at a view depth. Where a receiver asks the finest map that
    /// covers it, all that lie nearer are covered by finer maps, unless one of these is not padded enough, or they fade out.
    fn asked(&self, slice_start: f64, light_frustum: &LightFrustum, tiles: &[Tile]) -> Asked {
        let Self { settings, reach, shadowed, .. } = self;
        match settings.select {
            Select::Map if !light_frustum.is_face() => {
                // What the camera's depth does not show, as glass, may be covered by no finer map.
                let all_are_seen = settings.fit != Fit::Sample;
                let all_are_padded = tiles.iter().all(|tile| reach.is_held_by(tile.size));
                let nearer_are_held = settings.blend == 0.0 && all_are_padded && all_are_seen;
                Asked::Covered(if nearer_are_held { slice_start } else { shadowed.start }..shadowed.end)
            }
            Select::Map | Select::Depth | Select::ClipDepth => Asked::OwnSlice,
        }
    }
}

/// A map that is fitted to its receivers, before it is rounded to a [`ShadowView`].
struct FittedMap {
    projection: LightProjection,
    texel_metres: f64,
    casters: ConvexVolume,
    unclipped_depth: bool,
    samples: Option<SampleRegion>,
}

/// The whole way of one view, from what it is made from to its matrix and its casters.
fn fitted_map(fit: Fit, warp: Warp, input: &ViewInput<'_>, outline: &mut Outline) -> FittedMap {
    let receivers = Receivers::of(input);
    let (region, policy) = fit.region(input, &receivers, outline);
    let homography = warp.homography(input, &region);
    let samples = SampleRegion::of(input, &region, &homography);
    let rectangle = match &samples {
        Some(samples) => samples.rectangle(input.resolution),
        None => region.rectangle(input, &homography),
    };
    let Rectangle { min, max, texel_metres } = rectangle;
    let depths = region.depths.resolve(input, &region.space, texel_metres);
    let projection = LightProjection { space: region.map_space(&homography), homography, min, max, depths };
    let casters = policy.volume(input, &region, &projection, texel_metres);
    FittedMap { projection, texel_metres, casters, unclipped_depth: policy.flattens(input), samples }
}

/// Which view of the frame a map is.
struct Place {
    index: usize,
    light: usize,
    split: usize,
    tile: Tile,
    /// The view depths that it serves.
    depths: Range<f32>,
}

/// The view that draws a map.
fn shadow_view(map: FittedMap, place: Place) -> ShadowView {
    let FittedMap { projection, texel_metres, casters, unclipped_depth, samples } = map;
    let Place { index, light, split, tile, depths } = place;
    ShadowView {
        index,
        key: None,
        clip_from_world: finite_f64(projection.clip_from_world()),
        casters,
        light,
        split,
        depths,
        texel_metres: finite(texel_metres),
        depth_metres: finite(projection.depths.end - projection.depths.start),
        near_metres: finite(projection.depths.start),
        rays: projection.space.rays(),
        depth_scale: finite_vector(projection.depth_scale()),
        tile,
        unclipped_depth,
        samples,
        caster_error: 0.0,
    }
}

/// The view depths that have shadows, or why there can be no plan.
fn shadowed_depths(
    camera: &Camera,
    lights: &[Light],
    bounds: &Bounds,
    settings: &Settings,
) -> Result<Range<f32>, PlanError> {
    if lights.len() > MAX_LIGHTS {
        return Err(PlanError::Lights { got: lights.len(), max: MAX_LIGHTS });
    }
    let far = settings.distance.map_or(camera.far(), |distance| distance.min(camera.far()));
    let far = if far.is_finite() { far } else { end_of(bounds, camera) };
    if far <= camera.near() {
        return Err(PlanError::Distance { distance: far, near: camera.near() });
    }
    if !bounds.can_be_planned() {
        return Err(PlanError::Bounds);
    }
    Ok(camera.near()..far)
}

/// The view depth, metres, behind which nothing of the world lies, whichever way the camera looks: where shadows of a camera with an
/// infinite far plane end. It is rounded up in steps, so that cuts hold still while the eye moves a little, and always as it turns.
fn end_of(bounds: &Bounds, camera: &Camera) -> f32 {
    let eye = camera.eye().as_dvec3();
    let distances = bounds.world().corners().map(|corner| corner.as_dvec3().distance(eye));
    let farthest = 1.0001 * distances.into_iter().fold(0.0, f64::max);
    // No world, or all of it where the eye is: any end will do.
    let end = if farthest > 0.0 && farthest.is_finite() { quantise_up(farthest) as f32 } else { 0.0 };
    end.max(2.0 * camera.near())
}
