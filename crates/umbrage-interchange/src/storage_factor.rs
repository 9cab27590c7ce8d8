//! How many texels a sun overhead needs for each pixel: with a plan's splits, and at the least.

use std::ops::Range;

use umbrage_core::{Projection, ShadowPlan, Warp};

/// Returns the storage factor of a plan's splits, texels a pixel, 1 or more, for a sun overhead and a picture as high as wide
/// (Lloyd et al. 2006; Zhang et al. 2006, eq. 1).
pub fn storage_factor(plan: &ShadowPlan) -> f64 {
    umbrage_core::storage_factor(plan.splits(), plan.settings().warp != Warp::None) / spread(plan)
}

/// Returns the least storage factor that any splits of the same depths have.
pub fn min_storage_factor(plan: &ShadowPlan) -> f64 {
    umbrage_core::ideal_storage_factor(depths(plan)) / spread(plan)
}

fn depths(plan: &ShadowPlan) -> Range<f64> {
    let splits = plan.splits();
    splits[0]..splits[splits.len() - 1]
}

/// Returns how much wider the view gets a metre of depth; 1 where it does not.
fn spread(plan: &ShadowPlan) -> f64 {
    match plan.camera().projection() {
        Projection::Perspective { fov_y, .. } => 2.0 * (0.5 * f64::from(fov_y)).tan(),
        Projection::Orthographic { .. } => 1.0,
    }
}
