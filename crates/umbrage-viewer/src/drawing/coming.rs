//! Visibility and shadow maps of one picture, on their way to the CPU.

use umbrage::{ComingMaps, MapTexels, ShadowPlan};
use umbrage_render::{ComingPicture, Picture, RenderError};

/// What was asked for of one picture.
#[derive(Debug)]
pub struct Coming {
    /// The plan of the maps.
    pub plan: ShadowPlan,
    visibility: ComingPicture,
    /// Absent where this device cannot copy them.
    maps: Option<ComingMaps>,
    read: Option<Result<Picture, RenderError>>,
}

/// The visibility, and the maps where they can be copied.
pub type Come = (Result<Picture, RenderError>, Option<Result<MapTexels, RenderError>>);

impl Coming {
    /// Waits for both.
    pub fn new(plan: ShadowPlan, visibility: ComingPicture, maps: Option<ComingMaps>) -> Self {
        Self { plan, visibility, maps, read: None }
    }

    /// Takes both, once; `None` where they have not come yet.
    pub fn take(&mut self) -> Option<Come> {
        if self.read.is_none() {
            self.read = Some(self.visibility.take()?);
        }
        let maps = match &self.maps {
            None => None,
            Some(maps) => Some(maps.take()?.map_err(RenderError::from)),
        };
        Some((self.read.take()?, maps))
    }
}
