//! Whether settings can be had, and how much room they need.

use umbrage_core::{DepthLayer, Light, MAX_LIGHTS, MapLayout, Settings};

use crate::capabilities::Capabilities;
use crate::error::ShadowError;

/// Whether settings are in range, and a device can do what they ask for.
pub(crate) fn check(settings: &Settings, capabilities: Capabilities) -> Result<(), ShadowError> {
    settings.validate()?;
    let Settings { filter, bias, .. } = settings;
    let loads = filter.light_size().is_some()
        || filter.moments(1.0).is_some()
        || bias.depth_layer != DepthLayer::First;
    if loads && !capabilities.loads_depth {
        return Err(ShadowError::Unsupported {
            what: "a soft filter, a filter of moments, or a second `bias.depth_layer`",
            missing: "shaders that read depths as numbers",
            remedy: "use Vulkan, Metal, DX12 or WebGPU, or a filter that compares, as optimised or vogel",
        });
    }
    Ok(())
}

/// How the maps of such lights lie, and how many views they are.
pub(crate) fn room(settings: &Settings, lights: &[Light]) -> Result<(MapLayout, u32), ShadowError> {
    if !(1..=MAX_LIGHTS).contains(&lights.len()) {
        return Err(ShadowError::Lights { got: lights.len(), most: MAX_LIGHTS });
    }
    let views = lights.iter().map(|light| light.views(settings)).sum();
    Ok((MapLayout::of_lights(settings, lights)?, views))
}
