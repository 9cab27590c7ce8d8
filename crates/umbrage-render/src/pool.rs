//! What frames use in turn: plans with their lists, and targets. A frame takes what nobody holds any more.

use std::sync::Arc;

use crate::drawn::Planned;
use crate::error::RenderError;
use crate::gpu::Gpu;
use crate::target::{Shape, Target};

/// Plans with their lists and buffers.
#[derive(Debug, Default)]
pub(crate) struct Plans(Vec<Arc<Planned>>);

impl Plans {
    /// One that nobody holds, or a new one, filled by means of `with`. Where that fails, it is as it was, or there is none.
    pub fn filled<T>(
        &mut self,
        with: &mut T,
        make: impl FnOnce(&mut T) -> Result<Planned, RenderError>,
        fill: impl FnOnce(&mut T, &mut Planned) -> Result<(), RenderError>,
    ) -> Result<Arc<Planned>, RenderError> {
        if let Some(i) = self.0.iter_mut().position(|planned| Arc::get_mut(planned).is_some())
            && let Some(free) = Arc::get_mut(&mut self.0[i])
        {
            fill(with, free)?;
            let taken = Arc::clone(&self.0[i]);
            // Others that came back are of no use: one is enough for a frame that nobody holds.
            self.0.retain(|planned| Arc::strong_count(planned) > 1);
            return Ok(taken);
        }
        let mut made = make(with)?;
        fill(with, &mut made)?;
        let made = Arc::new(made);
        self.0.push(Arc::clone(&made));
        Ok(made)
    }
}

/// Targets by shape.
#[derive(Debug, Default)]
pub(crate) struct Targets(Vec<Arc<Target>>);

impl Targets {
    /// One of a shape that nobody holds, or a new one.
    pub fn take(&mut self, gpu: &Gpu, shape: Shape) -> Result<Arc<Target>, RenderError> {
        let free = |target: &Arc<Target>| Arc::strong_count(target) == 1;
        let found = self.0.iter().find(|target| free(target) && target.shape == shape).cloned();
        // What came back of another size, and more than one of this, is given up; those of another encoding are kept, for
        // pictures and visibility take turns.
        self.0.retain(|target| !free(target) || target.shape.encoding != shape.encoding);
        if let Some(found) = found {
            return Ok(found);
        }
        let made = Arc::new(gpu.allocate("the picture", || Target::new(gpu, shape))?);
        self.0.push(Arc::clone(&made));
        Ok(made)
    }
}
