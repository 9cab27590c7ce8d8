//! Cascades as Umbrage plans them, written over Bevy's own before anything is culled by them.

use bevy::ecs::entity::EntityHashMap;
use bevy::light::cascade::Cascade;
use bevy::light::{CascadeShadowConfig, Cascades, DirectionalLightShadowMap};
use bevy::prelude::*;
use umbrage_core::{DepthFormat, Fit, Light, Settings, ShadowPlan, plan};

use crate::boxes::Boxes;
use crate::convert::{self, Seen};
use crate::{StockCascades, UmbrageShadows};

/// Bevy draws no more cascades of a light than this.
const MAX_CASCADES: u32 = 4;

/// What a light's configuration asked for before it was written over.
#[derive(Clone, Debug, Default)]
pub(crate) struct Asked {
    count: u32,
    nearest: f32,
    distance: f32,
    /// What was written in its place. Where something else is found, someone has asked anew.
    written: Vec<f32>,
}

/// A light whose cascades are fitted.
type Sun<'w> =
    (Entity, &'w DirectionalLight, &'w GlobalTransform, &'w mut CascadeShadowConfig, &'w mut Cascades);

/// Writes the cascades of every light, for every camera.
pub(crate) fn fit(
    shadows: Res<UmbrageShadows>,
    boxes: Res<Boxes>,
    maps: Res<DirectionalLightShadowMap>,
    cameras: Query<(&GlobalTransform, &Projection), With<Camera3d>>,
    mut lights: Query<Sun<'_>, Without<StockCascades>>,
    mut asked: Local<EntityHashMap<Asked>>,
    mut room: Local<Option<ShadowPlan>>,
) {
    asked.retain(|light, _| lights.contains(*light));
    for (light, sun, transform, mut config, mut cascades) in &mut lights {
        if !sun.shadow_maps_enabled {
            continue;
        }
        let asked = asked.entry(light).or_default();
        asked.follow(&config);
        let Ok(sun) = convert::sun(transform) else { continue };
        let settings = settings(&shadows, &boxes, &maps, asked);
        let mut bounds = Vec::new();
        for (camera, cascades) in &mut cascades.cascades {
            let Ok((transform, projection)) = cameras.get(*camera) else { continue };
            match fitted(transform, projection, asked, sun, &boxes, &settings, &mut room) {
                Ok((of_camera, ends)) => {
                    *cascades = of_camera;
                    bounds = ends;
                }
                Err(why) => warn_once!("bevy_umbrage leaves the cascades of camera {camera} to Bevy: {why}"),
            }
        }
        asked.write(bounds, shadows.blend, &mut config);
    }
}

impl Asked {
    /// Takes what a configuration asks for, unless it is what was written there.
    fn follow(&mut self, config: &CascadeShadowConfig) {
        if config.bounds != self.written {
            self.count = config.bounds.len() as u32;
            self.nearest = config.minimum_distance;
            self.distance = config.bounds.last().copied().unwrap_or_default();
            self.written.clone_from(&config.bounds);
        }
    }

    /// Writes where cascades end, if they were fitted.
    fn write(&mut self, bounds: Vec<f32>, blend: f32, config: &mut Mut<'_, CascadeShadowConfig>) {
        if bounds.is_empty() {
            return;
        }
        if config.bounds != bounds || config.overlap_proportion != blend {
            config.bounds.clone_from(&bounds);
            config.overlap_proportion = blend;
        }
        self.written = bounds;
    }
}

/// The settings that a light is planned with.
fn settings(
    shadows: &UmbrageShadows,
    boxes: &Boxes,
    maps: &DirectionalLightShadowMap,
    asked: &Asked,
) -> Settings {
    let fit = match shadows.fit {
        // What may lie outside of its box may lie anywhere in a slice.
        Fit::Scene | Fit::Sample if boxes.are_incomplete => Fit::View,
        Fit::Sample => Fit::Scene,
        fit => fit,
    };
    Settings {
        splits: asked.count.clamp(1, MAX_CASCADES),
        lambda: shadows.lambda,
        blend: shadows.blend,
        fit,
        resolution: u32::try_from(maps.size).unwrap_or(u32::MAX),
        depth: DepthFormat::F32,
        ..Settings::default()
    }
}

/// The cascades of a light for a camera, and where each ends, metres from the eye; or why there are none.
fn fitted(
    transform: &GlobalTransform,
    projection: &Projection,
    asked: &Asked,
    sun: Light,
    boxes: &Boxes,
    settings: &Settings,
    room: &mut Option<ShadowPlan>,
) -> Result<(Vec<Cascade>, Vec<f32>), String> {
    let seen =
        Seen::of(transform, projection, asked.nearest, asked.distance).map_err(|why| why.to_string())?;
    let planned = match room {
        Some(plan) => plan.replan(&seen.eye, &[sun], &boxes.bounds, settings),
        None => plan(&seen.eye, &[sun], &boxes.bounds, settings).map(|plan| *room = Some(plan)),
    };
    planned.map_err(|why| why.to_string())?;
    let views = room.iter().flat_map(ShadowPlan::views);
    Ok(views.map(|view| (convert::cascade(view), view.depths.end - seen.behind)).unzip())
}

#[cfg(test)]
mod tests {
    use bevy::ecs::entity::EntityHashMap;

    use super::*;

    /// A world with a light that Bevy has given four cascades for each of these cameras.
    fn app(projections: &[Projection]) -> (App, Entity, Vec<Entity>) {
        let mut app = App::new();
        app.init_resource::<Boxes>().init_resource::<UmbrageShadows>();
        app.init_resource::<DirectionalLightShadowMap>().add_systems(Update, fit);
        let camera = |projection: &Projection| {
            app.world_mut().spawn((Camera3d::default(), projection.clone(), GlobalTransform::IDENTITY)).id()
        };
        let cameras: Vec<Entity> = projections.iter().map(camera).collect();
        let stock = vec![Cascade::default(); 4];
        let cascades: EntityHashMap<_> = cameras.iter().map(|camera| (*camera, stock.clone())).collect();
        let light = DirectionalLight { shadow_maps_enabled: true, ..default() };
        let transform = GlobalTransform::from(Transform::default().looking_to(Vec3::NEG_Y, Vec3::Z));
        let light = app.world_mut().spawn((light, Cascades { cascades }, transform)).id();
        (app, light, cameras)
    }

    fn bounds(app: &App, light: Entity) -> Vec<f32> {
        app.world().get::<CascadeShadowConfig>(light).expect("a light").bounds.clone()
    }

    /// Whether the cascades of a camera are still those that Bevy made.
    fn is_stock(app: &App, light: Entity, camera: Entity) -> bool {
        let cascades = &app.world().get::<Cascades>(light).expect("a light").cascades[&camera];
        cascades.iter().all(|cascade| cascade.texel_size == 0.0)
    }

    fn perspective(near: f32) -> Projection {
        Projection::Perspective(PerspectiveProjection { near, ..default() })
    }

    #[test]
    fn each_camera_has_cascades_of_its_own() {
        let (mut app, light, cameras) = app(&[perspective(0.1), perspective(1.0)]);
        let stock = bounds(&app, light);
        app.update();
        assert!(cameras.iter().all(|camera| !is_stock(&app, light, *camera)));
        let bounds = bounds(&app, light);
        assert_eq!((bounds.len(), bounds.last()), (4, stock.last()));
    }

    #[test]
    fn what_is_asked_anew_is_followed() {
        let (mut app, light, _) = app(&[perspective(0.1)]);
        app.update();
        app.world_mut().get_mut::<CascadeShadowConfig>(light).expect("a light").bounds = vec![4.0, 60.0];
        app.update();
        app.update();
        let bounds = bounds(&app, light);
        assert_eq!((bounds.len(), bounds.last()), (2, Some(&60.0)));
    }

    #[test]
    fn cascades_that_nobody_can_plan_stay_bevys() {
        let aside = OrthographicProjection {
            area: Rect::new(0.0, 0.0, 8.0, 8.0),
            ..OrthographicProjection::default_3d()
        };
        let (mut app, light, cameras) = app(&[Projection::Orthographic(aside)]);
        let stock = bounds(&app, light);
        app.update();
        assert!(is_stock(&app, light, cameras[0]));
        assert_eq!(bounds(&app, light), stock);
    }

    #[test]
    fn a_marked_light_and_one_without_maps_stay_as_they_are() {
        let (mut app, light, cameras) = app(&[perspective(0.1)]);
        app.world_mut().entity_mut(light).insert(StockCascades);
        app.update();
        assert!(is_stock(&app, light, cameras[0]));
        app.world_mut().entity_mut(light).remove::<StockCascades>().insert(DirectionalLight::default());
        app.update();
        assert!(is_stock(&app, light, cameras[0]));
    }
}
