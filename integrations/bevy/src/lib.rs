//! Umbrage's cascades and its shadow lookup, for Bevy's directional lights.
//!
//! Add the plug-in, and every [`DirectionalLight`] with shadow maps has cascades that are fitted to what the camera can see of
//! the world ([`cascades`]), and materials read them against the plane of the receiver ([`reading`]). Bevy's maps, bindings,
//! culling and passes stay as they are.
//!
//! ```no_run
//! use bevy::prelude::*;
//! use bevy_umbrage::UmbragePlugin;
//!
//! App::new().add_plugins((DefaultPlugins, UmbragePlugin::default())).run();
//! ```
//!
//! What is taken from Bevy: the number of cascades and where the last one ends (`CascadeShadowConfig`), the size of a map
//! (`DirectionalLightShadowMap`). What takes no part any more: where the first cascade ends, `overlap_proportion`, and the
//! light's `shadow_depth_bias` and `shadow_normal_bias`.
//!
//! This crate does not: touch point lights and spots, or draw anything itself.

mod boxes;
mod cascades;
mod convert;
mod reading;

use bevy::camera::CameraUpdateSystems;
use bevy::camera::visibility::VisibilitySystems;
use bevy::light::SimulationLightSystems;
use bevy::prelude::*;

pub use umbrage_core::Fit;

/// Gives directional lights Umbrage's cascades and lookup. Add it after Bevy's own plug-ins.
#[derive(Clone, Debug, Default)]
pub struct UmbragePlugin {
    /// The choices that the application starts with.
    pub shadows: UmbrageShadows,
}

/// What there is to choose; a change of this resource takes effect in the next frame.
#[derive(Resource, Clone, Debug, PartialEq)]
pub struct UmbrageShadows {
    /// The way the camera's depth is cut, from 0 to 1: 0 cuts it evenly, 1 by the same factor each time. The default is 0.8.
    pub lambda: f32,
    /// What a cascade is fitted to. [`Fit::Scene`], the default, has the finest texels; under [`Fit::Stable`] edges hold still
    /// while the camera moves. [`Fit::Sample`] counts as [`Fit::Scene`].
    pub fit: Fit,
    /// The share of a map's half width over which a cascade fades into the next, from 0 to 1. The default is 0: where maps meet,
    /// edges change in a line, and only one map is read. It holds for all lights; one that is not 0 costs a second lookup.
    pub blend: f32,
}

impl Default for UmbrageShadows {
    fn default() -> Self {
        let umbrage_core::Settings { lambda, fit, blend, .. } = umbrage_core::Settings::default();
        Self { lambda, fit, blend }
    }
}

/// Mark a light with this, and its cascades stay Bevy's own; it is read as the others are.
#[derive(Component, Clone, Copy, Debug, Default)]
pub struct StockCascades;

impl Plugin for UmbragePlugin {
    fn build(&self, app: &mut App) {
        app.insert_resource(self.shadows.clone());
        app.init_resource::<boxes::Boxes>();
        app.add_systems(
            PostUpdate,
            (boxes::follow, cascades::fit)
                .chain()
                .after(TransformSystems::Propagate)
                .after(CameraUpdateSystems)
                .after(VisibilitySystems::CalculateBounds)
                .after(VisibilitySystems::VisibilityPropagate)
                .after(SimulationLightSystems::UpdateDirectionalLightCascades)
                .before(SimulationLightSystems::UpdateLightFrusta),
        );
        app.add_systems(Update, reading::replace.run_if(resource_exists::<reading::Reading>));
    }

    fn finish(&self, app: &mut App) {
        reading::ask(app);
    }
}
