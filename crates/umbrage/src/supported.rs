//! Whether settings can be had, and which tiles they need.

use umbrage_core::{Allocation, DepthLayer, Light, MAX_LIGHTS, Settings};

use crate::capabilities::Capabilities;
use crate::error::ShadowError;

/// Whether settings are in range, and a device can do what they ask for.
pub(crate) fn check(settings: &Settings, capabilities: Capabilities) -> Result<(), ShadowError> {
    settings.validate()?;
    let Settings { filter, bias, .. } = settings;
    let loads = filter.reads_depth_values() || bias.depth_layer != DepthLayer::First;
    if loads && !capabilities.loads_depth {
        return Err(ShadowError::Unsupported {
            what: "a soft filter, a filter of moments, or a second `bias.depth_layer`",
            missing: "shaders that read depths as numbers",
            remedy: "use Vulkan, Metal, DX12 or WebGPU, or a filter that compares, as optimised or vogel",
        });
    }
    Ok(())
}

/// Which tiles the views of such lights get.
pub(crate) fn allocation(settings: &Settings, lights: &[Light]) -> Result<Allocation, ShadowError> {
    if !(1..=MAX_LIGHTS).contains(&lights.len()) {
        return Err(ShadowError::Lights { got: lights.len(), max: MAX_LIGHTS });
    }
    Ok(Allocation::new(settings, lights)?)
}
