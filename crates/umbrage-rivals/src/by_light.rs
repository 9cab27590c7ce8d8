//! The shadows of a picture, light by light, by a family that draws onto the camera's depth.

use umbrage_render::Gpu;
use web_time::Instant;

use crate::error::RivalError;
use crate::eye::Eye;
use crate::receivers::Receivers;
use crate::rival::{Seen, View};
use crate::shining::Shining;

/// What is known of one light.
#[derive(Debug)]
pub(crate) struct OfLight {
    /// The visibility of every pixel.
    pub visibility: Vec<Option<f32>>,
    /// The milliseconds until all was handed over to the device.
    pub listing: f64,
    /// The milliseconds that it took there, if it tells.
    pub on_device: Option<f64>,
}

/// A family that draws the shadows of one light after another onto the camera's depth.
pub(crate) trait ByLight {
    /// Returns the device, and what draws the camera's depth.
    fn parts(&mut self) -> (&Gpu, &mut Receivers);

    /// Draws the shadows of a light onto the depth that is seen.
    fn light(
        &mut self,
        eye: &Eye,
        light: &Shining,
        view: &View<'_>,
        seen: &wgpu::TextureView,
    ) -> Result<OfLight, RivalError>;
}

/// Draws the camera's depth once, and then the shadows of each light. Where the device does not tell how long that took, the wall
/// clock does.
pub(crate) fn see(family: &mut impl ByLight, eye: &Eye, view: &View<'_>) -> Result<Seen, RivalError> {
    let start = Instant::now();
    let seen = family.parts().1.depth(view)?;
    let mut listing_milliseconds = milliseconds_since(start);
    let (mut visibility, mut on_device) = (Vec::new(), Some(0.0));
    for light in view.lights {
        let light = Shining::at(light, view.pose)?;
        let of_light = family.light(eye, &light, view, &seen)?;
        on_device = on_device.zip(of_light.on_device).map(|(sum, more)| sum + more);
        listing_milliseconds += of_light.listing;
        visibility.push(of_light.visibility);
    }
    let (gpu, receivers) = family.parts();
    gpu.wait()?;
    let wall = milliseconds_since(start) - listing_milliseconds;
    let milliseconds = on_device.zip(receivers.milliseconds()).map_or(wall, |(lights, depth)| lights + depth);
    Ok(Seen { visibility, milliseconds, listing_milliseconds })
}

/// How long ago something was, by the wall clock.
pub(crate) fn milliseconds_since(start: Instant) -> f64 {
    start.elapsed().as_secs_f64() * 1e3
}
